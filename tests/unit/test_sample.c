/* SPDX-License-Identifier: MIT */
/*
 * Random numbers by name: uniform, stratified over the samples of a pixel, and
 * independent between pixels, frames, dimensions and vertices of the ray tree.
 */
#include "sample/sample.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 8, CELLS = SIDE * SIDE, DRAWS = CELLS * 1000 };

static struct sample_id id_of(uint32_t frame, int x, int y, uint32_t index)
{
	return sample_at(frame, (struct sample_place){ x, y, index });
}

static uint64_t some_dimension(void)
{
	return sample_dimension(SAMPLE_CAMERA_VERTEX, SAMPLE_AREA_LIGHT);
}

/* Counts over equal cells of the unit square. */
struct histogram {
	unsigned count[CELLS];
};

static void count(struct histogram *h, double u, double v)
{
	assert_true(u >= 0 && u < 1 && v >= 0 && v < 1);
	h->count[(int)(u * SIDE) * SIDE + (int)(v * SIDE)]++;
}

/* Chi squared of 63 degrees of freedom is above 130 once in a million. */
static void assert_even(const struct histogram *h)
{
	const double expected = (double)DRAWS / CELLS;
	double sum = 0;
	for (int i = 0; i < CELLS; i++)
		sum += (h->count[i] - expected) * (h->count[i] - expected) / expected;
	assert_true(sum < 130);
}

/* Each sample of a pixel by itself is uniform over the pixels, not only the first. */
static void every_sample_is_uniform(void **unused)
{
	(void)unused;
	const uint32_t indices[] = { 0, 1, 6, 100, 65537 };
	for (size_t k = 0; k < sizeof indices / sizeof *indices; k++) {
		struct histogram pairs = { 0 }, singles = { 0 };
		for (int i = 0; i < DRAWS; i++) {
			const struct sample_id id = id_of(0, i % 320, i / 320, indices[k]);
			const struct sample_pair p = sample_2d(id, some_dimension());
			count(&pairs, p.u, p.v);
			const double u = sample_1d(id, some_dimension());
			count(&singles, u, u * SIDE - floor(u * SIDE));
		}
		assert_even(&pairs);
		assert_even(&singles);
	}
}

/* The first 2^k numbers: one in each part of each division of the square into 2^k equal boxes. */
static void assert_net(int pixel, uint64_t dimension, int k)
{
	for (int split = 0; split <= k; split++) {
		bool taken[1024] = { false };
		for (uint32_t i = 0; i < 1u << k; i++) {
			const struct sample_pair p =
				sample_2d(id_of(3, pixel, 2 * pixel, i), dimension);
			const int column = (int)ldexp(p.u, split), row = (int)ldexp(p.v, k - split);
			bool *cell = &taken[(column << (k - split)) + row];
			assert_false(*cell);
			*cell = true;
		}
	}
}

static void pixels_are_stratified(void **unused)
{
	(void)unused;
	for (int pixel = 0; pixel < 100; pixel++) {
		const uint64_t dimension =
			sample_subdimension(some_dimension(), (uint32_t)(pixel % 7));
		for (int k = 1; k <= 10; k++)
			assert_net(pixel, dimension, k);
		bool taken[64] = { false };
		for (uint32_t i = 0; i < 64; i++) {
			const struct sample_id sample = id_of(3, pixel, 2 * pixel, i);
			bool *part = &taken[(int)(64 * sample_1d(sample, dimension))];
			assert_false(*part);
			*part = true;
		}
	}
}

/* So smooth functions are averaged far better than by chance: errors fall nearly as 1/n. */
static void averages_are_better_than_by_chance(void **unused)
{
	(void)unused;
	enum { SAMPLES = 64, PIXELS = 1000 };
	double squares = 0;
	for (int pixel = 0; pixel < PIXELS; pixel++) {
		double sum = 0;
		for (uint32_t i = 0; i < SAMPLES; i++) {
			const struct sample_pair p =
				sample_2d(id_of(0, pixel, 0, i), some_dimension());
			sum += p.u * p.v;
		}
		const double error = sum / SAMPLES - 0.25;
		squares += error * error;
	}
	const double by_chance = (1.0 / 9 - 1.0 / 16) / SAMPLES; /* variance of the mean */
	assert_true(squares / PIXELS < by_chance / 50);
}

/* Numbers under names that differ in one thing only fill the square as independent ones do. */
static void assert_independent(double (*a)(int), double (*b)(int))
{
	struct histogram h = { 0 };
	for (int i = 0; i < DRAWS; i++)
		count(&h, a(i), b(i));
	assert_even(&h);
}

