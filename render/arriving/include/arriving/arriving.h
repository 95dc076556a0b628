/* SPDX-License-Identifier: MIT */
/*
 * The light that arrives at a point of space, from all lights or some. Nothing
 * here knows a surface at that point: media, photons and vertices may ask, too.
 *
 * First light_aim for each light, which is quick; the caller drops what would not
 * matter. Then light_arriving for all that are left at once.
 */
#ifndef LAMBERT_ARRIVING_ARRIVING_H
#define LAMBERT_ARRIVING_ARRIVING_H

#include "light/light.h"
#include "medium/interior_stack.h"
#include "worker/worker.h"

/* Where light is wanted. */
struct light_target {
	vec3 point;
	const struct interior_stack *interiors; /* the point is in */
	unsigned level;	 /* of the ray tree: what blocks light at neighbours is looked at first */
	uint32_t vertex; /* of the ray tree: names random numbers */
};

/* What a light sends there. */
struct light_sample {
	const struct light *light;
	vec3 direction; /* unit, towards the light */
	double distance;
	rgb radiance;
	uint32_t number; /* of the light, among all that light the target */
};

/* The sample of a light without anything in its way; false: cone and distance leave nothing. */
bool light_aim(const struct worker *, const struct light *, const vec3 *p, struct light_sample *);
/* Takes from the samples of one target what is lost on the way. */
void light_arriving(
	struct worker *, const struct light_target *, struct light_sample *, size_t count);

/* Whether each point of an area light's grid lights by itself, under one shadow: area_illumination. */
static inline bool light_is_spread(const struct worker *w, const struct light *light)
{
	return light->area_illumination && light->area_count_u > 0 &&
	       w->scene->settings.quality >= 5;
}
/* How the grid of an area light stands. */
struct area_axes {
	vec3 u, v;
};
/* Such a grid, for the light that arrives of the whole. */
struct light_grid {
	const struct light_sample *whole;
	struct area_axes axes;
	rgb share;		     /* of each point */
	struct sample_family jitter; /* of their places */
};
struct light_grid light_grid_of(
	const struct worker *, const struct light_target *, const struct light_sample *);
/* What point (u, v) of the grid sends. */
void light_grid_sample(const struct worker *, const struct light_target *,
	const struct light_grid *, int u, int v, struct light_sample *);

struct light_memory *light_memory_create(const struct worker *);
void light_memory_destroy(struct light_memory *);

#endif
