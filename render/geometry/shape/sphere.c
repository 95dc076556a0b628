/* SPDX-License-Identifier: MIT */
/*
 * sphere { centre, radius }
 *
 * The point of the ray nearest the centre comes first; the chord lies evenly
 * around it. So nothing is lost to cancellation however far the ray starts
 * (after Haines et al., Ray Tracing Gems, chapter 7).
 */
#include "geometry/shape.h"

#include "base/elementary.h"

struct sphere {
	vec3 centre;
	double radius; /* < 0: the raw normal points inwards */
};

static const struct field sphere_fields[] = { FIELD(sphere, centre), FIELD(sphere, radius),
	FIELD_END };

/* Uniform scaling, rotation, mirroring and moving leave a sphere a sphere. */
static bool sphere_absorb(void *self, const transform *t)
{
	struct sphere *s = self;
	const vec3 x = transform_direction(t, vec(1, 0, 0));
	const vec3 y = transform_direction(t, vec(0, 1, 0));
	const vec3 z = transform_direction(t, vec(0, 0, 1));
	const double size = vec_length2(x);
	const double tolerance = 1e-14 * size; /* the rounding of composed rotations */
	if (!(fabs(vec_length2(y) - size) <= tolerance &&
		    fabs(vec_length2(z) - size) <= tolerance && fabs(vec_dot(x, y)) <= tolerance &&
		    fabs(vec_dot(y, z)) <= tolerance && fabs(vec_dot(z, x)) <= tolerance))
		return false;
	s->centre = transform_point(t, s->centre);
	s->radius *= sqrt(size);
	return true;
}

static box sphere_bounds(const void *self)
{
	const struct sphere *s = self;
	const double r = fabs(s->radius);
	const vec3 reach = vec(r, r, r);
	return (box){ vec_sub(s->centre, reach), vec_add(s->centre, reach) };
}

static bool sphere_enclosing_sphere(const void *self, vec3 *centre, double *radius)
{
	const struct sphere *s = self;
	*centre = s->centre;
	*radius = fabs(s->radius);
	return true;
}

/* The two crossings; false when the ray misses or only touches. */
static inline bool sphere_crossings(const struct sphere *s, const ray *r, double t[2])
{
	const vec3 from = vec_sub(r->origin, s->centre);
	const double inverse = 1 / vec_length2(r->direction);
	const double middle = -vec_dot(from, r->direction) * inverse;
	const vec3 closest = vec_mad(from, middle, r->direction);
	const double square = s->radius * s->radius - vec_length2(closest);
	if (!(square > 0))
		return false;
	const double half = sqrt(square * inverse);
	t[0] = middle - half;
	t[1] = middle + half;
	return true;
}

static bool sphere_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	double t[2];
	if (!sphere_crossings(self, r, t) || t[1] < tmin)
		return false;
	const double first = t[0] >= tmin ? t[0] : t[1];
	if (!(first < tmax))
		return false;
	found->t = first;
	return true;
}

static void sphere_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	double t[2];
	if (!sphere_crossings(self, r, t))
		return;
	for (int i = 0; i < 2; i++) {
		if (t[i] > tmin && t[i] < tmax)
			hits_push(out, t[i]);
	}
}

static bool sphere_chord(const void *self, const ray *r, struct chord *chord)
{
	chord->part[0] = chord->part[1] = 0;
	return sphere_crossings(self, r, chord->t);
}

static bool sphere_inside(const void *self, vec3 p)
{
	const struct sphere *s = self;
	return vec_length2(vec_sub(p, s->centre)) < s->radius * s->radius;
}

static vec3 sphere_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct sphere *s = self;
	(void)hit;
	const vec3 out = vec_sub(p, s->centre);
	return s->radius < 0 ? vec_negate(out) : out;
}

/* Longitude and latitude about the centre, in the directions the sphere was written in. */
static void sphere_uv(
	const void *self, const struct hit *hit, vec3 p, const transform *absorbed, double uv[2])
{
	const struct sphere *s = self;
	(void)hit;
	vec3 d = vec_sub(p, s->centre);
	if (absorbed)
		d = transform_direction_back(absorbed, d);
	d = vec_normalize(d);
	const bool pole = d.x * d.x + d.z * d.z <= 1e-10; /* the language calls this a pole */
	const double longitude = pole ? 0 : elementary_atan2(d.z, d.x);
	uv[0] = (longitude < 0 ? longitude + 2 * M_PI : longitude) / (2 * M_PI);
	uv[1] = 0.5 + elementary_asin(fmin(fmax(d.y, -1), 1)) / M_PI;
}

const struct shape_class shape_sphere = {
	.name = "sphere",
	.is_convex = true,
	.size = sizeof(struct sphere),
	.fields = sphere_fields,
	.absorb = sphere_absorb,
	.bounds = sphere_bounds,
	.enclosing_sphere = sphere_enclosing_sphere,
	.nearest = sphere_nearest,
	.hits = sphere_hits,
	.chord = sphere_chord,
	.inside = sphere_inside,
	.normal = sphere_normal,
	.uv = sphere_uv,
};
