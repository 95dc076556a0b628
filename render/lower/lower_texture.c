/* SPDX-License-Identifier: MIT */
/*
 * texture { … }: layers, the default texture, and the texture of an object while it
 * is put together.
 *
 * A transformation is not handed to the layers at once but kept beside the shared
 * texture, so that a texture used a thousand times costs a matrix each time, and
 * nothing at all where no pattern would notice.
 */
#include "looks.h"

#include <stdlib.h>
#include <string.h>

/* Up to this version layers turn filter into transmit. */
enum { VERSION_UNFILTERED_LAYERS = 310 };

struct texture_state {
	const struct texture_spec *spec;
	bool is_placed;
	transform place; /* not yet applied to the spec */
};

/* ---- memory ---- */

void *looks_find(struct lowering *l, const void *key)
{
	return pointer_map_find(&l->looks, key);
}

void looks_remember(struct lowering *l, const void *key, void *state)
{
	pointer_map_add(&l->looks, key, state);
}

/* ---- specs ---- */

static const struct texture_spec *spec_of_layers(
	struct lowering *l, const struct layer_state *layers, size_t count)
{
	struct texture_spec *spec = ARENA_NEW(l->states, struct texture_spec);
	spec->count = count;
	spec->layers = layers;
	return spec;
}

/* A copy whose layers may be changed. */
static struct layer_state *copy_layers(struct lowering *l, const struct texture_spec *spec)
{
	return arena_copy(l->states, spec->layers, spec->count * sizeof *spec->layers);
}

/* Whether the texture looks different in another place. (A plain pigment does not, but keeps its
 * transformations for a pattern it may be given later.) */
static bool spec_notices_place(const struct texture_spec *spec)
{
	if (spec->patterned)
		return spec->patterned->form != FORM_UV;
	for (size_t i = 0; i < spec->count; i++) {
		const enum look_form form = spec->layers[i].pigment->form;
		if (form == FORM_PATTERN || form == FORM_AVERAGE || spec->layers[i].normal)
			return true;
	}
	return false;
}

static const struct texture_spec *spec_moved(
	struct lowering *l, const struct texture_spec *from, const transform *t)
{
	if (from->patterned) {
		struct patterned_state *s =
			arena_copy(l->states, from->patterned, sizeof *from->patterned);
		struct texture_spec *spec = ARENA_NEW(l->states, struct texture_spec);
		pattern_state_move(l, &s->pattern, t);
		spec->patterned = s;
		return spec;
	}
	struct layer_state *layers = copy_layers(l, from);
	for (size_t i = 0; i < from->count; i++) {
		layers[i].pigment = pigment_moved(l, layers[i].pigment, t);
		layers[i].normal = normal_moved(l, layers[i].normal, t);
	}
	return spec_of_layers(l, layers, from->count);
}

static const struct texture_spec *spec_unscaled(struct lowering *l, const struct texture_spec *from)
{
	if (from->patterned) {
		struct patterned_state *s =
			arena_copy(l->states, from->patterned, sizeof *from->patterned);
		struct texture_spec *spec = ARENA_NEW(l->states, struct texture_spec);
		s->keeps_length = true;
		spec->patterned = s;
		return spec;
	}
	struct layer_state *layers = copy_layers(l, from);
	for (size_t i = 0; i < from->count; i++)
		layers[i].normal = normal_unscaled(l, layers[i].normal);
	return spec_of_layers(l, layers, from->count);
}

/* A pigment, normal or finish item, or a reference to one, for the top layer. */
static const struct texture_spec *spec_modified(
	struct lowering *l, const struct texture_spec *from, const struct node *item)
{
	if (from->patterned) {
		diag_error(l->diag, item->span, "%s cannot change a texture with a pattern",
			keyword_name(node_resolve(item)->keyword));
		return from;
	}
	const bool is_reference = item->keyword == K_REFERENCE;
	const struct node *n = node_resolve(item);
	struct layer_state *layers = copy_layers(l, from);
	struct layer_state *top = &layers[from->count - 1];
	if (n->keyword == K_PIGMENT)
		top->pigment =
			is_reference ? pigment_declared(l, n) : pigment_read(l, n, top->pigment);
	else if (n->keyword == K_NORMAL)
		top->normal = is_reference ? normal_declared(l, n) : normal_read(l, n, top->normal);
	else
		top->finish = is_reference ? finish_declared(l, n) : finish_read(l, n, top->finish);
	return spec_of_layers(l, layers, from->count);
}

static bool is_part(const struct node *n)
{
	return n->keyword == K_PIGMENT || n->keyword == K_NORMAL || n->keyword == K_FINISH;
}

static bool is_texture(const struct node *n)
{
	return n->keyword == K_TEXTURE || n->keyword == K_LAYERS ||
	       n->keyword == K_INTERIOR_TEXTURE;
}

/* ---- layers ---- */

