/* SPDX-License-Identifier: MIT */
/*
 * The modifiers of an object statement, applied to its draft in source order.
 */
#include "lower/draft.h"

static struct looks *looks_of(struct lowering *l, struct looks **looks)
{
	if (!*looks)
		*looks = ARENA_NEW(l->states, struct looks);
	return *looks;
}

static void add_texture(struct lowering *l, struct looks **looks, const struct node *item)
{
	texture_state_add(l, &looks_of(l, looks)->state, item);
}

/* interior_texture { … } reads like texture { … }. */
static void add_interior_texture(struct lowering *l, struct draft *d, const struct node *item)
{
	struct node *as_texture = arena_copy(l->states, item, sizeof *item);
	as_texture->keyword = K_TEXTURE;
	as_texture->next = NULL;
	add_texture(l, &draft_extras(l, d)->interior_texture, as_texture);
}

static void add_interior(struct lowering *l, struct draft *d, const struct node *n)
{
	draft_extras(l, d)->interior = lower_interior(l, n, d->extras->interior);
}

static void add_material(struct lowering *l, struct draft *d, const struct node *material)
{
	for (const struct node *item = material->children; item; item = item->next) {
		const struct node *n = node_resolve(item);
		if (n->keyword == K_MATERIAL)
			add_material(l, d, n);
		else if (n->keyword == K_INTERIOR)
			add_interior(l, d, n);
		else if (n->keyword == K_INTERIOR_TEXTURE)
			add_interior_texture(l, d, n);
		else if (node_is_transform(item) && d->texture) {
			const transform t = lower_transform(l, item);
			texture_state_transform(l, d->texture->state, &t);
		} else if (!node_is_transform(item)) {
			add_texture(l, &d->texture, item);
		}
	}
}

/* ---- clipped_by, bounded_by ---- */

bool draft_is_patch(const struct draft *d)
{
	if (d->kind == DRAFT_LIGHT || (d->kind == DRAFT_SHAPE && d->shape->is_patch))
		return true;
	for (const struct draft *child = d->extras->children; child; child = child->next) {
		const bool is_its_light = d->kind == DRAFT_GROUP && child->kind == DRAFT_LIGHT;
		if (!is_its_light && draft_is_patch(child))
			return true;
	}
	return false;
}

static void check_cutter(struct lowering *l, const struct node *item, const struct draft *d)
{
	if (d->texture)
		diag_error(l->diag, item->span,
			"an object in clipped_by or bounded_by cannot have a texture");
	if (draft_is_patch(d))
		diag_error(l->diag, item->span,
			"an object in clipped_by or bounded_by must be solid: this one has no "
			"inside");
}

static void read_cutters(struct lowering *l, const struct node *n, struct draft **list)
{
	while (*list)
		list = &(*list)->next;
	struct draft **first = list;
	for (const struct node *item = n->children; item; item = item->next) {
		if (node_is_transform(item)) {
			struct step step = lower_step(l, item);
			drafts_transform(l, *first, &step);
			continue;
		}
		struct draft *cutter = draft_from_node(l, item);
		if (!cutter)
			continue;
		check_cutter(l, item, cutter);
		*list = cutter;
		list = &cutter->next;
	}
}

static void add_cutters(struct lowering *l, struct draft *d, const struct node *n)
{
	const bool clips = n->keyword == K_CLIPPED_BY;
	struct draft_extras *e = draft_extras(l, d);
	struct draft **own = clips ? &e->clips : &e->bounds;
	struct draft *other = clips ? e->bounds : e->clips;
	if (d->bounds_are_clips) {
		diag_error(l->diag, n->span, "%s after the two lists have been linked",
			keyword_name(n->keyword));
	} else if (!node_child(n, clips ? K_BOUNDED_BY : K_CLIPPED_BY)) {
		read_cutters(l, n, own);
		if (clips && d->extras->extent)
			extent_clip(l, d);
	} else if (*own) {
		diag_error(l->diag, n->span, "%s has its own objects and cannot be linked as well",
			keyword_name(n->keyword));
	} else if (other) { /* linking to an empty list does nothing */
		d->bounds_are_clips = true;
		*own = other;
	}
}

/* ---- inverse and flags ---- */

