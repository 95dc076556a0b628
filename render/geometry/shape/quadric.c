/* SPDX-License-Identifier: MIT */
/*
 * quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }
 *
 * A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0, the inside
 * where it is negative. Takes every transformation into its coefficients.
 */
#include "geometry/shape.h"

#include "base/elementary.h"

struct quadric {
	vec3 squares, mixed, linear;
	double constant;
	/* built: */
	bool has_mixed; /* whether any mixed term is not zero */
	vec3 near;	/* a point the quadric lies around, its centre if it has one */
	bool is_convex; /* ellipsoid, elliptic cylinder or paraboloid, not inside out */
};

static const struct param quadric_params[] = { PARAM_VECTOR("the coefficients of the squares",
						       quadric, squares),
	PARAM_VECTOR("the coefficients of the mixed terms", quadric, mixed),
	PARAM_VECTOR("the linear coefficients", quadric, linear),
	PARAM_FLOAT("a constant", quadric, constant), PARAM_END };

/* Half the gradient of the quadratic part. */
static inline vec3 quadric_times(const struct quadric *q, vec3 p)
{
	const vec3 s = q->squares, m = q->mixed;
	if (!q->has_mixed)
		return vec_mul(s, p);
	return vec(s.x * p.x + 0.5 * (m.x * p.y + m.y * p.z),
		s.y * p.y + 0.5 * (m.x * p.x + m.z * p.z),
		s.z * p.z + 0.5 * (m.y * p.x + m.z * p.y));
}

static inline double quadric_value(const struct quadric *q, vec3 p)
{
	return vec_dot(p, vec_add(quadric_times(q, p), q->linear)) + q->constant;
}

/* The columns of the adjugate of the quadratic part; returns the determinant. */
static double quadric_adjugate(const struct quadric *q, vec3 columns[3])
{
	const vec3 a = quadric_times(q, vec(1, 0, 0));
	const vec3 b = quadric_times(q, vec(0, 1, 0));
	const vec3 c = quadric_times(q, vec(0, 0, 1));
	columns[0] = vec_cross(b, c);
	columns[1] = vec_cross(c, a);
	columns[2] = vec_cross(a, b);
	return vec_dot(a, columns[0]);
}

static void quadric_find_centre(struct quadric *q)
{
	vec3 adjugate[3];
	const double determinant = quadric_adjugate(q, adjugate);
	const double size = fabs(q->squares.x) + fabs(q->squares.y) + fabs(q->squares.z) +
			    fabs(q->mixed.x) + fabs(q->mixed.y) + fabs(q->mixed.z);
	q->near = vec(0, 0, 0);
	/* nearly singular: the centre, if any, is far from what one sees */
	if (fabs(determinant) > 1e-9 * size * size * size) {
		const double f = -0.5 / determinant;
		q->near = vec_scale(
			vec(vec_dot(adjugate[0], q->linear), vec_dot(adjugate[1], q->linear),
				vec_dot(adjugate[2], q->linear)),
			f);
	}
}

/* Whether the quadratic part is nowhere negative, up to rounding: its principal minors tell. */
static void quadric_find_convexity(struct quadric *q)
{
	const vec3 s = q->squares, m = vec_scale(q->mixed, 0.5);
	const double size = fabs(s.x) + fabs(s.y) + fabs(s.z) + fabs(m.x) + fabs(m.y) + fabs(m.z);
	const double least = -1e-12 * size, least2 = least * size, least3 = least2 * size;
	vec3 adjugate[3];
	q->is_convex = quadric_adjugate(q, adjugate) >= least3 && s.x >= least && s.y >= least &&
		       s.z >= least && s.x * s.y - m.x * m.x >= least2 &&
		       s.x * s.z - m.y * m.y >= least2 && s.y * s.z - m.z * m.z >= least2;
}

