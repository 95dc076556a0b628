/* SPDX-License-Identifier: MIT */
/*
 * Making an interaction of a hit: the normal turned against the ray, the side's
 * texture, where to evaluate it, and its parts. A plain texture is its own only
 * part and costs nothing more.
 */
#include "surface/interaction.h"

#include <stdlib.h>

/* The parts of the interaction at hand. */
struct surface_memory {
	struct texture_parts parts;
};

struct surface_memory *surface_memory_create(void)
{
	struct surface_memory *m = memory_alloc(1, sizeof *m);
	*m = (struct surface_memory){ 0 };
	return m;
}

void surface_memory_destroy(struct surface_memory *m)
{
	if (!m)
		return;
	free(m->parts.items);
	free(m);
}

/* Fills in the geometry; returns the texture of the side that was hit. */
static const struct texture *surface_open(struct surface *s, const struct hit *hit, const ray *r)
{
	const struct object *object = hit->object;
	s->point = ray_at(*r, hit->t);
	s->direction = r->direction;
	s->hit = hit;
	s->geometric = object_normal(hit, s->point);
	const bool back = vec_dot(s->geometric, s->direction) > 0;
	if (back)
		s->geometric = vec_negate(s->geometric);
	s->current = s->geometric;
	if (back && object->extras && object->extras->interior_texture)
		return object->extras->interior_texture;
	return object->texture;
}

static vec3 evaluation_point(const struct texture *texture, const struct surface *s)
{
	if (!texture->uses_uv)
		return s->point;
	double uv[2];
	object_uv(s->hit, s->point, uv);
	return vec(uv[0], uv[1], 0);
}

void interaction_make(struct worker *w, struct interaction *it, const struct hit *hit, const ray *r,
	const struct interior_stack *interiors, uint32_t vertex)
{
	it->object = hit->object;
	it->interiors = interiors;
	it->depth = hit->t;
	it->vertex = vertex;
	const struct texture *texture = surface_open(&it->surface, hit, r);
	const vec3 p = evaluation_point(texture, &it->surface);
	if (texture->layer_count > 0) {
		it->whole = (struct texture_part){ .texture = texture, .weight = 1, .p = p };
		it->parts = &it->whole;
		it->part_count = 1;
		return;
	}
	struct texture_parts *parts = &w->surface->parts;
	parts->count = 0;
	texture_resolve(texture, p, &it->surface, parts, w->scratch);
	it->parts = parts->items;
	it->part_count = parts->count;
}

void interaction_keep(struct worker *w, struct interaction *it)
{
	if (it->parts != &it->whole)
		it->parts = arena_copy(w->scratch, it->parts, it->part_count * sizeof *it->parts);
}
