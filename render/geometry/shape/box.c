/* SPDX-License-Identifier: MIT */
/*
 * box { corner, corner }
 *
 * The ray is inside between the last entry into and the first exit from the
 * three slabs. A direction component of zero gives infinite parameters, or no
 * number at all in the plane of a face; comparisons are written so that this
 * counts as inside the slab.
 */
#include "geometry/shape.h"

struct box_shape {
	vec3 lo, hi; /* as written until built */
};

/* Points this far outside, as a share of the size, are still inside. What coincides with a face
 * then lies inside as a whole, instead of here and there as hit points are rounded. */
#define SKIN 1e-10

enum face { FACE_LEFT, FACE_RIGHT, FACE_BOTTOM, FACE_TOP, FACE_FRONT, FACE_BACK };

static const struct field box_fields[] = { FIELD(box_shape, lo), FIELD(box_shape, hi), FIELD_END };

static void box_build(void *self, struct shape_build *build)
{
	struct box_shape *b = self;
	(void)build;
	const box sorted = { vec_min(b->lo, b->hi), vec_max(b->lo, b->hi) };
	b->lo = sorted.lo;
	b->hi = sorted.hi;
}

/* Moving and stretching. Mirroring would swap the faces' places in the uv map. */
static bool box_absorb(void *self, const transform *t)
{
	struct box_shape *b = self;
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			if (i == j ? !(t->m[i][j] > 0) : t->m[i][j] != 0)
				return false;
		}
	}
	b->lo = transform_point(t, b->lo);
	b->hi = transform_point(t, b->hi);
	return true;
}

static box box_bounds(const void *self)
{
	const struct box_shape *b = self;
	return (box){ b->lo, b->hi };
}

struct slabs {
	double in[3], out[3];
	double near, far;
};

/* Divides, as a plane does, so that a face in an axis-aligned plane is met at exactly its t. */
static inline void slab(
	double lo, double hi, double origin, double direction, double *in, double *out)
{
	const double a = (lo - origin) / direction, b = (hi - origin) / direction;
	*in = signbit(direction) ? b : a;
	*out = signbit(direction) ? a : b;
}

static inline bool box_slabs(const struct box_shape *b, const ray *r, struct slabs *s)
{
	slab(b->lo.x, b->hi.x, r->origin.x, r->direction.x, &s->in[0], &s->out[0]);
	slab(b->lo.y, b->hi.y, r->origin.y, r->direction.y, &s->in[1], &s->out[1]);
	slab(b->lo.z, b->hi.z, r->origin.z, r->direction.z, &s->in[2], &s->out[2]);
	double near = -INFINITY, far = INFINITY;
	for (int i = 0; i < 3; i++) {
		near = s->in[i] > near ? s->in[i] : near;
		far = s->out[i] < far ? s->out[i] : far;
	}
	s->near = near;
	s->far = far;
	return near <= far;
}

/* The face crossed at t. At an edge, which rounding blurs, the face that the ray meets most
 * squarely; then x before y before z. */
static uint32_t face_at(const double at[3], double t, bool leaving, const ray *r)
{
	const double blur = 1e-12 * fabs(t);
	const double d[3] = { r->direction.x, r->direction.y, r->direction.z };
	const bool at_t[3] = { fabs(at[0] - t) <= blur, fabs(at[1] - t) <= blur,
		fabs(at[2] - t) <= blur };
	int axis = at_t[0] ? 0 : at_t[1] ? 1 : 2;
	if (at_t[0] + at_t[1] + at_t[2] != 1) { /* hardly ever */
		axis = -1;
		for (int i = 0; i < 3; i++) {
			if (at_t[i] && (axis < 0 || fabs(d[i]) > fabs(d[axis])))
				axis = i;
		}
		axis = axis < 0 ? 0 : axis;
	}
	return (uint32_t)(2 * axis + ((d[axis] > 0) == leaving));
}

static bool box_nearest(const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	struct slabs s;
	if (!box_slabs(self, r, &s) || s.far < tmin)
		return false;
	const bool leaving = s.near < tmin;
	const double t = leaving ? s.far : s.near;
	if (!(t < tmax))
		return false;
	found->t = t;
	found->part = face_at(leaving ? s.out : s.in, t, leaving, r);
	return true;
}

static void box_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct slabs s;
	if (!box_slabs(self, r, &s))
		return;
	if (s.near > tmin && s.near < tmax)
		hits_push(out, s.near)->part = face_at(s.in, s.near, false, r);
	if (s.far > tmin && s.far < tmax)
		hits_push(out, s.far)->part = face_at(s.out, s.far, true, r);
}

static bool box_chord(const void *self, const ray *r, struct chord *chord)
{
	struct slabs s;
	if (!box_slabs(self, r, &s))
		return false;
	*chord = (struct chord){ { s.near, s.far },
		{ face_at(s.in, s.near, false, r), face_at(s.out, s.far, true, r) } };
	return true;
}

static bool box_inside(const void *self, vec3 p)
{
	const struct box_shape *b = self;
	const vec3 size = vec_sub(b->hi, b->lo);
	const double skin = SKIN * fmax(fmax(size.x, size.y), size.z);
	return p.x >= b->lo.x - skin && p.x <= b->hi.x + skin && p.y >= b->lo.y - skin &&
	       p.y <= b->hi.y + skin && p.z >= b->lo.z - skin && p.z <= b->hi.z + skin;
}

static vec3 box_normal(const void *self, const struct hit *hit, vec3 p)
{
	static const vec3 normals[6] = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0, 1, 0 },
		{ 0, 0, -1 }, { 0, 0, 1 } };
	(void)self;
	(void)p;
	return normals[hit->part];
}

/* The unfolded faces form a cross, four wide and three high. */
static void box_uv(
	const void *self, const struct hit *hit, vec3 p, const transform *absorbed, double uv[2])
{
	const struct box_shape *b = self;
	(void)absorbed;
	const double x = (p.x - b->lo.x) / (b->hi.x - b->lo.x) / 4;
	const double y = (p.y - b->lo.y) / (b->hi.y - b->lo.y) / 3;
	const double z = (p.z - b->lo.z) / (b->hi.z - b->lo.z);
	const double third = 1.0 / 3;
	switch ((enum face)hit->part) {
	case FACE_LEFT:
		uv[0] = z / 4, uv[1] = third + y;
		break;
	case FACE_RIGHT:
		uv[0] = 0.75 - z / 4, uv[1] = third + y;
		break;
	case FACE_BOTTOM:
		uv[0] = 0.25 + x, uv[1] = z / 3;
		break;
	case FACE_TOP:
		uv[0] = 0.25 + x, uv[1] = 1 - z / 3;
		break;
	case FACE_FRONT:
		uv[0] = 1 - x, uv[1] = third + y;
		break;
	case FACE_BACK:
		uv[0] = 0.25 + x, uv[1] = third + y;
		break;
	}
}

const struct shape_class shape_box = {
	.name = "box",
	.is_convex = true,
	.size = sizeof(struct box_shape),
	.fields = box_fields,
	.build = box_build,
	.absorb = box_absorb,
	.bounds = box_bounds,
	.nearest = box_nearest,
	.hits = box_hits,
	.chord = box_chord,
	.inside = box_inside,
	.normal = box_normal,
	.uv = box_uv,
};
