/* SPDX-License-Identifier: MIT */
/*
 * The life of a scene: created empty, filled by lowering, committed, traced,
 * destroyed.
 */
#include "scene/scene.h"

#include "accel/accel.h"

#include <stdlib.h>

/* Objects with a larger box are asked first, as unbounded ones are. */
#define VOLUME_UNBOUNDED 2e10
/* With fewer objects and lights than this the order of declaration is the order of asking. */
enum { HIERARCHY_MIN = 3 };

struct scene *scene_create(void)
{
	struct arena *arena = arena_create(0);
	struct scene *scene = ARENA_NEW(arena, struct scene);
	scene->arena = arena;
	return scene;
}

/* All but the growing arrays is in the arena. */
void scene_destroy(struct scene *scene)
{
	if (!scene)
		return;
	accel_destroy(scene->accel);
	free(scene->objects);
	free(scene->lights);
	pointer_map_release(&scene->ridged_tables);
	arena_destroy(scene->arena);
}

static bool counts_as_unbounded(const struct object *o)
{
	const vec3 size = vec_sub(o->bounds.hi, o->bounds.lo);
	return box_is_unbounded(o->bounds) || size.x * size.y * size.z > VOLUME_UNBOUNDED;
}

/* Exact ties go to unbounded objects first, then to what was declared first. */
static void rank_objects(struct scene *scene)
{
	const bool by_declaration = scene->object_count + scene->light_count < HIERARCHY_MIN;
	uint32_t rank = 0;
	for (int bounded = 0; bounded < 2; bounded++) {
		for (size_t i = 0; i < scene->object_count; i++) {
			struct object *o = scene->objects[i];
			if (by_declaration ? !bounded : !bounded == counts_as_unbounded(o))
				o->rank = rank++;
		}
	}
}

static void set_flags(struct scene *scene)
{
	for (size_t i = 0; i < scene->object_count; i++)
		scene->has_tinted_shadows |=
			(scene->objects[i]->visible_to & RAY_SHADOW_TINTED) != 0;
}

static void number_lights(struct scene *scene)
{
	scene->global_lights = ARENA_ARRAY(scene->arena, scene->light_count, const struct light *);
	for (size_t i = 0; i < scene->light_count; i++) {
		struct light *light = scene->lights[i];
		light->index = (uint32_t)i;
		if (!light->group_only && !rgb_is_dark(light->colour))
			scene->global_lights[scene->global_light_count++] = light;
	}
}

void scene_commit(struct scene *scene, unsigned threads)
{
	rank_objects(scene);
	number_lights(scene);
	set_flags(scene);
	scene->accel = accel_build(scene->objects, scene->object_count, threads);
}
