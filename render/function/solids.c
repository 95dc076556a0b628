/* SPDX-License-Identifier: MIT */
/*
 * Built-in functions: blobs, spikes, boxes, spirals, helices and other solids,
 * and the polar coordinates.
 */
#include "function/internal.h"

#include "base/elementary.h"

#include <math.h>

#define UNUSED(name) (void)(name)

/* Stands for 0 where an angle of the point (0, 0) would be needed. */
#define OFF_AXIS 1e-6

static double square(double v)
{
	return v * v;
}

/* Distance in a cross section between a square (exponent 0), a circle (1) and a star. */
static double cross_section(double a, double b, double exponent)
{
	if (exponent == 1)
		return sqrt(a * a + b * b);
	if (exponent == 0)
		return fmax(fabs(a), fabs(b));
	return elementary_pow(
		elementary_pow(fabs(a), 2 / exponent) + elementary_pow(fabs(b), 2 / exponent),
		exponent * 0.5);
}

double f_blob(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double h = p[0] / 2, rest = y * y + z * z;
	const double a = fmin(1, (square(x + h) + rest) * p[2] * p[2]);
	const double b = fmin(1, (square(x - h) + rest) * p[4] * p[4]);
	return -(p[1] * square(1 - a) + p[3] * square(1 - b));
}

double f_blob2(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double rest = y * y + z * z;
	return p[3] - p[2] * (elementary_exp(-p[1] * (x * x + rest)) +
				     elementary_exp(-p[1] * (square(x - p[0]) + rest)));
}

double f_comma(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	if (x == 0 && z == 0)
		x = 0.0001;
	const double angle = elementary_atan2(z, x), r = sqrt(square(x + p[0] / 4) + z * z);
	const double tail =
		p[0] / 2 * elementary_cos(angle / 2) - sqrt(square(r - 0.75 * p[0]) + y * y);
	const double head = p[0] / 2 - sqrt(square(x - p[0] / 2) + z * z + y * y);
	return -fmax(fmin(z, tail), head);
}

/* The three bell curves that several functions combine. */
static void bells(double x, double y, double z, double flat, double steep, double out[3])
{
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	out[0] = elementary_exp(-steep * (flat * x2 + flat * y2 + z2));
	out[1] = elementary_exp(-steep * (flat * x2 + y2 + flat * z2));
	out[2] = elementary_exp(-steep * (x2 + flat * y2 + flat * z2));
}

double f_cross_ellipsoids(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	double e[3];
	bells(x, y, z, p[0], p[1], e);
	return p[3] - p[2] * fmax(fmax(e[0], e[1]), e[2]);
}

double f_isect_ellipsoids(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	double e[3];
	bells(x, y, z, p[0], p[1], e);
	return p[3] - p[2] * fmin(fmin(e[0], e[1]), e[2]);
}

double f_flange_cover(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	double e[3];
	bells(x, y, z, p[0], p[1], e);
	return p[3] - p[2] * (e[0] + e[1] + e[2]);
}

double f_spikes(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	double e[3];
	bells(x, y, z, p[0], p[1], e);
	return -p[2] *
	       (p[4] * elementary_exp(-p[3] * (x * x + y * y + z * z)) - e[0] - e[1] - e[2]);
}

double f_spikes_2d(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return y - p[0] * elementary_cos(p[1] * x) * elementary_cos(p[2] * z) *
			   elementary_exp(-p[3] * (x * x + z * z));
}

double f_ellipsoid(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return sqrt(square(x * p[0]) + square(y * p[1]) + square(z * p[2]));
}

double f_sphere(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return sqrt(x * x + y * y + z * z) - p[0];
}

double f_torus(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return sqrt(square(sqrt(x * x + z * z) - p[0]) + y * y) - p[1];
}

double f_r(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(p);
	UNUSED(w);
	return sqrt(x * x + y * y + z * z);
}

double f_th(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(y);
	UNUSED(p);
	UNUSED(w);
	return elementary_atan2(x, z);
}

double f_ph(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(p);
	UNUSED(w);
	return elementary_atan2(sqrt(x * x + z * z), y);
}

double f_superellipsoid(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double round = elementary_pow(fabs(x), 2 / p[0]) + elementary_pow(fabs(y), 2 / p[0]);
	return 1 - elementary_pow(
			   elementary_pow(round, p[0] / p[1]) + elementary_pow(fabs(z), 2 / p[1]),
			   p[1] * 0.5);
}

/* How far a coordinate is beyond the flat part of a side. */
static double beyond(double v, double flat)
{
	return fmax(v >= flat ? v - flat : 0, v <= -flat ? -flat - v : 0);
}

double f_rounded_box(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double a = beyond(x, p[1] - p[0]), b = beyond(y, p[2] - p[0]);
	const double c = beyond(z, p[3] - p[0]);
	return sqrt(a * a + b * b + c * c) - p[0] - 1e-6;
}