const struct texture_spec *texture_layer(struct lowering *l, const struct texture_spec *below,
	const struct texture_spec *above, const struct node *item)
{
	if (below && (below->patterned || above->patterned)) {
		diag_error(l->diag, item->span,
			below->patterned
				? "a texture cannot be layered over a texture with a pattern"
				: "a texture with a pattern cannot be layered over another");
		return below;
	}
	const bool unfilter = item->state && item->state->version <= VERSION_UNFILTERED_LAYERS;
	if (above->patterned || (!below && !(unfilter && above->count > 1)))
		return above;
	const size_t below_count = below ? below->count : 0;
	const size_t count = below_count + above->count;
	struct layer_state *layers = ARENA_ARRAY(l->states, count, struct layer_state);
	if (below)
		memcpy(layers, below->layers, below_count * sizeof *layers);
	memcpy(layers + below_count, above->layers, above->count * sizeof *layers);
	for (size_t i = below ? below_count : 1; unfilter && i < count; i++)
		layers[i].pigment = pigment_unfiltered(l, layers[i].pigment);
	return spec_of_layers(l, layers, count);
}

/* ---- the default ---- */

static const struct texture_spec *first_default(struct lowering *l)
{
	static const char key;
	struct texture_spec *spec = looks_find(l, &key);
	if (spec)
		return spec;
	struct pigment_state *pigment = ARENA_NEW(l->declared_states, struct pigment_state);
	struct layer_state *layer = ARENA_NEW(l->declared_states, struct layer_state);
	pigment->pattern = pattern_state_fresh;
	*layer = (struct layer_state){ pigment, NULL, &finish_state_fresh };
	spec = ARENA_NEW(l->declared_states, struct texture_spec);
	spec->count = 1;
	spec->layers = layer;
	looks_remember(l, &key, spec);
	return spec;
}

static const struct texture_spec *default_changed(
	struct lowering *l, const struct texture_spec *before, const struct node *n)
{
	const struct node *resolved = node_resolve(n);
	if (is_part(resolved))
		return spec_modified(l, before, n);
	if (!is_texture(resolved))
		return before;
	const struct texture_spec *spec = n->keyword == K_REFERENCE ? texture_declared(l, resolved)
								    : texture_read(l, n, before);
	if (spec->count == 1)
		return spec;
	diag_error(l->diag, n->span, "the default texture must have one layer and no pattern");
	return before;
}

/* The chain of #default items is folded from the oldest that has not been folded yet. */
static const struct texture_spec *fold_defaults(struct lowering *l, const struct defaults *newest)
{
	size_t count = 0;
	const struct defaults *d = newest;
	for (; d && !looks_find(l, d); d = d->previous)
		count++;
	const struct texture_spec *spec = d ? looks_find(l, d) : first_default(l);
	const struct defaults **pending = memory_alloc(count + 1, sizeof *pending);
	size_t i = count;
	for (d = newest; i > 0; d = d->previous)
		pending[--i] = d;
	struct arena *const before = lowering_keep(l);
	for (; i < count; i++) {
		spec = default_changed(l, spec, pending[i]->node);
		looks_remember(l, pending[i], (void *)(uintptr_t)spec);
	}
	l->states = before;
	free(pending);
	return spec;
}

const struct texture_spec *default_spec(struct lowering *l, const struct language_state *state)
{
	const struct defaults *d = state ? state->defaults : NULL;
	const struct texture_spec *spec = d ? looks_find(l, d) : first_default(l);
	return spec ? spec : fold_defaults(l, d);
}

/* ---- reading ---- */

static struct texture_state state_of(const struct texture_spec *spec)
{
	return (struct texture_state){ .spec = spec };
}

/* Hands the kept transformation to the layers. */
static void settle(struct lowering *l, struct texture_state *s)
{
	if (s->is_placed)
		s->spec = spec_moved(l, s->spec, &s->place);
	s->is_placed = false;
}

/* A texture of its own, with one layer or several. */
static const struct texture_spec *read_layers(struct lowering *l, const struct node *n)
{
	if (n->keyword != K_LAYERS)
		return texture_read(l, n, default_spec(l, n->state));
	const struct texture_spec *spec = NULL;
	for (const struct node *item = n->children; item; item = item->next)
		spec = texture_layer(l, spec,
			item->keyword == K_REFERENCE
				? texture_declared(l, node_resolve(item))
				: texture_read(l, item, default_spec(l, item->state)),
			item);
	return spec ? spec : default_spec(l, n->state);
}

const struct texture_spec *texture_declared(struct lowering *l, const struct node *n)
{
	const struct texture_spec *spec = looks_find(l, n);
	if (spec)
		return spec;
	struct arena *const before = lowering_keep(l);
	spec = read_layers(l, n);
	l->states = before;
	looks_remember(l, n, (void *)(uintptr_t)spec);
	return spec;
}

/* A texture statement, or a reference to one. */
static const struct texture_spec *texture_of(struct lowering *l, const struct node *item)
{
	return item->keyword == K_REFERENCE ? texture_declared(l, node_resolve(item))
					    : read_layers(l, item);
}

static bool is_plain_item(const struct node *item)
{
	const struct node *n = node_resolve(item);
	return n && (is_part(n) || is_texture(n) || node_is_transform(item) ||
			    n->keyword == K_NO_BUMP_SCALE || n->keyword == K_TILES ||
			    n->keyword == K_MATERIAL_MAP);
}

