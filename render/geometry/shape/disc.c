/* SPDX-License-Identifier: MIT */
/*
 * disc { centre, normal, radius [, hole radius] }
 *
 * Handled in its own frame, where it lies in the plane z = 0. Its inside is the
 * whole half-space behind the normal.
 */
#include "geometry/shape.h"

struct disc {
	vec3 centre, normal;
	double radius, hole;
	transform frame; /* orthonormal until transformations come in */
};

static const struct field disc_fields[] = { FIELD(disc, centre), FIELD(disc, normal),
	FIELD(disc, radius), FIELD(disc, hole), FIELD_END };

static void disc_build(void *self, struct shape_build *build)
{
	struct disc *d = self;
	const vec3 w = vec_normalize(d->normal);
	if (!(vec_length2(w) > 0)) {
		build->dropped = true;
		return;
	}
	const transform turn = transform_turn_z(w), place = transform_translate(d->centre);
	d->frame = transform_compose(&turn, &place);
}

static bool disc_absorb(void *self, const transform *t)
{
	struct disc *d = self;
	d->frame = transform_compose(&d->frame, t);
	return true;
}

static box disc_bounds(const void *self)
{
	const struct disc *d = self;
	const double r = fabs(d->radius);
	const vec3 centre = transform_point(&d->frame, vec(0, 0, 0));
	const vec3 u = transform_direction(&d->frame, vec(r, 0, 0));
	const vec3 v = transform_direction(&d->frame, vec(0, r, 0));
	const vec3 reach = vec_hypot(u, v);
	return (box){ vec_sub(centre, reach), vec_add(centre, reach) };
}

static box disc_extent(const void *self, const transform *place)
{
	const struct disc *d = self;
	const double r = fabs(d->radius), thin = 1e-3;
	return box_placed(
		transform_box(&d->frame, (box){ { -r, -r, -thin }, { r, r, thin } }), place);
}

/* No number when the ray misses. */
static double disc_distance(const struct disc *d, const ray *world)
{
	const ray r = transform_ray_back(&d->frame, *world);
	const double t = -r.origin.z / r.direction.z;
	const double x = r.origin.x + t * r.direction.x, y = r.origin.y + t * r.direction.y;
	const double square = x * x + y * y;
	return square <= d->radius * d->radius && square >= d->hole * d->hole ? t : NAN;
}

static bool disc_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const double t = disc_distance(self, r);
	if (!(t >= tmin && t < tmax))
		return false;
	found->t = t;
	return true;
}

static void disc_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	const double t = disc_distance(self, r);
	if (t > tmin && t < tmax)
		hits_push(out, t);
}

static bool disc_inside(const void *self, vec3 p)
{
	const struct disc *d = self;
	return transform_point_back(&d->frame, p).z < 0;
}

static size_t disc_half_spaces(const void *self, struct half_space *out)
{
	const struct disc *d = self;
	const vec3 centre = transform_point(&d->frame, vec(0, 0, 0));
	const vec3 n = vec_normalize(transform_normal(&d->frame, vec(0, 0, 1)));
	out[0] = (struct half_space){ n, vec_dot(n, centre) };
	return 1;
}

static vec3 disc_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct disc *d = self;
	(void)hit;
	(void)p;
	return transform_normal(&d->frame, vec(0, 0, 1));
}

const struct shape_class shape_disc = {
	.name = "disc",
	.size = sizeof(struct disc),
	.fields = disc_fields,
	.build = disc_build,
	.reaches_out = true,
	.absorb = disc_absorb,
	.bounds = disc_bounds,
	.extent = disc_extent,
	.nearest = disc_nearest,
	.hits = disc_hits,
	.half_spaces = disc_half_spaces,
	.inside = disc_inside,
	.normal = disc_normal,
};
