/* SPDX-License-Identifier: MIT */
/*
 * Points, directions, rays and boxes in double precision, passed by value.
 */
#ifndef LAMBERT_BASE_VEC3_H
#define LAMBERT_BASE_VEC3_H

#include <math.h>
#include <stdbool.h>

typedef struct {
	double x, y, z;
} vec3;

/* The point reached at parameter t is origin + t * direction. */
typedef struct {
	vec3 origin, direction;
} ray;

/* Axis-aligned; lo <= hi in every coordinate unless it is empty. */
typedef struct {
	vec3 lo, hi;
} box;

static inline vec3 vec(double x, double y, double z)
{
	return (vec3){ x, y, z };
}
static inline vec3 vec_add(vec3 a, vec3 b)
{
	return vec(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline vec3 vec_sub(vec3 a, vec3 b)
{
	return vec(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline vec3 vec_mul(vec3 a, vec3 b)
{
	return vec(a.x * b.x, a.y * b.y, a.z * b.z);
}
static inline vec3 vec_scale(vec3 a, double s)
{
	return vec(a.x * s, a.y * s, a.z * s);
}
static inline vec3 vec_negate(vec3 a)
{
	return vec(-a.x, -a.y, -a.z);
}
/* a + s * b */
static inline vec3 vec_mad(vec3 a, double s, vec3 b)
{
	return vec(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}
static inline double vec_dot(vec3 a, vec3 b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline vec3 vec_cross(vec3 a, vec3 b)
{
	return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline double vec_length2(vec3 a)
{
	return vec_dot(a, a);
}
static inline double vec_length(vec3 a)
{
	return sqrt(vec_dot(a, a));
}
/* Unit vector along a; a itself when its length is zero. */
static inline vec3 vec_normalize(vec3 a)
{
	const double length = vec_length(a);
	return length > 0 ? vec_scale(a, 1 / length) : a;
}
/* The square root of a² + b² in each coordinate. */
static inline vec3 vec_hypot(vec3 a, vec3 b)
{
	return vec(sqrt(a.x * a.x + b.x * b.x), sqrt(a.y * a.y + b.y * b.y),
		sqrt(a.z * a.z + b.z * b.z));
}
static inline vec3 vec_min(vec3 a, vec3 b)
{
	return vec(fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z));
}
static inline vec3 vec_max(vec3 a, vec3 b)
{
	return vec(fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z));
}

static inline vec3 ray_at(ray r, double t)
{
	return vec_mad(r.origin, t, r.direction);
}

/* Half the edge of the box that stands for "unbounded", as in the reference. */
#define BOX_UNBOUNDED 1e10

static inline box box_everything(void)
{
	return (box){ { -BOX_UNBOUNDED, -BOX_UNBOUNDED, -BOX_UNBOUNDED },
		{ BOX_UNBOUNDED, BOX_UNBOUNDED, BOX_UNBOUNDED } };
}
static inline box box_nothing(void)
{
	return (box){ { INFINITY, INFINITY, INFINITY }, { -INFINITY, -INFINITY, -INFINITY } };
}
static inline box box_union(box a, box b)
{
	return (box){ vec_min(a.lo, b.lo), vec_max(a.hi, b.hi) };
}
static inline box box_intersection(box a, box b)
{
	return (box){ vec_max(a.lo, b.lo), vec_min(a.hi, b.hi) };
}
static inline box box_add_point(box b, vec3 p)
{
	return (box){ vec_min(b.lo, p), vec_max(b.hi, p) };
}
static inline bool box_is_empty(box b)
{
	return !(b.lo.x <= b.hi.x && b.lo.y <= b.hi.y && b.lo.z <= b.hi.z);
}
/* The faces belong to the box. */
static inline bool box_has(const box *b, vec3 p)
{
	return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y &&
	       p.z >= b->lo.z && p.z <= b->hi.z;
}
static inline vec3 box_centre(box b)
{
	return vec_scale(vec_add(b.lo, b.hi), 0.5);
}
static inline bool box_is_unbounded(box b)
{
	return b.lo.x <= -BOX_UNBOUNDED || b.lo.y <= -BOX_UNBOUNDED || b.lo.z <= -BOX_UNBOUNDED ||
	       b.hi.x >= BOX_UNBOUNDED || b.hi.y >= BOX_UNBOUNDED || b.hi.z >= BOX_UNBOUNDED;
}

/* Narrows *in to *out, parameters of a ray, to the slab from lo to hi. A direction of zero gives
 * infinities or, in a face of the slab, no number; the comparisons let the latter change nothing. */
static inline void slab_cut(
	double lo, double hi, double origin, double inverse, double *in, double *out)
{
	const double a = (lo - origin) * inverse, b = (hi - origin) * inverse;
	const double near = inverse < 0 ? b : a, far = inverse < 0 ? a : b;
	*in = near > *in ? near : *in;
	*out = far < *out ? far : *out;
}
/* Whether the ray, whose direction has the given reciprocals, comes into the box between tmin and
 * tmax; in doubt yes. */
static inline bool box_meets_ray(const box *b, vec3 origin, vec3 inverse, double tmin, double tmax)
{
	slab_cut(b->lo.x, b->hi.x, origin.x, inverse.x, &tmin, &tmax);
	slab_cut(b->lo.y, b->hi.y, origin.y, inverse.y, &tmin, &tmax);
	slab_cut(b->lo.z, b->hi.z, origin.z, inverse.z, &tmin, &tmax);
	return tmin - tmax <= 1e-12 * fabs(tmax);
}
static inline vec3 vec_reciprocal(vec3 a)
{
	return vec(1 / a.x, 1 / a.y, 1 / a.z);
}

#endif