static void read_plain_item(struct lowering *l, struct texture_state *s, const struct node *item)
{
	if (node_is_transform(item)) {
		const transform t = lower_transform(l, item);
		texture_state_transform(l, s, &t);
		return;
	}
	const struct node *n = node_resolve(item);
	settle(l, s);
	if (is_part(n))
		s->spec = spec_modified(l, s->spec, item);
	else if (is_texture(n))
		s->spec = texture_of(l, item);
	else if (n->keyword == K_NO_BUMP_SCALE)
		s->spec = spec_unscaled(l, s->spec);
	else if (n->keyword == K_TILES)
		s->spec = tiles_read(l, n);
	else
		lower_unsupported(l, item, keyword_name(n->keyword));
}

const struct texture_spec *texture_read(
	struct lowering *l, const struct node *block, const struct texture_spec *start)
{
	if (block->children && !is_plain_item(block->children))
		return patterned_read(l, block);
	struct texture_state s = state_of(start);
	for (const struct node *item = block->children; item; item = item->next)
		if (is_plain_item(item))
			read_plain_item(l, &s, item);
		else
			diag_error(l->diag, item->word, "unexpected %s in texture",
				keyword_name(item->keyword));
	settle(l, &s);
	return s.spec;
}

/* ---- building ---- */

static void build_layers(struct lowering *l, const struct texture_spec *spec, struct texture *out)
{
	struct layer *layers = arena_pack(l->arena, spec->count * sizeof *layers);
	for (size_t i = 0; i < spec->count; i++) {
		const struct layer_state *from = &spec->layers[spec->count - 1 - i];
		if (from->finish->subsurface)
			lower_unsupported(l, from->finish->subsurface, "subsurface");
		layers[i] = (struct layer){ pigment_build(l, from->pigment),
			normal_build(l, from->normal), finish_build(l, from->finish) };
		out->opaque |= pigment_is_opaque(layers[i].pigment);
	}
	out->layers = layers;
	out->layer_count = spec->count;
}

const struct texture *texture_build(struct lowering *l, const struct texture_spec *spec, bool uv)
{
	struct texture_spec *owned = (struct texture_spec *)(uintptr_t)spec;
	if (spec->built[uv])
		return spec->built[uv];
	struct texture *texture = arena_pack(l->arena, sizeof *texture);
	texture->uses_uv = uv;
	if (spec->patterned)
		patterned_build(l, spec->patterned, texture);
	else
		build_layers(l, spec, texture);
	owned->built[uv] = texture;
	return texture;
}

/* ---- the texture of an object ---- */

struct texture_state *texture_state_default(struct lowering *l, const struct language_state *state)
{
	const struct texture_state s = state_of(default_spec(l, state));
	return arena_copy(l->states, &s, sizeof s);
}

struct texture_state *texture_state_copy(struct lowering *l, const struct texture_state *s)
{
	return arena_copy(l->states, s, sizeof *s);
}

void texture_state_add(struct lowering *l, struct texture_state **state, const struct node *item)
{
	const struct node *n = node_resolve(item);
	if (!is_texture(n) && !is_part(n)) {
		diag_error(l->diag, item->span, "%s is not a texture or part of one",
			item->keyword == K_REFERENCE ? item->name : keyword_name(n->keyword));
		return;
	}
	const bool is_new = !*state;
	if (is_new)
		*state = texture_state_default(l, item->state);
	struct texture_state *s = *state;
	settle(l, s);
	if (is_part(n)) {
		s->spec = spec_modified(l, s->spec, item);
		return;
	}
	const struct texture_spec *spec = texture_of(l, item);
	s->spec = texture_layer(l, is_new ? NULL : s->spec, spec, item);
}

void texture_state_transform(struct lowering *l, struct texture_state *s, const transform *t)
{
	(void)l;
	s->place = s->is_placed ? transform_compose(&s->place, t) : *t;
	s->is_placed = true;
}

/* Objects that moved together share a texture: the last place is remembered. */
const struct texture *texture_state_finish(struct lowering *l, struct texture_state *s, bool uv)
{
	if (!s->is_placed || !spec_notices_place(s->spec))
		return texture_build(l, s->spec, uv);
	struct texture_spec *owned = (struct texture_spec *)(uintptr_t)s->spec;
	const bool same = owned->built_moved[uv] &&
			  memcmp(&owned->last_place[uv], &s->place, sizeof s->place) == 0;
	if (!same) {
		owned->built_moved[uv] = texture_build(l, spec_moved(l, owned, &s->place), uv);
		owned->last_place[uv] = s->place;
	}
	return owned->built_moved[uv];
}

bool texture_state_interior(const struct texture_state *s, double *ior, double *caustics)
{
	*ior = 0;
	*caustics = 0;
	for (size_t i = s->spec->count; i-- > 0;) {
		const struct finish *f = &s->spec->layers[i].finish->finish;
		if (*ior == 0)
			*ior = (double)f->ior;
		if (*caustics == 0)
			*caustics = (double)f->caustics;
	}
	return *ior != 0 || *caustics != 0;
}