static void quadric_prepare(struct quadric *q)
{
	q->has_mixed = q->mixed.x != 0 || q->mixed.y != 0 || q->mixed.z != 0;
	quadric_find_centre(q);
	quadric_find_convexity(q);
}

static void quadric_build(void *self, struct shape_build *build)
{
	(void)build;
	quadric_prepare(self);
}

/* With rows of the inverse as directions, x' = x M gives the form M⁻¹ Q M⁻ᵀ. */
static bool quadric_absorb(void *self, const transform *t)
{
	struct quadric *q = self;
	const struct quadric old = *q;
	const vec3 row[3] = { transform_direction_back(t, vec(1, 0, 0)),
		transform_direction_back(t, vec(0, 1, 0)),
		transform_direction_back(t, vec(0, 0, 1)) };
	const vec3 origin = transform_point_back(t, vec(0, 0, 0));
	vec3 image[3];
	for (int i = 0; i < 3; i++)
		image[i] = quadric_times(&old, row[i]);
	const vec3 slope = vec_mad(old.linear, 2, quadric_times(&old, origin));
	q->squares = vec(
		vec_dot(row[0], image[0]), vec_dot(row[1], image[1]), vec_dot(row[2], image[2]));
	q->mixed = vec(2 * vec_dot(row[0], image[1]), 2 * vec_dot(row[0], image[2]),
		2 * vec_dot(row[1], image[2]));
	q->linear = vec(vec_dot(row[0], slope), vec_dot(row[1], slope), vec_dot(row[2], slope));
	q->constant = quadric_value(&old, origin);
	quadric_prepare(q);
	return true;
}

/* Only what holds the inside as well, which also bounds what the quadric cuts: ellipsoids. */
static box quadric_bounds(const void *self)
{
	const struct quadric *q = self;
	vec3 adjugate[3];
	const double determinant = quadric_adjugate(q, adjugate);
	const vec3 s = q->squares;
	const double minor = s.x * s.y - 0.25 * q->mixed.x * q->mixed.x;
	const double size = s.x + s.y + s.z;
	if (!(s.x > 0 && s.y > 0 && s.z > 0 && minor > 0 &&
		    determinant > 1e-9 * size * size * size))
		return box_everything();
	const double depth = -quadric_value(q, q->near) / determinant;
	if (depth < 0)
		return box_nothing();
	const vec3 reach = vec(sqrt(depth * adjugate[0].x), sqrt(depth * adjugate[1].y),
		sqrt(depth * adjugate[2].z));
	/* the coefficients are rounded: leave room for it */
	const vec3 room = vec_mad(vec_scale(reach, 1 + 1e-9), 1e-12,
		vec(fabs(q->near.x), fabs(q->near.y), fabs(q->near.z)));
	return (box){ vec_sub(q->near, room), vec_add(q->near, room) };
}

/* x with (A + axis axisᵀ) x = b, for the quadratic part A. */
static vec3 solve_with(const struct quadric *q, vec3 axis, vec3 b)
{
	const vec3 r0 = vec_mad(quadric_times(q, vec(1, 0, 0)), axis.x, axis);
	const vec3 r1 = vec_mad(quadric_times(q, vec(0, 1, 0)), axis.y, axis);
	const vec3 r2 = vec_mad(quadric_times(q, vec(0, 0, 1)), axis.z, axis);
	const vec3 c0 = vec_cross(r1, r2), c1 = vec_cross(r2, r0), c2 = vec_cross(r0, r1);
	const vec3 sum = vec_add(vec_scale(c0, b.x), vec_mad(vec_scale(c1, b.y), b.z, c2));
	return vec_scale(sum, 1 / vec_dot(r0, c0));
}

/* Around an elliptic cylinder: planes that touch it. Its axis is where the quadratic part is zero;
 * in any direction v across, the surface of (p - c)ᵀ A (p - c) = depth reaches as far as
 * sqrt(depth vᵀ A⁻¹ v) from the centre c. */
