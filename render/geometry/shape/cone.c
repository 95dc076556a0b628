/* SPDX-License-Identifier: MIT */
/*
 * cylinder { a, b, radius [open] } and cone { a, radius, b, radius [open] }
 *
 * Both are handled in a frame of their own: the axis runs along z from 0 to 1
 * and the larger radius is 1. The frame takes in every transformation, so a ray
 * is transformed once, and all tolerances are relative to the size.
 */
#include "geometry/shape.h"

struct cone {
	vec3 a, b; /* as written */
	double radius_a, radius_b;
	bool is_open;
	/* built: */
	double base, slope; /* the radius at height z is base + slope * z; base may be negative */
	transform frame;    /* own frame to shape space */
};

enum cone_part { PART_SIDE, PART_TOP, PART_BOTTOM };

/* How far closed solids exclude, and open ones include, what is on their surface. */
#define SKIN 1e-10

static const struct field cylinder_fields[] = { FIELD(cone, b), FIELD(cone, a),
	FIELD(cone, radius_a), FIELD(cone, is_open), FIELD_END };

static const struct field cone_fields[] = { FIELD(cone, a), FIELD(cone, radius_a), FIELD(cone, b),
	FIELD(cone, radius_b), FIELD(cone, is_open), FIELD_END };

/* The frame with the given axis whose x and y have the length `radius`. */
static transform axis_frame(vec3 base, vec3 axis, double radius)
{
	const transform size = transform_scale(vec(radius, radius, vec_length(axis)));
	const transform turn = transform_turn_z(vec_normalize(axis));
	const transform place = transform_translate(base);
	const transform turned = transform_compose(&size, &turn);
	return transform_compose(&turned, &place);
}

/* Between a (radius_a, at height 0) and b (radius_b, at height 1). */
static void cone_build_between(struct cone *c, struct shape_build *build)
{
	const double size = fmax(fabs(c->radius_a), fabs(c->radius_b));
	if (!(size > 0)) {
		build->dropped = true;
		return;
	}
	c->base = c->radius_a / size;
	c->slope = (c->radius_b - c->radius_a) / size;
	c->frame = axis_frame(c->a, vec_sub(c->b, c->a), size);
}

static void cylinder_build(void *self, struct shape_build *build)
{
	struct cone *c = self;
	if (!(vec_length(vec_sub(c->b, c->a)) >= 1e-10)) {
		build->error(build->user, "the ends of a cylinder must not be the same point");
		return;
	}
	c->radius_a = c->radius_b = fabs(c->radius_a);
	cone_build_between(c, build);
}

static void cone_build(void *self, struct shape_build *build)
{
	struct cone *c = self;
	if (!(vec_length(vec_sub(c->b, c->a)) >= 1e-10)) {
		build->error(build->user, "the ends of a cone must not be the same point");
		return;
	}
	if (c->radius_b <= c->radius_a) { /* the wider end is the top, or the first */
		const struct cone old = *c;
		c->a = old.b, c->radius_a = old.radius_b;
		c->b = old.a, c->radius_b = old.radius_a;
	}
	cone_build_between(c, build);
}

static bool cone_absorb(void *self, const transform *t)
{
	struct cone *c = self;
	c->frame = transform_compose(&c->frame, t);
	return true;
}

/* The box of an ellipse about `centre` whose conjugate radii are u and v, times `radius`. */
static box ellipse_box(vec3 centre, vec3 u, vec3 v, double radius)
{
	const vec3 reach = vec_scale(vec_hypot(u, v), fabs(radius));
	return (box){ vec_sub(centre, reach), vec_add(centre, reach) };
}

static box cone_bounds(const void *self)
{
	const struct cone *c = self;
	const vec3 u = transform_direction(&c->frame, vec(1, 0, 0));
	const vec3 v = transform_direction(&c->frame, vec(0, 1, 0));
	const vec3 bottom = transform_point(&c->frame, vec(0, 0, 0));
	const vec3 top = transform_point(&c->frame, vec(0, 0, 1));
	return box_union(
		ellipse_box(bottom, u, v, c->base), ellipse_box(top, u, v, c->base + c->slope));
}

/* Its frame's box, as wide as the top all along. */
static box cone_extent(const void *self, const transform *place)
{
	const struct cone *c = self;
	const double wide = fabs(c->base + c->slope);
	return box_placed(
		transform_box(&c->frame, (box){ { -wide, -wide, 0 }, { wide, wide, 1 } }), place);
}

struct crossing {
	double t;
	enum cone_part part;
};

static unsigned cap_crossing(
	ray r, double z, double radius, enum cone_part part, struct crossing *out)
{
	const double t = (z - r.origin.z) / r.direction.z;
	const double x = r.origin.x + t * r.direction.x;
	const double y = r.origin.y + t * r.direction.y;
	if (!(x * x + y * y <= radius * radius))
		return 0;
	*out = (struct crossing){ t, part };
	return 1;
}

