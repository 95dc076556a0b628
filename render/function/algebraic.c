/* SPDX-License-Identifier: MIT */
/*
 * Built-in functions: algebraic surfaces. Most clamp their value, scaled by p[0],
 * to -10 … 10, so that the gradient of an isosurface made of them stays bounded;
 * the _2d ones sweep a plane curve around the y axis when p asks for it.
 */
#include "function/internal.h"

#include "base/elementary.h"

#include <math.h>

#define UNUSED(name) (void)(name)

/* The value of most functions here: v scaled by p[0] and limited. */
static double limited(double v, const double *p)
{
	return fmin(10, fmax(p[0] * v, -10));
}

static double limited_by(double v, double scale, double limit)
{
	return fmin(limit, fmax(scale * v, -limit));
}

/* The plane of a swept curve: for sweep > 0, (x, y) becomes the distance from the circle of radius
 * `sweep` and the height, rotated by `degrees`. */
static void sweep(double *x, double *y, double z, double on, double radius, double degrees)
{
	if (on <= 0)
		return;
	const double r = sqrt(*x * *x + z * z) - radius, a = degrees * (M_PI / 180);
	if (degrees == 0) {
		*x = r;
		return;
	}
	const double c = elementary_cos(a), s = elementary_sin(a);
	*x = r * c - *y * s;
	*y = r * s + *y * c;
}

double f_algbr_cyl1(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[2], p[3], p[4]);
	const double x2 = x * x;
	return -limited_by(-(x2 * fabs(x) - x2 + y * y), p[0], p[1]);
}

double f_algbr_cyl2(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[2], p[3], p[4]);
	const double x2 = x * x, y2 = y * y;
	return limited_by(-(2 * x2 * x2 - 3 * x2 * y + y2 - 2 * y2 * y + y2 * y2), p[0], p[1]);
}

double f_algbr_cyl3(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[2], p[3], p[4]);
	const double x2 = x * x, y2 = y * y;
	return limited_by(-(x2 * x2 + x2 * y2 - 2 * x2 * y - x * y2 + y2), p[0], p[1]);
}

double f_algbr_cyl4(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[2], p[3], p[4]);
	const double x2 = x * x, y2 = y * y;
	return limited_by(-(x2 * x2 + y2 * y2 + 2 * x2 * y2 + 3 * x2 * y - y2 * y), p[0], p[1]);
}

double f_bicorn(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double q = p[1] * p[1], s = x * x + z * z + 2 * p[1] * y - q;
	return limited(y * y * (q - x * x - z * z) - s * s, p);
}

double f_bifolia(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double q = x * x + y * y + z * z;
	return limited(-(q * q - p[1] * (x * x + z * z) * y), p);
}

double f_boy_surface(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double u = 1 - z, x2 = x * x, y2 = y * y, z2 = z * z, q = x2 + y2;
	const double cubic = 64 * u * u * u * z2 * z;
	const double square = 48 * u * u * z2 * (3 * x2 + 3 * y2 + 2 * z2);
	const double linear =
		12 * u * z *
		(27 * q * q - 24 * z2 * q + 36 * M_SQRT2 * y * z * (y2 - 3 * x2) + 4 * z2 * z2);
	const double rest =
		(9 * x2 + 9 * y2 - 2 * z2) *
		(-81 * q * q - 72 * z2 * q + 108 * M_SQRT2 * x * z * (x2 - 3 * y2) + 4 * z2 * z2);
	return limited(p[1] * (cubic - square + linear + rest), p);
}

double f_crossed_trough(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(x * x * z * z - y, p);
}

double f_cubic_saddle(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(x * x * x - y * y * y - z), p);
}

double f_cushion(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(z2 * x2 - z2 * z2 - 2 * z * x2 + 2 * z2 * z + x2 - z2 - (x2 - z) * (x2 - z) -
			       y2 * y2 - 2 * x2 * y2 - y2 * z2 + 2 * y2 * z + y2,
		p);
}

double f_odd(double x, double y, double z, const double *p, const struct function_world *w)
{
	return f_cushion(x, y, z, p, w);
}

