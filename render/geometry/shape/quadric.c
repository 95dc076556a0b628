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

static const struct field quadric_fields[] = { FIELD(quadric, squares), FIELD(quadric, mixed),
	FIELD(quadric, linear), FIELD(quadric, constant), FIELD_END };

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

/* ---- the box that the language tells of ---- */

/* Coefficients below this are none. */
#define NO_COEFFICIENT 1e-10
/* A box longer than this is no bound. */
#define LONGEST 1e6

/* A quadric without mixed terms about its centre: more squares are positive than negative. */
struct centred {
	double square[3], linear[3];
	double centre[3], constant;
	int positive, negative; /* squares */
	int odd;		/* the last axis whose square is not positive */
};

static double cleaned(double x)
{
	return fabs(x) < NO_COEFFICIENT ? 0 : x;
}

/* Along an axis without a square the centre is POV-Ray's, which is the apex of a paraboloid with the
 * other sign, and hides the constant. */
static struct centred centred_at(const struct quadric *q)
{
	const vec3 s = q->squares, l = q->linear;
	struct centred c = { { cleaned(s.x), cleaned(s.y), cleaned(s.z) },
		{ cleaned(l.x), cleaned(l.y), cleaned(l.z) }, { 0 }, q->constant, 0, 0, 0 };
	for (int i = 0; i < 3; i++) {
		if (c.square[i] != 0) {
			c.centre[i] = -0.5 * c.linear[i] / c.square[i];
			c.constant -= c.square[i] * c.centre[i] * c.centre[i];
		} else if (c.linear[i] != 0 && q->constant != 0) {
			c.centre[i] = q->constant / c.linear[i];
			c.constant -= q->constant;
		}
	}
	c.constant = cleaned(c.constant);
	return c;
}

/* Inside out it has the same box. */
static void centred_orient(struct centred *c)
{
	double sum = 0;
	for (int i = 0; i < 3; i++)
		sum += (c->square[i] > 0) - (c->square[i] < 0);
	const double sign = c->constant > 0 || (c->constant == 0 && sum < 0) ? -1 : 1;
	c->constant *= sign;
	for (int i = 0; i < 3; i++) {
		c->square[i] *= sign;
		c->linear[i] *= sign;
		c->positive += c->square[i] > 0;
		c->negative += c->square[i] < 0;
		if (!(c->square[i] > 0))
			c->odd = i;
	}
}

/* How large the sum of the positive terms gets where the odd coordinate is between lo and hi, which a
 * paraboloid narrows to its own side; NAN if that is not known. Of hyperboloids of any size POV-Ray takes
 * the waist for that of the constant -1. */
static double centred_reach(const struct centred *c, double *lo, double *hi)
{
	const double from = *lo - c->centre[c->odd], to = *hi - c->centre[c->odd];
	if (c->positive == 3 || (c->positive == 2 && c->negative == 0 && c->constant != 0))
		return c->constant < 0 ? -c->constant : NAN;
	if (c->positive == 2 && c->negative == 1) {
		const double far = fmax(fabs(from), fabs(to));
		return (c->constant != 0) - c->square[c->odd] * far * far;
	}
	const double slope = c->linear[c->odd];
	if (c->positive != 2 || slope == 0)
		return NAN;
	if (slope < 0)
		*lo = fmax(*lo, c->centre[c->odd]);
	else
		*hi = fmin(*hi, c->centre[c->odd]);
	return fabs(slope * (slope < 0 ? to : from));
}

/* As POV-Ray finds it, not always rightly; scenes place things by it. */
static box quadric_extent_within(const void *self, box b)
{
	const struct quadric *q = self;
	if (cleaned(q->mixed.x) != 0 || cleaned(q->mixed.y) != 0 || cleaned(q->mixed.z) != 0)
		return b;
	struct centred c = centred_at(q);
	centred_orient(&c);
	double lo[3] = { b.lo.x, b.lo.y, b.lo.z }, hi[3] = { b.hi.x, b.hi.y, b.hi.z };
	const double reach = centred_reach(&c, &lo[c.odd], &hi[c.odd]);
	if (isnan(reach))
		return b;
	for (int i = 0; i < 3; i++) {
		if (c.square[i] > 0) {
			lo[i] = fmax(lo[i], c.centre[i] - sqrt(reach / c.square[i]));
			hi[i] = fmin(hi[i], c.centre[i] + sqrt(reach / c.square[i]));
		}
		if (hi[i] - lo[i] > LONGEST)
			return box_everything();
	}
	return (box){ vec(lo[0], lo[1], lo[2]), vec(hi[0], hi[1], hi[2]) };
}

static box quadric_extent(const void *self, const transform *place)
{
	return box_placed(quadric_extent_within(self, box_everything()), place);
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
	.fields = quadric_fields,
	.keeps_normal_inverted = true,
	.build = quadric_build,
	.absorb = quadric_absorb,
	.bounds = quadric_bounds,
	.extent = quadric_extent,
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