static double first(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320, 0), some_dimension());
}
static double second_sample(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320 + 400, 1), some_dimension());
}
static double pixel_to_the_right(int i)
{
	return sample_1d(id_of(1, i % 320 + 1, i / 320, 0), some_dimension());
}
static double pixel_below(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320 + 1, 0), some_dimension());
}
static double pixel_mirrored(int i)
{
	return sample_1d(id_of(1, i / 320, i % 320, 0), some_dimension());
}
static double next_frame(int i)
{
	return sample_1d(id_of(2, i % 320, i / 320, 0), some_dimension());
}
static double frame_for_pixel(int i)
{
	return sample_1d(id_of((uint32_t)(i % 320), 1, i / 320, 0), some_dimension());
}
static double other_purpose(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320, 0),
		sample_dimension(SAMPLE_CAMERA_VERTEX, SAMPLE_GRAIN));
}
static double other_light(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320, 0), sample_subdimension(some_dimension(), 1));
}
static double behind_the_surface(int i)
{
	return sample_1d(id_of(1, i % 320, i / 320, 0),
		sample_dimension(sample_vertex(SAMPLE_CAMERA_VERTEX, 0), SAMPLE_AREA_LIGHT));
}

static void names_are_independent(void **unused)
{
	(void)unused;
	double (*const others[])(int) = { second_sample, pixel_to_the_right, pixel_below,
		next_frame, frame_for_pixel, other_purpose, other_light, behind_the_surface };
	for (size_t i = 0; i < sizeof others / sizeof *others; i++)
		assert_independent(first, others[i]);
	assert_true(first(5) != pixel_mirrored(5));
}

/* The samples of one pixel in two dimensions: each is stratified, and pairs of them fill the square. */
static void dimensions_of_a_pixel_are_independent(void **unused)
{
	(void)unused;
	struct histogram h = { 0 };
	const uint64_t other = sample_subdimension(some_dimension(), 1);
	for (int i = 0; i < DRAWS; i++) {
		const struct sample_id id = id_of(0, i / 4, 0, (uint32_t)(i % 4));
		count(&h, sample_1d(id, some_dimension()), sample_1d(id, other));
	}
	assert_even(&h);
	double correlation = 0; /* within one pixel, of four samples each */
	for (int pixel = 0; pixel < 10000; pixel++) {
		double sum = 0;
		for (uint32_t i = 0; i < 4; i++) {
			const struct sample_id id = id_of(0, pixel, 9, i);
			sum += (sample_1d(id, some_dimension()) - 0.5) *
			       (sample_1d(id, other) - 0.5);
		}
		correlation += 12 * 12 * sum * sum / 4;
	}
	/* 1 for unstratified samples, 2 for shuffled halves; 4 if both took their samples in one order */
	assert_true(correlation / 10000 < 2.2);
}

/* Reflections count upwards and transmissions downwards: no two vertices of a tree are one. */
enum { RAYS = 5, DEPTH = 5, VERTICES = 3906 };

static size_t grow_tree(uint32_t vertex, int depth, uint32_t *all, size_t count)
{
	const uint32_t rays[RAYS] = { 0, 1, 2, UINT32_MAX, UINT32_MAX - 1 };
	all[count++] = vertex;
	for (int i = 0; i < RAYS && depth < DEPTH; i++)
		count = grow_tree(sample_vertex(vertex, rays[i]), depth + 1, all, count);
	return count;
}

static void vertices_of_a_tree_differ(void **unused)
{
	(void)unused;
	uint32_t all[VERTICES];
	assert_int_equal(grow_tree(SAMPLE_CAMERA_VERTEX, 0, all, 0), VERTICES);
	for (size_t i = 0; i < VERTICES; i++) {
		for (size_t k = 0; k < i; k++)
			assert_true(all[i] != all[k]);
	}
}

/* Members are uniform, independent of each other within one sample, and each is stratified. */
static void families_are_as_good_as_pairs(void **unused)
{
	(void)unused;
	struct histogram one = { 0 }, two = { 0 };
	for (int i = 0; i < DRAWS; i++) {
		const struct sample_family f =
			sample_family(id_of(0, i % 320, i / 320, 2), some_dimension());
		const struct sample_pair a = sample_member(&f, 3), b = sample_member(&f, 4);
		count(&one, a.u, a.v);
		count(&two, a.u, b.u);
	}
	assert_even(&one);
	assert_even(&two);
	bool taken[16] = { false };
	for (uint32_t i = 0; i < 16; i++) {
		const struct sample_family f = sample_family(id_of(0, 4, 5, i), some_dimension());
		const struct sample_pair p = sample_member(&f, 7);
		bool *cell = &taken[(int)(4 * p.u) * 4 + (int)(4 * p.v)];
		assert_false(*cell);
		*cell = true;
	}
}

static void a_name_is_a_number(void **unused)
{
	(void)unused;
	const struct sample_id id = id_of(7, 12, -1, 3);
	const uint64_t dimension = sample_subdimension(some_dimension(), 4);
	assert_true(sample_1d(id, dimension) == sample_1d(id_of(7, 12, -1, 3), dimension));
	const struct sample_pair a = sample_2d(id, dimension), b = sample_2d(id, dimension);
	assert_true(a.u == b.u && a.v == b.v);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_sample_is_uniform),
		cmocka_unit_test(pixels_are_stratified),
		cmocka_unit_test(averages_are_better_than_by_chance),
		cmocka_unit_test(names_are_independent),
		cmocka_unit_test(dimensions_of_a_pixel_are_independent),
		cmocka_unit_test(vertices_of_a_tree_differ),
		cmocka_unit_test(families_are_as_good_as_pairs),
		cmocka_unit_test(a_name_is_a_number),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
