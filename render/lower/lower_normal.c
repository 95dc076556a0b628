/* SPDX-License-Identifier: MIT */
/*
 * normal { … }: reading its items, and building the render form.
 */
#include "looks.h"

#include "texture/patterns.h"

/* Below this quality surfaces are smooth. */
enum { QUALITY_NORMALS = 8 };
#define USUAL_ACCURACY 0.02f

static const struct normal_state fresh = { .amount = 0.5f, .accuracy = USUAL_ACCURACY };

/* ---- reading ---- */

static const struct normal_state *default_normal(struct lowering *l, const struct node *n)
{
	return default_spec(l, n->state)->layers->normal;
}

const struct normal_state *normal_declared(struct lowering *l, const struct node *n)
{
	const struct normal_state *state = looks_find(l, n);
	if (!state) {
		struct arena *const before = lowering_keep(l);
		state = normal_read(l, n, default_normal(l, n));
		l->states = before;
		looks_remember(l, n, (void *)(uintptr_t)state);
	}
	return state;
}

static const void *read_entry(struct lowering *l, const struct node *entry)
{
	return normal_read(l, entry, default_normal(l, entry));
}

static void name_pattern(struct lowering *l, struct normal_state *s, const struct node *item)
{
	const struct pattern_class *class = s->pattern.class;
	s->form = FORM_PATTERN;
	if (class->list_count == 0)
		return;
	if (node_child(item, K_NORMAL)) {
		s->map = lower_list(
			l, item, class->list_count, K_NORMAL, read_entry, default_normal(l, item));
	} else {
		s->map = NULL;
		s->accuracy = USUAL_ACCURACY;
	}
}

static void name_reference(struct lowering *l, struct normal_state *s, const struct node *item)
{
	const struct node *declared = node_resolve(item);
	if (declared && declared->keyword == K_NORMAL)
		*s = *normal_declared(l, declared);
	else
		diag_error(l->diag, item->span, "%s is not a normal", item->name);
}

static void set_map(struct lowering *l, struct normal_state *s, const struct node *item)
{
	const struct pattern_class *class = s->form == FORM_PATTERN ? s->pattern.class : NULL;
	if (class && (class->list_count > 0 || class->only_normals))
		diag_error(l->diag, item->word, "%s does not go with %s",
			keyword_name(item->keyword), class->name);
	else if (item->keyword == K_NORMAL_MAP)
		s->map = lower_map(l, item, read_entry, s->form == FORM_AVERAGE);
	else if (s->form == FORM_AVERAGE)
		diag_error(l->diag, item->word, "average takes a normal_map");
	else
		s->slopes = lower_map(l, item, NULL, false);
}

static void read_item(struct lowering *l, struct normal_state *s, const struct node *item)
{
	switch (item->keyword) {
	case K_REFERENCE:
		name_reference(l, s, item);
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
	case K_NORMAL_MAP:
	case K_SLOPE_MAP:
		set_map(l, s, item);
		return;
	case K_BUMP_SIZE:
		s->amount = (float)lower_float(l, item, 0, "a number");
		return;
	case K_ACCURACY:
		s->accuracy = (float)lower_float(l, item, 0, "a number");
		return;
	case K_NO_BUMP_SCALE:
		s->keeps_length = true;
		return;
	case K_BUMP_MAP:
		lower_unsupported(l, item, keyword_name(item->keyword));
		s->form = FORM_REFUSED;
		return;
	default:
		if (pattern_state_item(l, &s->pattern, item, "normal", &s->form))
			name_pattern(l, s, item);
	}
}

const struct normal_state *normal_read(
	struct lowering *l, const struct node *block, const struct normal_state *start)
{
	if (!start) {
		struct normal_state *s = arena_copy(l->states, &fresh, sizeof fresh);
		s->pattern = pattern_state_fresh;
		start = s;
	}
	struct normal_state *s = arena_copy(l->states, start, sizeof *start);
	s->built = NULL;
	for (const struct node *item = block->children; item && s->form != FORM_REFUSED;
		item = item->next)
		read_item(l, s, item);
	s->node = block;
	if (s->form == FORM_AVERAGE && !s->map)
		diag_error(l->diag, block->span, "average needs a normal_map");
	return s;
}

/* ---- changing ---- */

const struct normal_state *normal_moved(
	struct lowering *l, const struct normal_state *from, const transform *t)
{
	if (!from || from->form == FORM_UV || from->form == FORM_REFUSED)
		return from;
	struct normal_state *s = arena_copy(l->states, from, sizeof *from);
	s->built = NULL;
	pattern_state_move(l, &s->pattern, t);
	return s;
}

/* no_bump_scale, handed on to the entries of maps. */
const struct normal_state *normal_unscaled(struct lowering *l, const struct normal_state *from)
{
	if (!from)
		return NULL;
	struct normal_state *s = arena_copy(l->states, from, sizeof *from);
	s->built = NULL;
	s->keeps_length = true;
	return s;
}

/* ---- building ---- */

static const struct normal *const *build_items(
	struct lowering *l, const struct map_state *map, bool keeps_length)
{
	const struct normal **normals = ARENA_ARRAY(l->arena, map->count, const struct normal *);
	for (size_t i = 0; i < map->count; i++) {
		const struct normal_state *item = map->items[i];
		if (keeps_length && item && !item->keeps_length)
			item = normal_unscaled(l, item);
		normals[i] = normal_build(l, item);
	}
	return normals;
}

static const struct normal *build(struct lowering *l, const struct normal_state *s)
{
	struct normal *n = ARENA_NEW(l->arena, struct normal);
	n->keeps_length = s->keeps_length;
	n->amount = (double)s->amount;
	n->accuracy = (double)s->accuracy;
	if (s->form == FORM_UV) {
		const struct normal **normals = ARENA_ARRAY(l->arena, 1, const struct normal *);
		normals[0] = normal_build(l, s->mapped);
		n->kind = NORMAL_UV;
		n->normals = normals;
		return n;
	}
	pattern_build(l, &s->pattern, &n->pattern);
	if (s->map) {
		n->kind = s->form == FORM_AVERAGE ? NORMAL_AVERAGE : NORMAL_MAP;
		n->map = map_build(l, s->map);
		n->total_weight = map_total(s->map);
		n->normals = build_items(l, s->map, s->keeps_length);
	} else if (s->pattern.class->perturb) {
		n->kind = NORMAL_VECTOR;
	} else {
		n->kind = NORMAL_BUMP;
		if (s->slopes) {
			n->map = map_build(l, s->slopes);
			n->slopes = s->slopes->slopes;
		}
	}
	return n;
}

/* States with errors build nothing. A #default may prepare a normal without a pattern, so that is an
 * error only where it is used. */
static bool is_complete(struct lowering *l, const struct normal_state *s)
{
	if (s->form == FORM_NONE)
		diag_error(l->diag, s->node->span,
			"no normal type given: a normal begins with its pattern");
	return (s->form == FORM_UV && s->mapped) || (s->form == FORM_AVERAGE && s->map) ||
	       s->form == FORM_PATTERN;
}

const struct normal *normal_build(struct lowering *l, const struct normal_state *s)
{
	if (!s || l->options->quality < QUALITY_NORMALS || !is_complete(l, s))
		return NULL;
	struct normal_state *owned = (struct normal_state *)(uintptr_t)s;
	if (!s->built)
		owned->built = build(l, s);
	return s->built;
}
