/* SPDX-License-Identifier: MIT */
/*
 * Cameras: each kind makes a ray of a place on the picture. To add one, write a
 * file beside perspective.c and add its line to cameras.def.
 */
#ifndef LAMBERT_CAMERA_CAMERA_H
#define LAMBERT_CAMERA_CAMERA_H

#include "base/vec3.h"

struct camera;

struct camera_class {
	const char *name; /* the word of the language */
	/* The rays are parallel: each has an origin of its own, and the view is as large as the
	 * picture is at look_at. */
	bool is_parallel;
	/* The ray through (s, t), which run over the picture from -1/2 to 1/2, to the right and
	 * upwards. The direction need not be unit. */
	ray (*ray)(const struct camera *, double s, double t);
};

/* The vectors are final: angle, look_at and transformations are in them. */
struct camera {
	const struct camera_class *kind;
	vec3 location, right, up, direction;
};

/* The class of a word, or NULL. */
const struct camera_class *camera_find(const char *word);
/* The ray through a sample position, in pixel units, of a picture; false: no ray there. */
bool camera_ray(const struct camera *, double x, double y, unsigned width, unsigned height, ray *);

#endif