static size_t quadric_half_spaces(const void *self, struct half_space *out)
{
	const struct quadric *q = self;
	vec3 adjugate[3];
	const double size = q->squares.x + q->squares.y + q->squares.z;
	if (!q->is_convex || fabs(quadric_adjugate(q, adjugate)) > 1e-12 * size * size * size)
		return 0;
	vec3 axis = adjugate[0];
	for (int i = 1; i < 3; i++)
		axis = vec_length2(adjugate[i]) > vec_length2(axis) ? adjugate[i] : axis;
	if (!(vec_length(axis) > 1e-6 * size * size)) /* a slab, or nearly */
		return 0;
	axis = vec_normalize(axis);
	if (fabs(vec_dot(axis, q->linear)) > 1e-12 * (size + vec_length(q->linear)))
		return 0; /* parabolic */
	const vec3 stretched = vec_scale(axis, sqrt(size));
	const vec3 centre = solve_with(q, stretched, vec_scale(q->linear, -0.5));
	const double depth = -quadric_value(q, centre);
	if (!(depth >= 0))
		return 0;
	const vec3 u =
		vec_normalize(vec_cross(fabs(axis.x) < 0.5 ? vec(1, 0, 0) : vec(0, 1, 0), axis));
	const vec3 v = vec_cross(axis, u);
	for (int i = 0; i < SHAPE_HALF_SPACES; i++) {
		const double angle = 2 * M_PI * i / SHAPE_HALF_SPACES;
		const vec3 n =
			vec_mad(vec_scale(u, elementary_cos(angle)), elementary_sin(angle), v);
		const double reach = sqrt(depth * vec_dot(n, solve_with(q, stretched, n)));
		out[i] = (struct half_space){ n,
			vec_dot(n, centre) + reach * (1 + 1e-9) + 1e-12 * vec_length(centre) };
	}
	return SHAPE_HALF_SPACES;
}

/* The quadric along a ray: a s² + 2 b s + c at the parameter start + s. */
struct quadratic {
	double start, a, b, c;
};

static inline struct quadratic along_ray(const struct quadric *q, const ray *r)
{
	const vec3 d = r->direction, image = quadric_times(q, d);
	const double start = -vec_dot(vec_sub(r->origin, q->near), d) / vec_length2(d);
	const vec3 o = ray_at(*r, start);
	return (struct quadratic){ start, vec_dot(d, image),
		vec_dot(o, image) + 0.5 * vec_dot(q->linear, d), quadric_value(q, o) };
}

static inline unsigned quadric_roots(const struct quadric *q, const ray *r, double t[2])
{
	const struct quadratic f = along_ray(q, r);
	const double discriminant = f.b * f.b - f.a * f.c;
	if (!(discriminant >= 0))
		return 0;
	const double root = -(f.b + copysign(sqrt(discriminant), f.b));
	unsigned n = 0;
	if (f.a != 0)
		t[n++] = f.start + root / f.a;
	if (root != 0)
		t[n++] = f.start + f.c / root;
	return n;
}

static bool quadric_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	double t[2], best = INFINITY;
	const unsigned n = quadric_roots(self, r, t);
	for (unsigned i = 0; i < n; i++) {
		if (t[i] >= tmin && t[i] < tmax && t[i] < best)
			best = t[i];
	}
	if (best == INFINITY)
		return false;
	found->t = best;
	return true;
}

static void quadric_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	double t[2];
	const unsigned n = quadric_roots(self, r, t);
	for (unsigned i = 0; i < n; i++) {
		if (t[i] > tmin && t[i] < tmax)
			hits_push(out, t[i]);
	}
}

static bool quadric_has_chord(const void *self)
{
	const struct quadric *q = self;
	return q->is_convex;
}

