/* SPDX-License-Identifier: MIT */
/*
 * superellipsoid { <e, n> }
 *
 * g(g(|x|, |y|; 2/e), |z|; 2/n) = 1 with g(a, b; k) = (a^k + b^k)^(1/k). While both
 * exponents k are at least 1 this is a norm, so it is convex along the ray and
 * Newton's method from either end of the ray's way through the unit cube runs
 * to the surface without ever passing it. Pinched ones are searched octant by
 * octant.
 */
#include "geometry/shape.h"

#include "base/elementary.h"

#include <float.h>

struct superellipsoid {
	vec3 exponents; /* e, n as written */
	double round;	/* 2/e: the exponent about z */
	double profile; /* 2/n */
	bool is_convex;
};

/* What the language still counts as inside. */
#define SKIN 1e-10
/* Half a side of the cube in which hits are sought. */
#define CUBE (1 + 1e-6)
/* Steps in which an octant is searched for a pinched superellipsoid. */
#define PINCHED_STEPS 24

static const struct field superellipsoid_fields[] = { FIELD(superellipsoid, exponents), FIELD_END };

static void superellipsoid_build(void *self, struct shape_build *build)
{
	struct superellipsoid *s = self;
	(void)build;
	/* an exponent of zero means edges as sharp as a box */
	s->round = 2 / fmax(s->exponents.x, 1e-6);
	s->profile = 2 / fmax(s->exponents.y, 1e-6);
	s->is_convex = s->round >= 1 && s->profile >= 1;
}

static box superellipsoid_bounds(const void *self)
{
	(void)self;
	return (box){ { -1, -1, -1 }, { 1, 1, 1 } };
}

static box superellipsoid_extent(const void *self, const transform *place)
{
	(void)self;
	const double side = 1.0001;
	return box_placed((box){ { -side, -side, -side }, { side, side, side } }, place);
}

/* g(a, b; k) of numbers that are not negative, and its derivatives. */
static double power_mean(double a, double b, double k, double *by_a, double *by_b)
{
	const double big = fmax(a, b), small = fmin(a, b);
	if (big == 0) {
		*by_a = *by_b = 0;
		return 0;
	}
	const double ratio = small / big, power = elementary_pow(ratio, k);
	const double root = elementary_pow(1 + power, 1 / k);
	const double by_big = root / (1 + power);
	const double by_small = small > 0 ? by_big * power / ratio : 0;
	*by_a = a >= b ? by_big : by_small;
	*by_b = a >= b ? by_small : by_big;
	return big * root;
}

/* Negative inside. The gradient's components are zero where the surface has a ridge. */
static double value(const struct superellipsoid *s, vec3 p, vec3 *gradient)
{
	double by_x, by_y, by_disc, by_z;
	const double disc = power_mean(fabs(p.x), fabs(p.y), s->round, &by_x, &by_y);
	const double f = power_mean(disc, fabs(p.z), s->profile, &by_disc, &by_z);
	*gradient = vec(p.x != 0 ? copysign(by_x * by_disc, p.x) : 0,
		p.y != 0 ? copysign(by_y * by_disc, p.y) : 0, p.z != 0 ? copysign(by_z, p.z) : 0);
	return f - 1;
}

static double value_along(const struct superellipsoid *s, const ray *r, double t, double *slope)
{
	vec3 gradient;
	const double f = value(s, ray_at(*r, t), &gradient);
	*slope = vec_dot(gradient, r->direction);
	return f;
}

/* The part of the ray in the unit cube and after tmin. The faces of a box-like one lie on the cube's:
 * rounding must not begin the search behind them. */
static bool cube_section(const ray *r, double tmin, double *in, double *out)
{
	const vec3 inverse = vec_reciprocal(r->direction);
	*in = -INFINITY;
	*out = INFINITY;
	slab_cut(-CUBE, CUBE, r->origin.x, inverse.x, in, out);
	slab_cut(-CUBE, CUBE, r->origin.y, inverse.y, in, out);
	slab_cut(-CUBE, CUBE, r->origin.z, inverse.z, in, out);
	*in = fmax(*in, tmin);
	return *in < *out;
}

/* From `t`, outside, to the surface before `end`. A convex function lies above its tangents: each
 * step stops short of the root, until rounding ends the progress. */
static bool newton_in(const struct superellipsoid *s, const ray *r, double *t, double end)
{
	const double direction = end > *t ? 1 : -1;
	for (;;) {
		double slope;
		const double f = value_along(s, r, *t, &slope);
		if (f <= 0)
			return true;
		if (!(slope * direction < 0))
			return false;
		const double next = *t - f / slope;
		if ((next - *t) * direction <= DBL_EPSILON * fabs(*t))
			return true;
		if ((end - next) * direction < 0)
			return false;
		*t = next;
	}
}

