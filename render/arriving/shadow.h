/* SPDX-License-Identifier: MIT */
/*
 * What the files of the room share: memory, shadow rays, points of area lights.
 */
#ifndef LAMBERT_ARRIVING_SHADOW_H
#define LAMBERT_ARRIVING_SHADOW_H

#include "arriving/arriving.h"

/* Levels of the ray tree whose shadows are remembered apart: neighbouring camera rays are alike, and
 * so are their reflections. */
enum { BLOCKER_LEVELS = 4 };

/* A point of an area light, once it has been asked. */
struct grid_point {
	rgb radiance;
	uint32_t round; /* it was found in; another one: not known */
};

struct light_memory {
	const struct object **blockers; /* by light and level: what blocked it last, or NULL */
	struct arena *passing;		/* as long as a shadow ray */
	bool has_fog;			/* some light is attenuated by the fog on its way */
	struct grid_point *grid;	/* of the area light being asked */
	size_t grid_room;
	uint32_t grid_round;
};

/* What of the sample's light arrives. */
rgb shadow_filter(struct worker *, const struct light_target *, const struct light_sample *);
/* The same, averaged over an area light. */
rgb area_light_filter(struct worker *, const struct light_target *, const struct light_sample *);
/* The axes of the light's grid seen from a point: square to the direction with `orient`. */
struct area_axes area_light_axes(const struct light *, vec3 to_centre);
/* The random numbers of its points. */
struct sample_family area_light_jitter(
	const struct worker *, const struct light_target *, const struct light *);
/* Where the light of grid point (u, v) stands, with its own jitter. */
vec3 area_light_point(const struct light *, const struct area_axes *,
	const struct sample_family *jitter, int u, int v);

#endif
