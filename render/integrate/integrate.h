/* SPDX-License-Identifier: MIT */
/*
 * What the files of the integrator share: trace.c follows rays, shade.c makes a
 * colour of what they meet, direct_light.c adds the lights, sky.c is behind all.
 */
#ifndef LAMBERT_INTEGRATE_INTEGRATE_H
#define LAMBERT_INTEGRATE_INTEGRATE_H

#include "integrate/trace.h"
#include "arriving/arriving.h"
#include "surface/transmission.h"

/* What comes along a ray. */
struct radiance {
	rgb light;
	float transmit; /* share of what is behind the picture */
};

/* One ray of the tree. */
struct path {
	ray ray;
	struct interior_stack inside;
	float weight;	 /* share in the picture, for adc_bailout */
	int level;	 /* compared with max_trace_level */
	uint32_t kind;	 /* enum ray_kind */
	bool straight;	 /* goes on unbent through a surface: keeps the level */
	uint32_t vertex; /* of the ray tree it ends at: names random numbers */
};

struct integrate_memory {
	unsigned width, height; /* of the picture */
	struct interior_stack at_camera;
};

/* ---- trace.c ---- */

/* The light along the path; *path is used up. */
struct radiance trace_path(struct worker *, struct path *);

/* ---- shade.c ---- */

/* The light of a hit without what comes through it. If *onward is present, *path has become the ray
 * that goes on. */
struct radiance shade_hit(
	struct worker *, struct path *, const struct hit *, struct transmission *onward);

/* ---- direct_light.c ---- */

/* What the lobes of a part send on of all lights, and what they send by themselves. */
rgb direct_light(
	struct worker *, const struct path *, const struct interaction *, const struct layers *);

/* ---- sky.c ---- */

/* What comes from where nothing is. */
struct radiance sky_radiance(const struct scene *, vec3 direction, bool reflected);

#endif
