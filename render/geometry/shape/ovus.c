/* SPDX-License-Identifier: MIT */
/*
 * ovus { bottom radius, top radius [sturm] }
 *
 * An egg about the y axis: a sphere around the origin below, a sphere around
 * (0, bottom radius, 0) above, and between them the arc of a circle that
 * touches both, turned around the axis. The arc's circle has its centre on the
 * far side of the axis, so the body is the inner sheet of a torus that cuts
 * itself. The egg is convex: a ray crosses it twice or not at all.
 */
#include "geometry/shape.h"

#include "base/elementary.h"
#include "shape/polynomial.h"

/* How far over its seams a piece is looked for, in radii: neighbours touch there, so what both find is
 * the same to the last places, and no ray slips between them. */
#define SEAM 1e-9

struct ovus {
	double bottom, top; /* radii */
	bool sturm;
	double arc, distance,
		height;	  /* radius of the arc's circle; its centre from the axis; at y */
	double low, high; /* the arc is between these heights */
};

static const struct field ovus_fields[] = { FIELD(ovus, bottom), FIELD(ovus, top),
	FIELD(ovus, sturm), FIELD_END };

static void ovus_build(void *self, struct shape_build *build)
{
	struct ovus *o = self;
	const double b = o->bottom, t = o->top;
	if (b < 0 || t < 0) {
		build->error(build->user, "the radii of an ovus are not negative");
	} else if (t >= 2 * b) {
		build->warning(build->user, "this ovus is a sphere: its top holds its bottom");
		o->low = o->high = -HUGE_VAL; /* all of it is above */
	} else if (b > t) {
		o->arc = 2 * b;
		o->height = 2 * t - b - t * t / (2 * b);
		o->distance = sqrt(b * b - o->height * o->height);
		o->low = -o->height;
		o->high = (b - o->height) * t / (o->arc - t) + b;
	} else {
		o->arc = 2 * t;
		o->height = -2 * t + b + 3 * t * t / (2 * b);
		o->distance = sqrt(t * t - (o->height - b) * (o->height - b));
		o->low = -o->height * b / (o->arc - b);
		o->high = 2 * b - o->height;
	}
}

static box ovus_bounds(const void *self)
{
	const struct ovus *o = self;
	const double width = fmax(o->arc - o->distance, fmax(o->bottom, o->top));
	const bool is_sphere = o->low == -HUGE_VAL;
	return (box){ vec(-width, is_sphere ? o->bottom - o->top : -o->bottom, -width),
		vec(width, o->bottom + o->top, width) };
}

/* The first and last crossing found so far. */
struct egg_chord {
	double in, out;
};

/* Takes a crossing at height y in if it is on the piece between two heights. The height is worked out
 * near the egg: from a far origin it would be lost. */
static void add_crossing(struct egg_chord *c, double t, double y, double from, double to)
{
	if (!(y >= from && y <= to))
		return;
	c->in = fmin(c->in, t);
	c->out = fmax(c->out, t);
}

static void cross_sphere(
	struct egg_chord *c, const ray *r, double height, double radius, double from, double to)
{
	const vec3 origin = vec_sub(r->origin, vec(0, height, 0));
	const double inverse = 1 / vec_length2(r->direction);
	const double middle = -vec_dot(origin, r->direction) * inverse;
	const vec3 closest = vec_mad(origin, middle, r->direction);
	const double square = radius * radius - vec_length2(closest);
	if (!(square > 0))
		return;
	const double half = sqrt(square * inverse);
	const double y = closest.y + height, rise = half * r->direction.y;
	add_crossing(c, middle - half, y - rise, from, to);
	add_crossing(c, middle + half, y + rise, from, to);
}

