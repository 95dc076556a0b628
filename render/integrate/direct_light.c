/* SPDX-License-Identifier: MIT */
/*
 * Direct light: what the lobes at a point send on of the light of each lamp. What
 * a lobe would make of a light is known before the shadow ray is, so light that
 * could not matter costs no shadow ray; the shadows of all that is left are asked
 * together, once for all lobes.
 */
#include "integrate.h"

/* What one lobe makes of one light. */
struct lit_lobe {
	bool shows; /* anything of it */
	struct brdf_value value;
};

/* The lights of one part of an interaction. */
struct lighting {
	struct worker *worker;
	const struct interaction *it;
	const struct layers *layers;
	struct light_target target;
	struct light_sample *samples; /* that matter */
	struct lit_lobe *lit;	      /* of each sample, each lobe */
	size_t count;
};

static unsigned how_it_lights(const struct lighting *l, const struct light *light)
{
	return (light->kind->makes_highlights ? BRDF_HIGHLIGHTS : 0) |
	       (l->it->object->double_illuminate ? BRDF_BOTH_SIDES : 0);
}

/* Whether a light that stands at one point is behind a lobe that shows nothing of such light. This
 * is seen before its direction is made unit: a sine of rounding errors is no cosine of 1e-10. */
static bool is_behind(const struct lighting *l, const struct lobe *lobe, const struct light *light)
{
	if (light->parallel || lobe->finish->diffuse_back != 0 || light->area_illumination ||
		l->it->object->double_illuminate)
		return false;
	return vec_dot(lobe->normal, vec_sub(light->location, l->target.point)) <= 0;
}

/* Takes up a light if some lobe shows something of it. */
static void light_add(struct lighting *l, const struct light *light)
{
	struct light_sample *s = &l->samples[l->count];
	struct lit_lobe *lit = &l->lit[l->count * l->layers->count];
	const bool spread = light_is_spread(l->worker, light);
	const unsigned how =
		how_it_lights(l, light) | (light->area_illumination ? BRDF_BOTH_SIDES : 0);
	bool is_aimed = false, matters = false;
	for (size_t i = 0; i < l->layers->count; i++) {
		const struct lobe *lobe = &l->layers->lobes[i];
		lit[i].shows = false;
		if (!lobe_scatters(lobe) || (!spread && is_behind(l, lobe, light)))
			continue;
		if (!is_aimed)
			*s = light_aim(l->worker, light, l->target.point);
		is_aimed = true;
		if (rgb_is_dark(s->radiance))
			return;
		lit[i].shows = spread || brdf_eval(l->it, lobe, s->direction, how, &lit[i].value);
		matters |= lit[i].shows;
	}
	l->count += matters;
}

/* area_illumination: each light of the grid lights by itself, under the common shadow. */
static rgb grid_light(
	const struct lighting *l, const struct lobe *lobe, const struct light_sample *whole)
{
	const struct light *light = whole->light;
	const unsigned how = how_it_lights(l, light);
	const struct light_grid grid = light_grid_of(whole);
	rgb sum = rgb_grey(0);
	for (int v = 0; v < light->area_count_v; v++) {
		for (int u = 0; u < light->area_count_u; u++) {
			const struct light_sample s =
				light_grid_sample(l->worker, &l->target, &grid, u, v);
			struct brdf_value value;
			if (brdf_eval(l->it, lobe, s.direction, how, &value))
				sum = rgb_add(sum, brdf_reflect(l->worker, l->it, lobe, s.direction,
							   &value, s.radiance, s.number));
		}
	}
	return sum;
}

/* What lobe number i sends on of all lights. */
static rgb lobe_light(const struct lighting *l, size_t i)
{
	const struct lobe *lobe = &l->layers->lobes[i];
	rgb sum = rgb_grey(0);
	for (size_t k = 0; k < l->count; k++) {
		const struct light_sample *s = &l->samples[k];
		const struct lit_lobe *lit = &l->lit[k * l->layers->count + i];
		if (!lit->shows || rgb_is_dark(s->radiance))
			continue;
		sum = rgb_add(sum, light_is_spread(l->worker, s->light)
					   ? grid_light(l, lobe, s)
					   : brdf_reflect(l->worker, l->it, lobe, s->direction,
						     &lit->value, s->radiance, s->number));
	}
	return sum;
}

/* Ambient light and what the lobe emits. */
static rgb own_light(const struct lighting *l, const struct lobe *lobe)
{
	const struct finish *f = lobe->finish;
	const rgb pigment = rgb_scale(lobe->pigment, lobe->own);
	rgb light = rgb_grey(0);
	if (!rgb_is_zero(f->ambient))
		light = rgb_mul(
			rgb_mul(pigment, f->ambient), l->worker->scene->settings.ambient_light);
	if (!rgb_is_zero(f->emission))
		light = rgb_add(light, rgb_mul(pigment, f->emission));
	return light;
}

static size_t group_light_count(const struct light *const *lights)
{
	size_t n = 0;
	while (lights && lights[n])
		n++;
	return n;
}

/* Room for all lights of the object; what is there belongs to the part at hand. */
static void lighting_begin(struct lighting *l, size_t lights)
{
	struct integrate_memory *m = l->worker->integrate;
	if (m->sample_room < lights) {
		m->sample_room = lights;
		m->samples = memory_grow(m->samples, lights, sizeof *m->samples);
	}
	if (m->lit_room < lights * l->layers->count) {
		m->lit_room = lights * l->layers->count;
		m->lit = memory_grow(m->lit, m->lit_room, sizeof *m->lit);
	}
	l->samples = m->samples;
	l->lit = m->lit;
	l->count = 0;
}

/* Takes up the lights that matter and finds what arrives of them. */
static void lighting_find(struct lighting *l)
{
	const struct scene *scene = l->worker->scene;
	const struct object *object = l->it->object;
	const struct light *const *group = object->extras ? object->extras->lights : NULL;
	const size_t global_count = object->global_lights ? scene->global_light_count : 0;
	const size_t group_count = group_light_count(group);
	lighting_begin(l, global_count + group_count);
	for (size_t i = 0; i < global_count; i++)
		light_add(l, scene->global_lights[i]);
	for (size_t i = 0; i < group_count; i++)
		light_add(l, group[i]);
	if (l->count > 0)
		light_arriving(l->worker, &l->target, l->samples, l->count);
}

static bool some_lobe_scatters(const struct layers *layers)
{
	for (size_t i = 0; i < layers->count; i++) {
		if (lobe_scatters(&layers->lobes[i]))
			return true;
	}
	return false;
}

rgb direct_light(struct worker *w, const struct path *path, const struct interaction *it,
	const struct layers *layers)
{
	struct lighting l; /* field by field: a surface without lights needs few of them */
	l.worker = w;
	l.it = it;
	l.layers = layers;
	l.count = 0;
	if (some_lobe_scatters(layers)) {
		l.target = (struct light_target){ it->surface.point, it->interiors,
			(unsigned)path->level, it->vertex };
		lighting_find(&l);
	}
	rgb sum = rgb_grey(0);
	for (size_t i = 0; i < layers->count; i++) {
		const struct lobe *lobe = &layers->lobes[i];
		const rgb light = rgb_add(own_light(&l, lobe), lobe_light(&l, i));
		sum = rgb_add(sum, rgb_mul(lobe->weight, light));
	}
	return sum;
}
