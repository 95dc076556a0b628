/* SPDX-License-Identifier: MIT */
/*
 * The roots of polynomials: made from known roots, they must come back.
 */
#include "shape/polynomial.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* A random number in [0, 1) from a counter; fixed, so that failures repeat. */
static double random_unit(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11) * 0x1p-53;
}

/* Multiplies c, of the given degree, by (x - root). */
static void multiply_root(double *c, unsigned degree, double root)
{
	c[degree + 1] = 0;
	for (unsigned i = degree + 1; i > 0; i--)
		c[i] = c[i - 1] - root * c[i];
	c[0] *= -root;
}

/* Multiplies c by x² + b x + a. */
static void multiply_pair(double *c, unsigned degree, double b, double a)
{
	c[degree + 1] = c[degree + 2] = 0;
	for (unsigned i = degree + 3; i-- > 0;)
		c[i] = a * c[i] + (i >= 1 ? b * c[i - 1] : 0) + (i >= 2 ? c[i - 2] : 0);
}

static void finds_separate_roots(void **unused)
{
	(void)unused;
	uint64_t state = 1;
	for (int round = 0; round < 20000; round++) {
		const unsigned real = 1 + (unsigned)(random_unit(&state) * 4);
		const unsigned pairs = (unsigned)(random_unit(&state) * 2);
		const double scale = pow(10, 12 * random_unit(&state) - 6);
		const double factor = pow(10, 40 * random_unit(&state) - 20);
		double c[12] = { factor }, wanted[4];
		unsigned degree = 0;
		for (unsigned i = 0; i < real; i++) {
			wanted[i] = scale * (i + 0.2 + 0.6 * random_unit(&state));
			multiply_root(c, degree++, wanted[i]);
		}
		for (unsigned i = 0; i < pairs; i++, degree += 2) /* no real roots */
			multiply_pair(c, degree, scale * random_unit(&state), scale * scale);
		double found[POLYNOMIAL_MAX_DEGREE];
		const unsigned count = polynomial_crossings(c, degree, -scale, 5 * scale, found);
		assert_int_equal(count, real);
		for (unsigned i = 0; i < count; i++)
			assert_true(fabs(found[i] - wanted[i]) < 1e-11 * scale);
		double first;
		assert_true(polynomial_first_crossing(c, degree, -scale, 5 * scale, &first));
		assert_true(first == found[0]);
	}
}

/* A bound for polynomial_value: Higham, Accuracy and Stability of Numerical Algorithms, section 5.1. */
static double rounding_error(const double *c, unsigned degree, double x)
{
	double sum = fabs(c[degree]);
	for (unsigned i = degree; i-- > 0;)
		sum = sum * fabs(x) + fabs(c[i]);
	return 2 * degree * DBL_EPSILON * sum;
}

static void crossings_alternate(void **unused)
{
	(void)unused;
	uint64_t state = 2;
	for (int round = 0; round < 20000; round++) {
		const unsigned degree = 3 + (unsigned)(random_unit(&state) * 8);
		double c[12], found[POLYNOMIAL_MAX_DEGREE];
		for (unsigned i = 0; i <= degree; i++)
			c[i] = (random_unit(&state) - 0.5) * pow(10, 8 * random_unit(&state));
		const unsigned count = polynomial_crossings(c, degree, -3, 2, found);
		const bool differ = (polynomial_value(c, degree, -3) >= 0) !=
				    (polynomial_value(c, degree, 2) >= 0);
		assert_int_equal(count % 2, differ);
		for (unsigned i = 0; i < count; i++) {
			assert_true(found[i] >= (i ? found[i - 1] : -3) && found[i] <= 2);
			assert_true(fabs(polynomial_value(c, degree, found[i])) <=
				    2 * rounding_error(c, degree, found[i]));
		}
	}
}

static void double_roots_cross_evenly(void **unused)
{
	(void)unused;
	uint64_t state = 3;
	for (int round = 0; round < 20000; round++) {
		const double touch = 1 + random_unit(&state), cross = 3 + random_unit(&state);
		double c[8] = { random_unit(&state) < 0.5 ? 1 : -1 }, found[POLYNOMIAL_MAX_DEGREE];
		multiply_root(c, 0, touch);
		multiply_root(c, 1, touch);
		multiply_root(c, 2, cross);
		multiply_root(c, 3, -cross);
		const unsigned crossings = polynomial_crossings(c, 4, 0, 5, found);
		assert_true(crossings == 1 || crossings == 3);
		assert_true(fabs(found[crossings - 1] - cross) < 1e-13);
		if (crossings == 3) {
			assert_true(fabs(found[0] - touch) < 1e-6);
			assert_true(fabs(found[1] - touch) < 1e-6);
		}
	}
}

