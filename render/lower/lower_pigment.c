/* SPDX-License-Identifier: MIT */
/*
 * pigment { … }: reading its items, and building the render form. A pigment whose
 * colour is the same everywhere becomes that colour.
 */
#include "looks.h"

#include "texture/patterns.h"

#include <string.h>

/* Filter and transmit below this let no light through. */
#define OPAQUE_EPSILON 1e-10f
/* From this quality on quick_color is ignored. */
enum { QUALITY_FULL_COLOUR = 6 };

/* ---- reading ---- */

const struct pigment_state *pigment_declared(struct lowering *l, const struct node *n)
{
	const struct pigment_state *state = looks_find(l, n);
	if (!state) {
		struct arena *const before = lowering_keep(l);
		state = pigment_read(l, n, default_spec(l, n->state)->layers->pigment);
		l->states = before;
		looks_remember(l, n, (void *)(uintptr_t)state);
	}
	return state;
}

static const void *read_entry(struct lowering *l, const struct node *entry)
{
	return pigment_read(l, entry, default_spec(l, entry->state)->layers->pigment);
}

static void name_colour(struct lowering *l, struct pigment_state *s, const struct node *item)
{
	s->form = FORM_PLAIN;
	s->colour = lower_colour(l, item, 0);
	s->map = NULL;
}

static void name_pattern(struct lowering *l, struct pigment_state *s, const struct node *item)
{
	const struct pattern_class *class = s->pattern.class;
	s->form = FORM_PATTERN;
	if (class->only_normals)
		diag_error(l->diag, item->word, "facets is a pattern of normals");
	else if (class->list_count > 0 && node_child(item, K_PIGMENT))
		s->map = lower_list(l, item, class->list_count, K_PIGMENT, read_entry,
			default_spec(l, item->state)->layers->pigment);
	else if (class->list_count > 0)
		s->map = lower_colour_list(l, item, class);
}

static void set_map(struct lowering *l, struct pigment_state *s, const struct node *item)
{
	const bool colours = item->keyword == K_COLOR_MAP;
	const bool is_list = s->form == FORM_PATTERN && s->pattern.class->list_count > 0;
	if (s->form == FORM_PLAIN || is_list || (colours && s->form == FORM_AVERAGE)) {
		diag_error(l->diag, item->word, "%s does not go with this pigment: %s",
			keyword_name(item->keyword),
			s->form == FORM_PLAIN ? "it is a plain colour"
			: is_list	      ? "its pattern has a list"
					      : "average takes a pigment_map");
		s->form = FORM_REFUSED;
	} else {
		s->map = lower_map(l, item, colours ? NULL : read_entry, s->form == FORM_AVERAGE);
	}
}

static void name_reference(struct lowering *l, struct pigment_state *s, const struct node *item)
{
	const struct node *declared = node_resolve(item);
	if (declared && declared->keyword == K_PIGMENT)
		*s = *pigment_declared(l, declared);
	else
		diag_error(l->diag, item->span, "%s is not a pigment", item->name);
}

static void read_item(struct lowering *l, struct pigment_state *s, const struct node *item)
{
	switch (item->keyword) {
	case K_REFERENCE:
		name_reference(l, s, item);
		return;
	case K_COLOUR_VALUE:
		name_colour(l, s, item);
		return;
	case K_AVERAGE:
		s->form = FORM_AVERAGE;
		s->pattern.class = NULL;
		return;
	case K_UV_MAPPING:
		s->form = FORM_UV;
		l->has_uv_mapping = true;
		s->mapped = read_entry(l, item);
		return;
	case K_COLOR_MAP:
	case K_PIGMENT_MAP:
		set_map(l, s, item);
		return;
	case K_QUICK_COLOR:
		s->quick = lower_colour(l, item, 0);
		s->has_quick = true;
		return;
	case K_IMAGE_MAP:
		lower_unsupported(l, item, keyword_name(item->keyword));
		s->form = FORM_REFUSED;
		return;
	default:
		if (pattern_state_item(l, &s->pattern, item, "pigment", &s->form))
			name_pattern(l, s, item);
	}
}

