/* SPDX-License-Identifier: MIT */
/*
 * Object statements to drafts: primitives by their parameter tables, CSG by
 * their children, declared objects by copying.
 */
#include "lower/draft.h"

#include <string.h>

static bool is_csg_keyword(enum keyword k)
{
	return k == K_UNION || k == K_MERGE || k == K_INTERSECTION || k == K_DIFFERENCE ||
	       k == K_COMPOSITE;
}

bool node_is_object(const struct node *item)
{
	return keyword_is_object(node_resolve(item)->keyword);
}

static const struct draft_extras no_extras;

struct draft_extras *draft_extras(struct lowering *l, struct draft *d)
{
	if (d->extras == &no_extras)
		d->extras = arena_pack(l->states, sizeof *d->extras);
	return (struct draft_extras *)(uintptr_t)d->extras;
}

transform draft_place(const struct draft *d)
{
	return d->place ? *d->place : transform_identity();
}

static struct draft *draft_create(struct lowering *l, enum draft_kind kind, const struct node *n)
{
	struct draft *d = arena_pack(l->states, sizeof *d);
	d->kind = kind;
	d->node = n;
	d->extras = &no_extras;
	d->split_union = true;
	return d;
}

/* What is declared is no part of the scene: copies of it will be. */
static struct arena *arena_of_objects(const struct lowering *l)
{
	return l->states == l->declared_states ? l->declared_states : l->arena;
}

/* Gives a draft a shape, whose data are still zero. */
static void set_shape(struct lowering *l, struct draft *d, const struct shape_class *shape)
{
	d->object = arena_pack(arena_of_objects(l), sizeof *d->object + shape->size);
	d->shape = shape;
	d->self = d->object + 1;
}

static struct looks *looks_copy(struct lowering *l, const struct looks *looks)
{
	if (!looks)
		return NULL;
	struct looks *copy = ARENA_NEW(l->states, struct looks);
	copy->state = texture_state_copy(l, looks->state);
	return copy;
}

static struct draft_interior *interior_copy(struct lowering *l, const struct draft_interior *i)
{
	return i ? arena_copy(l->states, i, sizeof *i) : NULL;
}

static struct draft *draft_copy(struct lowering *l, const struct draft *d);

static struct draft *list_copy(struct lowering *l, const struct draft *list)
{
	struct draft *first = NULL, **end = &first;
	for (; list; list = list->next) {
		*end = draft_copy(l, list);
		end = &(*end)->next;
	}
	return first;
}

static struct draft_extras *extras_copy(
	struct lowering *l, const struct draft_extras *e, bool bounds_are_clips)
{
	struct draft_extras *copy = arena_copy(l->states, e, sizeof *e);
	copy->children = list_copy(l, e->children);
	if (e->light)
		copy->light = arena_copy(l->arena, e->light, sizeof *e->light);
	copy->looks_like = e->looks_like ? draft_copy(l, e->looks_like) : NULL;
	copy->projected_through = e->projected_through ? draft_copy(l, e->projected_through) : NULL;
	copy->interior_texture = looks_copy(l, e->interior_texture);
	copy->interior = interior_copy(l, e->interior);
	if (e->extent)
		copy->extent = arena_copy(l->states, e->extent, sizeof *e->extent);
	copy->clips = list_copy(l, e->clips);
	copy->bounds = bounds_are_clips ? copy->clips : list_copy(l, e->bounds);
	return copy;
}

static struct draft *draft_copy(struct lowering *l, const struct draft *d)
{
	struct draft *copy = arena_copy(l->states, d, sizeof *d);
	copy->next = NULL;
	if (d->shape) {
		set_shape(l, copy, d->shape);
		memcpy(copy->self, d->self, d->shape->size);
	}
	copy->texture = looks_copy(l, d->texture);
	if (d->extras != &no_extras)
		copy->extras = extras_copy(l, d->extras, d->bounds_are_clips);
	return copy;
}

static void share_identities(struct lowering *l, struct draft *copy, const struct draft *original)
{
	if (original->extras == &no_extras)
		return;
	struct draft_extras *e = draft_extras(l, copy);
	e->interior = original->extras->interior;
	e->light = original->extras->light;
	const struct draft *from = original->extras->children;
	for (struct draft *to = e->children; to; to = to->next, from = from->next)
		share_identities(l, to, from);
}

struct draft *draft_twin(struct lowering *l, const struct draft *d)
{
	struct draft *copy = draft_copy(l, d);
	share_identities(l, copy, d);
	return copy;
}

struct step lower_step(struct lowering *l, const struct node *item)
{
	return (struct step){ .t = lower_transform(l, item),
		.is_scale = node_resolve(item)->keyword == K_SCALE };
}