static unsigned convex_crossings(
	const struct superellipsoid *s, const ray *r, double in, double out, double t[2])
{
	double slope;
	unsigned n = 0;
	if (value_along(s, r, in, &slope) >= 0) {
		t[n] = in;
		if (!newton_in(s, r, &t[n], out))
			return 0;
		n++;
	}
	double last = out;
	newton_in(s, r, &last, in);
	t[n] = n ? fmax(last, t[0]) : last;
	return n + 1;
}

/* ---- pinched ---- */

static double value_at(const struct superellipsoid *s, const ray *r, double t)
{
	double slope;
	return value_along(s, r, t, &slope);
}

static double halve(const struct superellipsoid *s, const ray *r, double lo, double hi, bool out_lo)
{
	for (;;) {
		const double middle = 0.5 * (lo + hi);
		if (!(middle > lo && middle < hi))
			return middle;
		if ((value_at(s, r, middle) >= 0) == out_lo)
			lo = middle;
		else
			hi = middle;
	}
}

/* Between lo, where the surface comes nearer, and hi, where it goes away again: a point beyond the
 * surface, if there is one, found by halving towards the turning point. */
static bool reach_across(const struct superellipsoid *s, const ray *r, double lo, double hi,
	bool outside, double *across)
{
	for (int i = 0; i < 50; i++) {
		const double middle = 0.5 * (lo + hi);
		double slope;
		if ((value_along(s, r, middle, &slope) >= 0) != outside) {
			*across = middle;
			return true;
		}
		if ((slope < 0) == outside)
			lo = middle;
		else
			hi = middle;
	}
	return false;
}

/* Crossings of a stretch within one octant, where the function is smooth. */
static unsigned octant_crossings(const struct superellipsoid *s, const ray *r, double lo, double hi,
	double *t, unsigned room)
{
	unsigned n = 0;
	double before = lo, slope_before, slope, across;
	bool outside = value_along(s, r, lo, &slope_before) >= 0;
	for (int i = 1; i <= PINCHED_STEPS && n + 2 <= room; i++) {
		const double here = i == PINCHED_STEPS ? hi : lo + (hi - lo) * i / PINCHED_STEPS;
		const bool now = value_along(s, r, here, &slope) >= 0;
		const bool turns = (slope_before < 0) == outside && (slope > 0) == outside;
		if (now != outside) {
			t[n++] = halve(s, r, before, here, outside);
		} else if (turns && reach_across(s, r, before, here, outside, &across)) {
			t[n++] = halve(s, r, before, across, outside);
			t[n++] = halve(s, r, across, here, !outside);
		}
		before = here;
		slope_before = slope;
		outside = now;
	}
	return n;
}

#define MAX_CROSSINGS 16

static unsigned pinched_crossings(
	const struct superellipsoid *s, const ray *r, double in, double out, double *t)
{
	const double o[3] = { r->origin.x, r->origin.y, r->origin.z };
	const double d[3] = { r->direction.x, r->direction.y, r->direction.z };
	double ends[5] = { in };
	int count = 1;
	for (int i = 0; i < 3; i++) {
		const double t0 = -o[i] / d[i];
		if (!(t0 > in && t0 < out))
			continue;
		int k = count++;
		for (; k > 0 && ends[k - 1] > t0; k--)
			ends[k] = ends[k - 1];
		ends[k] = t0;
	}
	ends[count] = out;
	unsigned n = 0;
	for (int i = 0; i < count; i++)
		n += octant_crossings(s, r, ends[i], ends[i + 1], t + n, MAX_CROSSINGS - n);
	return n;
}

/* Ascending. */
static unsigned crossings(const struct superellipsoid *s, const ray *r, double tmin, double *t)
{
	double in, out;
	if (!cube_section(r, tmin, &in, &out))
		return 0;
	return s->is_convex ? convex_crossings(s, r, in, out, t)
			    : pinched_crossings(s, r, in, out, t);
}

static bool superellipsoid_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	double t[MAX_CROSSINGS];
	const unsigned n = crossings(self, r, tmin, t);
	if (n == 0 || !(t[0] < tmax))
		return false;
	found->t = t[0];
	return true;
}

static void superellipsoid_hits(
	const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	double t[MAX_CROSSINGS];
	const unsigned n = crossings(self, r, tmin, t);
	for (unsigned i = 0; i < n; i++) {
		if (t[i] > tmin && t[i] < tmax)
			hits_push(out, t[i]);
	}
}

static bool superellipsoid_inside(const void *self, vec3 p)
{
	vec3 gradient;
	return value(self, p, &gradient) < SKIN;
}

static vec3 superellipsoid_normal(const void *self, const struct hit *hit, vec3 p)
{
	vec3 gradient;
	(void)hit;
	value(self, p, &gradient);
	return gradient;
}

const struct shape_class shape_superellipsoid = {
	.name = "superellipsoid",
	.size = sizeof(struct superellipsoid),
	.fields = superellipsoid_fields,
	.build = superellipsoid_build,
	.bounds = superellipsoid_bounds,
	.extent = superellipsoid_extent,
	.nearest = superellipsoid_nearest,
	.hits = superellipsoid_hits,
	.inside = superellipsoid_inside,
	.normal = superellipsoid_normal,
};