const struct pigment_state *pigment_read(
	struct lowering *l, const struct node *block, const struct pigment_state *start)
{
	struct pigment_state *s = arena_copy(l->states, start, sizeof *start);
	s->built = NULL;
	s->node = block;
	for (const struct node *item = block->children; item && s->form != FORM_REFUSED;
		item = item->next)
		read_item(l, s, item);
	if (s->form == FORM_AVERAGE && (!s->map || !s->map->items)) {
		diag_error(l->diag, block->span, "average needs a pigment_map");
		s->form = FORM_PLAIN;
	}
	s->node = block;
	return s;
}

/* ---- changing ---- */

const struct pigment_state *pigment_moved(
	struct lowering *l, const struct pigment_state *from, const transform *t)
{
	if (from->form == FORM_UV)
		return from;
	struct pigment_state *s = arena_copy(l->states, from, sizeof *from);
	s->built = NULL;
	pattern_state_move(l, &s->pattern, t);
	return s;
}

static void unfilter(colour *c)
{
	c->transmit += c->filter;
	c->filter = 0;
}

static const struct map_state *unfiltered_map(struct lowering *l, const struct map_state *from)
{
	struct map_state *map = arena_copy(l->arena, from, sizeof *from);
	if (map->colours) {
		map->colours = arena_copy(l->arena, map->colours, map->count * sizeof(colour));
		for (size_t i = 0; i < map->count; i++)
			unfilter(&map->colours[i]);
	}
	if (map->items) {
		map->items = arena_copy(l->arena, map->items, map->count * sizeof *map->items);
		for (size_t i = 0; i < map->count; i++)
			map->items[i] = pigment_unfiltered(l, map->items[i]);
	}
	return map;
}

const struct pigment_state *pigment_unfiltered(struct lowering *l, const struct pigment_state *from)
{
	struct pigment_state *s = arena_copy(l->states, from, sizeof *from);
	s->built = NULL;
	unfilter(&s->colour);
	if (s->map)
		s->map = unfiltered_map(l, s->map);
	if (s->mapped)
		s->mapped = pigment_unfiltered(l, s->mapped);
	return s;
}

/* ---- building ---- */

static bool lets_light_through(colour c)
{
	return fabsf(c.filter) > OPAQUE_EPSILON || fabsf(c.transmit) > OPAQUE_EPSILON;
}

static const struct pigment *plain_pigment(struct lowering *l, colour c)
{
	struct pigment *p = arena_pack(l->arena, sizeof *p);
	*p = (struct pigment){ .is_plain = true, .is_opaque = !lets_light_through(c), .colour = c };
	return p;
}

static bool quick_counts(const struct lowering *l, const struct pigment_state *s)
{
	const colour q = s->quick;
	return s->has_quick && l->options->quality < QUALITY_FULL_COLOUR && q.r != -1 &&
	       q.g != -1 && q.b != -1 && q.filter != -1 && q.transmit != -1;
}

static bool same_colours(const colour *c, size_t count)
{
	for (size_t i = 1; i < count; i++)
		if (memcmp(&c[i], &c[0], sizeof *c) != 0)
			return false;
	return true;
}

/* The colours of a map; of a map of plain pigments, theirs. NULL: it has others. */
static const colour *map_colours(
	struct lowering *l, const struct map_state *map, const struct pigment *const *pigments)
{
	if (map->colours)
		return map->colours;
	for (size_t i = 0; i < map->count; i++)
		if (!pigments[i]->is_plain)
			return NULL;
	colour *colours = ARENA_ARRAY(l->arena, map->count, colour);
	for (size_t i = 0; i < map->count; i++)
		colours[i] = pigments[i]->colour;
	return colours;
}

