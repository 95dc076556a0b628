/* SPDX-License-Identifier: MIT */
/*
 * The light that arrives at a point: where each light stands as seen from there,
 * then shadows. By quality there are no shadows below 4, and area lights are
 * points below 5.
 */
#include "arriving/arriving.h"

#include "medium/fog.h"
#include "shadow.h"

#include <stdlib.h>

static bool has_fog(const struct scene *scene)
{
	for (size_t i = 0; i < scene->light_count; i++) {
		const struct light *light = scene->lights[i];
		if (light->media_attenuation && light->media_interaction)
			return scene_is_foggy(scene);
	}
	return false;
}

struct light_memory *light_memory_create(const struct worker *w)
{
	const size_t blockers = w->scene->light_count * BLOCKER_LEVELS;
	struct light_memory *m = memory_alloc(1, sizeof *m);
	*m = (struct light_memory){ .has_fog = has_fog(w->scene), .passing = arena_create(0) };
	m->blockers = ARENA_ARRAY(w->arena, blockers, const struct object *);
	return m;
}

void light_memory_destroy(struct light_memory *m)
{
	arena_destroy(m->passing);
	free(m->grid);
	free(m);
}

static bool is_area(const struct worker *w, const struct light *light)
{
	return light->area_count_u > 0 && w->scene->settings.quality >= 5;
}

/* The lights of a spread grid are attenuated one by one. */
bool light_aim(
	const struct worker *w, const struct light *light, const vec3 *p, struct light_sample *s)
{
	s->light = light;
	s->number = light->index;
	s->distance = light_direction(light, light->location, *p, &s->direction);
	s->radiance = light->colour;
	if (!light_attenuates(light) || light_is_spread(w, light))
		return true;
	s->radiance =
		rgb_scale(s->radiance, light_attenuation(light, p, &s->direction, s->distance));
	return !rgb_is_dark(s->radiance);
}

void light_arriving(struct worker *w, const struct light_target *target,
	struct light_sample *samples, size_t count)
{
	if (w->scene->settings.quality < 4)
		return;
	for (size_t i = 0; i < count; i++) {
		struct light_sample *s = &samples[i];
		if (!s->light->kind->casts_shadows && !s->light->projected_through)
			continue;
		s->radiance = is_area(w, s->light) ? area_light_filter(w, target, s)
						   : shadow_filter(w, target, s);
	}
}

struct light_grid light_grid_of(
	const struct worker *w, const struct light_target *target, const struct light_sample *whole)
{
	const struct light *light = whole->light;
	const int count = light->area_count_u * light->area_count_v;
	return (struct light_grid){ whole, area_light_axes(light, whole->direction),
		rgb_scale(whole->radiance, 1.0 / count), area_light_jitter(w, target, light) };
}

void light_grid_sample(const struct worker *w, const struct light_target *target,
	const struct light_grid *grid, int u, int v, struct light_sample *s)
{
	const struct light *light = grid->whole->light;
	const vec3 centre = area_light_point(light, &grid->axes, &grid->jitter, u, v);
	const uint32_t cell = (uint32_t)(v * light->area_count_u + u);
	s->light = light;
	s->number = light->index + cell * (uint32_t)w->scene->light_count;
	s->distance = light_direction(light, centre, target->point, &s->direction);
	s->radiance = grid->share;
	if (light_attenuates(light))
		s->radiance = rgb_scale(s->radiance,
			light_attenuation(light, &target->point, &s->direction, s->distance));
}