void drafts_transform(struct lowering *l, struct draft *list, struct step *step)
{
	for (; list; list = list->next)
		draft_transform(l, list, step);
}

static void move_place(struct lowering *l, struct draft *d, struct step *step)
{
	if (!step->to || step->from != d->place) {
		const transform before = draft_place(d);
		const transform after = transform_compose(&before, &step->t);
		step->from = d->place;
		step->to = arena_copy(l->states, &after, sizeof after);
	}
	d->place = step->to;
}

void draft_transform(struct lowering *l, struct draft *d, struct step *step)
{
	const transform *t = &step->t;
	drafts_transform(l, d->extras->clips, step);
	if (!d->bounds_are_clips)
		drafts_transform(l, d->extras->bounds, step);
	if (d->texture && !d->uv_mapping)
		texture_state_transform(l, d->texture->state, t);
	if (d->extras->interior_texture && !d->uv_mapping)
		texture_state_transform(l, d->extras->interior_texture->state, t);
	drafts_transform(l, d->extras->children, step);
	if (d->kind == DRAFT_LIGHT) {
		light_transform(d->extras->light, t);
		drafts_transform(l, d->extras->looks_like, step);
		drafts_transform(l, d->extras->projected_through, step);
	} else if (d->shape && d->shape->step) {
		d->shape->step(d->self, t, step->is_scale);
	} else {
		move_place(l, d, step);
	}
	if (d->extras->extent)
		extent_move(l, d, t);
}

/* ---- primitives ---- */

struct build_report {
	struct lowering *lowering;
	const struct node *node;
};

static void build_error(void *user, const char *message)
{
	const struct build_report *r = user;
	diag_error(r->lowering->diag, r->node->span, "%s", message);
}

static void build_warning(void *user, const char *message)
{
	const struct build_report *r = user;
	diag_warning(r->lowering->diag, r->node->span, "%s", message);
}

static bool read_flag(struct lowering *l, const struct node *n, enum keyword word)
{
	bool value = false;
	for (const struct node *item = n->children; item; item = item->next)
		if (item->keyword == word)
			value = lower_switch(l, item, true);
	return value;
}

/* Writes argument `index` or the flag to its field. Returns the index of the next argument. */
static uint32_t fill_field(struct lowering *l, const struct node *n, uint32_t index,
	const struct parameter *p, void *field)
{
	switch (p->type) {
	case PARAMETER_FLOAT:
		*(double *)field = lower_float(l, n, index, p->name);
		return index + 1;
	case PARAMETER_VECTOR:
	case PARAMETER_PAIR:
		*(vec3 *)field = lower_vector(l, n, index, p->name);
		return index + 1;
	case PARAMETER_OPTIONAL:
		if (index >= n->arg_count)
			return index;
		*(double *)field = lower_float(l, n, index, p->name);
		return index + 1;
	case PARAMETER_ARRAY:
		if (index >= n->arg_count || n->args[index].kind != ARG_ARRAY)
			return index;
		*(struct field_array *)field = (struct field_array){ n->args[index].array.values,
			n->args[index].array.count };
		return index + 1;
	case PARAMETER_FLAG:
		*(bool *)field = read_flag(l, n, p->word);
		return index;
	default:
		return index;
	}
}

static void fill_fields(
	struct lowering *l, const struct node *n, const struct shape_class *shape, void *self)
{
	const struct field *field = shape->fields;
	uint32_t index = 0;
	const struct parameter *p = shape_word_of(n->keyword)->parameters;
	for (; p->type != PARAMETER_END; p++)
		if (p->type != PARAMETER_ITEM)
			index = fill_field(l, n, index, p, (char *)self + field++->offset);
	if (index < n->arg_count)
		diag_error(l->diag, n->args[index].span, "%s has one value too many",
			keyword_name(n->keyword));
}

static bool is_flag_of(enum keyword shape, enum keyword item)
{
	const struct parameter *p = shape_word_of(shape)->parameters;
	for (; p->type != PARAMETER_END; p++)
		if (p->type == PARAMETER_FLAG && p->word == item)
			return true;
	return false;
}

bool draft_takes_flag(const struct draft *d, const struct node *item)
{
	return d->kind == DRAFT_SHAPE && is_flag_of(d->node->keyword, item->keyword);
}

