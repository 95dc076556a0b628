/* SPDX-License-Identifier: MIT */
/*
 * The warps of the language. Transformations are warps too; they lead from the
 * outer space into the pattern's.
 */
#include "texture/warp.h"

#include "base/elementary.h"
#include "noise/noise.h"

#include <math.h>

/* Periods below this do not repeat. */
#define PERIOD_MIN 1e-10

vec3 warp_transform(const void *self, vec3 p)
{
	return transform_point_back(self, p);
}

vec3 warp_turbulence(const void *self, vec3 p)
{
	const struct turbulence *t = self;
	const vec3 v = noise_turbulence(p, t->octaves, (double)t->omega, (double)t->lambda);
	return vec_add(p, vec_mul(t->amount, v));
}

/* Cells along one axis. The width, and the way back to the first cell, are single precision. */
vec3 warp_repeat(const void *self, vec3 p)
{
	const struct warp_repeat *w = self;
	double q[3] = { p.x, p.y, p.z };
	const double flip[3] = { w->flip.x, w->flip.y, w->flip.z };
	const float cell = (float)floor(q[w->axis] / (double)w->width);
	q[w->axis] -= (double)(cell * w->width);
	if (fmod((double)cell, 2) != 0) {
		for (int i = 0; i < 3; i++)
			if (flip[i] != 0)
				q[i] = -q[i];
		if (flip[w->axis] != 0)
			q[w->axis] += (double)w->width;
	}
	return vec_mad(vec(q[0], q[1], q[2]), (double)cell, w->offset);
}

/* Cells farther away are like the one in the middle. */
static int64_t cell_index(double whole)
{
	return fabs(whole) < 1e15 ? (int64_t)whole : 0;
}

/* The centre of the cell p is in, moved at random when the holes are turbulent. */
static vec3 hole_centre(const struct warp_black_hole *w, vec3 p)
{
	if (!w->repeats)
		return w->centre;
	const vec3 n = { w->repeat.x >= PERIOD_MIN ? floor(p.x / w->repeat.x) : 0,
		w->repeat.y >= PERIOD_MIN ? floor(p.y / w->repeat.y) : 0,
		w->repeat.z >= PERIOD_MIN ? floor(p.z / w->repeat.z) : 0 };
	vec3 centre = vec_add(w->centre, vec_mul(n, w->repeat));
	if (w->turbulent) {
		const double *u = cell_uniforms +
				  cell_hash(cell_index(n.x), cell_index(n.y), cell_index(n.z));
		centre = vec_add(centre, vec_mul(vec(u[0], u[1], u[2]), w->turbulence));
	}
	return centre;
}

vec3 warp_black_hole(const void *self, vec3 p)
{
	const struct warp_black_hole *w = self;
	if (w->inert)
		return p;
	const vec3 d = vec_sub(p, hole_centre(w, p));
	const double length = vec_length(d);
	if (length >= w->radius)
		return p;
	const double pull =
		w->strength * elementary_pow((w->radius - length) / w->radius, w->falloff);
	const double m = pull < 1 ? pull : 1;
	return vec_mad(p, w->inverse ? -m : m, d);
}

/* Share of a turn about the y axis, from x towards z. */
static double turn(double x, double z)
{
	if (z == 0)
		return x > 0 ? 0 : 0.5;
	const double c = x / sqrt(x * x + z * z);
	const double angle = elementary_acos(c < -1 ? -1 : c > 1 ? 1 : c);
	return (z < 0 ? 2 * M_PI - angle : angle) / (2 * M_PI);
}

static vec3 orient(const struct warp_wrap *w, vec3 p)
{
	const vec3 o = w->orientation;
	if (o.x == 0 && o.y == 0 && o.z == 1)
		return p;
	return vec(o.x * p.z + o.y * p.x + o.z * p.x, o.x * p.y - o.y * p.z + o.z * p.y,
		-o.x * p.x + o.y * p.y + o.z * p.z);
}

/* What circumferences are multiplied by at distance `length`. */
static double stretch(const struct warp_wrap *w, double length)
{
	return w->exponent == 1	  ? length
	       : w->exponent == 0 ? 1
				  : elementary_pow(length, w->exponent);
}

vec3 warp_cylindrical(const void *self, vec3 p)
{
	const struct warp_wrap *w = self;
	const double length = sqrt(p.x * p.x + p.z * p.z);
	if (length == 0)
		return p;
	return orient(w, vec(turn(p.x, p.z) * stretch(w, length), p.y, length));
}

vec3 warp_spherical(const void *self, vec3 p)
{
	const struct warp_wrap *w = self;
	const double length = vec_length(p);
	if (length == 0)
		return p;
	const vec3 unit = vec_scale(p, 1 / length);
	const double s = stretch(w, length), y = unit.y < -1 ? -1 : unit.y > 1 ? 1 : unit.y;
	const double u = unit.x == 0 && unit.z == 0 ? 0 : turn(unit.x, unit.z);
	return orient(w, vec(u * s, (0.5 + 2 * elementary_asin(y) / (2 * M_PI)) * s, length));
}

vec3 warp_toroidal(const void *self, vec3 p)
{
	const struct warp_wrap *w = self;
	const double length = sqrt(p.x * p.x + p.z * p.z);
	if (length == 0)
		return p;
	const double x = length - w->major_radius, m = sqrt(x * x + p.y * p.y);
	double v = elementary_acos(-x / m) / (2 * M_PI);
	if (p.y > 0)
		v = 1 - v;
	const double s = stretch(w, m);
	return orient(w, vec(turn(p.x, p.z) * s, v * s, m));
}

vec3 warp_planar(const void *self, vec3 p)
{
	const struct warp_wrap *w = self;
	return orient(w, vec(p.x, p.y, w->distance));
}

/* -1 to 1 becomes 0 to 1. */
static double unit_range(double v)
{
	return (v + 1) / 2;
}

/* The six faces laid out as a cross. */
vec3 warp_cubic(const void *self, vec3 p)
{
	(void)self;
	const double x = p.x, y = p.y, z = p.z, ax = fabs(x), ay = fabs(y), az = fabs(z);
	const double third = 1.0 / 3;
	if (x >= 0 && x >= ay && x >= az)
		return vec(0.75 - 0.25 * unit_range(z / x), third + third * unit_range(y / x), x);
	if (y >= 0 && y >= ax && y >= az)
		return vec(0.25 + 0.25 * unit_range(x / y), 1 - third * unit_range(z / y), y);
	if (z >= 0 && z >= ax && z >= ay)
		return vec(0.25 + 0.25 * unit_range(x / z), third + third * unit_range(y / z), z);
	if (x < 0 && ax >= ay && ax >= az)
		return vec(0.25 * unit_range(z / ax), third + third * unit_range(y / ax), ax);
	if (y < 0 && ay >= ax && ay >= az)
		return vec(0.25 + 0.25 * unit_range(x / ay), third * unit_range(z / ay), ay);
	return vec(1 - 0.25 * unit_range(x / az), third + third * unit_range(y / az), az);
}
