/* SPDX-License-Identifier: MIT */
/*
 * A complete top-level draft becomes objects and lights of the scene: looks,
 * interiors and flags go from parent to child, unions are dissolved, what still
 * has no texture gets the default one.
 */
#include "lower/draft.h"

#include <stdlib.h>
#include <string.h>

/* What a child takes from its parents. */
struct heritage {
	struct looks *texture, *interior_texture;
	struct draft_interior *interior;
	struct draft_interior **fallback; /* of the whole statement: made when first needed */
	bool in_compound;		  /* the fallback is shared with others */
	bool in_solid;			  /* part of an object that stays one */
	bool uv_mapping, no_shadow, no_image, no_reflection;
	const struct light *const *lights;
	bool global_lights;
	const struct language_state *state;
	uint32_t
		only; /* the kind of ray this is made for, where rays see different things; else 0 */
	bool is_repeat; /* after others for other rays: lights are there already */
};

struct object_list {
	struct object **items;
	size_t count, room;
};

static void list_add(struct object_list *list, struct object *o)
{
	if (list->count == list->room) {
		list->room = list->room ? 2 * list->room : 8;
		list->items = memory_grow(list->items, list->room, sizeof(struct object *));
	}
	list->items[list->count++] = o;
}

/* What has been added behind the first so many. */
static struct object_list list_from(const struct object_list *list, size_t first)
{
	return (struct object_list){ list->items ? list->items + first : NULL, list->count - first,
		0 };
}

static void scene_add_object(struct scene *s, struct object *o)
{
	if (s->object_count == s->object_room) {
		s->object_room = s->object_room ? 2 * s->object_room : 64;
		s->objects = memory_grow(s->objects, s->object_room, sizeof(struct object *));
	}
	s->objects[s->object_count++] = o;
}

static void scene_add_light(struct scene *s, struct light *light)
{
	if (s->light_count == s->light_room) {
		s->light_room = s->light_room ? 2 * s->light_room : 16;
		s->lights = memory_grow(s->lights, s->light_room, sizeof(struct light *));
	}
	s->lights[s->light_count++] = light;
}

static void collect(
	struct lowering *, struct draft *, const struct heritage *, struct object_list *);

/* ---- looks ---- */

static const struct texture *finish_looks(struct lowering *l, struct looks *looks, bool uv)
{
	if (!looks || !looks->state)
		return NULL;
	if (!looks->finished)
		looks->finished = texture_state_finish(l, looks->state, uv);
	return looks->finished;
}

/* One finished default texture for each #default in force. */
static const struct texture *default_texture(struct lowering *l, const struct language_state *state)
{
	if (!l->default_texture || l->default_of != state->defaults) {
		l->default_texture =
			texture_state_finish(l, texture_state_default(l, state), false);
		l->default_of = state->defaults;
	}
	return l->default_texture;
}

static struct heritage inherit(const struct heritage *parent, const struct draft *d)
{
	struct heritage h = *parent;
	if (d->texture) {
		h.texture = d->texture;
		h.uv_mapping = d->uv_mapping;
	}
	if (d->extras->interior_texture)
		h.interior_texture = d->extras->interior_texture;
	if (d->extras->interior)
		h.interior = d->extras->interior;
	h.in_compound |= d->kind == DRAFT_CSG || d->kind == DRAFT_MADE;
	h.in_solid |= d->kind == DRAFT_CSG && (d->csg != CSG_UNION || d->extras->clips);
	h.no_shadow |= d->no_shadow;
	h.no_image |= d->no_image;
	h.no_reflection |= d->no_reflection;
	return h;
}

/*
 * All leaves without an interior of their own share their compound's, and each sets its `hollow` and
 * the obsolete ior and caustics of its finish there: what the last leaf says holds for all of them, as
 * in POV-Ray.
 */
static const struct interior *finish_interior(
	struct lowering *l, struct draft_interior *i, bool hollow, const struct looks *looks)
{
	double ior, caustics;
	if (looks && looks->state && texture_state_interior(looks->state, &ior, &caustics)) {
		i->data.ior = ior > 0 ? ior : i->data.ior;
		i->data.caustics = caustics != 0 ? caustics : i->data.caustics;
	}
	i->data.hollow = hollow;
	if (!i->finished)
		i->finished = arena_pack(l->arena, sizeof *i->finished);
	*i->finished = i->data;
	return i->finished;
}

