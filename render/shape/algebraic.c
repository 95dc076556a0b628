/* SPDX-License-Identifier: MIT */
/*
 * cubic { <coefficients> }, quartic { <coefficients> }, poly { order, <coefficients> }
 *
 * The zeros of a polynomial in x, y and z; the coefficients stand by falling
 * powers of x, then y, then z. Along a ray it is a polynomial in the distance,
 * formed by Horner's rule at the point of the ray nearest the origin.
 */
#include "render/shape.h"
#include "render/shape/polynomial.h"

#include <string.h>

#define MAX_ORDER 35
/* How far beyond its surface the language lets the inside reach, in values of the polynomial. */
#define FAT 1e-4

struct algebraic {
	double order; /* as written; then 3 or 4 for cubic and quartic */
	struct param_array coefficients;
	bool sturm; /* asks for care that is always taken */
	double top; /* built: the sum of all coefficients of the highest order, without signs */
};

static const struct param cubic_params[] = { PARAM_ARRAY("coefficients", algebraic, coefficients),
	PARAM_FLAG("sturm", algebraic, sturm), PARAM_END };
static const struct param poly_params[] = { PARAM_FLOAT("an order", algebraic, order),
	PARAM_ARRAY("coefficients", algebraic, coefficients), PARAM_FLAG("sturm", algebraic, sturm),
	PARAM_END };

static void algebraic_build(struct algebraic *a, unsigned order, struct shape_build *build)
{
	a->order = order;
	if (a->coefficients.count != (order + 1) * (order + 2) * (order + 3) / 6) {
		build->error(build->user, "the number of coefficients does not fit the order");
		return;
	}
	a->coefficients.values = arena_copy(build->arena, a->coefficients.values,
		a->coefficients.count * sizeof *a->coefficients.values);
	const double *c = a->coefficients.values;
	for (unsigned i = 0; i <= order; i++) {
		for (unsigned j = 0; j <= i; c += ++j)
			a->top += fabs(*c);
	}
}

/* The highest coefficient along a ray is zero where it is no more than rounding: else it would have
 * roots of its own, far away. */
static unsigned rounded_degree(const struct algebraic *a, const double *c)
{
	const unsigned order = (unsigned)a->order;
	return fabs(c[order]) <= 1e-14 * a->top ? order - 1 : order;
}

static void cubic_build(void *self, struct shape_build *build)
{
	algebraic_build(self, 3, build);
}

static void quartic_build(void *self, struct shape_build *build)
{
	algebraic_build(self, 4, build);
}

static void poly_build(void *self, struct shape_build *build)
{
	struct algebraic *a = self;
	if (!(a->order >= 2 && a->order < MAX_ORDER + 1)) {
		build->error(build->user, "the order of a poly must be from 2 to 35");
		return;
	}
	algebraic_build(a, (unsigned)a->order, build);
}

static box algebraic_bounds(const void *self)
{
	(void)self;
	return box_everything();
}

/* p = p * (a + b s) + q, where p then has degree `degree` and q a smaller or equal one. */
static void multiply_add(
	double *p, unsigned degree, double a, double b, const double *q, unsigned q_degree)
{
	for (unsigned i = degree; i > 0; i--)
		p[i] = a * p[i] + b * p[i - 1];
	p[0] *= a;
	for (unsigned i = 0; i <= q_degree; i++)
		p[i] += q[i];
}

/* The polynomial along the ray o + s d, lowest power first. */
static void along_ray(const struct algebraic *a, vec3 o, vec3 d, double *in_x)
{
	const unsigned n = (unsigned)a->order;
	const double *c = a->coefficients.values;
	double in_y[MAX_ORDER + 1], in_z[MAX_ORDER + 1];
	memset(in_x, 0, (n + 1) * sizeof *in_x);
	for (unsigned i = 0; i <= n; i++) { /* x^(n - i) */
		memset(in_y, 0, (n + 1) * sizeof *in_y);
		for (unsigned j = 0; j <= i; j++) { /* y^(i - j) */
			memset(in_z, 0, (n + 1) * sizeof *in_z);
			for (unsigned k = 0; k <= j; k++) /* z^(j - k) */
				multiply_add(in_z, k, o.z, d.z, c++, 0);
			multiply_add(in_y, j, o.y, d.y, in_z, j);
		}
		multiply_add(in_x, i, o.x, d.x, in_y, i);
	}
}