static struct draft *draft_primitive(
	struct lowering *l, const struct node *n, const struct shape_class *shape)
{
	struct draft *d = draft_create(l, DRAFT_SHAPE, n);
	const unsigned before = diag_errors(l->diag);
	set_shape(l, d, shape);
	fill_fields(l, n, shape, d->self);
	struct build_report report = { l, n };
	struct shape_build build = {
		.arena = l->arena, .user = &report, .error = build_error, .warning = build_warning
	};
	if (shape->build && diag_errors(l->diag) == before)
		shape->build(d->self, &build);
	if (build.dropped) { /* an empty union in its place */
		d->kind = DRAFT_CSG;
		d->csg = CSG_UNION;
		d->object = NULL;
		d->shape = NULL;
		d->self = NULL;
	}
	extent_begin(l, d);
	for (const struct node *item = n->children; item; item = item->next) {
		if (!is_flag_of(n->keyword, item->keyword))
			draft_modify(l, d, item);
	}
	return d;
}

/* ---- compounds ---- */

/* Most often a brace stands in the wrong place. */
static void warn_of_few_members(struct lowering *l, const struct node *n)
{
	int members = 0;
	for (const struct node *item = n->children; item && members < 2; item = item->next)
		members += node_is_object(item);
	if (members < 2)
		diag_warning(l->diag, n->word, "%s of %s", keyword_name(n->keyword),
			members == 0 ? "no objects" : "a single object");
}

/* Whether something of a draft refers to its node; if not, so does the draft no longer. */
static bool keeps_node(struct draft *d)
{
	const struct draft_extras *e = d->extras;
	if (d->kind == DRAFT_MADE || d->texture || e->interior_texture || e->looks_like ||
		e->projected_through || e->clips || e->bounds)
		return true;
	bool keeps = false;
	for (struct draft *child = e->children; child; child = child->next)
		keeps |= keeps_node(child);
	if (!keeps)
		d->node = NULL;
	return keeps;
}

static bool is_begun(const struct begun_compound *begun, span word)
{
	return begun->end && begun->word.source == word.source &&
	       begun->word.offset == word.offset && begun->word.site == word.site;
}

void draft_members(struct lowering *l, span word, const struct node *first)
{
	struct begun_compound *begun = &l->begun;
	if (!is_begun(begun, word))
		*begun = (struct begun_compound){ .word = word, .end = &begun->first };
	for (const struct node *item = first; item; item = item->next) {
		struct draft *child = draft_from_node(l, item);
		if (!child)
			continue;
		begun->has_nodes |= keeps_node(child);
		*begun->end = child;
		begun->end = &child->next;
	}
}

/* Where the next child goes, behind the members that are drafted already. */
static struct draft **adopt_members(struct lowering *l, struct draft *d)
{
	struct draft_extras *e = draft_extras(l, d);
	if (!is_begun(&l->begun, d->node->word))
		return &e->children;
	struct draft **end = l->begun.first ? l->begun.end : &e->children;
	e->children = l->begun.first;
	l->begun = (struct begun_compound){ .first = NULL };
	return end;
}

static void read_children(struct lowering *l, const struct node *n, struct draft *d)
{
	struct draft **end = adopt_members(l, d);
	bool first = true;
	for (const struct node *item = n->children; item; item = item->next) {
		if (!node_is_object(item))
			continue;
		struct draft *child = draft_from_node(l, item);
		if (!child)
			continue;
		if (d->is_difference && !first && child->kind != DRAFT_LIGHT)
			draft_invert(l, child);
		first = first && child->kind == DRAFT_LIGHT;
		*end = child;
		end = &child->next;
	}
}

static void read_modifiers(struct lowering *l, const struct node *n, struct draft *d)
{
	for (const struct node *item = n->children; item; item = item->next) {
		if (!node_is_object(item))
			draft_modify(l, d, item);
	}
}

static void warn_of_patches(struct lowering *l, const struct draft *d)
{
	for (const struct draft *child = d->extras->children; child; child = child->next)
		if (draft_is_patch(child))
			diag_warning(l->diag, child->node->word,
				"%s has no inside, or a part without one: its place is in a union, "
				"not in %s",
				keyword_name(child->node->keyword), keyword_name(d->node->keyword));
}

static struct draft *draft_csg(struct lowering *l, const struct node *n)
{
	struct draft *d = draft_create(l, DRAFT_CSG, n);
	d->is_difference = n->keyword == K_DIFFERENCE;
	d->csg = n->keyword == K_MERGE				      ? CSG_MERGE
		 : n->keyword == K_UNION || n->keyword == K_COMPOSITE ? CSG_UNION
								      : CSG_INTERSECTION;
	if (!is_begun(&l->begun, n->word)) /* else there are many */
		warn_of_few_members(l, n);
	read_children(l, n, d);
	if (d->csg == CSG_INTERSECTION)
		warn_of_patches(l, d);
	extent_begin(l, d);
	read_modifiers(l, n, d);
	return d;
}

