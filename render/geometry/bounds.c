/* SPDX-License-Identifier: MIT */
/*
 * Bounding boxes of objects, and of what several objects have in common. Where
 * these are half-spaces, or lie in some, the box follows from linear programming
 * duality: if a positive combination of three normals n is an axis e, then e . p
 * is at most that combination of their distances. So no corner is ever computed,
 * and every bound found is one.
 */
#include "geometry/shape.h"

#include <float.h>

/* ---- half-spaces ---- */

/* More half-spaces than these are left out, which only makes the box larger. */
#define HALF_SPACES_MAX 32

/* Rounding of normals and of combination factors. */
#define SLACK 1e-9

static const vec3 axes[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

static double *coordinate(vec3 *p, int axis)
{
	return axis == 0 ? &p->x : axis == 1 ? &p->y : &p->z;
}

/* Takes in that sign * coordinate <= limit. */
static void limit_axis(box *b, int axis, double sign, double limit)
{
	double *bound = coordinate(sign > 0 ? &b->hi : &b->lo, axis);
	if (sign * *bound > limit)
		*bound = sign * limit;
}

/* The bounds that three half-spaces give. */
static void limit_by_three(box *b, const struct half_space *h[3])
{
	const vec3 cross[3] = { vec_cross(h[1]->normal, h[2]->normal),
		vec_cross(h[2]->normal, h[0]->normal), vec_cross(h[0]->normal, h[1]->normal) };
	const double determinant = vec_dot(h[0]->normal, cross[0]);
	if (!(fabs(determinant) > 1e-6))
		return;
	for (int axis = 0; axis < 3; axis++) {
		double limit = 0, size = 0, least = INFINITY, most = -INFINITY;
		for (int i = 0; i < 3; i++) {
			const double factor = vec_dot(axes[axis], cross[i]) / determinant;
			limit += factor * h[i]->distance;
			size += fabs(factor * h[i]->distance);
			least = fmin(least, factor);
			most = fmax(most, factor);
		}
		if (least >= -1e-3 * SLACK)
			limit_axis(b, axis, 1, limit + SLACK * size);
		if (most <= 1e-3 * SLACK)
			limit_axis(b, axis, -1, -limit + SLACK * size);
	}
}

static box cut_by_half_spaces(box b, const struct half_space *list, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		for (size_t j = i + 1; j < count; j++) {
			for (size_t k = j + 1; k < count; k++)
				limit_by_three(&b, (const struct half_space *[3]){
							   &list[i], &list[j], &list[k] });
		}
	}
	return b;
}

/* The sides of the box that bound it. */
static size_t half_spaces_of_box(box b, struct half_space *out)
{
	size_t count = 0;
	for (int axis = 0; axis < 3; axis++) {
		const double lo = *coordinate(&b.lo, axis), hi = *coordinate(&b.hi, axis);
		if (lo > -BOX_UNBOUNDED)
			out[count++] = (struct half_space){ vec_negate(axes[axis]), -lo };
		if (hi < BOX_UNBOUNDED)
			out[count++] = (struct half_space){ axes[axis], hi };
	}
	return count;
}

static size_t half_spaces_of(const struct object *o, struct half_space *list, size_t n)
{
	if (!o->shape->half_spaces || o->place || n + SHAPE_HALF_SPACES + 6 > HALF_SPACES_MAX)
		return n;
	return n + o->shape->half_spaces(o->self, list + n);
}

/* The part of b, which bounds `whole` if that is not NULL, that the objects leave of it. */
static box cut(box b, const struct object *whole, const struct object *const *objects, size_t count)
{
	struct half_space list[HALF_SPACES_MAX];
	size_t n = whole && count > 0 ? half_spaces_of(whole, list, 0) : 0;
	for (size_t i = 0; i < count; i++) {
		const struct object *o = objects[i];
		if (o->inverted)
			continue;
		if (!o->reaches_out)
			b = box_intersection(b, o->bounds);
		n = half_spaces_of(o, list, n);
	}
	if (n == 0 || box_is_empty(b))
		return b;
	n += half_spaces_of_box(b, list + n);
	return cut_by_half_spaces(b, list, n);
}

box box_cut(box b, const struct object *const *objects, size_t count)
{
	return cut(b, NULL, objects, count);
}

/* ---- objects ---- */

/* A bound moved outwards by a few units in the last place, for the rounding of hit points. */
static double widened(double x, double size, double sign)
{
	const double moved = x + sign * 4 * DBL_EPSILON * (fabs(x) + size);
	return fmin(fmax(moved, -BOX_UNBOUNDED), BOX_UNBOUNDED);
}

static box box_widened(box b)
{
	const vec3 d = vec_sub(b.hi, b.lo);
	const double size = fmax(fmax(d.x, d.y), d.z);
	const double more = size < BOX_UNBOUNDED ? size : 0;
	return (box){ { widened(b.lo.x, more, -1), widened(b.lo.y, more, -1),
			      widened(b.lo.z, more, -1) },
		{ widened(b.hi.x, more, 1), widened(b.hi.y, more, 1), widened(b.hi.z, more, 1) } };
}

/* Of an intersection, all that is within the others is taken in by its bounds. */
static bool reaches_out(const struct object *o)
{
	if (o->shape != &shape_csg)
		return o->shape->reaches_out;
	const struct csg *csg = o->self;
	const size_t count = csg->kind == CSG_INTERSECTION ? 0 : csg->count + csg->unseen;
	for (size_t i = 0; i < count; i++) {
		if (csg->children[i]->reaches_out)
			return true;
	}
	return false;
}

void object_set_bounds(struct object *o)
{
	const struct shape_class *shape = o->shape;
	const struct object_extras *e = o->extras;
	o->has_chord = shape->chord && !(e && e->clip_count) &&
		       (!shape->has_chord || shape->has_chord(o->self));
	o->reaches_out = reaches_out(o);
	box b = shape->bounds(o->self);
	if (o->place && !box_is_empty(b))
		b = transform_box(o->place, b);
	if (e) {
		b = cut(b, o, e->clips, e->clip_count);
		b = cut(b, o, e->bounds_by, e->bound_count);
	}
	o->bounds = box_is_empty(b) ? box_nothing() : box_widened(b);
}
