/* SPDX-License-Identifier: MIT */
/*
 * Shadow rays. Anything opaque ends the light, and that is asked first, without
 * looking at a texture. Only then, and only in scenes that have such objects,
 * the surfaces that let light through are visited in order, each tinting it.
 */
#include "shading.h"

#include "base/elementary.h"

#include <float.h>

/* The share of light one plain texture lets through. */
static rgb layers_tint(
	const struct worker *w, struct surface *s, const struct texture_part *part, double caustics)
{
	rgb tint = rgb_grey(1);
	for (size_t i = 0; i < part->texture->layer_count; i++) {
		const struct layer *layer = &part->texture->layers[i];
		const vec3 normal = layer_normal(w, part, layer, s);
		colour c;
		if (pigment_colour(layer->pigment, part->p, s, &c))
			tint = rgb_mul(tint, colour_tint(c));
		if (caustics != 0)
			tint = rgb_scale(tint,
				1 + elementary_pow(fabs(vec_dot(normal, s->direction)), caustics));
	}
	return tint;
}

static rgb patterned_tint(
	struct worker *w, struct surface *s, const struct texture *texture, vec3 p, double caustics)
{
	const size_t first = parts_resolve(w, texture, p, s);
	rgb tint = rgb_grey(0);
	for (size_t i = first; i < w->part_count; i++) {
		const struct texture_part *part = &w->parts[i];
		tint = rgb_add(tint, rgb_scale(layers_tint(w, s, part, caustics), part->weight));
	}
	w->part_count = first;
	return tint;
}

/* What one crossing lets through; `length` is the way since the crossing before. */
static rgb crossing_tint(struct worker *w, const struct hit *hit, ray r, double length,
	const struct containment *inside)
{
	const struct interior *interior = object_interior(hit->object);
	struct surface s;
	vec3 p;
	const struct texture *texture = surface_open(&s, hit, &r, &p);
	rgb tint;
	if (texture->layer_count > 0) {
		const struct texture_part whole = { .texture = texture, .weight = 1, .p = p };
		tint = layers_tint(w, &s, &whole, interior->caustics);
	} else {
		tint = patterned_tint(w, &s, texture, p, interior->caustics);
	}
	if (interior->fade_power > 0 && containment_has(inside, interior))
		tint = rgb_mul(tint, interior_fading(interior, length));
	return tint;
}

static rgb fogged(struct worker *w, const struct light *light, ray r, double from, double to,
	const struct containment *inside, rgb arriving)
{
	if (!w->has_shadow_fog || !light->media_attenuation || !light->media_interaction)
		return arriving;
	if (!containment_is_hollow(inside))
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
static rgb tinted(struct worker *w, const struct light *light, const struct point *at, ray r,
	double limit, double distance, rgb arriving)
{
	struct containment inside;
	containment_borrow(&inside, &at->path->inside);
	double from = 0;
	struct hit hit;
	while (w->scene->has_tinted_shadows && !rgb_is_zero(arriving) &&
		accel_nearest(w->scene->accel, &r, just_above(from + T_SHADOW), limit,
			RAY_SHADOW_TINTED, &hit)) {
		arriving = rgb_mul(arriving, crossing_tint(w, &hit, r, hit.t - from, &inside));
		arriving = fogged(w, light, r, from, hit.t, &inside, arriving);
		containment_toggle(&inside, object_interior(hit.object), w->shadow);
		from = hit.t;
	}
	if (distance - from > T_SHADOW)
		arriving = fogged(w, light, r, from, distance, &inside, arriving);
	if (arena_used(w->shadow) > 0)
		arena_reset(w->shadow);
	return arriving;
}

/* Whether anything opaque is in the way; most often it is what was so at the neighbouring point. */
static bool is_blocked(struct worker *w, const struct light *light, const struct point *at,
	const ray *r, double limit)
{
	const unsigned level = (unsigned)at->path->level % BLOCKER_LEVELS;
	const struct object **last = &w->blockers[light->index * BLOCKER_LEVELS + level];
	*last = accel_blocker(w->scene->accel, r, T_SHADOW, limit, RAY_SHADOW_OPAQUE, *last);
	return *last != NULL;
}

rgb shadow_filter(struct worker *w, const struct light *light, const struct point *at,
	vec3 direction, double distance, rgb arriving)
{
	const struct scene *scene = w->scene;
	const ray r = { at->surface.point, direction };
	double limit = distance;
	if (light->projected_through) {
		struct hit gate;
		if (!object_nearest(light->projected_through, &r, T_MIN, distance, &gate))
			return rgb_grey(0);
		if (light->type == LIGHT_SHADOWLESS)
			return arriving;
		limit = gate.t; /* between gate and light nothing shades */
	}
	limit -= T_SHADOW;
	w->stats.shadow_rays++;
	if (limit > T_SHADOW && is_blocked(w, light, at, &r, limit))
		return rgb_grey(0);
	if (!scene->has_tinted_shadows && !w->has_shadow_fog)
		return arriving;
	return tinted(w, light, at, r, limit, distance, arriving);
}
