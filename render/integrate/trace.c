/* SPDX-License-Identifier: MIT */
/*
 * The ray tree. A path is followed from surface to surface in a loop as long as
 * one ray goes on, so any number of clear surfaces costs no stack; only
 * reflections, and refractions that several textures bend differently, recurse.
 * Every stretch of the way is seen through the fog that fills it.
 */
#include "integrate.h"

#include "accel/accel.h"
#include "medium/fog.h"

#include <stdlib.h>

/* ---- worker ---- */

static struct integrate_memory *integrate_memory_create(
	const struct worker *w, unsigned width, unsigned height)
{
	const struct scene *scene = w->scene;
	struct integrate_memory *m = memory_alloc(1, sizeof *m);
	*m = (struct integrate_memory){ .width = width, .height = height };
	if (!scene->camera.kind->is_parallel)
		m->at_camera = interior_stack_at(scene, scene->camera.location, w->arena);
	return m;
}

struct worker *worker_create(const struct scene *scene, unsigned width, unsigned height)
{
	struct worker *w = memory_alloc(1, sizeof *w);
	worker_init(w, scene);
	w->surface = surface_memory_create();
	w->light = light_memory_create(w);
	w->integrate = integrate_memory_create(w, width, height);
	return w;
}

void worker_destroy(struct worker *w)
{
	if (!w)
		return;
	surface_memory_destroy(w->surface);
	light_memory_destroy(w->light);
	free(w->integrate);
	worker_finish(w);
	free(w);
}

/* ---- rays ---- */

/* To the next surface, *depth away, or to the sky. */
static struct radiance surface_or_sky(
	struct worker *w, struct path *path, struct transmission *onward, double *depth)
{
	const struct scene *scene = w->scene;
	struct hit hit;
	if (accel_nearest(scene->accel, &path->ray, T_MIN, T_MISS, path->kind, &hit)) {
		*depth = hit.t;
		return shade_hit(w, path, &hit, onward);
	}
	*depth = T_MISS;
	onward->present = false;
	return sky_radiance(scene, path->ray.direction, path->kind == RAY_REFLECTED);
}

/* One stretch, through the fog that fills it. */
static struct radiance stretch_trace(
	struct worker *w, struct path *path, struct transmission *onward)
{
	const struct scene *scene = w->scene;
	double depth;
	if (!path->straight)
		path->level++;
	if ((uint64_t)path->level > w->stats.max_level)
		w->stats.max_level = (uint64_t)path->level;
	if (!scene_is_foggy(scene) || !interior_stack_is_hollow(&path->inside))
		return surface_or_sky(w, path, onward, &depth);

	const ray r = path->ray; /* the path itself goes on */
	struct radiance radiance = surface_or_sky(w, path, onward, &depth);
	rgb factor, added;
	fog_effect(scene, r, depth, &factor, &added);
	radiance.light = rgb_add(added, rgb_mul(factor, radiance.light));
	radiance.transmit *= rgb_luminance(factor);
	if (onward->present) {
		onward->factor = rgb_mul(onward->factor, factor);
		onward->transmit *= rgb_luminance(factor);
	}
	return radiance;
}

/* Whether a ray that goes straight on starts where it started before: so far out that its step is
 * rounded away. It would go on forever. Any other comes nearer to the end of the scene with each step. */
static bool is_stuck(const struct path *path, vec3 before)
{
	const vec3 o = path->ray.origin;
	return path->straight && o.x == before.x && o.y == before.y && o.z == before.z;
}

struct radiance trace_path(struct worker *w, struct path *path)
{
	const struct settings *settings = &w->scene->settings;
	struct radiance sum = { 0 };
	rgb factor = rgb_grey(1);
	float transmit = 1;
	for (;;) {
		struct transmission onward;
		const vec3 origin = path->ray.origin;
		if (path->level >= settings->max_trace_level ||
			path->weight < settings->adc_bailout)
			break;
		const struct radiance radiance = stretch_trace(w, path, &onward);
		sum.light = rgb_add(sum.light, rgb_mul(factor, radiance.light));
		sum.transmit += transmit * radiance.transmit;
		if (!onward.present || is_stuck(path, origin))
			break;
		factor = rgb_mul(factor, onward.factor);
		transmit *= onward.transmit;
	}
	return sum;
}

colour trace_sample(struct worker *w, double x, double y, struct sample_place place)
{
	const struct scene *scene = w->scene;
	const struct integrate_memory *m = w->integrate;
	struct path path;
	if (!camera_ray(&scene->camera, x, y, m->width, m->height, &path.ray))
		return (colour){ .transmit = 1 };
	w->stats.camera_rays++;
	w->sample = sample_at(scene->settings.frame, place);
	path.weight = 1;
	path.level = 0;
	path.kind = RAY_CAMERA;
	path.vertex = SAMPLE_CAMERA_VERTEX;
	path.straight = false;
	if (scene->camera.kind->is_parallel)
		path.inside = interior_stack_at(scene, path.ray.origin, w->scratch);
	else
		interior_stack_borrow(&path.inside, &m->at_camera);

	const struct radiance radiance = trace_path(w, &path);
	if (arena_used(w->scratch) > 0)
		arena_reset(w->scratch);
	return (colour){ radiance.light.r, radiance.light.g, radiance.light.b, 0,
		radiance.transmit };
}
