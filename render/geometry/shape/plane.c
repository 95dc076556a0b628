/* SPDX-License-Identifier: MIT */
/*
 * plane { normal, distance }
 *
 * All points p with normal . p = distance, the normal made unit; the inside lies
 * behind the normal.
 */
#include "geometry/shape.h"

struct plane {
	vec3 normal;
	double distance;
};

/* The language ends planes this far from the start of a ray: the horizon shows it. */
#define FARTHEST 1e7
/* Both sides of a plane contain a skin this thick. It makes a plane that is coplanar with a face
 * treat the whole face alike, in spite of rounding. */
#define SKIN 1e-10

static const struct field plane_fields[] = { FIELD(plane, normal), FIELD(plane, distance),
	FIELD_END };

static void plane_build(void *self, struct shape_build *build)
{
	struct plane *pl = self;
	if (!(vec_length(pl->normal) >= 1e-10)) {
		build->error(build->user, "the normal of a plane must not be zero");
		return;
	}
	pl->normal = vec_normalize(pl->normal);
}

static bool plane_absorb(void *self, const transform *t)
{
	struct plane *pl = self;
	const vec3 p = transform_point(t, vec_scale(pl->normal, pl->distance));
	pl->normal = vec_normalize(transform_normal(t, pl->normal));
	pl->distance = vec_dot(pl->normal, p);
	return true;
}

static void plane_invert(void *self)
{
	struct plane *pl = self;
	pl->normal = vec_negate(pl->normal);
	pl->distance = -pl->distance;
}

/* A half-space that an axis-aligned plane leaves of one coordinate. */
static void bound_axis(double normal, double distance, double *lo, double *hi)
{
	if (normal > 0)
		*hi = fmax(fmin(distance / normal, BOX_UNBOUNDED), -BOX_UNBOUNDED);
	else
		*lo = fmax(fmin(distance / normal, BOX_UNBOUNDED), -BOX_UNBOUNDED);
}

/* Holds the inside as well, so that a plane bounds what it cuts. */
static box plane_bounds(const void *self)
{
	const struct plane *pl = self;
	const bool x = fabs(pl->normal.x) > SKIN;
	const bool y = fabs(pl->normal.y) > SKIN;
	const bool z = fabs(pl->normal.z) > SKIN;
	box b = box_everything();
	if (x && !y && !z)
		bound_axis(pl->normal.x, pl->distance, &b.lo.x, &b.hi.x);
	if (!x && y && !z)
		bound_axis(pl->normal.y, pl->distance, &b.lo.y, &b.hi.y);
	if (!x && !y && z)
		bound_axis(pl->normal.z, pl->distance, &b.lo.z, &b.hi.z);
	return b;
}

/* Infinite or no number for a ray along the plane, which no comparison accepts. */
static inline double plane_distance(const struct plane *pl, const ray *r)
{
	return (pl->distance - vec_dot(pl->normal, r->origin)) / vec_dot(pl->normal, r->direction);
}

static bool plane_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const double t = plane_distance(self, r);
	if (!(t >= tmin && t < tmax && t <= FARTHEST))
		return false;
	found->t = t;
	return true;
}

static void plane_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	const double t = plane_distance(self, r);
	if (t > tmin && t < tmax && t <= FARTHEST)
		hits_push(out, t);
}

static bool plane_chord(const void *self, const ray *r, struct chord *chord)
{
	const struct plane *pl = self;
	const double height = pl->distance - vec_dot(pl->normal, r->origin);
	const double speed = vec_dot(pl->normal, r->direction);
	const double t = height / speed;
	*chord =
		(struct chord){ { speed < 0 ? t : -INFINITY, speed > 0 ? t : INFINITY }, { 0, 0 } };
	return speed != 0 || height > -SKIN;
}

static size_t plane_half_spaces(const void *self, struct half_space *out)
{
	const struct plane *pl = self;
	*out = (struct half_space){ pl->normal, pl->distance + SKIN };
	return 1;
}

static bool plane_inside(const void *self, vec3 p)
{
	const struct plane *pl = self;
	return vec_dot(pl->normal, p) - pl->distance < SKIN;
}

static vec3 plane_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct plane *pl = self;
	(void)hit;
	(void)p;
	return pl->normal;
}

const struct shape_class shape_plane = {
	.name = "plane",
	.size = sizeof(struct plane),
	.fields = plane_fields,
	.build = plane_build,
	.absorb = plane_absorb,
	.invert = plane_invert,
	.bounds = plane_bounds,
	.nearest = plane_nearest,
	.hits = plane_hits,
	.chord = plane_chord,
	.half_spaces = plane_half_spaces,
	.inside = plane_inside,
	.normal = plane_normal,
};