static struct draft *draft_light(struct lowering *l, const struct node *n)
{
	struct draft *d = draft_create(l, DRAFT_LIGHT, n);
	struct light *light = ARENA_NEW(l->arena, struct light);
	draft_extras(l, d)->light = light;
	light_defaults(light);
	extent_begin(l, d);
	lower_light_items(l, n, d);
	return d;
}

static struct draft *draft_group(struct lowering *l, const struct node *n)
{
	struct draft *d = draft_create(l, DRAFT_GROUP, n);
	read_children(l, n, d);
	extent_begin(l, d);
	for (const struct node *item = n->children; item; item = item->next) {
		if (node_is_object(item))
			continue;
		if (item->keyword == K_GLOBAL_LIGHTS)
			d->global_lights = lower_switch(l, item, true);
		else if (item->keyword != K_PHOTONS)
			draft_modify(l, d, item);
	}
	return d;
}

static struct draft *draft_made(struct lowering *l, const struct node *n, shape_road *road)
{
	struct draft *d = draft_create(l, DRAFT_MADE, n);
	draft_extras(l, d)->road = road;
	extent_begin(l, d);
	read_modifiers(l, n, d);
	return d;
}

/* object { S modifiers } */
static struct draft *draft_object(struct lowering *l, const struct node *n)
{
	const struct node *inner = n->children;
	while (inner && !node_is_object(inner))
		inner = inner->next;
	if (!inner) {
		diag_error(l->diag, n->span, "object needs an object between its braces");
		return NULL;
	}
	struct draft *d = draft_from_node(l, inner);
	if (d)
		read_modifiers(l, n, d);
	return d;
}

/* An interior_texture is the other side of a texture of the same object. */
static void check_interior_texture(struct lowering *l, const struct node *n, const struct draft *d)
{
	const struct node *item = n->children;
	while (item && item->keyword != K_INTERIOR_TEXTURE)
		item = item->next;
	if (item && !d->texture)
		diag_error(l->diag, item->span,
			"interior_texture needs a texture or pigment of the same object beside it");
}

/* What renders a primitive, or NULL; looked up by name once. */
static const struct shape_class *shape_of(struct lowering *l, enum keyword k)
{
	if (!l->shapes[k])
		l->shapes[k] = shape_find(keyword_name(k));
	return l->shapes[k];
}

static struct draft *draft_statement(struct lowering *l, const struct node *n)
{
	if (n->keyword == K_OBJECT)
		return draft_object(l, n);
	if (is_csg_keyword(n->keyword))
		return draft_csg(l, n);
	if (n->keyword == K_LIGHT_SOURCE)
		return draft_light(l, n);
	if (n->keyword == K_LIGHT_GROUP)
		return draft_group(l, n);
	shape_road *road = shape_road_find(n->keyword);
	if (road)
		return draft_made(l, n, road);
	const struct shape_class *shape = shape_of(l, n->keyword);
	if (shape)
		return draft_primitive(l, n, shape);
	lower_unsupported(l, n, keyword_name(n->keyword));
	return NULL;
}

static struct draft *draft_complete(struct lowering *l, const struct node *n)
{
	struct draft *d = draft_statement(l, n);
	if (!d)
		return NULL;
	check_interior_texture(l, n, d);
	if (d->extras->extent)
		extent_cut(d);
	return d;
}

/* Drafts a declared object to be copied from. What there is to say was said at its first use. */
static struct draft *draft_to_keep(struct lowering *l, const struct node *n)
{
	struct arena *const before = lowering_keep(l);
	const bool muted = diag_mute(l->diag, true);
	struct draft *d = draft_complete(l, n);
	diag_mute(l->diag, muted);
	l->states = before;
	return d;
}

/* Many a declared object is used once, such as each state of a union that a loop makes of itself and
 * one object more: only from its second use on there is a draft to copy from. */
struct draft *draft_from_node(struct lowering *l, const struct node *item)
{
	static const struct draft used_once;
	if (item->keyword != K_REFERENCE)
		return draft_complete(l, item);
	const struct node *n = node_resolve(item);
	const struct draft *declared = pointer_map_find(&l->drafts, n);
	if (!declared) {
		pointer_map_add(&l->drafts, n, (void *)(uintptr_t)&used_once);
		return draft_complete(l, n);
	}
	if (declared == &used_once) {
		declared = draft_to_keep(l, n);
		if (!declared)
			return NULL;
		pointer_map_add(&l->drafts, n, (void *)(uintptr_t)declared);
	}
	return draft_copy(l, declared);
}

struct draft *draft_from_block(struct lowering *l, const struct node *n)
{
	return draft_object(l, n);
}