/* Opaque objects are never entered, so those that share with nobody need none of their own. */
static const struct interior *plain_interior(struct lowering *l, bool hollow)
{
	struct interior **slot = &l->plain_interior[hollow];
	if (!*slot) {
		*slot = ARENA_NEW(l->arena, struct interior);
		**slot = (struct interior){
			.ior = 1, .dispersion = 1, .dispersion_samples = 7, .hollow = hollow
		};
	}
	return *slot;
}

/*
 * The interior that was given, or the one of everything in the statement that was given none. A
 * compound asks before its parts do: theirs is the last word on what is shared.
 */
static const struct interior *shared_interior(
	struct lowering *l, const struct draft *d, const struct heritage *h)
{
	if (!h->interior && !*h->fallback)
		*h->fallback = lower_interior(l, NULL, NULL);
	return finish_interior(l, h->interior ? h->interior : *h->fallback, d->hollow, h->texture);
}

static const struct interior *interior_of(struct lowering *l, const struct draft *d,
	const struct heritage *h, const struct texture *texture)
{
	if (!h->interior && texture->opaque && !h->in_compound)
		return plain_interior(l, d->hollow);
	return shared_interior(l, d, h);
}

static uint8_t visibility(const struct heritage *h, bool opaque)
{
	unsigned kinds = RAY_CAMERA | RAY_SECONDARY | RAY_REFLECTED;
	if (h->no_image)
		kinds &= ~(unsigned)(RAY_CAMERA | RAY_SECONDARY);
	if (h->no_reflection)
		kinds &= ~(unsigned)RAY_REFLECTED;
	if (!h->no_shadow)
		kinds |= opaque ? RAY_SHADOW_OPAQUE : RAY_SHADOW_TINTED;
	return (uint8_t)kinds;
}

/* The extras of an object, to be written. */
static struct object_extras *extras_of(struct lowering *l, struct object *o)
{
	if (!o->extras)
		o->extras = arena_pack(l->arena, sizeof *o->extras);
	return (struct object_extras *)(uintptr_t)o->extras;
}

static const struct object *const *finish_cutters(
	struct lowering *l, struct draft *list, const struct heritage *h, uint32_t *count);

static void finish_cutting(
	struct lowering *l, const struct draft *d, const struct heritage *h, struct object *o)
{
	if (!d->extras->clips)
		return;
	struct object_extras *e = extras_of(l, o);
	e->clips = finish_cutters(l, d->extras->clips, h, &e->clip_count);
}

static void finish_lights(struct lowering *l, const struct heritage *h, struct object *o)
{
	o->global_lights = h->global_lights;
	if (h->lights)
		extras_of(l, o)->lights = h->lights;
}

/* Everything about a leaf but its shape and place. */
static void finish_leaf(
	struct lowering *l, const struct draft *d, const struct heritage *h, struct object *o)
{
	o->texture = finish_looks(l, h->texture, h->uv_mapping);
	if (!o->texture)
		o->texture = default_texture(l, h->state);
	const struct texture *inner = finish_looks(l, h->interior_texture, h->uv_mapping);
	if (inner)
		extras_of(l, o)->interior_texture = inner;
	o->interior = interior_of(l, d, h, o->texture);
	o->uv_mapping = h->uv_mapping;
	o->hollow = d->hollow;
	o->double_illuminate = d->double_illuminate;
	o->inverted = d->inverted;
	o->normal_stays = o->shape->keeps_normal_inverted;
	finish_lights(l, h, o);
	o->visible_to = visibility(h, o->texture->opaque && (!inner || inner->opaque));
	finish_cutting(l, d, h, o);
	object_set_bounds(o);
}

/* Objects that moved together share their place. */
static const transform *place_copy(struct lowering *l, const transform *place)
{
	if (!l->latest_place || memcmp(l->latest_place, place, sizeof *place) != 0) {
		transform *copy = arena_pack(l->arena, sizeof *copy);
		*copy = *place;
		l->latest_place = copy;
	}
	return l->latest_place;
}