/* CSG by De Morgan: a union of inverted children would be open; it becomes an intersection. */
void draft_invert(struct lowering *l, struct draft *d)
{
	if (d->kind == DRAFT_SHAPE && d->shape->is_patch)
		return;
	if (d->kind == DRAFT_CSG || d->kind == DRAFT_GROUP) {
		d->csg = d->csg == CSG_INTERSECTION ? CSG_MERGE : CSG_INTERSECTION;
		for (struct draft *child = d->extras->children; child; child = child->next)
			draft_invert(l, child);
	} else if (d->kind == DRAFT_SHAPE && d->shape->invert) {
		d->shape->invert(d->self);
	} else {
		d->inverted = !d->inverted;
	}
	if (d->extras->extent)
		extent_invert(l, d);
}

static void spread_hollow(struct draft *d, bool hollow)
{
	for (struct draft *child = d->extras->children; child; child = child->next) {
		if (child->hollow_set)
			continue;
		child->hollow = hollow;
		spread_hollow(child, hollow);
	}
}

static void spread_double_illuminate(struct draft *d, bool on)
{
	d->double_illuminate = on;
	for (struct draft *child = d->extras->children; child; child = child->next)
		spread_double_illuminate(child, on);
}

static void set_uv_mapping(struct lowering *l, struct draft *d, const struct node *item)
{
	if (d->texture)
		diag_error(l->diag, item->word,
			"uv_mapping must come before the texture of an object");
	d->uv_mapping = true;
}

/* Modifiers whose only effect is on features that are refused elsewhere, or none at all. */
static bool has_no_effect(const struct node *item)
{
	switch (item->keyword) {
	case K_NO_RADIOSITY:
	case K_RADIOSITY:
	case K_HIERARCHY:
	case K_DTAG:
	case K_COLOUR_VALUE:
		return true;
	default:
		return false;
	}
}

static bool set_flag(struct lowering *l, struct draft *d, const struct node *item)
{
	switch (item->keyword) {
	case K_INVERSE:
		if (d->kind == DRAFT_SHAPE && d->shape->is_patch)
			diag_warning(
				l->diag, item->word, "inverse has no effect on %s", d->shape->name);
		draft_invert(l, d);
		return true;
	case K_HOLLOW:
		d->hollow = lower_switch(l, item, true);
		d->hollow_set = true;
		spread_hollow(d, d->hollow);
		return true;
	case K_NO_SHADOW:
		d->no_shadow = true;
		return true;
	case K_NO_IMAGE:
		d->no_image = lower_switch(l, item, true);
		return true;
	case K_NO_REFLECTION:
		d->no_reflection = lower_switch(l, item, true);
		return true;
	case K_DOUBLE_ILLUMINATE:
		spread_double_illuminate(d, lower_switch(l, item, true));
		return true;
	case K_UV_MAPPING:
		set_uv_mapping(l, d, item);
		return true;
	case K_SPLIT_UNION:
		d->split_union = lower_float(l, item, 0, "a switch") != 0;
		return true;
	case K_STURM: /* of a copy; what it asks for is always done */
		if (draft_takes_flag(d, item))
			return true;
		diag_error(l->diag, item->word, "sturm does not apply to %s",
			keyword_name(d->node->keyword));
		return true;
	default:
		return false;
	}
}

void draft_modify(struct lowering *l, struct draft *d, const struct node *item)
{
	const struct node *n = node_resolve(item);
	if (node_is_transform(item)) {
		struct step step = lower_step(l, item);
		draft_transform(l, d, &step);
		return;
	}
	switch (n->keyword) {
	case K_TEXTURE:
	case K_LAYERS:
	case K_PIGMENT:
	case K_NORMAL:
	case K_FINISH:
		add_texture(l, &d->texture, item);
		return;
	case K_INTERIOR_TEXTURE:
		add_interior_texture(l, d, n);
		return;
	case K_MATERIAL:
		add_material(l, d, n);
		return;
	case K_INTERIOR:
		add_interior(l, d, n);
		return;
	case K_CLIPPED_BY:
	case K_BOUNDED_BY:
		add_cutters(l, d, n);
		return;
	case K_PHOTONS: /* of an object; those of a lamp only steer what is shot at targets */
		l->has_photons |= node_child(n, K_TARGET) != NULL;
		return;
	default:
		break;
	}
	if (!set_flag(l, d, n) && !has_no_effect(n))
		lower_unsupported(l, n, keyword_name(n->keyword));
}