/* The quartic of the torus, in the distance from the point of the ray nearest its centre. */
static void cross_arc(
	struct egg_chord *c, const struct ovus *o, const ray *r, double from, double to)
{
	const double scale = vec_length(r->direction);
	const vec3 d = vec_scale(r->direction, 1 / scale);
	const vec3 origin = vec_sub(r->origin, vec(0, o->height, 0));
	const double before = vec_dot(origin, d);
	const vec3 q = vec_mad(origin, -before, d);
	const double reach = o->arc * o->arc - vec_length2(q);
	if (!(reach > 0))
		return;
	const double rho = sqrt(q.x * q.x + q.z * q.z), h = o->distance;
	const double rest = q.y * q.y - o->arc * o->arc;
	const double k = vec_length2(q) + (h - o->arc) * (h + o->arc);
	const double quartic[5] = { ((rho - h) * (rho - h) + rest) * ((rho + h) * (rho + h) + rest),
		8 * h * h * q.y * d.y, 2 * k - 4 * h * h * (1 - d.y * d.y), 0, 1 };
	double roots[POLYNOMIAL_MAX_DEGREE];
	const double end = sqrt(reach);
	const unsigned count = polynomial_crossings(quartic, 4, -end, end, roots);
	for (unsigned i = 0; i < count; i++)
		if (roots[i] * roots[i] + k <= 0) /* the inner sheet */
			add_crossing(c, (roots[i] - before) / scale,
				q.y + roots[i] * d.y + o->height, from, to);
}

static bool ovus_chord(const void *self, const ray *r, struct chord *out)
{
	const struct ovus *o = self;
	const double seam = SEAM * (o->bottom + o->top);
	struct egg_chord c = { HUGE_VAL, -HUGE_VAL };
	cross_sphere(&c, r, o->bottom, o->top, o->high - seam, HUGE_VAL);
	if (o->low > -HUGE_VAL) {
		cross_sphere(&c, r, 0, o->bottom, -HUGE_VAL, o->low + seam);
		if (o->low < o->high)
			cross_arc(&c, o, r, o->low - seam, o->high + seam);
	}
	if (!(c.in < c.out))
		return false;
	*out = (struct chord){ { c.in, c.out }, { 0, 0 } };
	return true;
}

static void ovus_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct chord c;
	if (!ovus_chord(self, r, &c))
		return;
	for (int i = 0; i < 2; i++) {
		if (c.t[i] > tmin && c.t[i] < tmax)
			hits_push(out, c.t[i]);
	}
}

static bool ovus_inside(const void *self, vec3 p)
{
	const struct ovus *o = self;
	const double square = p.x * p.x + p.z * p.z, above = p.y - o->bottom;
	if (square + above * above < o->top * o->top)
		return true;
	if (o->low == -HUGE_VAL)
		return false;
	if (square + p.y * p.y < o->bottom * o->bottom)
		return true;
	const double out = sqrt(square) + o->distance, up = p.y - o->height;
	return p.y > o->low && p.y < o->high && out * out + up * up < o->arc * o->arc;
}

static vec3 ovus_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct ovus *o = self;
	(void)hit;
	if (p.y >= o->high)
		return vec(p.x, p.y - o->bottom, p.z);
	if (p.y <= o->low)
		return p;
	const double rho = sqrt(p.x * p.x + p.z * p.z);
	const double out = rho > 0 ? 1 + o->distance / rho : 1;
	return vec(p.x * out, p.y - o->height, p.z * out);
}

/* That of a sphere around a point of the axis. */
static void ovus_uv(
	const void *self, const struct hit *hit, vec3 p, const transform *absorbed, double uv[2])
{
	const struct ovus *o = self;
	(void)hit;
	(void)absorbed;
	const vec3 d = vec_normalize(vec_sub(p, vec(0, o->top / 2, 0)));
	const bool pole = d.x * d.x + d.z * d.z <= 1e-10; /* the language calls this a pole */
	const double longitude = pole ? 0 : elementary_atan2(d.z, d.x);
	uv[0] = (longitude < 0 ? longitude + 2 * M_PI : longitude) / (2 * M_PI);
	uv[1] = 0.5 + elementary_asin(fmin(fmax(d.y, -1), 1)) / M_PI;
}

const struct shape_class shape_ovus = {
	.name = "ovus",
	.size = sizeof(struct ovus),
	.fields = ovus_fields,
	.is_convex = true,
	.build = ovus_build,
	.bounds = ovus_bounds,
	.hits = ovus_hits,
	.chord = ovus_chord,
	.inside = ovus_inside,
	.normal = ovus_normal,
	.uv = ovus_uv,
};
