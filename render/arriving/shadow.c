/* SPDX-License-Identifier: MIT */
/*
 * Shadow rays. Anything opaque ends the light, and that is asked first, without
 * looking at a texture. Only then, and only in scenes that have such objects,
 * the surfaces that let light through are visited in order, each tinting it.
 */
#include "shadow.h"

#include "accel/accel.h"
#include "medium/fog.h"
#include "medium/interior.h"
#include "surface/layers.h"

#include <float.h>

/* What one crossing lets through; `length` is the way since the crossing before. */
static rgb crossing_tint(struct worker *w, const struct hit *hit, const ray *r, double length,
	const struct interior_stack *inside)
{
	const struct interior *interior = object_interior(hit->object);
	struct interaction it;
	interaction_make(w, &it, hit, r, inside, 0);
	const rgb tint = layers_tint(w, &it);
	if (interior->fade_power > 0 && interior_stack_has(inside, interior))
		return rgb_mul(tint, interior_fading(interior, length));
	return tint;
}

static rgb fogged(struct worker *w, const struct light *light, ray r, double from, double to,
	const struct interior_stack *inside, rgb arriving)
{
	if (!w->light->has_fog || !light->media_attenuation || !light->media_interaction)
		return arriving;
	if (!interior_stack_is_hollow(inside))
		return arriving;
	rgb factor, added;
	const ray piece = { ray_at(r, from), r.direction };
	fog_effect(w->scene, piece, to - from, &factor, &added);
	return rgb_mul(arriving, factor);
}

/* A number a rounding error above t > 0. */
static double just_above(double t)
{
	return t * (1 + DBL_EPSILON);
}

/* Follows the ray through everything that is not opaque, up to `limit`. */
static rgb tinted(struct worker *w, const struct light_target *target, const struct light_sample *s,
	ray r, double limit)
{
	const struct light *light = s->light;
	const double distance = s->distance;
	rgb arriving = s->radiance;
	struct interior_stack inside;
	interior_stack_borrow(&inside, target->interiors);
	double from = 0;
	struct hit hit;
	while (w->scene->has_tinted_shadows && !rgb_is_zero(arriving) &&
		accel_nearest(w->scene->accel, &r, just_above(from + T_SHADOW), limit,
			RAY_SHADOW_TINTED, &hit)) {
		arriving = rgb_mul(arriving, crossing_tint(w, &hit, &r, hit.t - from, &inside));
		arriving = fogged(w, light, r, from, hit.t, &inside, arriving);
		interior_stack_toggle(&inside, object_interior(hit.object), w->light->passing);
		from = hit.t;
	}
	if (distance - from > T_SHADOW)
		arriving = fogged(w, light, r, from, distance, &inside, arriving);
	if (arena_used(w->light->passing) > 0)
		arena_reset(w->light->passing);
	return arriving;
}

/* Whether anything opaque is in the way; most often it is what was so at the neighbouring point. */
static bool is_blocked(const struct worker *w, const struct light *light, unsigned level,
	const ray *r, double limit)
{
	const struct object **last =
		&w->light->blockers[light->index * BLOCKER_LEVELS + level % BLOCKER_LEVELS];
	*last = accel_blocker(w->scene->accel, r, T_SHADOW, limit, RAY_SHADOW_OPAQUE, *last);
	return *last != NULL;
}

rgb shadow_filter(struct worker *w, const struct light_target *target, const struct light_sample *s)
{
	const struct light *light = s->light;
	const ray r = { target->point, s->direction };
	double limit = s->distance;
	if (light->projected_through) {
		struct hit gate;
		if (!object_nearest(light->projected_through, &r, T_MIN, s->distance, &gate))
			return rgb_grey(0);
		if (!light->kind->casts_shadows)
			return s->radiance;
		limit = gate.t; /* between gate and light nothing shades */
	}
	limit -= T_SHADOW;
	w->stats.shadow_rays++;
	if (limit > T_SHADOW && is_blocked(w, light, target->level, &r, limit))
		return rgb_grey(0);
	if (!w->scene->has_tinted_shadows && !w->light->has_fog)
		return s->radiance;
	return tinted(w, target, s, r, limit);
}
