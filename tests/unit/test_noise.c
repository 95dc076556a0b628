/* SPDX-License-Identifier: MIT */
/*
 * Noise against known values, and properties that the pictures rely on.
 */
#include "noise/noise.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* The known values have 12 digits. */
#define DIGITS 6e-13

static const vec3 points[3] = { { 0.3, 0.4, 0.5 }, { -1.7, 2.2, 13.6 }, { 1, 2, 3 } };

static void assert_near(double value, double known, double tolerance)
{
	if (!(fabs(value - known) <= tolerance))
		fail_msg("%.15g is not %.15g", value, known);
}

static void test_tables(void **state)
{
	(void)state;
	assert_int_equal(hash_table[0], 2291);
	assert_int_equal(hash_table[4095], 3088);
	assert_true(noise_reals[0] == -1 && noise_reals[1] == 0.604974);
	assert_true(noise_reals[5] == -0.0161593 && noise_reals[266] == 0.566186);
	assert_near(cell_uniforms[0], 0.814723691903, DIGITS);
	assert_near(cell_uniforms[3], 0.835008589784, DIGITS);
	const unsigned permutation[10] = { 0, 1, 386, 3, 649, 1576, 1405, 7, 1146, 9 };
	for (int i = 0; i < 10; i++)
		assert_int_equal(noise_permutation[i], permutation[i]);
	assert_near(noise_gradients[0][1], 0.705260290, 6e-10);
	assert_near(noise_gradients[1][2], 0.188766929, 6e-10);
}

static void test_scalar(void **state)
{
	(void)state;
	const double known[3][3] = {
		{ 0.419031695590, 0.475871266933, 0.678075305081 },
		{ 0.444333489906, 0.488265498136, 0.342788940122 },
		{ 0.306996500000, 0.420990174329, 0.471585305317 },
	};
	for (int i = 0; i < 3; i++)
		for (int generator = 1; generator <= 3; generator++)
			assert_near(noise_scalar(points[i], generator), known[i][generator - 1],
				DIGITS);
}

static void test_vector(void **state)
{
	(void)state;
	const vec3 known[3] = {
		{ -0.080968304410, -0.170550743007, -0.186296023276 },
		{ -0.055666510094, 0.257632830341, -0.378392565425 },
		{ -0.193003500000, -0.457183000000, 0.474075000000 },
	};
	for (int i = 0; i < 3; i++) {
		const vec3 v = noise_vector(points[i]);
		assert_near(v.x, known[i].x, DIGITS);
		assert_near(v.y, known[i].y, DIGITS);
		assert_near(v.z, known[i].z, DIGITS);
	}
}

static void test_turbulence(void **state)
{
	(void)state;
	const double known2[3] = { 1.060390678903, 0.783375835014, 0.672749895313 };
	const double known1[3] = { 1.003233074216, 0.716781430893, 0.603864593750 };
	for (int i = 0; i < 3; i++) {
		assert_near(noise_turbulence_scalar(points[i], 6, 0.5f, 2, 2), known2[i], DIGITS);
		assert_near(noise_turbulence_scalar(points[i], 6, 0.5f, 2, 1), known1[i], DIGITS);
	}
	const vec3 one = noise_turbulence(points[0], 1, 0.5, 2), d = noise_vector(points[0]);
	assert_true(one.x == d.x && one.y == d.y && one.z == d.z);
}

/* The first component of vector noise and generators 1 and 2 are one function. */
static void test_scalar_is_vector_x(void **state)
{
	(void)state;
	for (int i = -2000; i < 2000; i++) {
		const vec3 p = { i * 0.3137, i * -0.0771, i * 1.711 };
		const double x = noise_vector(p).x + 0.5;
		assert_true(noise_scalar(p, 1) == (x < 0 ? 0 : x > 1 ? 1 : x));
	}
}

static void test_periods(void **state)
{
	(void)state;
	for (int i = 0; i < 200; i++) {
		const vec3 p = { i * 0.25, i * 0.5 - 20, i * 0.125 };
		const vec3 q = { p.x + 4096, p.y - 4096, p.z + 8192 };
		assert_near(noise_scalar(p, 2), noise_scalar(q, 2), 1e-9);
		assert_near(noise_scalar(p, 3), noise_scalar(q, 3), 1e-7);
	}
}

/* No coordinate is too large, nor missing. */
static void test_extremes(void **state)
{
	(void)state;
	const double extremes[] = { 1e300, -1e300, INFINITY, -INFINITY, (double)NAN, -1e-11, -1 };
	for (size_t i = 0; i < sizeof extremes / sizeof *extremes; i++)
		for (int generator = 1; generator <= 3; generator++) {
			const double v = noise_scalar(vec(extremes[i], 0.5, 0.5), generator);
			assert_true(v >= 0 && v <= 1);
		}
}

static void test_wave_sources(void **state)
{
	(void)state;
	struct arena *arena = arena_create(0);
	const struct wave_sources made = wave_sources_make(arena, 10), *sources = &made;
	assert_int_equal(sources->count, 10);
	assert_near(sources->items[0].centre.y, 0.492048408, 6e-10);
	assert_near(sources->items[1].frequency, 0.960041200, 6e-10);
	assert_near(sources->items[2].centre.z, 0.643300326, 6e-10);
	arena_destroy(arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_tables),
		cmocka_unit_test(test_scalar),
		cmocka_unit_test(test_vector),
		cmocka_unit_test(test_turbulence),
		cmocka_unit_test(test_scalar_is_vector_x),
		cmocka_unit_test(test_periods),
		cmocka_unit_test(test_extremes),
		cmocka_unit_test(test_wave_sources),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
