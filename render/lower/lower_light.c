/* SPDX-License-Identifier: MIT */
/*
 * light_source { location, colour items }: each type word replaces the type and
 * resets the cone; transformations move what has been read so far.
 */
#include "lower/lower.h"

#include "base/elementary.h"
#include "light/light.h"
#include "lower/draft.h"

#define RADIANS_PER_DEGREE 0.017453292519943296

/* Lights of one grid: every thread keeps one value for each. */
enum { AREA_LIGHTS_MAX = 1 << 22 };

static void set_kind(struct light *light, const struct light_class *kind)
{
	light->kind = kind;
	light->parallel |= kind->is_parallel;
	if (!kind->has_cone)
		return;
	light->tightness = 0;
	light->radius = kind->radius;
	light->falloff = kind->falloff;
}

static void need_cone(struct lowering *l, const struct node *item, const struct light *light)
{
	const bool point_at = item->keyword == K_POINT_AT;
	if (light->kind->has_cone || (point_at && light->parallel))
		return;
	diag_error(l->diag, item->word, "%s must come after spotlight%s in a light_source",
		keyword_name(item->keyword), point_at ? ", cylinder or parallel" : " or cylinder");
}

static void read_area(struct lowering *l, const struct node *item, struct light *light)
{
	light->area_u = lower_vector(l, item, 0, "its first axis");
	light->area_v = lower_vector(l, item, 1, "its second axis");
	light->area_count_u = lower_int(l, item, 2, "the number of lights along the first axis");
	light->area_count_v = lower_int(l, item, 3, "the number of lights along the second axis");
	if (light->area_count_u < 1 || light->area_count_v < 1)
		diag_error(
			l->diag, item->span, "area_light: the number of lights must be at least 1");
	else if (light->area_count_u > AREA_LIGHTS_MAX / light->area_count_v)
		diag_error(l->diag, item->span,
			"area_light: %d by %d lights are too many, at most %d are possible",
			light->area_count_u, light->area_count_v, AREA_LIGHTS_MAX);
}

static bool read_number(struct lowering *l, const struct node *item, struct light *light)
{
	double *target = NULL;
	switch (item->keyword) {
	case K_RADIUS:
		target = &light->radius;
		break;
	case K_FALLOFF:
		target = &light->falloff;
		break;
	case K_TIGHTNESS:
		target = &light->tightness;
		break;
	case K_FADE_DISTANCE:
		light->fade_distance = lower_float(l, item, 0, "a distance");
		return true;
	case K_FADE_POWER:
		light->fade_power = lower_float(l, item, 0, "a power");
		return true;
	case K_ADAPTIVE:
		light->adaptive = lower_int(l, item, 0, "a level");
		return true;
	default:
		return false;
	}
	need_cone(l, item, light);
	*target = lower_float(l, item, 0, "a number");
	return true;
}

static bool read_word(struct lowering *l, const struct node *item, struct light *light)
{
	const struct light_class *kind = light_find(keyword_name(item->keyword));
	if (kind) {
		set_kind(light, kind);
		return true;
	}
	switch (item->keyword) {
	case K_PARALLEL:
		light->parallel = true;
		return true;
	case K_POINT_AT:
		need_cone(l, item, light);
		light->point_at = lower_vector(l, item, 0, "a point");
		return true;
	case K_AREA_LIGHT:
		read_area(l, item, light);
		return true;
	case K_JITTER:
		light->jitter = true;
		return true;
	case K_CIRCULAR:
		light->circular = true;
		return true;
	case K_ORIENT:
		light->orient = light->circular = true;
		return true;
	case K_AREA_ILLUMINATION:
		light->area_illumination = lower_switch(l, item, true);
		return true;
	case K_MEDIA_ATTENUATION:
		light->media_attenuation = lower_switch(l, item, true);
		return true;
	case K_MEDIA_INTERACTION:
		light->media_interaction = lower_switch(l, item, true);
		return true;
	case K_PHOTONS:
		return true; /* no effect while there is no photon map */
	default:
		return false;
	}
}

void light_transform(struct light *light, const transform *t)
{
	light->location = transform_point(t, light->location);
	light->point_at = transform_point(t, light->point_at);
	light->area_u = transform_direction(t, light->area_u);
	light->area_v = transform_direction(t, light->area_v);
}

/* The object of looks_like stands at the light. */
static void read_attached(struct lowering *l, const struct node *item, struct draft *d)
{
	struct draft *object = draft_from_block(l, item);
	if (!object)
		return;
	if (item->keyword == K_LOOKS_LIKE) {
		struct step to_light = { .t = transform_translate(d->extras->light->location) };
		draft_transform(l, object, &to_light);
		if (d->extras->looks_like)
			diag_error(
				l->diag, item->span, "a light_source can have only one looks_like");
		draft_extras(l, d)->looks_like = object;
	} else {
		if (d->extras->projected_through)
			diag_error(l->diag, item->span,
				"a light_source can have only one projected_through");
		draft_extras(l, d)->projected_through = object;
	}
}

/* What cannot be rendered yet is refused when the light is used. */
static void check_area(struct lowering *l, const struct node *n, const struct light *light)
{
	const bool has_area = light->area_count_u > 0;
	if (light->orient && !node_child(n, K_CIRCULAR))
		diag_warning(l->diag, n->word, "orient makes an area_light circular");
	if (light->circular && (light->area_count_u < 2 || light->area_count_v < 2))
		diag_error(l->diag, n->span,
			"a circular area_light needs at least 2 lights along each axis");
	else if (light->area_illumination && !has_area)
		diag_warning(l->diag, n->span, "area_illumination needs area_light");
}

void lower_light_items(struct lowering *l, const struct node *n, struct draft *d)
{
	struct light *light = d->extras->light;
	light->location = lower_vector(l, n, 0, "a location");
	light->colour = lower_rgb(l, n, 1, "a colour");
	for (const struct node *item = n->children; item; item = item->next) {
		if (node_is_transform(item)) {
			struct step step = lower_step(l, item);
			draft_transform(l, d, &step);
		} else if (item->keyword == K_LOOKS_LIKE || item->keyword == K_PROJECTED_THROUGH) {
			read_attached(l, item, d);
		} else if (!read_word(l, item, light) && !read_number(l, item, light)) {
			lower_unsupported(l, item, keyword_name(item->keyword));
		}
	}
	check_area(l, n, light);
}

void light_defaults(struct light *light)
{
	*light = (struct light){ .kind = light_find("point"),
		.point_at = { 0, 0, 1 },
		.adaptive = 100,
		.media_interaction = true };
}

void light_finish(struct light *light)
{
	const vec3 axis = vec_sub(light->point_at, light->location);
	light->axis = vec_normalize(axis);
	if (light->kind->has_angles) {
		light->radius = elementary_cos(light->radius * RADIANS_PER_DEGREE);
		light->falloff = elementary_cos(light->falloff * RADIANS_PER_DEGREE);
	}
}
