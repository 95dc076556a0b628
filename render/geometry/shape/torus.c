/* SPDX-License-Identifier: MIT */
/*
 * torus { major, minor [sturm] }
 *
 * A ring about the y axis. Hits are the roots of a quartic in the distance from
 * the point of the ray nearest the centre: there its coefficients are small and
 * the cubic one vanishes. `sturm` asks for care that is always taken.
 */
#include "geometry/shape.h"

#include "base/elementary.h"
#include "shape/polynomial.h"

struct torus {
	double major, minor;
	bool sturm;
};

static const struct field torus_fields[] = { FIELD(torus, major), FIELD(torus, minor),
	FIELD(torus, sturm), FIELD_END };

static void torus_build(void *self, struct shape_build *build)
{
	struct torus *o = self;
	o->major = fabs(o->major);
	build->dropped = !(o->minor > 0);
}

static box torus_bounds(const void *self)
{
	const struct torus *o = self;
	const vec3 reach = vec(o->major + o->minor, o->minor, o->major + o->minor);
	return (box){ vec_negate(reach), reach };
}

/* The part of the ray that can meet the torus, as a quartic in its own parameter s = (t - start) *
 * scale. */
struct section {
	double start, scale;
	double quartic[5];
	double lo, hi;
};

/* Where the ray is between the planes y = -minor and y = minor. */
static void cut_slab(struct section *s, double y, double dy, double minor)
{
	const double a = (-minor - y) / dy, b = (minor - y) / dy;
	/* written so that no number (a ray along a plane) cuts nothing */
	const double in = dy < 0 ? b : a, out = dy < 0 ? a : b;
	s->lo = in > s->lo ? in : s->lo;
	s->hi = out < s->hi ? out : s->hi;
}

static inline bool torus_section(
	const struct torus *o, const ray *r, double tmin, double tmax, struct section *s)
{
	const double outer = o->major + o->minor;
	s->scale = vec_length(r->direction);
	const vec3 d = vec_scale(r->direction, 1 / s->scale);
	const double before = vec_dot(r->origin, d);
	const vec3 q = vec_mad(r->origin, -before, d); /* nearest the centre */
	const double reach = outer * outer - vec_length2(q);
	if (!(reach > 0))
		return false;
	s->start = -before / s->scale;
	s->hi = sqrt(reach);
	s->lo = -s->hi;
	cut_slab(s, q.y, d.y, o->minor);
	/* a little wider, so that both ends are outside for certain */
	s->lo -= 1e-9 * outer;
	s->hi += 1e-9 * outer;
	const double from = tmin * s->scale + before, to = tmax * s->scale + before;
	s->lo = from > s->lo ? from : s->lo;
	s->hi = to < s->hi ? to : s->hi;
	if (!(s->lo < s->hi))
		return false;

	const double rr = 4 * o->major * o->major;
	const double rho = sqrt(q.x * q.x + q.z * q.z);
	const double tube = q.y * q.y - o->minor * o->minor;
	const double k = vec_length2(q) + (o->major - o->minor) * (o->major + o->minor);
	s->quartic[0] = ((rho - o->major) * (rho - o->major) + tube) *
			((rho + o->major) * (rho + o->major) + tube);
	s->quartic[1] = 2 * rr * q.y * d.y;
	s->quartic[2] = 2 * k - rr * (1 - d.y * d.y);
	s->quartic[3] = 0;
	s->quartic[4] = 1;
	return true;
}

static bool torus_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	struct section s;
	double root;
	if (!torus_section(self, r, tmin, tmax, &s) ||
		!polynomial_first_crossing(s.quartic, 4, s.lo, s.hi, &root))
		return false;
	const double t = s.start + root / s.scale;
	if (!(t >= tmin && t < tmax))
		return false;
	found->t = t;
	return true;
}

static void torus_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct section s;
	double roots[POLYNOMIAL_MAX_DEGREE];
	if (!torus_section(self, r, tmin, tmax, &s))
		return;
	const unsigned count = polynomial_crossings(s.quartic, 4, s.lo, s.hi, roots);
	for (unsigned i = 0; i < count; i++) {
		const double t = s.start + roots[i] / s.scale;
		if (t > tmin && t < tmax)
			hits_push(out, t);
	}
}

static bool torus_inside(const void *self, vec3 p)
{
	const struct torus *o = self;
	const double from_ring = sqrt(p.x * p.x + p.z * p.z) - o->major;
	return from_ring * from_ring + p.y * p.y <= o->minor * o->minor;
}

static vec3 torus_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct torus *o = self;
	(void)hit;
	const double rho = sqrt(p.x * p.x + p.z * p.z);
	if (rho == 0)
		return p;
	const double out = 1 - o->major / rho;
	return vec(p.x * out, p.y, p.z * out);
}

static void torus_uv(
	const void *self, const struct hit *hit, vec3 p, const transform *absorbed, double uv[2])
{
	const struct torus *o = self;
	(void)hit;
	(void)absorbed;
	const double rho = sqrt(p.x * p.x + p.z * p.z);
	uv[0] = 1 - (elementary_atan2(p.z, p.x) + M_PI) / (2 * M_PI);
	uv[1] = (elementary_atan2(p.y, rho - o->major) + M_PI) / (2 * M_PI);
}

const struct shape_class shape_torus = {
	.name = "torus",
	.size = sizeof(struct torus),
	.fields = torus_fields,
	.build = torus_build,
	.bounds = torus_bounds,
	.nearest = torus_nearest,
	.hits = torus_hits,
	.inside = torus_inside,
	.normal = torus_normal,
	.uv = torus_uv,
};