/* Value and gradient at p, carried through the same scheme. */
static double value_and_gradient(const struct algebraic *a, vec3 p, vec3 *gradient)
{
	const unsigned n = (unsigned)a->order;
	const double *c = a->coefficients.values;
	double f = 0;
	vec3 g = vec(0, 0, 0);
	for (unsigned i = 0; i <= n; i++) {
		double fy = 0, gyy = 0, gyz = 0;
		for (unsigned j = 0; j <= i; j++) {
			double fz = 0, gz = 0;
			for (unsigned k = 0; k <= j; k++) {
				gz = gz * p.z + fz;
				fz = fz * p.z + *c++;
			}
			gyy = gyy * p.y + fy;
			gyz = gyz * p.y + gz;
			fy = fy * p.y + fz;
		}
		g = vec(g.x * p.x + f, g.y * p.x + gyy, g.z * p.x + gyz);
		f = f * p.x + fy;
	}
	*gradient = g;
	return f;
}

static void algebraic_hits(
	const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	const struct algebraic *a = self;
	const double scale = vec_length(r->direction);
	const vec3 d = vec_scale(r->direction, 1 / scale);
	const double before = vec_dot(r->origin, d);
	double c[MAX_ORDER + 1], roots[POLYNOMIAL_MAX_DEGREE];
	along_ray(a, vec_mad(r->origin, -before, d), d, c);
	const unsigned count = polynomial_crossings(
		c, rounded_degree(a, c), tmin * scale + before, tmax * scale + before, roots);
	for (unsigned i = 0; i < count; i++) {
		const double t = (roots[i] - before) / scale;
		if (t > tmin && t < tmax)
			hits_push(out, t);
	}
}

static bool algebraic_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const struct algebraic *a = self;
	const double scale = vec_length(r->direction);
	const vec3 d = vec_scale(r->direction, 1 / scale);
	const double before = vec_dot(r->origin, d);
	double c[MAX_ORDER + 1], root;
	along_ray(a, vec_mad(r->origin, -before, d), d, c);
	if (!polynomial_first_crossing(
		    c, (unsigned)a->order, tmin * scale + before, tmax * scale + before, &root))
		return false;
	const double t = (root - before) / scale;
	if (!(t >= tmin && t < tmax))
		return false;
	found->t = t;
	return true;
}

static bool algebraic_inside(const void *self, vec3 p)
{
	vec3 gradient;
	return value_and_gradient(self, p, &gradient) < FAT;
}

static vec3 algebraic_normal(const void *self, const struct hit *hit, vec3 p)
{
	vec3 gradient;
	(void)hit;
	value_and_gradient(self, p, &gradient);
	return vec_length2(gradient) > 0 ? gradient : vec(1, 0, 0);
}

#define ALGEBRAIC(word, its_params)                                                                \
	const struct shape_class shape_##word = {                                                  \
		.name = #word,                                                                     \
		.size = sizeof(struct algebraic),                                                  \
		.params = its_params,                                                              \
		.build = word##_build,                                                             \
		.bounds = algebraic_bounds,                                                        \
		.nearest = algebraic_nearest,                                                      \
		.hits = algebraic_hits,                                                            \
		.inside = algebraic_inside,                                                        \
		.normal = algebraic_normal,                                                        \
	};
ALGEBRAIC(cubic, cubic_params)
ALGEBRAIC(quartic, cubic_params)
ALGEBRAIC(poly, poly_params)
