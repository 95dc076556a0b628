/* SPDX-License-Identifier: MIT */
/*
 * Direct light: what the lobes at a point send on of the light of each lamp. What
 * a lobe would make of a light is known before the shadow ray is, so light that
 * could not matter costs no shadow ray, and one shadow ray serves all lobes.
 */
#include "integrate.h"

/* A lobe that scatters light, and what it makes of the light at hand. */
struct lit_lobe {
	const struct lobe *lobe;
	bool has_back; /* light from behind matters, too */
	bool shows;
	struct brdf_value value;
	rgb sum; /* sent on of all lights so far */
};

struct lighting {
	struct worker *worker;
	const struct interaction *it;
	struct light_target target;
	bool both_sides; /* double_illuminate */
	struct lit_lobe *lit, *end;
};

static unsigned how_it_lights(const struct light *light, bool both_sides)
{
	return (light->kind->makes_highlights ? BRDF_HIGHLIGHTS : 0) |
	       (both_sides ? BRDF_BOTH_SIDES : 0);
}

/* Whether a light that stands at one point is behind a lobe that shows nothing of such light. This
 * is seen before its direction is made unit: a sine of rounding errors is no cosine of 1e-10. */
static bool is_behind(
	const struct lighting *l, const struct lit_lobe *lit, const struct light *light)
{
	if (lit->has_back || light->parallel || light->area_illumination)
		return false;
	return vec_dot(lit->lobe->normal, vec_sub(light->location, l->target.point)) <= 0;
}

static bool lobe_shows(const struct lighting *l, struct lit_lobe *lit, const struct light *light,
	const struct light_sample *s)
{
	if (light_is_spread(l->worker, light))
		return true;
	const bool both_sides = l->both_sides || light->area_illumination;
	return brdf_eval(
		l->it, lit->lobe, &s->direction, how_it_lights(light, both_sides), &lit->value);
}

/* Whether some lobe shows anything of a light; if so, *s is what it sends. */
static bool light_matters(struct lighting *l, const struct light *light, struct light_sample *s)
{
	bool is_aimed = false, matters = false;
	for (struct lit_lobe *lit = l->lit; lit < l->end; lit++) {
		lit->shows = false;
		if (is_behind(l, lit, light))
			continue;
		if (!is_aimed) {
			if (!light_aim(l->worker, light, &l->target.point, s))
				return false;
			is_aimed = true;
		}
		lit->shows = lobe_shows(l, lit, light, s);
		matters |= lit->shows;
	}
	return matters;
}

/* area_illumination: each light of the grid lights by itself, under the common shadow. */
static rgb grid_light(
	const struct lighting *l, const struct lobe *lobe, const struct light_sample *whole)
{
	const struct light *light = whole->light;
	const unsigned how = how_it_lights(light, l->both_sides);
	const struct light_grid grid = light_grid_of(l->worker, &l->target, whole);
	rgb sum = rgb_grey(0);
	for (int v = 0; v < light->area_count_v; v++) {
		for (int u = 0; u < light->area_count_u; u++) {
			struct light_sample s;
			struct brdf_value value;
			light_grid_sample(l->worker, &l->target, &grid, u, v, &s);
			if (brdf_eval(l->it, lobe, &s.direction, how, &value))
				sum = rgb_add(
					sum, brdf_reflect(l->worker, l->it, lobe, &s.direction,
						     &value, s.radiance, s.number));
		}
	}
	return sum;
}

static void light_add(struct lighting *l, const struct light *light)
{
	struct light_sample s;
	if (!light_matters(l, light, &s))
		return;
	light_arriving(l->worker, &l->target, &s, 1);
	if (rgb_is_dark(s.radiance))
		return;
	for (struct lit_lobe *lit = l->lit; lit < l->end; lit++) {
		if (!lit->shows)
			continue;
		const rgb sent = light_is_spread(l->worker, light)
					 ? grid_light(l, lit->lobe, &s)
					 : brdf_reflect(l->worker, l->it, lit->lobe, &s.direction,
						   &lit->value, s.radiance, s.number);
		lit->sum = rgb_add(lit->sum, sent);
	}
}

/* All lights: those of the scene, and those of the groups the object is in. */
static void lights_add(struct lighting *l)
{
	const struct scene *scene = l->worker->scene;
	const struct object *object = l->it->object;
	if (object->global_lights) {
		for (size_t i = 0; i < scene->global_light_count; i++)
			light_add(l, scene->global_lights[i]);
	}
	const struct light *const *group = object->extras ? object->extras->lights : NULL;
	for (; group && *group; group++)
		light_add(l, *group);
}

/* Ambient light and what the lobe emits. */
static rgb own_light(const struct worker *w, const struct lobe *lobe)
{
	const struct finish *f = lobe->finish;
	const rgb pigment = rgb_scale(lobe->pigment, lobe->own);
	rgb light = rgb_grey(0);
	if (!rgb_is_zero(f->ambient))
		light = rgb_mul(rgb_mul(pigment, f->ambient), w->scene->settings.ambient_light);
	if (!rgb_is_zero(f->emission))
		light = rgb_add(light, rgb_mul(pigment, f->emission));
	return light;
}

/* Takes up the lobes that scatter light. */
static void lobes_add(struct lighting *l, const struct layers *layers)
{
	l->end = l->lit;
	for (size_t i = 0; i < layers->count; i++) {
		const struct lobe *lobe = &layers->lobes[i];
		if (!lobe_scatters(lobe))
			continue;
		l->end->lobe = lobe;
		l->end->has_back = l->both_sides || lobe->finish->diffuse_back != 0;
		l->end->sum = rgb_grey(0);
		l->end++;
	}
}

rgb direct_light(struct worker *w, const struct path *path, const struct interaction *it,
	const struct layers *layers)
{
	struct lit_lobe few[LOBES_FEW];
	struct lighting l; /* field by field: a surface without lights needs few of them */
	l.worker = w;
	l.it = it;
	l.both_sides = it->object->double_illuminate;
	l.lit = layers->count <= LOBES_FEW
			? few
			: ARENA_ARRAY(w->scratch, layers->count, struct lit_lobe);
	lobes_add(&l, layers);
	if (l.end > l.lit) {
		l.target = (struct light_target){ it->surface.point, it->interiors,
			(unsigned)path->level, it->vertex };
		lights_add(&l);
	}
	rgb sum = rgb_grey(0);
	const struct lit_lobe *lit = l.lit;
	for (size_t i = 0; i < layers->count; i++) {
		const struct lobe *lobe = &layers->lobes[i];
		rgb light = own_light(w, lobe);
		if (lit < l.end && lit->lobe == lobe)
			light = rgb_add(light, lit++->sum);
		sum = rgb_add(sum, rgb_mul(lobe->weight, light));
	}
	return sum;
}