static struct object *finish_shape(struct lowering *l, struct draft *d, const struct heritage *h)
{
	struct object *o = d->object;
	o->shape = d->shape;
	o->self = d->self;
	const bool moved = d->place && !transform_is_identity(d->place);
	/* uv coordinates of a sphere are those before its transformations */
	if (moved && (h->uv_mapping || !d->shape->absorb || !d->shape->absorb(d->self, d->place)))
		o->place = place_copy(l, d->place);
	finish_leaf(l, d, h, o);
	if (moved && !o->place && d->shape->uv && l->has_uv_mapping)
		extras_of(l, o)->uv_place = place_copy(l, d->place);
	return o;
}

struct glyphs {
	struct lowering *lowering;
	const struct draft *draft;
	const struct heritage *heritage;
	struct object_list *out;
};

static void add_glyph(void *user, struct object *o)
{
	struct glyphs *g = user;
	finish_leaf(g->lowering, g->draft, g->heritage, o);
	list_add(g->out, o);
}

/* ---- compounds ---- */

/* The last `unseen` children have no surface. */
static struct object *wrap(struct lowering *l, enum csg_kind kind,
	const struct object_list *children, size_t unseen, const struct heritage *h)
{
	struct object *o = arena_pack(l->arena, sizeof *o);
	struct csg *csg = ARENA_NEW(l->arena, struct csg);
	csg->kind = kind;
	csg->count = children->count - unseen;
	csg->unseen = unseen;
	csg->children =
		arena_copy(l->arena, children->items, children->count * sizeof(struct object *));
	bool opaque = true, any_shadow = false;
	for (size_t i = 0; i < children->count; i++) {
		any_shadow |= (children->items[i]->visible_to &
				      (RAY_SHADOW_OPAQUE | RAY_SHADOW_TINTED)) != 0;
		opaque &= (children->items[i]->visible_to & RAY_SHADOW_TINTED) == 0 &&
			  (!children->items[i]->texture || children->items[i]->texture->opaque);
	}
	struct heritage own = *h;
	own.no_shadow |= kind == CSG_UNION && !any_shadow;
	o->shape = &shape_csg;
	o->self = csg;
	finish_lights(l, h, o);
	o->visible_to = visibility(&own, opaque);
	return o;
}

/* A child of a compound must be one object. */
static struct object *collect_one(struct lowering *l, struct draft *d, const struct heritage *h)
{
	struct object_list list = { NULL, 0, 0 };
	collect(l, d, h, &list);
	struct object *o = list.count == 1 ? list.items[0] : NULL;
	if (!o) {
		o = wrap(l, CSG_UNION, &list, 0, h);
		object_set_bounds(o);
	}
	free(list.items);
	return o;
}

static const struct object *const *finish_cutters(
	struct lowering *l, struct draft *list, const struct heritage *h, uint32_t *count)
{
	const struct heritage plain = { .fallback = h->fallback, .state = h->state };
	struct object_list cutters = { NULL, 0, 0 };
	for (struct draft *d = list; d; d = d->next)
		list_add(&cutters, collect_one(l, d, &plain));
	*count = (uint32_t)cutters.count;
	const struct object *const *copy =
		arena_copy(l->arena, cutters.items, cutters.count * sizeof(struct object *));
	free(cutters.items);
	return copy;
}

static box hull_of(const struct object_list *list)
{
	box hull = box_nothing();
	for (size_t i = 0; i < list->count; i++)
		hull = box_union(hull, list->items[i]->bounds);
	return hull;
}

/* Whether a convex bound holds the whole box: then it can be dropped. */
static bool holds_box(const struct object *bound, box b)
{
	if (box_is_unbounded(b) || !bound->shape->is_convex || bound->inverted ||
		(bound->extras && bound->extras->clip_count))
		return false;
	for (int corner = 0; corner < 8; corner++) {
		const vec3 p = vec(corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y,
			corner & 4 ? b.hi.z : b.lo.z);
		if (!object_inside(bound, p))
			return false;
	}
	return true;
}

