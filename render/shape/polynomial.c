/* SPDX-License-Identifier: MIT */
/*
 * Roots between the roots of the derivative, see the header.
 */
#include "render/shape/polynomial.h"

#include <float.h>
#include <math.h>

double polynomial_value(const double *c, unsigned degree, double x)
{
	double value = c[degree];
	for (unsigned i = degree; i-- > 0;)
		value = value * x + c[i];
	return value;
}

/* Higham, Accuracy and Stability of Numerical Algorithms, section 5.1. */
double polynomial_error(const double *c, unsigned degree, double x)
{
	double sum = fabs(c[degree]);
	for (unsigned i = degree; i-- > 0;)
		sum = sum * fabs(x) + fabs(c[i]);
	return 2 * degree * DBL_EPSILON * sum;
}

static inline double value_and_slope(const double *c, unsigned degree, double x, double *slope)
{
	double value = c[degree], derivative = 0;
	for (unsigned i = degree; i-- > 0;) {
		derivative = derivative * x + value;
		value = value * x + c[i];
	}
	*slope = derivative;
	return value;
}

/* The root between lo and hi, at which the signs differ. Newton's step is taken where it stays
 * between the nearest points of either sign known so far, else the interval is halved. */
static double bracketed_root(
	const double *c, unsigned degree, double lo, double hi, bool positive_at_lo)
{
	double x = 0.5 * (lo + hi), before = hi - lo;
	/* halving alone ends after as many steps as there are bits between lo and hi */
	for (int step = 0; step < 2200; step++) {
		double slope;
		const double value = value_and_slope(c, degree, x, &slope);
		if (value == 0)
			return x;
		if ((value > 0) == positive_at_lo)
			lo = x;
		else
			hi = x;
		double next = x - value / slope;
		/* written so that no number (slope 0) also halves */
		if (!(next > lo && next < hi && fabs(next - x) < 0.5 * before))
			next = 0.5 * (lo + hi);
		before = fabs(next - x);
		if (before <= DBL_EPSILON * fabs(x) || next == x)
			return next;
		x = next;
	}
	return x;
}

/* b² - ac with the rounding errors of both products added back. */
static double discriminant(double a, double b, double c)
{
	const double bb = b * b, ac = a * c;
	if (fabs(bb - ac) > 1e-3 * bb) /* no cancellation to speak of */
		return bb - ac;
	return (bb - ac) + (fma(b, b, -bb) - fma(a, c, -ac));
}

static unsigned put_if_inside(double x, double lo, double hi, double *roots, unsigned count)
{
	if (x >= lo && x <= hi)
		roots[count++] = x;
	return count;
}

static unsigned quadratic_crossings(const double *k, double lo, double hi, double *roots)
{
	const double a = k[2], b = 0.5 * k[1], c = k[0];
	const double d = discriminant(a, b, c);
	if (!(d > 0))
		return 0;
	const double q = -(b + copysign(sqrt(d), b));
	const double x1 = q / a, x2 = c / q;
	const unsigned count = put_if_inside(fmin(x1, x2), lo, hi, roots, 0);
	return put_if_inside(fmax(x1, x2), lo, hi, roots, count);
}

static unsigned crossings(
	const double *c, unsigned degree, double lo, double hi, bool first_only, double *roots);

/* The ends of the interval and between them the turning points. */
static unsigned turning_points(
	const double *c, unsigned degree, double lo, double hi, double *points)
{
	double derivative[POLYNOMIAL_MAX_DEGREE + 1];
	for (unsigned i = 1; i <= degree; i++)
		derivative[i - 1] = i * c[i];
	points[0] = lo;
	const unsigned count = 1 + crossings(derivative, degree - 1, lo, hi, false, points + 1);
	points[count] = hi;
	return count + 1;
}

static unsigned crossings(
	const double *c, unsigned degree, double lo, double hi, bool first_only, double *roots)
{
	while (degree > 0 && c[degree] == 0)
		degree--;
	if (degree == 0)
		return 0;
	if (degree == 1)
		return put_if_inside(-c[0] / c[1], lo, hi, roots, 0);
	if (degree == 2)
		return quadratic_crossings(c, lo, hi, roots);
	double points[POLYNOMIAL_MAX_DEGREE + 2];
	const unsigned count = turning_points(c, degree, lo, hi, points);
	unsigned found = 0;
	bool positive = polynomial_value(c, degree, lo) >= 0;
	for (unsigned i = 1; i < count; i++) {
		const bool next = polynomial_value(c, degree, points[i]) >= 0;
		if (next != positive) {
			roots[found++] =
				bracketed_root(c, degree, points[i - 1], points[i], positive);
			if (first_only)
				return found;
		}
		positive = next;
	}
	return found;
}

unsigned polynomial_crossings(const double *c, unsigned degree, double lo, double hi, double *roots)
{
	return lo < hi ? crossings(c, degree, lo, hi, false, roots) : 0;
}

bool polynomial_first_crossing(const double *c, unsigned degree, double lo, double hi, double *root)
{
	double roots[POLYNOMIAL_MAX_DEGREE];
	if (!(lo < hi) || crossings(c, degree, lo, hi, true, roots) == 0)
		return false;
	*root = roots[0];
	return true;
}

unsigned polynomial_roots(const double *c, unsigned degree, double lo, double hi, double *roots)
{
	while (degree > 0 && c[degree] == 0)
		degree--;
	if (degree < 2)
		return polynomial_crossings(c, degree, lo, hi, roots);
	if (!(lo < hi))
		return 0;
	double points[POLYNOMIAL_MAX_DEGREE + 2];
	const unsigned count = turning_points(c, degree, lo, hi, points);
	unsigned found = 0;
	bool positive = polynomial_value(c, degree, lo) >= 0;
	bool touched = false; /* the point before is a root already */
	for (unsigned i = 1; i < count; i++) {
		const double value = polynomial_value(c, degree, points[i]);
		const bool touches =
			i + 1 < count && fabs(value) <= polynomial_error(c, degree, points[i]);
		if (touches)
			roots[found++] = points[i];
		else if ((value >= 0) != positive && !touched)
			roots[found++] =
				bracketed_root(c, degree, points[i - 1], points[i], positive);
		touched = touches;
		positive = value >= 0;
	}
	return found;
}