double f_devils_curve(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(-(x2 * x2 + 2 * x2 * z2 - 0.36 * x2 - y2 * y2 + 0.25 * y2 + z2 * z2), p);
}

double f_devils_curve_2d(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[3], p[4], p[5]);
	const double x2 = x * x, y2 = y * y;
	return limited(-(x2 * (x2 - p[1] * p[1]) - y2 * (y2 - p[2] * p[2])), p);
}

double f_dupin_cyclid(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double rho = p[5] * p[5], f = p[2] * p[2], h = p[4] * p[4];
	const double a = f - h - (p[3] + p[1]) * (p[3] + p[1]);
	const double b = f - h - (p[3] - p[1]) * (p[3] - p[1]);
	const double c = p[3] * p[3], d = p[1] * p[1];
	const double x2 = x * x, y2 = y * y, z2 = z * z, r2 = x2 + y2 + z2;
	const double shift = p[3] * x + p[4] * y - rho;
	return limited(-(a * b * (x2 * x2 + y2 * y2 + z2 * z2) +
			       2 * a * b * (x2 * y2 + x2 * z2 + y2 * z2) +
			       2 * rho *
				       ((-h - c + f + d) * (2 * x * p[3] + 2 * y * p[4] - rho) -
					       4 * p[4] * f * y) *
				       r2 +
			       4 * rho * rho * (p[3] * x + p[4] * y) * shift +
			       4 * rho * rho * d * y2 + rho * rho * rho * rho),
		p);
}

double f_enneper(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double z2 = z * z;
	if (fabs(z) < 0.2)
		z = 0.2;
	const double a = (y * y - x * x) / (2 * z) + 2 * z2 / 9, b = (y * y - x * x) / (4 * z);
	return limited(-(a * a * a - 6 * b * b), p);
}

double f_folium_surface(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited((y * y + z * z) * (1 + (p[2] - 4 * p[1]) * x) + x * x * (1 + p[2]), p);
}

double f_folium_surface_2d(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[3], p[4], p[5]);
	return limited(-(y * y * (1 + (p[2] - 4 * p[1]) * x) + x * x * (1 + p[2])), p);
}

double f_glob(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x4 = x * x * x * x;
	return limited(0.5 * x4 * x + 0.5 * x4 - (y * y + z * z), p);
}

double f_heart(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z, q = 2 * x2 + y2 + z2 - 1;
	return limited(-(q * q * q - 0.1 * x2 * z2 * z - y2 * z2 * z), p);
}

double f_hunt_surface(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	const double a = x2 + y2 + z2 - 13, b = 3 * x2 + y2 - 4 * z2 - 12;
	return limited(-(4 * a * a * a + 27 * b * b), p);
}

double f_hyperbolic_torus(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double a = p[1] * p[1], b = p[2] * p[2], x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(
		-(x2 * x2 + 2 * x2 * y2 - 2 * x2 * z2 - 2 * (a + b) * x2 + y2 * y2 - 2 * y2 * z2 +
			2 * (a - b) * y2 + z2 * z2 + 2 * (a + b) * z2 + (a - b) * (a - b)),
		p);
}

double f_kampyle_of_eudoxus(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, c = p[2] * p[2];
	return limited(-(y * y + z * z - c * x2 * x2 + c * p[1] * p[1] * x2), p);
}

double f_kampyle_of_eudoxus_2d(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[3], p[4], p[5]);
	const double x2 = x * x, c = p[2] * p[2];
	return limited(-(y * y - c * x2 * x2 + c * p[1] * p[2] * x2), p);
}

double f_klein_bottle(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double q = x * x + y * y + z * z, m = q - 2 * y - 1;
	return limited(-((q + 2 * y - 1) * (m * m - 8 * z * z) + 16 * x * z * m), p);
}

double f_kummer_surface_v1(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(
		-(x2 * x2 + y2 * y2 + z2 * z2 - x2 - y2 - z2 - x2 * y2 - x2 * z2 - y2 * z2 + 1), p);
}

