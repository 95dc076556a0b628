/* SPDX-License-Identifier: MIT */
/*
 * union (kept), merge, intersection; a difference is an intersection with
 * children turned inside out.
 *
 * A hit of one child counts if its point is inside all others (intersection) or
 * none (merge). For the nearest hit the children are asked one after another,
 * each only for what lies before the best so far, and their hits are tried from
 * the front: most inside tests of a complete list are never made.
 */
#include "render/shape.h"

static box csg_bounds(const void *self)
{
	const struct csg *csg = self;
	if (csg->kind == CSG_INTERSECTION) {
		box b = box_everything();
		for (size_t i = 0; i < csg->count; i++) {
			if (!csg->children[i]->inverted)
				b = box_intersection(b, csg->children[i]->bounds);
		}
		return csg->count ? b : box_nothing();
	}
	box b = box_nothing();
	for (size_t i = 0; i < csg->count; i++) {
		/* a complement has no bounds (a difference within a difference) */
		if (csg->children[i]->inverted)
			return box_everything();
		b = box_union(b, csg->children[i]->bounds);
	}
	return b;
}

static bool csg_inside(const void *self, vec3 p)
{
	const struct csg *csg = self;
	const bool decides = csg->kind != CSG_INTERSECTION;
	for (size_t i = 0; i < csg->count; i++) {
		if (object_inside(csg->children[i], p) == decides)
			return decides;
	}
	return !decides && csg->count > 0;
}

/* Whether a hit at p of a child counts. */
static bool survives(const struct csg *csg, size_t child, vec3 p)
{
	if (csg->kind == CSG_UNION)
		return true;
	const bool wanted = csg->kind == CSG_INTERSECTION;
	for (size_t i = 0; i < csg->count; i++) {
		if (i != child && object_inside(csg->children[i], p) != wanted)
			return false;
	}
	return true;
}

/* Every hit of an intersection lies in the boxes of all children that are not inside out. */
static bool misses_a_factor(
	const struct csg *csg, const ray *r, vec3 inverse, double tmin, double tmax)
{
	if (csg->kind != CSG_INTERSECTION)
		return false;
	for (size_t i = 0; i < csg->count; i++) {
		const struct object *child = csg->children[i];
		if (!child->inverted &&
			!box_meets_ray(&child->bounds, r->origin, inverse, tmin, tmax))
			return true;
	}
	return false;
}

/* Of the hits not after `before`, the nearest; of equal ones the last. Taken out of the list. */
static bool take_nearest(struct hits *hits, double before, struct hit *out)
{
	size_t best = hits->count;
	for (size_t i = 0; i < hits->count; i++) {
		if (hits->items[i].t <= before) {
			best = i;
			before = hits->items[i].t;
		}
	}
	if (best == hits->count)
		return false;
	*out = hits->items[best];
	for (size_t i = best + 1; i < hits->count; i++)
		hits->items[i - 1] = hits->items[i];
	hits->count--;
	return true;
}

/* The first hit of a child in [tmin, tmax) that counts. */
static bool child_nearest(const struct csg *csg, size_t child, const ray *r, double tmin,
	double tmax, struct hit *found)
{
	struct hit buffer[HITS_ROOM];
	struct hits hits;
	hits_init(&hits, buffer, HITS_ROOM);
	object_hits(csg->children[child], r, nextafter(tmin, -INFINITY), tmax, &hits);
	bool any = false;
	struct hit hit;
	while (!any && take_nearest(&hits, INFINITY, &hit))
		any = survives(csg, child, ray_at(*r, hit.t));
	if (any)
		*found = hit;
	hits_release(&hits);
	return any;
}

static bool csg_nearest(const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const struct csg *csg = self;
	const vec3 inverse = vec_reciprocal(r->direction);
	if (misses_a_factor(csg, r, inverse, tmin, tmax))
		return false;
	bool any = false;
	for (size_t i = 0; i < csg->count; i++) {
		const struct object *child = csg->children[i];
		if (!box_meets_ray(&child->bounds, r->origin, inverse, tmin, tmax))
			continue;
		struct hit hit;
		const bool hits = csg->kind == CSG_UNION
					  ? object_nearest(child, r, tmin, tmax, &hit)
					  : child_nearest(csg, i, r, tmin, tmax, &hit);
		if (!hits)
			continue;
		*found = hit;
		any = true;
		tmax = nextafter(hit.t, INFINITY); /* a later child wins a tie */
	}
	return any;
}

static void csg_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	const struct csg *csg = self;
	const vec3 inverse = vec_reciprocal(r->direction);
	if (misses_a_factor(csg, r, inverse, tmin, tmax))
		return;
	for (size_t i = 0; i < csg->count; i++) {
		if (!box_meets_ray(&csg->children[i]->bounds, r->origin, inverse, tmin, tmax))
			continue;
		size_t kept = out->count;
		object_hits(csg->children[i], r, tmin, tmax, out);
		for (size_t j = kept; j < out->count; j++) {
			if (survives(csg, i, ray_at(*r, out->items[j].t)))
				out->items[kept++] = out->items[j];
		}
		out->count = kept;
	}
}

const struct shape_class shape_csg = {
	.name = "csg",
	.size = sizeof(struct csg),
	.is_compound = true,
	.bounds = csg_bounds,
	.nearest = csg_nearest,
	.hits = csg_hits,
	.inside = csg_inside,
};
