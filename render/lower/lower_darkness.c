/* SPDX-License-Identifier: MIT */
/*
 * Warns of what leaves a picture black and its author looking for the reason:
 * no light, or a camera within something that no light is in.
 *
 * Only what is certain is said. An object counts as dark if it is opaque and only lamps would show
 * it: neither ambient and emission nor what it reflects.
 */
#include "lower/lower.h"

#include "geometry/shape.h"
#include "light/light.h"

#include <math.h>

/* A camera is inside of something if so is this much around it: it may stand on a floor. */
#define ROOM 1e-3
/* The light of its own that a surface was given to be seen by: more than the default ambient of 0.1. */
#define CHOSEN_GLOW 0.15f

static float brightest(rgb c)
{
	return fmaxf(c.r, fmaxf(c.g, c.b));
}

static bool layer_is_dark(const struct settings *s, const struct layer *layer)
{
	const struct finish *f = layer->finish;
	const rgb ambient = s->ambient_light;
	const float glow = brightest((rgb){ f->ambient.r * ambient.r, f->ambient.g * ambient.g,
				   f->ambient.b * ambient.b }) +
			   brightest(f->emission);
	const struct pigment *p = layer->pigment;
	const bool black =
		p->is_plain && brightest((rgb){ p->colour.r, p->colour.g, p->colour.b }) <= 0;
	return !black && glow < f->diffuse && glow < CHOSEN_GLOW &&
	       brightest(f->reflection_max) <= 0;
}

static bool texture_is_dark(const struct settings *s, const struct texture *t)
{
	if (!t || !t->opaque || !t->layer_count)
		return false;
	for (size_t i = 0; i < t->layer_count; i++)
		if (!layer_is_dark(s, &t->layers[i]))
			return false;
	return true;
}

static bool object_is_dark(const struct settings *s, const struct object *o)
{
	if (o->shape != &shape_csg)
		return texture_is_dark(s, o->texture) &&
		       !(o->extras && o->extras->interior_texture);
	const struct csg *csg = o->self;
	for (size_t i = 0; i < csg->count; i++)
		if (!object_is_dark(s, csg->children[i]))
			return false;
	return csg->count > 0;
}

/* ---- light ---- */

static void warn_of_no_light(struct lowering *l)
{
	const struct scene *scene = l->scene;
	for (size_t i = 0; i < scene->object_count; i++)
		if (object_is_dark(&scene->settings, scene->objects[i])) {
			diag_warning(l->diag, NO_SPAN,
				"the scene has no light_source: its surfaces show ambient and "
				"emission only");
			return;
		}
}

/* ---- the camera ---- */

static bool is_well_inside(const struct object *o, vec3 p)
{
	static const vec3 steps[] = { { 0, 0, 0 }, { ROOM, 0, 0 }, { -ROOM, 0, 0 }, { 0, ROOM, 0 },
		{ 0, -ROOM, 0 }, { 0, 0, ROOM }, { 0, 0, -ROOM } };
	for (size_t i = 0; i < sizeof steps / sizeof *steps; i++)
		if (!object_inside(o, vec_add(p, steps[i])))
			return false;
	return true;
}

/* Whether a lamp outside of the object cannot reach its inner side. */
static bool is_kept_out(const struct light *light, const struct object *o)
{
	return light->kind->casts_shadows && !object_inside(o, light->location);
}

static bool is_dark_within(const struct scene *scene, const struct object *o)
{
	const uint8_t needed = RAY_CAMERA | RAY_SHADOW_OPAQUE;
	if ((o->visible_to & needed) != needed || o->extras || !object_is_solid(o) ||
		!object_is_dark(&scene->settings, o))
		return false;
	for (size_t i = 0; i < scene->light_count; i++)
		if (!is_kept_out(scene->lights[i], o))
			return false;
	return true;
}

static void warn_of_camera_inside(struct lowering *l)
{
	const struct scene *scene = l->scene;
	const vec3 eye = scene->camera.location;
	for (size_t i = 0; i < scene->object_count; i++) {
		const struct object *o = scene->objects[i];
		if (!box_has(&o->bounds, eye) || !is_dark_within(scene, o) ||
			!is_well_inside(o, eye))
			continue;
		diag_warning(l->diag, l->camera_word,
			"the camera is inside an opaque %s, but no light_source is: its inner side "
			"is dark",
			o->shape == &shape_csg ? "object" : o->shape->name);
		return;
	}
}

void lower_warn_of_darkness(struct lowering *l)
{
	enum { LIT_QUALITY = 2 }; /* below, surfaces show their colours without light */
	const struct scene *scene = l->scene;
	if (scene->settings.quality < LIT_QUALITY || l->has_radiosity)
		return;
	if (!scene->light_count)
		warn_of_no_light(l);
	else if (!scene->camera.kind->is_parallel)
		warn_of_camera_inside(l);
}