double f_kummer_surface_v2(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(-(x2 * x2 + y2 * y2 + z2 * z2 + p[1] * (x2 + y2 + z2) +
			       p[2] * (x2 * y2 + x2 * z2 + y2 * z2) + p[3] * x * y * z - 1),
		p);
}

double f_lemniscate_of_gerono(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x;
	return limited(-(x2 * x2 - x2 + y * y + z * z), p);
}

double f_lemniscate_of_gerono_2d(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[3], p[4], p[5]);
	const double x2 = x * x, c = p[2] * p[2];
	return limited(-(y * y - c * p[1] * p[1] * x2 + c * x2 * x2), p);
}

double f_mitre(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(-(4 * x2 * (x2 + y2 + z2) - y2 * (1 - y2 - z2)), p);
}

double f_nodal_cubic(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(x);
	UNUSED(w);
	return limited(-(y * y * y + z * z * z - 6 * y * z), p);
}

double f_ovals_of_cassini(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double a = p[1] * p[1], q = x * x + y * y + z * z + a;
	return limited(-(q * q - p[3] * a * (x * x + z * z) - p[2] * p[2]), p);
}

double f_paraboloid(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(x * x - y + z * z), p);
}

double f_parabolic_torus(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double a = p[1] * p[1], b = p[2] * p[2], x2 = x * x, y2 = y * y;
	return limited(-(x2 * x2 + 2 * x2 * y2 - 2 * x2 * z - (a + b) * x2 + y2 * y2 - 2 * y2 * z +
			       (a - b) * y2 + z * z + (a + b) * z + (a - b) * (a - b)),
		p);
}

double f_pillow(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(x2 * x2 + y2 * y2 + z2 * z2 - (x2 + y2 + z2), p);
}

double f_piriform(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x3 = x * x * x;
	return -limited(-(x3 * x - x3 + y * y + z * z), p);
}

double f_piriform_2d(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[4], p[5], p[6]);
	const double x3 = x * x * x, c = p[3] * p[3];
	return limited(-(y * y - p[1] * c * x3 - p[2] * c * x3 * x), p);
}

double f_quartic_paraboloid(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(x * x * x * x + z * z * z * z - y), p);
}

double f_quartic_saddle(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(x * x * x * x - z * z * z * z - y), p);
}

double f_quartic_cylinder(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double q = x * x + z * z, c = p[2] * p[2];
	return limited(-(q * y * y + c * q - c * p[1] * p[1]), p);
}

double f_steiners_roman(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(-(x2 * y2 + x2 * z2 + y2 * z2 + x * y * z), p);
}

double f_strophoid(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, c = p[3] * p[3];
	return limited(-((p[2] - x) * (y * y + z * z) - c * p[1] * x2 - c * x2 * x), p);
}

double f_strophoid_2d(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[4], p[5], p[6]);
	const double x2 = x * x, c = p[3] * p[3];
	return limited(-((p[2] - x) * y * y - c * p[1] * x2 - c * x2 * x), p);
}

double f_torus2(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double a = p[1] * p[1], b = p[2] * p[2], x2 = x * x, y2 = y * y, z2 = z * z;
	return limited(
		-(x2 * x2 + y2 * y2 + z2 * z2 + 2 * x2 * y2 + 2 * x2 * z2 + 2 * y2 * z2 -
			2 * (a + b) * x2 + 2 * (a - b) * y2 - 2 * (a + b) * z2 + (a - b) * (a - b)),
		p);
}

double f_torus_gumdrop(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	const double x2 = x * x, q = y * y + z * z;
	return limited(-(4 * (x2 * x2 + q * q) + 17 * x2 * q - 20 * (x2 + q) + 17), p);
}

double f_umbrella(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(x * x - y * z * z), p);
}

double f_witch_of_agnesi(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	return limited(-(p[1] * (y - 1) + (x * x + z * z) * y), p);
}

double f_witch_of_agnesi_2d(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(w);
	sweep(&x, &y, z, p[3], p[4], p[5]);
	return limited(-(p[1] * p[1] * y + x * x * y - p[2]), p);
}
