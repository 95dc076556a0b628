/* SPDX-License-Identifier: MIT */
/*
 * Textures with a pattern of their own: texture_map, lists, average, uv_mapping and tiles.
 */
#include "looks.h"

#include "texture/patterns.h"

static const struct texture_spec *spec_of(struct lowering *l, struct patterned_state *s)
{
	struct texture_spec *spec = ARENA_NEW(l->states, struct texture_spec);
	spec->patterned = s;
	return spec;
}

static const void *read_entry(struct lowering *l, const struct node *entry)
{
	return texture_read(l, entry, default_spec(l, entry->state));
}

static void name_pattern(struct lowering *l, struct patterned_state *s, const struct node *item)
{
	const struct pattern_class *class = s->pattern.class;
	s->form = FORM_PATTERN;
	if (class->only_normals)
		diag_error(l->diag, item->word, "facets is a pattern of normals");
	if (class->list_count > 0)
		s->map = lower_list(l, item, class->list_count, K_TEXTURE, read_entry,
			default_spec(l, item->state));
}

static void read_item(struct lowering *l, struct patterned_state *s, const struct node *item)
{
	switch (item->keyword) {
	case K_AVERAGE:
		s->form = FORM_AVERAGE;
		return;
	case K_UV_MAPPING:
		s->form = FORM_UV;
		l->has_uv_mapping = true;
		s->mapped = texture_read(l, item, default_spec(l, item->state));
		return;
	case K_TEXTURE_MAP:
		if (s->form == FORM_PATTERN && s->pattern.class->list_count > 0)
			diag_error(l->diag, item->word, "texture_map does not go with %s",
				s->pattern.class->name);
		else
			s->map = lower_map(l, item, read_entry, s->form == FORM_AVERAGE);
		return;
	case K_NO_BUMP_SCALE:
		s->keeps_length = true;
		return;
	default:
		if (pattern_state_item(l, &s->pattern, item, "texture", &s->form))
			name_pattern(l, s, item);
	}
}

const struct texture_spec *patterned_read(struct lowering *l, const struct node *block)
{
	struct patterned_state *s = ARENA_NEW(l->states, struct patterned_state);
	s->pattern = pattern_state_fresh;
	s->node = block;
	for (const struct node *item = block->children; item && s->form != FORM_REFUSED;
		item = item->next)
		read_item(l, s, item);
	if (s->form == FORM_REFUSED)
		return default_spec(l, block->state);
	if (s->form != FORM_UV && !s->map) {
		diag_error(
			l->diag, block->span, "a texture with a pattern must have a texture_map");
		return default_spec(l, block->state);
	}
	return spec_of(l, s);
}

/* The textures of one kind of tile, as layers. */
static const struct texture_spec *tile_layers(
	struct lowering *l, const struct node *block, const struct node *tiles)
{
	const struct texture_spec *spec = NULL;
	for (const struct node *item = block->children; item; item = item->next)
		if (item->keyword == K_TEXTURE)
			spec = texture_layer(l, spec, read_entry(l, item), item);
	if (!spec) {
		diag_error(
			l->diag, block->span, "%s needs a texture", keyword_name(block->keyword));
		spec = default_spec(l, tiles->state);
	}
	return spec;
}

/* A checker whose first texture lies on the odd cells. */
const struct texture_spec *tiles_read(struct lowering *l, const struct node *tiles)
{
	struct patterned_state *s = ARENA_NEW(l->states, struct patterned_state);
	struct map_state *map = ARENA_NEW(l->arena, struct map_state);
	const struct node *second = node_child(tiles, K_TILE2);
	map->count = 2;
	map->is_list = true;
	map->values = ARENA_ARRAY(l->arena, 2, float);
	map->values[1] = 1;
	map->items = ARENA_ARRAY(l->arena, 2, const void *);
	map->items[1] = tile_layers(l, tiles, tiles);
	map->items[0] = second ? tile_layers(l, second, tiles) : default_spec(l, tiles->state);
	s->form = FORM_PATTERN;
	s->pattern = pattern_state_fresh;
	s->pattern.class = &pattern_checker;
	s->pattern.frequency = 0;
	s->map = map;
	s->node = tiles;
	return spec_of(l, s);
}

/* ---- building ---- */

void patterned_build(struct lowering *l, const struct patterned_state *s, struct texture *out)
{
	struct texture_map *map = ARENA_NEW(l->arena, struct texture_map);
	const size_t count = s->form == FORM_UV ? 1 : s->map->count;
	const struct texture **textures = ARENA_ARRAY(l->arena, count, const struct texture *);
	map->keeps_length = s->keeps_length;
	map->textures = textures;
	out->map = map;
	if (s->form == FORM_UV) {
		map->kind = TEXTURE_UV;
		textures[0] = texture_build(l, s->mapped, false);
	} else {
		map->kind = s->form == FORM_AVERAGE ? TEXTURE_AVERAGE : TEXTURE_MAP;
		map->map = map_build(l, s->map);
		map->total_weight = map_total(s->map);
		pattern_build(l, &s->pattern, &map->pattern);
		for (size_t i = 0; i < count; i++)
			textures[i] = texture_build(l, s->map->items[i], false);
	}
	out->opaque = true;
	for (size_t i = 0; i < count; i++)
		out->opaque &= textures[i]->opaque;
}