/* All crossings, in the order in which later ones win ties. */
static unsigned cone_crossings(const struct cone *c, const ray *world, struct crossing out[4])
{
	const ray r = transform_ray_back(&c->frame, *world);
	const vec3 d = r.direction;
	/* from the point nearest the middle the coefficients are small */
	const vec3 from = vec_sub(r.origin, vec(0, 0, 0.5));
	const double start = -vec_dot(from, d) / vec_length2(d);
	const vec3 o = vec_mad(r.origin, start, d);
	const double radius = c->base + c->slope * o.z, growth = c->slope * d.z;
	const double qa = d.x * d.x + d.y * d.y - growth * growth;
	const double qb = o.x * d.x + o.y * d.y - radius * growth;
	const double qc = o.x * o.x + o.y * o.y - radius * radius;
	const double discriminant = qb * qb - qa * qc;
	if (discriminant < 0 && qa > 0) /* outside all along, so it misses the caps too */
		return 0;
	unsigned n = 0;
	if (discriminant >= 0) {
		const double q = -(qb + copysign(sqrt(discriminant), qb));
		const double roots[2] = { q / qa, q != 0 ? qc / q : q / qa };
		for (int i = 0; i < 2; i++) {
			const double z = o.z + roots[i] * d.z;
			if (z >= 0 && z <= 1)
				out[n++] = (struct crossing){ start + roots[i], PART_SIDE };
		}
	}
	if (!c->is_open) {
		n += cap_crossing(r, 1, c->base + c->slope, PART_TOP, &out[n]);
		n += cap_crossing(r, 0, c->base, PART_BOTTOM, &out[n]);
	}
	return n;
}

static bool cone_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	struct crossing crossings[4];
	const unsigned n = cone_crossings(self, r, crossings);
	const struct crossing *best = NULL;
	for (unsigned i = 0; i < n; i++) {
		const double t = crossings[i].t;
		if (t >= tmin && (best ? t <= best->t : t < tmax))
			best = &crossings[i];
	}
	if (!best)
		return false;
	found->t = best->t;
	found->part = (uint32_t)best->part;
	return true;
}

static void cone_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct crossing crossings[4];
	const unsigned n = cone_crossings(self, r, crossings);
	for (unsigned i = 0; i < n; i++) {
		if (crossings[i].t > tmin && crossings[i].t < tmax)
			hits_push(out, crossings[i].t)->part = (uint32_t)crossings[i].part;
	}
}

/* A tube is not convex, nor is a cone on both sides of its tip. */
static bool cone_has_chord(const void *self)
{
	const struct cone *c = self;
	return !c->is_open && c->base >= 0 && c->base + c->slope >= 0;
}

static bool cone_chord(const void *self, const ray *r, struct chord *chord)
{
	struct crossing crossings[4];
	const unsigned n = cone_crossings(self, r, crossings);
	if (n == 0)
		return false;
	const struct crossing *in = crossings, *out = crossings;
	for (unsigned i = 1; i < n; i++) {
		in = crossings[i].t <= in->t ? &crossings[i] : in;
		out = crossings[i].t >= out->t ? &crossings[i] : out;
	}
	*chord = (struct chord){ { in->t, out->t }, { (uint32_t)in->part, (uint32_t)out->part } };
	return true;
}

static bool cone_inside(const void *self, vec3 world)
{
	const struct cone *c = self;
	const vec3 p = transform_point_back(&c->frame, world);
	const double radius = c->base + c->slope * p.z;
	const double skin = c->is_open ? SKIN : -SKIN;
	return p.z >= -skin && p.z <= 1 + skin && p.x * p.x + p.y * p.y <= radius * radius + skin;
}

static vec3 cone_normal(const void *self, const struct hit *hit, vec3 world)
{
	const struct cone *c = self;
	if (hit->part == PART_TOP)
		return transform_normal(&c->frame, vec(0, 0, 1));
	if (hit->part == PART_BOTTOM)
		return transform_normal(&c->frame, vec(0, 0, -1));
	const vec3 p = transform_point_back(&c->frame, world);
	vec3 n = vec(p.x, p.y, -c->slope * (c->base + c->slope * p.z));
	if (vec_length2(n) == 0) /* the very tip */
		n = vec(0, 0, c->slope > 0 ? -1 : 1);
	return transform_normal(&c->frame, n);
}

const struct shape_class shape_cylinder = {
	.name = "cylinder",
	.is_convex = true,
	.size = sizeof(struct cone),
	.fields = cylinder_fields,
	.build = cylinder_build,
	.absorb = cone_absorb,
	.bounds = cone_bounds,
	.extent = cone_extent,
	.nearest = cone_nearest,
	.hits = cone_hits,
	.chord = cone_chord,
	.has_chord = cone_has_chord,
	.inside = cone_inside,
	.normal = cone_normal,
};

const struct shape_class shape_cone = {
	.name = "cone",
	.size = sizeof(struct cone),
	.fields = cone_fields,
	.build = cone_build,
	.absorb = cone_absorb,
	.bounds = cone_bounds,
	.extent = cone_extent,
	.nearest = cone_nearest,
	.hits = cone_hits,
	.chord = cone_chord,
	.has_chord = cone_has_chord,
	.inside = cone_inside,
	.normal = cone_normal,
};