static const struct pigment *const *build_items(struct lowering *l, const struct map_state *map)
{
	if (!map->items)
		return NULL;
	const struct pigment **pigments = ARENA_ARRAY(l->arena, map->count, const struct pigment *);
	for (size_t i = 0; i < map->count; i++)
		pigments[i] = pigment_build(l, map->items[i]);
	return pigments;
}

static bool all_opaque(const struct pigment_source *source)
{
	for (size_t i = 0; i < source->map.count; i++)
		if (source->colours ? lets_light_through(source->colours[i])
				    : !pigment_is_opaque(source->pigments[i]))
			return false;
	return true;
}

static const struct pigment *build_source(struct lowering *l, const struct pigment_state *s)
{
	const struct map_state *map = s->map ? s->map : default_map_state(l, s->pattern.class);
	struct pigment_source *source = ARENA_NEW(l->arena, struct pigment_source);
	source->map = map_build(l, map);
	source->pigments = build_items(l, map);
	if (s->form == FORM_AVERAGE) {
		source->kind = PIGMENT_AVERAGE;
		source->total_weight = map_total(map);
	} else {
		source->colours = map_colours(l, map, source->pigments);
		source->kind = source->colours ? PIGMENT_COLOURS : PIGMENT_PIGMENTS;
		if (source->colours && same_colours(source->colours, map->count))
			return plain_pigment(l, source->colours[0]);
	}
	pattern_build(l, &s->pattern, &source->pattern);
	struct pigment *p = ARENA_NEW(l->arena, struct pigment);
	*p = (struct pigment){ .is_opaque = all_opaque(source), .source = source };
	return p;
}

static const struct pigment *build_uv(struct lowering *l, const struct pigment_state *s)
{
	const struct pigment *mapped = pigment_build(l, s->mapped);
	if (mapped->is_plain)
		return mapped;
	struct pigment_source *source = ARENA_NEW(l->arena, struct pigment_source);
	const struct pigment **pigments = ARENA_ARRAY(l->arena, 1, const struct pigment *);
	pigments[0] = mapped;
	source->kind = PIGMENT_UV;
	source->pigments = pigments;
	struct pigment *p = ARENA_NEW(l->arena, struct pigment);
	*p = (struct pigment){ .is_opaque = mapped->is_opaque, .source = source };
	return p;
}

/* A mandel set has its colours only for exponent 2. */
static bool wants_mandel_map(const struct pattern_state *s)
{
	const struct fractal *f = s->self;
	return s->class == &pattern_mandel && f->exponent == 2;
}

static const struct pigment *build(struct lowering *l, const struct pigment_state *s)
{
	if (quick_counts(l, s))
		return plain_pigment(l, s->quick);
	if (s->form == FORM_NONE && s->node)
		diag_warning(l->diag, s->node->word,
			"pigment type unspecified: a pigment begins with its colour or pattern");
	if (s->form == FORM_NONE || s->form == FORM_REFUSED)
		return plain_pigment(l, (colour){ 0, 0, 0, 0, 0 });
	if (s->form == FORM_PLAIN)
		return plain_pigment(l, s->colour);
	if (s->form == FORM_UV)
		return build_uv(l, s);
	if (!s->map && s->form == FORM_PATTERN && wants_mandel_map(&s->pattern)) {
		struct pigment_state coloured = *s;
		const struct pattern_class with_map = { .map = &default_map_mandel };
		coloured.map = default_map_state(l, &with_map);
		return build_source(l, &coloured);
	}
	return build_source(l, s);
}

const struct pigment *pigment_build(struct lowering *l, const struct pigment_state *s)
{
	struct pigment_state *owned = (struct pigment_state *)(uintptr_t)s;
	if (!s->built)
		owned->built = build(l, s);
	return s->built;
}

const struct pigment *lower_pigment(
	struct lowering *l, const struct node *n, const transform *place)
{
	const struct pigment_state *s =
		n->keyword == K_REFERENCE
			? pigment_declared(l, node_resolve(n))
			: pigment_read(l, n, default_spec(l, n->state)->layers->pigment);
	return pigment_build(l, place ? pigment_moved(l, s, place) : s);
}