static void perfect_squares_cross_evenly(void **unused)
{
	(void)unused;
	const double c[5] = { 36, -60, 37, -10, 1 }; /* ((x - 2)(x - 3))² */
	double found[POLYNOMIAL_MAX_DEGREE];
	assert_int_equal(polynomial_crossings(c, 4, -10, 10, found) % 2, 0);
}

/* The interval only selects: a wide one gives the roots of a narrow one. */
static void wide_intervals_find_the_same(void **unused)
{
	(void)unused;
	uint64_t state = 4;
	for (int round = 0; round < 20000; round++) {
		const unsigned degree = 3 + (unsigned)(random_unit(&state) * 4);
		const double scale = pow(10, 8 * random_unit(&state) - 4);
		double c[8] = { random_unit(&state) - 0.5 }, narrow[POLYNOMIAL_MAX_DEGREE],
		       wide[POLYNOMIAL_MAX_DEGREE];
		for (unsigned i = 0; i < degree; i++)
			multiply_root(c, i, scale * (i + 0.3 + 0.4 * random_unit(&state)));
		const unsigned count = polynomial_crossings(c, degree, -scale, 8 * scale, narrow);
		assert_int_equal(count, degree);
		assert_int_equal(polynomial_crossings(c, degree, -1e12, 1e12, wide), count);
		for (unsigned i = 0; i < count; i++)
			assert_true(fabs(narrow[i] - wide[i]) < 1e-10 * scale);
		/* from between two roots on */
		double first;
		assert_true(polynomial_first_crossing(c, degree, scale, INFINITY, &first));
		assert_true(fabs(first - narrow[1]) < 1e-10 * scale);
	}
}

static void triple_root(void **unused)
{
	(void)unused;
	double c[5] = { 1 }, found[POLYNOMIAL_MAX_DEGREE];
	for (unsigned i = 0; i < 3; i++)
		multiply_root(c, i, 1.5);
	const unsigned count = polynomial_crossings(c, 3, 0, 4, found);
	assert_int_equal(count % 2, 1);
	for (unsigned i = 0; i < count; i++)
		assert_true(fabs(found[i] - 1.5) < 1e-4);
}

static void keeps_to_the_interval(void **unused)
{
	(void)unused;
	const double c[4] = { -6, 11, -6, 1 }; /* roots 1, 2, 3 */
	double found[POLYNOMIAL_MAX_DEGREE];
	assert_int_equal(polynomial_crossings(c, 3, 1.5, 2.5, found), 1);
	assert_true(fabs(found[0] - 2) < 1e-15);
	assert_int_equal(polynomial_crossings(c, 3, 3.5, 9, found), 0);
	assert_int_equal(polynomial_crossings(c, 3, 2, 2, found), 0);
}

static void loses_vanishing_leading_terms(void **unused)
{
	(void)unused;
	const double line[5] = { -2, 1, 0, 0, 0 };
	const double tiny[5] = { -2, 1, 0, 0, 1e-300 };
	const double none[5] = { 3, 0, 0, 0, 0 };
	double found[POLYNOMIAL_MAX_DEGREE];
	assert_int_equal(polynomial_crossings(line, 4, 0, 10, found), 1);
	assert_true(found[0] == 2);
	assert_int_equal(polynomial_crossings(tiny, 4, 0, 10, found), 1);
	assert_true(fabs(found[0] - 2) < 1e-15);
	assert_int_equal(polynomial_crossings(none, 4, 0, 10, found), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(finds_separate_roots),
		cmocka_unit_test(crossings_alternate),
		cmocka_unit_test(double_roots_cross_evenly),
		cmocka_unit_test(perfect_squares_cross_evenly),
		cmocka_unit_test(wide_intervals_find_the_same),
		cmocka_unit_test(triple_root),
		cmocka_unit_test(keeps_to_the_interval),
		cmocka_unit_test(loses_vanishing_leading_terms),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