/* The user's bounds that can cut something off the objects in the list. */
static void finish_bounds(struct lowering *l, struct draft *d, const struct heritage *h,
	const struct object_list *list, const struct object *const **bounds, uint32_t *count)
{
	*bounds = NULL;
	*count = 0;
	if (!d->extras->bounds || d->bounds_are_clips)
		return;
	uint32_t all = 0, tight = 0;
	const struct object *const *made = finish_cutters(l, d->extras->bounds, h, &all);
	const box hull = hull_of(list);
	for (uint32_t i = 0; i < all; i++)
		tight += !holds_box(made[i], hull);
	if (tight) {
		*bounds = made;
		*count = all;
	}
}

static bool has_light(const struct draft *d)
{
	for (const struct draft *child = d->extras->children; child; child = child->next)
		if (child->kind == DRAFT_LIGHT)
			return true;
	return false;
}

/* The objects of an author who bounds by hand have boxes already. */
static void warn_of_bounds(
	struct lowering *l, const struct draft *d, const struct object_list *bounded)
{
	if (d->extras->bounds && !d->bounds_are_clips && !l->for_questions &&
		!box_is_unbounded(hull_of(bounded)))
		diag_warning(l->diag, d->extras->bounds->node->span,
			"bounded_by is not needed: each finite object has its own bounds");
}

static void keep_bounds(
	struct lowering *l, struct object *o, const struct object *const *bounds, uint32_t count)
{
	if (!count)
		return;
	struct object_extras *e = extras_of(l, o);
	e->bounds_by = bounds;
	e->bound_count = count;
}

static void intersect_bounds(struct object *o, const struct object *const *bounds, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		if (!bounds[i]->inverted && !box_is_unbounded(bounds[i]->bounds))
			o->bounds = box_intersection(o->bounds, bounds[i]->bounds);
	}
}

/* ---- children that not all rays see ---- */

static bool has_flags_within(const struct draft *d)
{
	for (const struct draft *child = d->extras->children; child; child = child->next) {
		if (child->no_image || child->no_reflection || child->no_shadow ||
			has_flags_within(child))
			return true;
	}
	return false;
}

/* Whether a union stays one object. Bounds that cut nothing off only matter to flags. */
static bool is_kept(const struct draft *d)
{
	return d->extras->clips || !d->split_union || (d->extras->bounds && has_flags_within(d));
}

/*
 * Within a merge, and a union that stays one object, a child with no_image or no_reflection is
 * unseen by some rays: then the object is made several times, each time for other rays. Camera
 * rays see the no_image children of a union all the same, as in POV-Ray.
 */
static bool is_left_out(
	const struct draft *parent, const struct draft *child, const struct heritage *h)
{
	if (!h->only || parent->csg == CSG_INTERSECTION)
		return false;
	const bool sees_all = parent->csg == CSG_UNION && h->only == RAY_CAMERA;
	return h->only == RAY_REFLECTED ? child->no_reflection : child->no_image && !sees_all;
}

/* The kinds of rays for which some child within is left out. */
static uint32_t missing_for(const struct draft *d, bool in_compound)
{
	const bool is_compound =
		d->kind == DRAFT_CSG && (in_compound || d->csg != CSG_UNION || is_kept(d));
	const bool leaves_out = is_compound && d->csg != CSG_INTERSECTION;
	uint32_t kinds = 0;
	for (const struct draft *child = d->extras->children; child; child = child->next) {
		kinds |= missing_for(child, is_compound);
		if (leaves_out && child->no_image)
			kinds |= RAY_CAMERA | RAY_SECONDARY;
		if (leaves_out && child->no_reflection)
			kinds |= RAY_REFLECTED;
	}
	return kinds;
}

/* Adds the children that are left out; their number. */
static size_t collect_unseen(
	struct lowering *l, struct draft *d, const struct heritage *h, struct object_list *members)
{
	const size_t before = members->count;
	for (struct draft *child = d->extras->children; child; child = child->next) {
		if (is_left_out(d, child, h))
			list_add(members, collect_one(l, child, h));
	}
	return members->count - before;
}

