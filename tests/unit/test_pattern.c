/* SPDX-License-Identifier: MIT */
/*
 * Patterns against known values and against slower definitions of the same thing;
 * frequency and waves; the lookup in maps.
 */
#include "texture/pattern.h"
#include "texture/map.h"
#include "noise/noise.h"
#include "texture/pigment.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define DIGITS 6e-13

static const vec3 points[3] = { { 0.3, 0.4, 0.5 }, { -1.7, 2.2, 13.6 }, { 1, 2, 3 } };

static void assert_near(double value, double known, double tolerance)
{
	if (!(fabs(value - known) <= tolerance))
		fail_msg("%.15g is not %.15g", value, known);
}

/* A pattern with the parameters it has when nothing is said; `self` is 256 bytes of room. */
static struct pattern pattern_of(const char *word, void *self)
{
	const struct pattern_class *class = pattern_find(word);
	assert_non_null(class);
	assert_true(class->size <= 256);
	for (size_t i = 0; i < class->size; i++)
		((char *)self)[i] = class->defaults ? ((const char *)class->defaults)[i] : 0;
	if (class->build)
		class->build(self);
	return (struct pattern){
		.class = class, .self = self, .frequency = 1, .exponent = 1, .noise_generator = 2
	};
}

static double raw(const struct pattern *pattern, vec3 p)
{
	return pattern->class->value(pattern, p, NULL);
}

/* A number in 0 to 1 from a counter. */
static double random_number(unsigned *state)
{
	*state = *state * 1664525u + 1013904223u;
	return (*state >> 8) / 16777216.0;
}

static vec3 random_point(unsigned *state, double size)
{
	const double x = random_number(state), y = random_number(state), z = random_number(state);
	return vec((x - 0.5) * size, (y - 0.5) * size, (z - 0.5) * size);
}

static void test_known_values(void **state)
{
	(void)state;
	static const struct {
		const char *word;
		double values[3];
	} known[] = {
		{ "crackle", { 0.342964385923, 0.079765061307, 0.080313036308 } },
		{ "granite", { 0.540567699968, 0.524141201398, 0.517680167060 } },
		{ "agate", { 0.378208858443, 0.524282798873, 0.957294244936 } },
		{ "wrinkles", { 0.537929473251, 0.399185793171, 0.339524955211 } },
	};
	_Alignas(16) char self[256];
	for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
		const struct pattern pattern = pattern_of(known[i].word, self);
		for (int j = 0; j < 3; j++)
			assert_near(raw(&pattern, points[j]), known[i].values[j], DIGITS);
	}
}

static void test_ripples(void **state)
{
	(void)state;
	struct arena *arena = arena_create(0);
	_Alignas(16) char self[256];
	struct pattern pattern = pattern_of("ripples", self);
	const struct wave_sources sources = wave_sources_make(arena, 10);
	pattern.wave_sources = &sources;
	assert_near(raw(&pattern, points[0]), 0.273188178700, DIGITS);
	arena_destroy(arena);
}

/* The two smallest distances over all 81 cells. */
static double slow_crackle(vec3 q)
{
	double first = INFINITY, second = INFINITY;
	for (int dx = -2; dx <= 2; dx++)
		for (int dy = -2; dy <= 2; dy++)
			for (int dz = -2; dz <= 2; dz++) {
				if ((dx * dx == 4) + (dy * dy == 4) + (dz * dz == 4) > 1)
					continue;
				const double x = floor(q.x) + dx, y = floor(q.y) + dy,
					     z = floor(q.z) + dz;
				const double *u = cell_uniforms +
						  cell_hash((int64_t)x, (int64_t)y, (int64_t)z);
				const double d =
					vec_length(vec_sub(vec(x + u[0], y + u[1], z + u[2]), q));
				if (d < first) {
					second = first;
					first = d;
				} else if (d < second) {
					second = d;
				}
			}
	return clamp01(second - first);
}

static void test_crackle_prunes_nothing_needed(void **state)
{
	(void)state;
	_Alignas(16) char self[256];
	const struct pattern pattern = pattern_of("crackle", self);
	unsigned seed = 1;
	for (int i = 0; i < 20000; i++) {
		const vec3 p = random_point(&seed, 200);
		assert_near(raw(&pattern, p), slow_crackle(p), 1e-11);
	}
}

/* The class of the nearest of all centres around. */
static double slow_hexagon(vec3 q)
{
	const double h = sqrt(3) / 2;
	double nearest = INFINITY, value = 0;
	for (int a = -20; a <= 20; a++)
		for (int b = -20; b <= 20; b++) {
			const double dx = q.x - 1.5 * a, dz = q.z - h * (a + 2 * b);
			if (dx * dx + dz * dz < nearest) {
				nearest = dx * dx + dz * dz;
				value = ((b - a) % 3 + 3) % 3;
			}
		}
	return value;
}

static void test_hexagon(void **state)
{
	(void)state;
	_Alignas(16) char self[256];
	const struct pattern pattern = pattern_of("hexagon", self);
	unsigned seed = 2;
	for (int i = 0; i < 5000; i++) {
		const vec3 p = random_point(&seed, 12);
		assert_true(raw(&pattern, p) == slow_hexagon(p));
	}
}

