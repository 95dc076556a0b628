/* SPDX-License-Identifier: MIT */
/*
 * The ray tree. A path is followed from surface to surface in a loop as long as
 * one ray goes on, so any number of clear surfaces costs no stack; only
 * reflections, and refractions that several textures bend differently, recurse.
 * Every stretch of the way is seen through the fog that fills it.
 */
#include "shading.h"

#include "base/random.h"

#include <stdlib.h>

/* ---- worker ---- */

static bool is_foggy(const struct scene *scene)
{
	return scene->fog_count > 0 && scene->settings.quality >= 9;
}

static void gather_lights(struct worker *w)
{
	const struct scene *scene = w->scene;
	w->lights = ARENA_ARRAY(w->arena, scene->light_count, const struct light *);
	w->blockers =
		ARENA_ARRAY(w->arena, scene->light_count * BLOCKER_LEVELS, const struct object *);
	for (size_t i = 0; i < scene->light_count; i++) {
		const struct light *light = scene->lights[i];
		for (int level = 0; level < BLOCKER_LEVELS; level++)
			w->blockers[i * BLOCKER_LEVELS + (size_t)level] = NULL;
		if (!light->group_only)
			w->lights[w->light_count++] = light;
		if (is_foggy(scene) && light->media_attenuation && light->media_interaction)
			w->has_shadow_fog = true;
	}
}

struct worker *worker_create(const struct scene *scene, unsigned width, unsigned height)
{
	struct worker *w = memory_alloc(1, sizeof *w);
	*w = (struct worker){ .scene = scene, .width = width, .height = height };
	w->arena = arena_create(0);
	w->scratch = arena_create(0);
	w->shadow = arena_create(0);
	gather_lights(w);
	w->origin_moves = scene->camera.type == CAMERA_ORTHOGRAPHIC;
	if (!w->origin_moves)
		w->at_camera = containment_at(scene, scene->camera.location, w->arena);
	return w;
}

void worker_destroy(struct worker *w)
{
	if (!w)
		return;
	free(w->parts);
	free(w->reflections);
	free(w->incidences);
	free(w->grid);
	arena_destroy(w->arena);
	arena_destroy(w->scratch);
	arena_destroy(w->shadow);
	free(w);
}

const struct trace_stats *worker_stats(const struct worker *w)
{
	return &w->stats;
}

double worker_random(struct worker *w)
{
	return random_unit(random_mix(w->sample_key, w->draws++));
}

/* ---- rays ---- */

/* To the next surface, *depth away, or to the sky. */
static struct seen surface_or_sky(
	struct worker *w, struct path *path, struct passage *onward, double *depth)
{
	const struct scene *scene = w->scene;
	struct hit hit;
	if (accel_nearest(scene->accel, &path->ray, T_MIN, T_MISS, path->kind, &hit)) {
		*depth = hit.t;
		return shade_hit(w, path, &hit, onward);
	}
	*depth = T_MISS;
	onward->present = false;
	return sky_seen(scene, path->ray.direction, path->kind == RAY_REFLECTED);
}

/* One stretch, through the fog that fills it. */
static struct seen stretch_trace(struct worker *w, struct path *path, struct passage *onward)
{
	const struct scene *scene = w->scene;
	double depth;
	if (!path->straight)
		path->level++;
	if ((uint64_t)path->level > w->stats.max_level)
		w->stats.max_level = (uint64_t)path->level;
	if (!is_foggy(scene) || !containment_is_hollow(&path->inside))
		return surface_or_sky(w, path, onward, &depth);

	const ray r = path->ray; /* the path itself goes on */
	struct seen seen = surface_or_sky(w, path, onward, &depth);
	rgb factor, added;
	fog_effect(scene, r, depth, &factor, &added);
	seen.light = rgb_add(added, rgb_mul(factor, seen.light));
	seen.transmit *= rgb_luminance(factor);
	if (onward->present) {
		onward->factor = rgb_mul(onward->factor, factor);
		onward->transmit *= rgb_luminance(factor);
	}
	return seen;
}

/* Whether a ray that goes straight on starts where it started before: so far out that its step is
 * rounded away. It would go on forever. Any other comes nearer to the end of the scene with each step. */
static bool is_stuck(const struct path *path, vec3 before)
{
	const vec3 o = path->ray.origin;
	return path->straight && o.x == before.x && o.y == before.y && o.z == before.z;
}

struct seen trace_path(struct worker *w, struct path *path)
{
	const struct settings *settings = &w->scene->settings;
	struct seen sum = { 0 };
	rgb factor = rgb_grey(1);
	float transmit = 1;
	for (;;) {
		struct passage onward;
		const vec3 origin = path->ray.origin;
		if (path->level >= settings->max_trace_level ||
			path->weight < settings->adc_bailout)
			break;
		const struct seen seen = stretch_trace(w, path, &onward);
		sum.light = rgb_add(sum.light, rgb_mul(factor, seen.light));
		sum.transmit += transmit * seen.transmit;
		if (!onward.present || is_stuck(path, origin))
			break;
		factor = rgb_mul(factor, onward.factor);
		transmit *= onward.transmit;
	}
	return sum;
}

colour trace_sample(struct worker *w, double x, double y)
{
	const struct scene *scene = w->scene;
	struct path path;
	if (!camera_ray(&scene->camera, x, y, w->width, w->height, &path.ray))
		return (colour){ .transmit = 1 };
	w->stats.camera_rays++;
	w->sample_key = random_key(x, y);
	w->draws = 0;
	path.weight = 1;
	path.level = 0;
	path.kind = RAY_CAMERA;
	path.straight = false;
	if (w->origin_moves)
		path.inside = containment_at(scene, path.ray.origin, w->scratch);
	else
		containment_borrow(&path.inside, &w->at_camera);

	const struct seen seen = trace_path(w, &path);
	if (arena_used(w->scratch) > 0)
		arena_reset(w->scratch);
	return (colour){ seen.light.r, seen.light.g, seen.light.b, 0, seen.transmit };
}