static void collect_union(
	struct lowering *l, struct draft *d, const struct heritage *h, struct object_list *out)
{
	const struct interior *interior = shared_interior(l, d, h);
	const size_t first = out->count;
	for (struct draft *child = d->extras->children; child; child = child->next)
		if (!is_left_out(d, child, h))
			collect(l, child, h, out);
	const size_t unseen = collect_unseen(l, d, h, out);
	const struct object_list members = list_from(out, first);
	const struct object *const *bounds;
	uint32_t bound_count;
	finish_bounds(l, d, h, &members, &bounds, &bound_count);
	if (d->split_union && !h->in_solid && !has_light(d))
		warn_of_bounds(l, d, &members);
	if (members.count && (bound_count || unseen || is_kept(d))) {
		struct object *o = wrap(l, CSG_UNION, &members, unseen, h);
		o->interior = interior;
		finish_cutting(l, d, h, o);
		keep_bounds(l, o, bounds, bound_count);
		object_set_bounds(o);
		intersect_bounds(o, bounds, bound_count);
		out->count = first;
		list_add(out, o);
	}
}

/* An intersection of nothing is everywhere: what it is a part of may need that. */
static void collect_compound(
	struct lowering *l, struct draft *d, const struct heritage *h, struct object_list *out)
{
	struct object_list members = { NULL, 0, 0 };
	const struct interior *interior = shared_interior(l, d, h);
	for (struct draft *child = d->extras->children; child; child = child->next) {
		if (child->kind == DRAFT_LIGHT)
			collect(l, child, h, out);
		else if (!is_left_out(d, child, h))
			list_add(&members, collect_one(l, child, h));
	}
	const size_t unseen = collect_unseen(l, d, h, &members);
	if (members.count || d->csg == CSG_INTERSECTION) {
		struct object *o = wrap(l, d->csg, &members, unseen, h);
		o->interior = interior;
		if (!members.count && !h->interior)
			o->interior = plain_interior(l, true); /* nothing is in nothing */
		finish_cutting(l, d, h, o);
		object_set_bounds(o);
		struct object_list self = { &o, 1, 1 };
		const struct object *const *bounds;
		uint32_t bound_count;
		finish_bounds(l, d, h, &self, &bounds, &bound_count);
		keep_bounds(l, o, bounds, bound_count);
		intersect_bounds(o, bounds, bound_count);
		list_add(out, o);
	}
	free(members.items);
}

/* The objects of a road; turned inside out, what is outside all of them. */
static void collect_made(
	struct lowering *l, struct draft *d, const struct heritage *h, struct object_list *out)
{
	const struct interior *interior = shared_interior(l, d, h);
	struct object_list letters = { NULL, 0, 0 };
	struct glyphs glyphs = { l, d, h, d->inverted ? &letters : out };
	const transform place = draft_place(d);
	d->extras->road(l, d->node, &place, add_glyph, NULL, &glyphs);
	if (d->inverted) {
		struct object *o = wrap(l, CSG_INTERSECTION, &letters, 0, h);
		o->interior = interior;
		object_set_bounds(o);
		list_add(out, o);
	}
	free(letters.items);
}

/* ---- lights ---- */

static void collect_light(struct lowering *l, struct draft *d, const struct heritage *h,
	bool in_group, struct object_list *out)
{
	light_finish(d->extras->light);
	d->extras->light->group_only = in_group;
	if (d->extras->projected_through) {
		const struct heritage plain = { .fallback = h->fallback, .state = h->state };
		d->extras->light->projected_through =
			collect_one(l, d->extras->projected_through, &plain);
	}
	scene_add_light(l->scene, d->extras->light);
	if (d->extras->looks_like) {
		const struct heritage lamp = { .fallback = h->fallback,
			.state = h->state,
			.no_shadow = true,
			.global_lights = true };
		collect(l, d->extras->looks_like, &lamp, out);
	}
}

/* A light_group: its own lights shine on its objects only. Turned inside out it is what all of them
 * turned inside out have in common. */
