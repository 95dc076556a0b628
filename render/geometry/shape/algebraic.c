/* SPDX-License-Identifier: MIT */
/*
 * cubic { <coefficients> }, quartic { <coefficients> }, poly { order, <coefficients> },
 * polynomial { order, xyz(i, j, k): coefficient, ... }, which arrives with all its coefficients
 *
 * The zeros of a polynomial in x, y and z; the coefficients stand by falling
 * powers of x, then y, then z, and most are zero: only the others are kept. Along
 * a ray it is a polynomial in the distance, formed by Horner's rule at the point
 * of the ray nearest the origin.
 */
#include "geometry/shape.h"
#include "shape/polynomial.h"

#include <stdint.h>

#define MAX_ORDER 35
/* How far beyond its surface the language lets the inside reach, in values of the polynomial. */
#define FAT 1e-4

/* A coefficient and what Horner's rule does after adding it: multiply so many times by z; then, at
 * the end of a polynomial in z, by y; then, at the end of one in y and z, by x. */
struct term {
	double coefficient;
	uint8_t times_z, times_y, times_x;
	bool ends_z, ends_y;
};

struct algebraic {
	double order; /* as written; then 3 or 4 for cubic and quartic */
	struct field_array coefficients;
	bool sturm; /* asks for care that is always taken */
	/* built: */
	double top;	    /* the sum of all coefficients of the highest order, without signs */
	struct term *terms; /* that are not zero */
	size_t term_count;
};

static const struct field cubic_fields[] = { FIELD(algebraic, coefficients),
	FIELD(algebraic, sturm), FIELD_END };
static const struct field poly_fields[] = { FIELD(algebraic, order), FIELD(algebraic, coefficients),
	FIELD(algebraic, sturm), FIELD_END };

/* Appends the coefficient of x^x y^y z^z; until another term follows it is taken to be the last. */
static void add_term(struct algebraic *a, double coefficient, unsigned powers[3])
{
	const unsigned x = powers[0], y = powers[1], z = powers[2];
	struct term *term = &a->terms[a->term_count++];
	*term = (struct term){ coefficient, (uint8_t)z, (uint8_t)y, (uint8_t)x, true, true };
	if (a->term_count == 1)
		return;
	struct term *before = term - 1;
	before->ends_y = before->times_x != x;
	before->ends_z = before->ends_y || before->times_y != y;
	if (before->ends_y)
		before->times_x = (uint8_t)(before->times_x - x);
	else if (before->ends_z)
		before->times_y = (uint8_t)(before->times_y - y);
	else
		before->times_z = (uint8_t)(before->times_z - z);
}