/* Six kinds, each with a sixth of the plane, with period 3 and root 3. */
static void test_triangular(void **state)
{
	(void)state;
	_Alignas(16) char self[256];
	const struct pattern pattern = pattern_of("triangular", self);
	unsigned seed = 3;
	int counts[6] = { 0 };
	for (int i = 0; i < 60000; i++) {
		const vec3 p = random_point(&seed, 60);
		const double v = raw(&pattern, p);
		assert_true(v >= 0 && v <= 5 && v == floor(v));
		assert_true(raw(&pattern, vec(p.x + 3, p.y, p.z)) == v);
		counts[(int)v]++;
	}
	for (int i = 0; i < 6; i++)
		assert_in_range(counts[i], 9500, 10500);
	assert_true(raw(&pattern, vec(0.5, 0, 0.2)) == 0);
	assert_true(raw(&pattern, vec(1, 0, 0.2)) == 3);
}

static void test_checker_at_lattice_planes(void **state)
{
	(void)state;
	_Alignas(16) char self[256];
	const struct pattern pattern = pattern_of("checker", self);
	assert_true(raw(&pattern, vec(0.5, 0.5, 0.5)) == 0);
	assert_true(raw(&pattern, vec(-1e-12, 0.5, 0.5)) == 0);
	assert_true(raw(&pattern, vec(-1e-9, 0.5, 0.5)) == 1);
	assert_true(raw(&pattern, vec(-1.5, -0.5, 0.5)) == 1);
}

/* The wrap of frequencies is a little longer than 1. */
static void test_frequency_drifts(void **state)
{
	(void)state;
	_Alignas(16) char self[256];
	struct pattern pattern = pattern_of("marble", self);
	assert_near(pattern_value(&pattern, vec(-100.5, 0, 0), NULL), 0.501, 1e-12);
	assert_near(pattern_value(&pattern, vec(1.000005, 0, 0), NULL), 1.000005, 1e-15);
	pattern.frequency = 0;
	assert_near(pattern_value(&pattern, vec(2.5, 0, 0), NULL), 2.5, 0);
}

static void test_waves(void **state)
{
	(void)state;
	static const struct {
		enum wave wave;
		double quarter, three_quarters;
	} known[] = {
		{ WAVE_RAMP, 0.25, 0.75 },
		{ WAVE_TRIANGLE, 0.5, 0.5 },
		{ WAVE_SINE, 1, 0 },
		{ WAVE_SCALLOP, 0.70710678118654752, 0.70710678118654752 },
		{ WAVE_CUBIC, 0.15625, 0.84375 },
		{ WAVE_POLY, 0.0625, 0.5625 },
	};
	_Alignas(16) char self[256];
	struct pattern pattern = pattern_of("marble", self);
	pattern.exponent = 2;
	for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
		pattern.wave = known[i].wave;
		assert_near(
			pattern_value(&pattern, vec(0.25, 0, 0), NULL), known[i].quarter, 1e-15);
		assert_near(pattern_value(&pattern, vec(0.75, 0, 0), NULL), known[i].three_quarters,
			1e-15);
	}
}

static void test_map_lookup(void **state)
{
	(void)state;
	const float values[] = { 0.25f, 0.5f, 0.5f, 1 }, differences[] = { 0, 0.25f, 0, 0.5f };
	const struct map map = { 4, values, differences, false };
	static const struct {
		double v;
		size_t low, high;
		double share;
	} known[] = {
		{ -1, 0, 0, 0 },
		{ 0.25, 0, 0, 0 },
		{ 0.375, 0, 1, 0.5 },
		{ 0.5, 1, 1, 0 },
		{ 0.75, 2, 3, 0.5 },
		{ 1, 3, 3, 0 },
		{ 7, 3, 3, 0 },
	};
	for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
		const struct blend b = map_lookup(&map, known[i].v);
		assert_int_equal(b.low, known[i].low);
		assert_int_equal(b.high, known[i].high);
		assert_near(b.share, known[i].share, 0);
	}
	assert_int_equal(map_lookup(&map, (double)NAN).high, 0);
}

/* Every pattern that needs nothing but a point gives a number for any point. */
static void test_extremes(void **state)
{
	(void)state;
	static const char *const words[] = { "agate", "boxed", "bozo", "brick", "bumps", "cells",
		"checker", "crackle", "cubic", "cylindrical", "dents", "gradient", "granite",
		"hexagon", "julia", "leopard", "magnet", "mandel", "marble", "onion", "planar",
		"quilted", "radial", "spherical", "spiral1", "spiral2", "spotted", "square",
		"triangular", "wood", "wrinkles" };
	const double extremes[] = { 0, -0.0, 1e17, -1e17, 1e300, (double)INFINITY, (double)NAN };
	_Alignas(16) char self[256];
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		const struct pattern pattern = pattern_of(words[i], self);
		for (size_t j = 0; j < sizeof extremes / sizeof *extremes; j++) {
			const vec3 q = pattern_warp(&pattern, vec(extremes[j], 1, extremes[j]));
			assert_true(fabs(q.x) <= 1e17 && fabs(q.z) <= 1e17);
			(void)pattern_value(&pattern, q, NULL);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_known_values),
		cmocka_unit_test(test_ripples),
		cmocka_unit_test(test_crackle_prunes_nothing_needed),
		cmocka_unit_test(test_hexagon),
		cmocka_unit_test(test_triangular),
		cmocka_unit_test(test_checker_at_lattice_planes),
		cmocka_unit_test(test_frequency_drifts),
		cmocka_unit_test(test_waves),
		cmocka_unit_test(test_map_lookup),
		cmocka_unit_test(test_extremes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
