/* SPDX-License-Identifier: MIT */
/*
 * triangle { p1, p2, p3 } and smooth_triangle { p1, n1, p2, n2, p3, n3 }
 *
 * The ray passes a triangle if it passes its three edges on the same side. The
 * volume of the corner that an edge forms with the ray decides; computed from the
 * start of the ray it only changes sign when the edge is walked the other way, so
 * neighbours agree exactly and leave no cracks.
 */
#include "geometry/shape.h"

struct triangle {
	vec3 p[3];
	vec3 normal; /* (p3 - p1) x (p2 - p1); zero: degenerate, never hit */
};

struct smooth_triangle {
	struct triangle flat;
	vec3 normals[3]; /* unit, unless a matrix has changed that */
};

static const struct field triangle_fields[] = { FIELD(triangle, p[0]), FIELD(triangle, p[1]),
	FIELD(triangle, p[2]), FIELD_END };

static const struct field smooth_triangle_fields[] = { FIELD(smooth_triangle, flat.p[0]),
	FIELD(smooth_triangle, normals[0]), FIELD(smooth_triangle, flat.p[1]),
	FIELD(smooth_triangle, normals[1]), FIELD(smooth_triangle, flat.p[2]),
	FIELD(smooth_triangle, normals[2]), FIELD_END };

static vec3 face_normal(const struct triangle *tr)
{
	return vec_cross(vec_sub(tr->p[2], tr->p[0]), vec_sub(tr->p[1], tr->p[0]));
}

static void triangle_build(void *self, struct shape_build *build)
{
	struct triangle *tr = self;
	tr->normal = face_normal(tr);
	if (vec_length2(tr->normal) > 0)
		return;
	build->warning(build->user, "degenerate triangle: its corners lie on a line");
	build->dropped = true;
}

/* The corners move; the normal follows them, so a mirrored triangle turns over. */
static bool triangle_absorb(void *self, const transform *t)
{
	struct triangle *tr = self;
	for (int i = 0; i < 3; i++)
		tr->p[i] = transform_point(t, tr->p[i]);
	tr->normal = face_normal(tr);
	return true;
}

/* Whether all normals point to the same side of the face. */
static bool normals_agree(const struct smooth_triangle *s)
{
	int sides = 0;
	for (int i = 0; i < 3; i++) {
		const double side = vec_dot(s->normals[i], s->flat.normal);
		sides += side > 0 ? 1 : side < 0 ? -1 : 0;
	}
	return sides == 3 || sides == -3;
}

static void smooth_triangle_build(void *self, struct shape_build *build)
{
	struct smooth_triangle *s = self;
	s->flat.normal = face_normal(&s->flat);
	for (int i = 0; i < 3; i++)
		s->normals[i] = vec_normalize(s->normals[i]);
	if (normals_agree(s))
		return;
	build->warning(build->user, "degenerate smooth_triangle: its corners lie on a line, or "
				    "its normals do not all point to one side of it");
	build->dropped = true;
}

/* A matrix may change the lengths of the normals, and so their weights; scale makes them 1. */
static void smooth_triangle_step(void *self, const transform *t, bool is_scale)
{
	struct smooth_triangle *s = self;
	triangle_absorb(&s->flat, t);
	for (int i = 0; i < 3; i++) {
		const vec3 n = transform_normal(t, s->normals[i]);
		s->normals[i] = is_scale ? vec_normalize(n) : n;
	}
	if (!normals_agree(s))
		s->flat.normal = vec(0, 0, 0);
}

static box triangle_bounds(const void *self)
{
	const struct triangle *tr = self;
	return box_add_point(box_add_point((box){ tr->p[0], tr->p[0] }, tr->p[1]), tr->p[2]);
}

static box triangle_extent(const void *self, const transform *place)
{
	const box b = triangle_bounds(self);
	const vec3 thin = vec(1e-10, 1e-10, 1e-10);
	return box_placed((box){ vec_sub(b.lo, thin), vec_add(b.hi, thin) }, place);
}

static inline bool triangle_cross(
	const struct triangle *tr, const ray *r, double tmin, double tmax, struct hit *found)
{
	const vec3 a = vec_sub(tr->p[0], r->origin);
	const double t = vec_dot(tr->normal, a) / vec_dot(tr->normal, r->direction);
	if (!(t >= tmin && t < tmax))
		return false;
	const vec3 b = vec_sub(tr->p[1], r->origin), c = vec_sub(tr->p[2], r->origin);
	const double ab = vec_dot(r->direction, vec_cross(a, b));
	const double bc = vec_dot(r->direction, vec_cross(b, c));
	const double ca = vec_dot(r->direction, vec_cross(c, a));
	if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)))
		return false;
	const double sum = ab + bc + ca;
	if (sum == 0) /* seen edge-on */
		return false;
	found->t = t;
	found->u = ca / sum;
	found->v = ab / sum;
	return true;
}

static bool triangle_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	return triangle_cross(self, r, tmin, tmax, found);
}

static void triangle_hits(
	const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct hit found = { 0 };
	if (triangle_cross(self, r, tmin, tmax, &found) && found.t > tmin)
		*hits_push(out, found.t) = found;
}

static vec3 triangle_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct triangle *tr = self;
	(void)hit;
	(void)p;
	return tr->normal;
}

static vec3 smooth_triangle_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct smooth_triangle *s = self;
	(void)p;
	const vec3 n = vec_scale(s->normals[0], 1 - hit->u - hit->v);
	return vec_mad(vec_mad(n, hit->u, s->normals[1]), hit->v, s->normals[2]);
}

const struct shape_class shape_triangle = {
	.name = "triangle",
	.size = sizeof(struct triangle),
	.fields = triangle_fields,
	.is_patch = true,
	.build = triangle_build,
	.absorb = triangle_absorb,
	.bounds = triangle_bounds,
	.extent = triangle_extent,
	.nearest = triangle_nearest,
	.hits = triangle_hits,
	.normal = triangle_normal,
};

const struct shape_class shape_smooth_triangle = {
	.name = "smooth_triangle",
	.size = sizeof(struct smooth_triangle),
	.fields = smooth_triangle_fields,
	.is_patch = true,
	.build = smooth_triangle_build,
	.step = smooth_triangle_step,
	.bounds = triangle_bounds,
	.extent = triangle_extent,
	.nearest = triangle_nearest,
	.hits = triangle_hits,
	.normal = smooth_triangle_normal,
};
