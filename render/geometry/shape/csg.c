/* SPDX-License-Identifier: MIT */
/*
 * union (kept), merge, intersection; a difference is an intersection with
 * children turned inside out.
 *
 * A hit of one child counts if its point is inside all others (intersection) or
 * none (merge). Where the ray is inside a convex child is known as a chord: it
 * gives the child's hits and, away from its ends, decides which hits of the
 * others count; near its ends, where surfaces may coincide, their points do. An
 * intersection is only looked for where all chords overlap.
 */
#include "geometry/shape.h"

/* Further children are treated as if they had no chord. */
#define CHORDS_MAX 32

static box csg_bounds(const void *self)
{
	const struct csg *csg = self;
	if (csg->kind == CSG_INTERSECTION)
		return box_cut(box_everything(), csg->children, csg->count);
	box b = box_nothing();
	for (size_t i = 0; i < csg->count + csg->unseen; i++) {
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
	for (size_t i = 0; i < csg->count + csg->unseen; i++) {
		if (object_inside(csg->children[i], p) == decides)
			return decides;
	}
	return !decides;
}

/* ---- kept unions ---- */

static bool union_nearest(
	const struct csg *csg, const ray *r, double tmin, double tmax, struct hit *found)
{
	const vec3 inverse = vec_reciprocal(r->direction);
	bool any = false;
	for (size_t i = 0; i < csg->count; i++) {
		const struct object *child = csg->children[i];
		struct hit hit;
		if (!box_meets_ray(&child->bounds, r->origin, inverse, tmin, tmax) ||
			!object_nearest(child, r, tmin, tmax, &hit))
			continue;
		*found = hit;
		any = true;
		tmax = double_after(hit.t); /* a later child wins a tie */
	}
	return any;
}

static void union_hits(
	const struct csg *csg, const ray *r, double tmin, double tmax, struct hits *out)
{
	const vec3 inverse = vec_reciprocal(r->direction);
	for (size_t i = 0; i < csg->count; i++) {
		if (box_meets_ray(&csg->children[i]->bounds, r->origin, inverse, tmin, tmax))
			object_hits(csg->children[i], r, tmin, tmax, out);
	}
}

/* ---- a ray through an intersection or merge ---- */

struct passage {
	const struct csg *csg;
	const ray *ray;
	vec3 inverse; /* of the direction */
	struct chord chords[CHORDS_MAX];
};

static inline bool has_chord(const struct csg *csg, size_t child)
{
	const struct object *o = csg->children[child];
	return o->has_chord && !(o->extras && o->extras->bound_count) && child < CHORDS_MAX;
}

static inline double slack(double t)
{
	return CHORD_SLACK * (1 + fabs(t));
}

/* Fills in the chords and narrows the interval to where hits can count; false if nowhere. */
static bool passage_open(struct passage *p, double *tmin, double *tmax)
{
	const struct csg *csg = p->csg;
	const bool cuts = csg->kind == CSG_INTERSECTION;
	for (size_t i = 0; i < csg->count; i++) {
		const struct object *child = csg->children[i];
		const bool bounds = cuts && !child->inverted && !child->reaches_out;
		if (has_chord(csg, i)) {
			struct chord *c = &p->chords[i];
			if (!object_chord(child, p->ray, c)) {
				if (bounds)
					return false;
				c->t[0] = INFINITY;
				c->t[1] = -INFINITY;
			} else if (bounds) {
				const double from = c->t[0] - slack(c->t[0]);
				const double to = c->t[1] + slack(c->t[1]);
				*tmin = from > *tmin ? from : *tmin;
				*tmax = to < *tmax ? to : *tmax;
			}
		} else if (bounds && !box_meets_ray(&child->bounds, p->ray->origin, p->inverse,
					     *tmin, *tmax)) {
			return false;
		}
		if (!(*tmin < *tmax))
			return false;
	}
	return true;
}

static bool is_inside(const struct passage *p, size_t child, double t)
{
	const struct object *o = p->csg->children[child];
	if (has_chord(p->csg, child)) {
		const struct chord *c = &p->chords[child];
		const double s = slack(t);
		if (t > c->t[0] + s && t < c->t[1] - s)
			return !o->inverted;
		if (t < c->t[0] - s || t > c->t[1] + s)
			return o->inverted;
	}
	return object_inside(o, ray_at(*p->ray, t));
}

/* Whether a hit of a child counts. */
static bool survives(const struct passage *p, size_t child, double t)
{
	const struct csg *csg = p->csg;
	const bool wanted = csg->kind == CSG_INTERSECTION;
	for (size_t i = 0; i < csg->count; i++) {
		if (i != child && is_inside(p, i, t) != wanted)
			return false;
	}
	return true;
}

/* A shape may end before its inside does, as planes end at the horizon. */
static bool is_hit(const struct object *o, const ray *r, double t)
{
	struct hit hit;
	return t < 1e6 || object_nearest(o, r, t, double_after(t), &hit);
}

/* Whether an end of a chord lies in [tmin, tmax) and counts. */
static bool end_counts(const struct passage *p, size_t child, int end, double tmin, double tmax)
{
	const double t = p->chords[child].t[end];
	return t >= tmin && t < tmax && survives(p, child, t) &&
	       is_hit(p->csg->children[child], p->ray, t);
}

static struct hit end_hit(const struct passage *p, size_t child, int end)
{
	const struct chord *c = &p->chords[child];
	return (struct hit){
		.t = c->t[end], .object = p->csg->children[child], .part = c->part[end]
	};
}

/* Of the hits, the nearest; of equal ones the last. Taken out of the list. */
static bool take_nearest(struct hits *hits, struct hit *out)
{
	if (hits->count == 0)
		return false;
	size_t best = 0;
	for (size_t i = 1; i < hits->count; i++) {
		if (hits->items[i].t <= hits->items[best].t)
			best = i;
	}
	*out = hits->items[best];
	for (size_t i = best + 1; i < hits->count; i++)
		hits->items[i - 1] = hits->items[i];
	hits->count--;
	return true;
}

/* The first hit of a child without a chord in [tmin, tmax) that counts. */
static bool child_nearest(
	const struct passage *p, size_t child, double tmin, double tmax, struct hit *found)
{
	struct hit buffer[HITS_ROOM];
	struct hits hits;
	hits_init(&hits, buffer, HITS_ROOM);
	object_hits(p->csg->children[child], p->ray, double_before(tmin), tmax, &hits);
	bool any = false;
	struct hit hit;
	while (!any && take_nearest(&hits, &hit))
		any = survives(p, child, hit.t);
	if (any)
		*found = hit;
	hits_release(&hits);
	return any;
}

static bool csg_nearest(const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const struct csg *csg = self;
	if (csg->kind == CSG_UNION)
		return union_nearest(csg, r, tmin, tmax, found);
	struct passage p;
	p.csg = csg;
	p.ray = r;
	p.inverse = vec_reciprocal(r->direction);
	if (!passage_open(&p, &tmin, &tmax))
		return false;
	bool any = false;
	for (size_t i = 0; i < csg->count; i++) {
		struct hit hit;
		if (has_chord(csg, i)) {
			const bool first = end_counts(&p, i, 0, tmin, tmax);
			if (!first && !end_counts(&p, i, 1, tmin, tmax))
				continue;
			hit = end_hit(&p, i, !first);
		} else if (!box_meets_ray(
				   &csg->children[i]->bounds, r->origin, p.inverse, tmin, tmax) ||
			   !child_nearest(&p, i, tmin, tmax, &hit)) {
			continue;
		}
		*found = hit;
		any = true;
		tmax = double_after(hit.t); /* a later child wins a tie */
	}
	return any;
}

static void child_hits(
	const struct passage *p, size_t child, double tmin, double tmax, struct hits *out)
{
	size_t kept = out->count;
	object_hits(p->csg->children[child], p->ray, tmin, tmax, out);
	for (size_t i = kept; i < out->count; i++) {
		if (survives(p, child, out->items[i].t))
			out->items[kept++] = out->items[i];
	}
	out->count = kept;
}

static void csg_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	const struct csg *csg = self;
	if (csg->kind == CSG_UNION) {
		union_hits(csg, r, tmin, tmax, out);
		return;
	}
	struct passage p;
	p.csg = csg;
	p.ray = r;
	p.inverse = vec_reciprocal(r->direction);
	if (!passage_open(&p, &tmin, &tmax))
		return;
	for (size_t i = 0; i < csg->count; i++) {
		if (has_chord(csg, i)) {
			for (int end = 0; end < 2; end++) {
				if (end_counts(&p, i, end, double_after(tmin), tmax))
					*hits_push(out, 0) = end_hit(&p, i, end);
			}
		} else if (box_meets_ray(
				   &csg->children[i]->bounds, r->origin, p.inverse, tmin, tmax)) {
			child_hits(&p, i, tmin, tmax, out);
		}
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
