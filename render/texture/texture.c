/* SPDX-License-Identifier: MIT */
/*
 * Resolving patterned textures at a point into plain ones with weights. Colours are
 * blended after shading, so all a patterned texture does is choose.
 */
#include "texture/texture_map.h"

#include "base/arena.h"
#include "texture/pigment.h"

struct resolving {
	struct surface *surface;
	struct texture_parts *parts;
	struct arena *scratch;
};

static void resolve(struct resolving *, const struct texture *, vec3 p, float weight,
	const struct texture_frame *);

/* The frame for the entries of `map`; a map that does not turn directions needs none. */
static const struct texture_frame *frame_push(
	struct resolving *r, const struct texture_map *map, const struct texture_frame *outer)
{
	if (!map->pattern.frame)
		return outer;
	struct texture_frame *frame = ARENA_NEW(r->scratch, struct texture_frame);
	*frame = (struct texture_frame){ outer, map };
	return frame;
}

static void resolve_map(struct resolving *r, const struct texture_map *map, vec3 p, float weight,
	const struct texture_frame *outer)
{
	const struct texture_frame *frame = frame_push(r, map, outer);
	const vec3 q = pattern_warp(&map->pattern, p);
	if (map->kind == TEXTURE_AVERAGE) {
		for (size_t i = 0; i < map->map.count; i++)
			resolve(r, map->textures[i], q,
				weight * (map->map.values[i] / map->total_weight), frame);
		return;
	}
	const double v = pattern_value(&map->pattern, q, r->surface);
	const struct blend b = map_lookup(&map->map, v);
	if (b.low == b.high) {
		resolve(r, map->textures[b.low], q, weight, frame);
		return;
	}
	resolve(r, map->textures[b.low], q, (float)((double)weight * (1 - b.share)), frame);
	resolve(r, map->textures[b.high], q, (float)((double)weight * b.share), frame);
}

static void part_push(struct texture_parts *parts, struct texture_part part)
{
	if (parts->count == parts->room) {
		parts->room = parts->room ? 2 * parts->room : 16;
		parts->items = memory_grow(parts->items, parts->room, sizeof *parts->items);
	}
	parts->items[parts->count++] = part;
}

static void resolve(struct resolving *r, const struct texture *texture, vec3 p, float weight,
	const struct texture_frame *frame)
{
	if (texture->uses_uv)
		p = surface_uv_point(r->surface);
	if (texture->layer_count == 0) {
		if (texture->map->kind == TEXTURE_UV)
			resolve(r, texture->map->textures[0], surface_uv_point(r->surface), weight,
				frame);
		else
			resolve_map(r, texture->map, p, weight, frame);
		return;
	}
	part_push(r->parts, (struct texture_part){ texture, weight, p, frame });
}

void texture_resolve(const struct texture *texture, vec3 p, struct surface *surface,
	struct texture_parts *parts, struct arena *scratch)
{
	resolve(&(struct resolving){ surface, parts, scratch }, texture, p, 1, NULL);
}

static vec3 frame_enter(const struct texture_frame *frame, vec3 n)
{
	if (!frame)
		return n;
	n = transform_normal_back(frame->map->pattern.frame, frame_enter(frame->outer, n));
	return frame->map->keeps_length ? n : vec_normalize(n);
}

vec3 texture_part_normal(
	const struct texture_part *part, const struct layer *layer, struct surface *surface)
{
	if (!layer->normal)
		return surface->geometric;
	vec3 n = frame_enter(part->frame, surface->geometric);
	n = normal_perturb(layer->normal, n, part->p, surface);
	for (const struct texture_frame *f = part->frame; f; f = f->outer) {
		n = transform_normal(f->map->pattern.frame, n);
		if (!f->map->keeps_length)
			n = vec_normalize(n);
	}
	return vec_normalize(n);
}