static void collect_group(
	struct lowering *l, struct draft *d, const struct heritage *h, struct object_list *out)
{
	size_t count = 0;
	for (struct draft *child = d->extras->children; child; child = child->next)
		count += child->kind == DRAFT_LIGHT;
	const struct light **lights = ARENA_ARRAY(l->arena, count + 1, const struct light *);
	size_t i = 0;
	for (struct draft *child = d->extras->children; child; child = child->next) {
		if (child->kind == DRAFT_LIGHT)
			lights[i++] = child->extras->light;
	}
	struct heritage own = *h;
	own.lights = lights;
	own.global_lights = d->global_lights;
	const struct interior *interior = shared_interior(l, d, h);
	struct object_list members = { NULL, 0, 0 };
	for (struct draft *child = d->extras->children; child; child = child->next) {
		if (child->kind == DRAFT_LIGHT && !h->is_repeat)
			collect_light(l, child, h, true, out);
		else if (child->kind != DRAFT_LIGHT && d->csg == CSG_UNION)
			collect(l, child, &own, out);
		else if (child->kind != DRAFT_LIGHT)
			list_add(&members, collect_one(l, child, &own));
	}
	if (d->csg != CSG_UNION) {
		struct object *o = wrap(l, d->csg, &members, 0, &own);
		o->interior = interior;
		object_set_bounds(o);
		list_add(out, o);
	}
	free(members.items);
}

static void collect(
	struct lowering *l, struct draft *d, const struct heritage *parent, struct object_list *out)
{
	const struct heritage h = inherit(parent, d);
	switch (d->kind) {
	case DRAFT_LIGHT:
		if (!h.is_repeat)
			collect_light(l, d, &h, false, out);
		break;
	case DRAFT_GROUP:
		collect_group(l, d, &h, out);
		break;
	case DRAFT_CSG:
		if (d->csg == CSG_UNION)
			collect_union(l, d, &h, out);
		else
			collect_compound(l, d, &h, out);
		break;
	case DRAFT_MADE:
		collect_made(l, d, &h, out);
		break;
	case DRAFT_SHAPE: {
		struct object *o = finish_shape(l, d, &h);
		struct object_list self = { &o, 1, 1 };
		const struct object *const *bounds;
		uint32_t bound_count;
		finish_bounds(l, d, &h, &self, &bounds, &bound_count);
		if (!h.in_solid)
			warn_of_bounds(l, d, &self);
		intersect_bounds(o, bounds, bound_count);
		list_add(out, o);
		break;
	}
	}
}

/* For rays of these kinds. */
static void emit(struct lowering *l, struct draft *d, const struct heritage *h, uint32_t kinds)
{
	struct object_list list = { NULL, 0, 0 };
	collect(l, d, h, &list);
	for (size_t i = 0; i < list.count; i++) {
		struct object *o = list.items[i];
		o->visible_to &= (uint8_t)kinds;
		o->is_repeat = h->is_repeat;
		if (o->visible_to || kinds == RAY_ALL)
			scene_add_object(l->scene, o);
	}
	free(list.items);
}

void draft_emit(struct lowering *l, struct draft *d, const struct language_state *state)
{
	static const uint32_t apart[] = { RAY_CAMERA, RAY_SECONDARY, RAY_REFLECTED };
	struct draft_interior *fallback = NULL;
	struct heritage h = { .fallback = &fallback, .global_lights = true, .state = state };
	const uint32_t missing = l->for_questions ? 0 : missing_for(d, false);
	for (size_t i = 0; missing && i < sizeof apart / sizeof *apart; i++) {
		if (!(missing & apart[i]))
			continue;
		h.only = apart[i];
		emit(l, draft_twin(l, d), &h, h.only);
		h.is_repeat = true;
	}
	h.only = 0;
	emit(l, d, &h, RAY_ALL & ~missing);
}

const struct object *lower_inside_object(struct lowering *l, const struct node *block)
{
	struct draft_interior *fallback = NULL;
	const struct heritage none = { .fallback = &fallback, .state = block->state };
	struct draft *d = NULL;
	struct arena *const before = l->states;
	l->states = l->statement_states; /* the object is of the scene, whoever keeps the test */
	for (const struct node *item = block->children; item; item = item->next) {
		if (!d && node_is_object(item)) {
			d = draft_from_node(l, item);
		} else if (d && node_is_transform(item)) {
			struct step step = lower_step(l, item);
			draft_transform(l, d, &step);
		}
	}
	const struct object *o = d ? collect_one(l, d, &none) : NULL;
	l->states = before;
	return o;
}
