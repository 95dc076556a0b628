/* SPDX-License-Identifier: MIT */
/*
 * The boxes that min_extent and max_extent tell of. Scenes place things by them,
 * so they are those of the language, not the tightest: the corners of a shape's
 * own box are moved, a compound's box again with each transformation, and a clip
 * counts only if its box is the smaller one. Kept while an object is read.
 */
#include "lower/draft.h"

/* A box longer than this is no bound. */
#define LONGEST 1e6
/* Volumes nearer than this share are equal, as they are in single precision. */
#define SAME 1e-6

static double volume(box b)
{
	const vec3 size = vec_sub(b.hi, b.lo);
	return size.x * size.y * size.z;
}

/* Half-spaces, which planes have, bound nothing by themselves. */
static box whole(box b)
{
	return box_is_unbounded(b) ? box_everything() : b;
}

/* ---- primitives ---- */

static box box_of_shape(const struct shape_class *shape, const void *self, const transform *place)
{
	return shape->extent ? shape->extent(self, place) : box_placed(shape->bounds(self), place);
}

static bool absorbs(struct lowering *l, const struct draft *d, const transform *t, void **moved)
{
	*moved = arena_copy(l->states, d->self, d->shape->size);
	return d->shape->absorb && d->shape->absorb(*moved, t);
}

static box box_of_placed(struct lowering *l, const struct draft *d)
{
	const struct extent *e = d->extras->extent;
	void *moved;
	absorbs(l, d, &e->absorbed, &moved);
	return box_of_shape(d->shape, moved, e->has_rest ? &e->rest : NULL);
}

/* A shape takes in what it can; from the first transformation on that it cannot, its corners move. */
static void move_shape(struct lowering *l, struct draft *d, const transform *t)
{
	struct extent *e = d->extras->extent;
	const transform all = transform_compose(&e->absorbed, t);
	void *moved;
	if (!e->has_rest && absorbs(l, d, &all, &moved)) {
		e->absorbed = all;
	} else {
		e->rest = transform_compose(&e->rest, t);
		e->has_rest = true;
	}
	e->box = box_of_placed(l, d);
}

/* ---- compounds ---- */

/* Of no children: no bound. */
static box hull_of_children(const struct draft *d)
{
	box b = d->extras->children ? box_nothing() : box_everything();
	for (const struct draft *child = d->extras->children; child; child = child->next)
		b = box_union(b, whole(child->extras->extent->box));
	return b;
}

/* The part of b that the inside of a shape may reach. */
static box reached(struct lowering *l, const struct draft *d, box b)
{
	void *moved;
	const transform place = draft_place(d);
	if (!d->shape || !d->shape->extent_within || !absorbs(l, d, &place, &moved))
		return b;
	return box_intersection(b, d->shape->extent_within(moved, b));
}

static bool is_counted(const struct draft *child)
{
	return !child->extras->extent->inverted && child->kind != DRAFT_LIGHT;
}

/* Also of planes along the axes; last come shapes whose reach depends on the others. */
static box common_of_children(struct lowering *l, const struct draft *d)
{
	box b = box_everything();
	for (const struct draft *child = d->extras->children; child; child = child->next) {
		if (is_counted(child))
			b = box_intersection(b, child->extras->extent->box);
	}
	for (const struct draft *child = d->extras->children; child; child = child->next) {
		if (is_counted(child))
			b = reached(l, child, b);
	}
	return b;
}

static void add_part(void *user, struct object *part)
{
	box *hull = user;
	*hull = box_union(*hull, box_of_shape(part->shape, part->self, part->place));
}

static box hull_of_parts(struct lowering *l, const struct draft *d)
{
	box hull = box_nothing();
	d->extras->road(l, d->node, NULL, add_part, add_part, &hull);
	return hull;
}

/* ---- the life of a draft ---- */

static box first_box(struct lowering *l, const struct draft *d)
{
	switch (d->kind) {
	case DRAFT_SHAPE:
		return box_of_shape(d->shape, d->self, NULL);
	case DRAFT_MADE:
		return hull_of_parts(l, d);
	case DRAFT_LIGHT:
		return box_everything();
	default:
		return d->csg == CSG_INTERSECTION ? common_of_children(l, d) : hull_of_children(d);
	}
}

static bool is_long(box b)
{
	const vec3 size = vec_sub(b.hi, b.lo);
	return size.x > LONGEST || size.y > LONGEST || size.z > LONGEST;
}

void extent_begin(struct lowering *l, struct draft *d)
{
	if (!l->for_questions)
		return;
	struct extent *e = ARENA_NEW(l->states, struct extent);
	e->absorbed = e->rest = transform_identity();
	e->box = first_box(l, d);
	if (d->kind == DRAFT_CSG && is_long(e->box))
		e->box = box_everything();
	draft_extras(l, d)->extent = e;
}

void extent_move(struct lowering *l, struct draft *d, const transform *t)
{
	if (d->kind == DRAFT_SHAPE && d->shape->step)
		d->extras->extent->box = box_of_shape(d->shape, d->self, NULL);
	else if (d->kind == DRAFT_SHAPE && !d->shape->moves_extent)
		move_shape(l, d, t);
	else if (!box_is_empty(d->extras->extent->box))
		d->extras->extent->box = transform_box(t, d->extras->extent->box);
}

/* A shape that turns itself inside out (plane) is a shape like others afterwards. */
void extent_invert(struct lowering *l, struct draft *d)
{
	if (d->kind == DRAFT_SHAPE && d->shape->invert)
		d->extras->extent->box = box_of_placed(l, d);
	else
		d->extras->extent->inverted = !d->extras->extent->inverted;
}

/* What the boxes of the cutters have in common: of planes as well, or only of what is bounded. */
static box common_of_cutters(const struct draft *list, bool with_planes)
{
	box b = box_everything();
	for (; list; list = list->next) {
		const box own = list->extras->extent->box;
		if (!list->extras->extent->inverted)
			b = box_intersection(b, with_planes ? own : whole(own));
	}
	return b;
}

static void replace_if_smaller(struct extent *e, box b)
{
	if (!box_is_empty(b) && volume(b) < (1 - SAME) * volume(whole(e->box)))
		e->box = b;
}

void extent_clip(struct lowering *l, struct draft *d)
{
	if (d->shape && d->shape->extent_within)
		replace_if_smaller(d->extras->extent,
			reached(l, d, common_of_cutters(d->extras->clips, true)));
}

void extent_cut(struct draft *d)
{
	replace_if_smaller(d->extras->extent, common_of_cutters(d->extras->clips, false));
	if (!d->bounds_are_clips)
		replace_if_smaller(d->extras->extent, common_of_cutters(d->extras->bounds, false));
}