static bool quadric_chord(const void *self, const ray *r, struct chord *chord)
{
	const struct quadric *q = self;
	const struct quadratic f = along_ray(q, r);
	const vec3 s = q->squares;
	*chord = (struct chord){ { -INFINITY, INFINITY }, { 0, 0 } };
	if (f.a <= 1e-14 * (s.x + s.y + s.z) * vec_length2(r->direction)) { /* along the axis */
		if (f.b == 0)
			return f.c <= 0;
		chord->t[f.b > 0] = f.start - 0.5 * f.c / f.b;
		return true;
	}
	const double discriminant = f.b * f.b - f.a * f.c;
	if (!(discriminant >= 0))
		return false;
	const double root = -(f.b + copysign(sqrt(discriminant), f.b));
	const double t1 = f.start + root / f.a;
	const double t2 = root != 0 ? f.start + f.c / root : t1;
	chord->t[0] = t1 < t2 ? t1 : t2;
	chord->t[1] = t1 < t2 ? t2 : t1;
	return true;
}

/* The least value of s t² + l t between lo and hi. */
static double least_term(double s, double l, double lo, double hi)
{
	if (s > 0) {
		const double t = fmin(fmax(-0.5 * l / s, lo), hi);
		return t * (s * t + l);
	}
	if ((hi >= BOX_UNBOUNDED && (s < 0 || l < 0)) || (lo <= -BOX_UNBOUNDED && (s < 0 || l > 0)))
		return -INFINITY;
	return fmin(lo * (s * lo + l), hi * (s * hi + l));
}

/* Cuts lo to hi to where s t² + l t + rest <= 0 is possible. */
static void cut_interval(double s, double l, double rest, double *lo, double *hi)
{
	if (!isfinite(rest) || s < 0)
		return;
	if (s > 0) {
		const double middle = -0.5 * l / s;
		const double reach = sqrt(fmax(0, middle * middle - rest / s));
		*lo = fmax(*lo, middle - reach);
		*hi = fmin(*hi, middle + reach);
	} else if (l > 0) {
		*hi = fmin(*hi, -rest / l);
	} else if (l < 0) {
		*lo = fmax(*lo, -rest / l);
	}
}

static box quadric_extent_within(const void *self, box b)
{
	const struct quadric *q = self;
	const vec3 s = q->squares, l = q->linear;
	if (q->has_mixed)
		return b;
	double x = least_term(s.x, l.x, b.lo.x, b.hi.x);
	double y = least_term(s.y, l.y, b.lo.y, b.hi.y);
	const double z = least_term(s.z, l.z, b.lo.z, b.hi.z);
	cut_interval(s.x, l.x, q->constant + y + z, &b.lo.x, &b.hi.x);
	x = least_term(s.x, l.x, b.lo.x, b.hi.x);
	cut_interval(s.y, l.y, q->constant + x + z, &b.lo.y, &b.hi.y);
	y = least_term(s.y, l.y, b.lo.y, b.hi.y);
	cut_interval(s.z, l.z, q->constant + x + y, &b.lo.z, &b.hi.z);
	return b;
}

static bool quadric_inside(const void *self, vec3 p)
{
	return quadric_value(self, p) <= 0;
}

static vec3 quadric_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct quadric *q = self;
	(void)hit;
	const vec3 n = vec_mad(q->linear, 2, quadric_times(q, p));
	return vec_length2(n) > 0 ? n : vec(1, 0, 0);
}

const struct shape_class shape_quadric = {
	.name = "quadric",
	.size = sizeof(struct quadric),
	.params = quadric_params,
	.keeps_normal_inverted = true,
	.build = quadric_build,
	.absorb = quadric_absorb,
	.bounds = quadric_bounds,
	.extent_within = quadric_extent_within,
	.moves_extent = true,
	.nearest = quadric_nearest,
	.hits = quadric_hits,
	.chord = quadric_chord,
	.has_chord = quadric_has_chord,
	.half_spaces = quadric_half_spaces,
	.inside = quadric_inside,
	.normal = quadric_normal,
};