static void algebraic_build(struct algebraic *a, unsigned order, struct shape_build *build)
{
	a->order = order;
	if (a->coefficients.count != (order + 1) * (order + 2) * (order + 3) / 6) {
		build->error(build->user, "the number of coefficients does not fit the order");
		return;
	}
	a->terms = ARENA_ARRAY(build->arena, a->coefficients.count, struct term);
	const double *c = a->coefficients.values;
	for (unsigned i = 0; i <= order; i++) {
		for (unsigned j = 0; j <= i; j++) {
			a->top += fabs(*c);
			for (unsigned k = 0; k <= j; k++, c++) {
				if (*c != 0)
					add_term(a, *c, (unsigned[3]){ order - i, i - j, j - k });
			}
		}
	}
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

static void polynomial_build(void *self, struct shape_build *build)
{
	poly_build(self, build);
}

static box algebraic_bounds(const void *self)
{
	(void)self;
	return box_everything();
}

/* A polynomial while it is formed, lowest power first. */
struct series {
	double c[MAX_ORDER + 1];
	unsigned degree;
};

/* p (a + b s)^times */
static inline void series_times(struct series *p, double a, double b, unsigned times)
{
	for (; times > 0; times--) {
		p->c[p->degree + 1] = b * p->c[p->degree];
		for (unsigned i = p->degree; i > 0; i--)
			p->c[i] = a * p->c[i] + b * p->c[i - 1];
		p->c[0] *= a;
		p->degree++;
	}
}

/* Adds q to p and makes q zero. */
static inline void series_take(struct series *p, struct series *q)
{
	for (; p->degree < q->degree; p->degree++)
		p->c[p->degree + 1] = 0;
	for (unsigned i = 0; i <= q->degree; i++)
		p->c[i] += q->c[i];
	q->c[0] = 0;
	q->degree = 0;
}

/* p (a + b s)^times, where the result has no more than five coefficients. All of them are worked
 * on: that is faster than to count. */
static inline void quartic_times(double *p, double a, double b, unsigned times)
{
	for (; times > 0; times--) {
		for (unsigned i = 4; i > 0; i--)
			p[i] = a * p[i] + b * p[i - 1];
		p[0] *= a;
	}
}

static inline void quartic_take(double *p, double *q)
{
	for (unsigned i = 0; i < 5; i++) {
		p[i] += q[i];
		q[i] = 0;
	}
}

/* along_ray up to the fourth order. */
static void quartic_along_ray(const struct algebraic *a, vec3 o, vec3 d, double in_x[5])
{
	double in_y[5] = { 0 }, in_z[5] = { 0 };
	for (unsigned i = 0; i < 5; i++)
		in_x[i] = 0;
	for (size_t i = 0; i < a->term_count; i++) {
		const struct term *term = &a->terms[i];
		in_z[0] += term->coefficient;
		quartic_times(in_z, o.z, d.z, term->times_z);
		if (!term->ends_z)
			continue;
		quartic_take(in_y, in_z);
		quartic_times(in_y, o.y, d.y, term->times_y);
		if (!term->ends_y)
			continue;
		quartic_take(in_x, in_y);
		quartic_times(in_x, o.x, d.x, term->times_x);
	}
}

static void series_along_ray(const struct algebraic *a, vec3 o, vec3 d, struct series *in_x)
{
	struct series in_y, in_z;
	in_x->c[0] = in_y.c[0] = in_z.c[0] = 0;
	in_x->degree = in_y.degree = in_z.degree = 0;
	for (size_t i = 0; i < a->term_count; i++) {
		const struct term *term = &a->terms[i];
		in_z.c[0] += term->coefficient;
		series_times(&in_z, o.z, d.z, term->times_z);
		if (!term->ends_z)
			continue;
		series_take(&in_y, &in_z);
		series_times(&in_y, o.y, d.y, term->times_y);
		if (!term->ends_y)
			continue;
		series_take(in_x, &in_y);
		series_times(in_x, o.x, d.x, term->times_x);
	}
}

/* The polynomial along the ray o + s d, lowest power first; returns its degree. */
static unsigned along_ray(const struct algebraic *a, vec3 o, vec3 d, struct series *out)
{
	const unsigned order = (unsigned)a->order;
	if (order <= 4) {
		quartic_along_ray(a, o, d, out->c);
		out->degree = order;
	} else {
		series_along_ray(a, o, d, out);
	}
	/* The highest coefficient is zero where it is no more than rounding: else it would have
	 * roots of its own, far away. */
	if (out->degree == order && fabs(out->c[order]) <= 1e-14 * a->top)
		return order - 1;
	return out->degree;
}

/* Value and gradient at p, carried through the same scheme. */
static double value_and_gradient(const struct algebraic *a, vec3 p, vec3 *gradient)
{
	double f = 0, fy = 0, fz = 0;
	vec3 g = vec(0, 0, 0);
	double gyy = 0, gyz = 0, gz = 0;
	for (size_t i = 0; i < a->term_count; i++) {
		const struct term *term = &a->terms[i];
		fz += term->coefficient;
		for (unsigned k = term->times_z; k > 0; k--) {
			gz = gz * p.z + fz;
			fz *= p.z;
		}
		if (!term->ends_z)
			continue;
		fy += fz;
		gyz += gz;
		fz = gz = 0;
		for (unsigned k = term->times_y; k > 0; k--) {
			gyy = gyy * p.y + fy;
			gyz *= p.y;
			fy *= p.y;
		}
		if (!term->ends_y)
			continue;
		f += fy;
		g = vec(g.x, g.y + gyy, g.z + gyz);
		fy = gyy = gyz = 0;
		for (unsigned k = term->times_x; k > 0; k--) {
			g = vec(g.x * p.x + f, g.y * p.x, g.z * p.x);
			f *= p.x;
		}
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
	struct series s;
	double roots[POLYNOMIAL_MAX_DEGREE];
	const unsigned degree = along_ray(a, vec_mad(r->origin, -before, d), d, &s);
	const unsigned count = polynomial_crossings(
		s.c, degree, tmin * scale + before, tmax * scale + before, roots);
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
	struct series s;
	double root;
	const unsigned degree = along_ray(a, vec_mad(r->origin, -before, d), d, &s);
	if (!polynomial_first_crossing(
		    s.c, degree, tmin * scale + before, tmax * scale + before, &root))
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

#define ALGEBRAIC(word, its_fields)                                                                \
	const struct shape_class shape_##word = {                                                  \
		.name = #word,                                                                     \
		.size = sizeof(struct algebraic),                                                  \
		.fields = its_fields,                                                              \
		.build = word##_build,                                                             \
		.bounds = algebraic_bounds,                                                        \
		.nearest = algebraic_nearest,                                                      \
		.hits = algebraic_hits,                                                            \
		.inside = algebraic_inside,                                                        \
		.normal = algebraic_normal,                                                        \
	};
ALGEBRAIC(cubic, cubic_fields)
ALGEBRAIC(quartic, cubic_fields)
ALGEBRAIC(poly, poly_fields)
ALGEBRAIC(polynomial, poly_fields)