double f_helical_torus(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double r = sqrt(x * x + z * z);
	if (x == 0 && z == 0)
		x = OFF_AXIS;
	const double around = elementary_atan2(x, z), tube = elementary_atan2(r - p[0], y);
	const double q = sqrt(square(r - p[0]) + y * y);
	double angle = fmod(around * p[1] + tube * p[2], 2 * M_PI);
	if (angle < 0)
		angle += 2 * M_PI;
	double t = elementary_cos(elementary_atan2((angle - M_PI) * p[8], q - p[5]) * p[7] +
				  around * p[9]) *
			   p[3] +
		   p[4];
	const double u = p[4] + p[5] - p[0] - r;
	angle -= M_PI;
	t -= fmin(sqrt(square(q - p[5]) + angle * angle * p[6]), q + p[5]);
	return -fmax(u, t);
}

double f_helix1(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double r = sqrt(x * x + z * z);
	if (x == 0 && z == 0)
		x = OFF_AXIS;
	double angle = fmod(elementary_atan2(z, x) * p[0] + y * p[1] * p[0], 2 * M_PI);
	if (angle < 0)
		angle += 2 * M_PI;
	double c = (angle - M_PI) / p[4] / (p[1] * p[0]), a = r - p[3];
	if (p[5] != 1 && p[6] != 0) {
		const double turn = p[6] * (M_PI / 180), old = a;
		const double cosine = elementary_cos(turn), sine = elementary_sin(turn);
		a = old * cosine - c * sine;
		c = old * sine + c * cosine;
	}
	return fmin(p[3] + r, cross_section(a, c, p[5])) - p[2];
}

double f_helix2(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double c = elementary_cos(y * p[1]), s = elementary_sin(y * p[1]);
	const double a = x - p[3] * c, b = z - p[3] * s;
	return cross_section(a * c + b * s, -a * s + b * c, p[5]) - p[2];
}

/* Of the double that is next to a third of pi. */
#define COS_60 0.50000000000000011
#define SIN_60 0.8660254037844386

/* The position within a hexagonal cell, and its angle. */
static double hexagon(double *a, double *b, double x, double y)
{
	const double half = sqrt(3) / 2;
	*a = fabs(fmod(fabs(x), sqrt(3)) - half);
	*b = fabs(fmod(fabs(y), 3) - 1.5);
	const double a2 = half - *a, b2 = 1.5 - *b;
	if (*a * *a + *b * *b > a2 * a2 + b2 * b2) {
		*a = a2;
		*b = b2;
	}
	return elementary_atan2(*b, *a);
}

double f_hex_x(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(z);
	UNUSED(p);
	UNUSED(w);
	double a, b;
	const double angle = hexagon(&a, &b, x, y);
	return angle < M_PI / 6 ? a : a * COS_60 + b * SIN_60;
}

double f_hex_y(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(z);
	UNUSED(p);
	UNUSED(w);
	double a, b;
	const double angle = hexagon(&a, &b, x, y);
	return angle < M_PI / 6 ? b : fabs(-a * SIN_60 + b * COS_60);
}

/* Distance from the nearest thread of one direction of a mesh. */
static double thread(double v, double period)
{
	double m = fmod(v, 2 * period);
	if (m < 0)
		m += 2 * period;
	return fabs(m - period);
}

static double woven(double height, double scale, double across, double width)
{
	return -sqrt(square(height * scale) + square(across * width));
}

double f_mesh1(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double along_z = elementary_cos(z * M_PI / p[1]) * p[3],
		     along_x = elementary_cos(x * M_PI / p[0]) * p[3];
	const double a = woven(y - along_z, p[4], thread(x, p[0]), p[2]);
	const double b = woven(y + along_z, p[4], thread(x - p[0], p[0]), p[2]);
	const double c = woven(y + along_x, p[4], thread(z, p[1]), p[2]);
	const double d = woven(y - along_x, p[4], thread(z - p[1], p[1]), p[2]);
	return -fmax(fmax(a, b), fmax(c, d));
}

double f_poly4(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double t = p[0] + p[1] * y + p[2] * y * y + p[3] * y * y * y + p[4] * y * y * y * y;
	return sqrt(x * x + z * z) - fmax(t, -5);
}

double f_polytubes(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double r = p[1] + p[2] * y + p[3] * y * y + p[4] * y * y * y + p[5] * y * y * y * y;
	const double tubes = repeats_of(p[0]);
	double nearest = -10000;
	for (int i = 0; i < whole(tubes); i++) {
		const double angle = 2 * M_PI * i / tubes;
		const double d = sqrt(square(x - r * elementary_sin(angle)) +
				      square(z - r * elementary_cos(angle)));
		nearest = fmax(nearest, -d);
	}
	return -nearest;
}

double f_quantum(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(p);
	UNUSED(w);
	if (x == 0 && z == 0)
		x = OFF_AXIS;
	const double r = sqrt(x * x + z * z), c = elementary_cos(elementary_atan2(r, y));
	const double q = 2 * sqrt(r * r + y * y);
	const double t = q * q * elementary_exp(-0.33333333 * q) * (3 * c * c - 1);
	return -0.1 * (t * t - 12);
}

double f_spiral(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double radius = sqrt(x * x + y * y + z * z);
	double r = sqrt(x * x + z * z);
	if (x == 0 && z == 0)
		x = OFF_AXIS;
	r += p[0] * elementary_atan2(z, x) / (2 * M_PI);
	const double q = cross_section(fmod(r, p[0]) - p[0] / 2, y, p[5]);
	return -fmin(p[2] - radius, p[1] - fmin(q, radius));
}
