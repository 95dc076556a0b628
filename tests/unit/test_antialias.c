/* SPDX-License-Identifier: MIT */
/*
 * The hash and jitter tables against their formulas and reference values, and
 * both methods of antialiasing over an edge so simple that the pixels can be
 * worked out by hand.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "sampling.h"
#include "noise/tables.h"

#include <math.h>
#include <string.h>

/* ---- tables ---- */

static void hash_follows_its_formula(void **state)
{
	(void)state;
	uint16_t table[4096];
	uint32_t s = 0;
	for (unsigned i = 0; i < 4096; i++)
		table[i] = (uint16_t)i;
	for (unsigned i = 4096; i-- > 0;) {
		s = 1812433253u * s + 12345u;
		const unsigned k = (s >> 16 & 32767) % 4096;
		const uint16_t other = table[i];
		table[i] = table[k];
		table[k] = other;
	}
	assert_memory_equal(table, hash_table, sizeof table);
	assert_int_equal(hash_table[0], 2291);
	assert_int_equal(hash_table[4095], 3088);
}

static double crc_entry(unsigned i)
{
	unsigned c = i;
	for (int bit = 0; bit < 8; bit++)
		c = c & 1 ? c >> 1 ^ 0xA001u : c >> 1;
	return round(((c & 32767) / 32768.0 - 0.5) * 1e6) / 1e6;
}

/* Positions (0, k / 1019.0) reach every entry of the table by a known path. */
static void jitter_follows_its_formula(void **state)
{
	(void)state;
	for (unsigned k = 0; k < 4096; k++) {
		const struct position j = sample_jitter((struct position){ .y = (k + 0.5) / 1019 });
		const unsigned cell = hash_table[(hash_table[0] ^ k) & 4095] & 255;
		assert_true(fabs(j.x - crc_entry(cell)) < 1e-7);
	}
}

static void jitter_reference_values(void **state)
{
	(void)state;
	static const double cases[][4] = {
		{ 0, 0, 0.084015, 0.084015 },
		{ 1.25, 2.5, 0.203125, -0.304657 },
		{ -0.333333, 7.1, 0.080078, 0.412109 },
		{ 100.5, -0.5, 0.230469, 0.050781 },
	};
	for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
		const struct position j =
			sample_jitter((struct position){ .x = cases[i][0], .y = cases[i][1] });
		assert_true(fabs(j.x - cases[i][2]) < 1e-6);
		assert_true(fabs(j.y - cases[i][3]) < 1e-6);
	}
}

/* ---- pictures of one edge ---- */

enum { WIDTH = 8, HEIGHT = 4 };

/* Stands in for the tracer: light right of x = 3.3, of the given colour. */
struct edge {
	colour left, right;
	unsigned samples;
};

static void edge_samples(void *user, size_t count, const struct position *at, colour *out)
{
	struct edge *e = user;
	e->samples += (unsigned)count;
	for (size_t i = 0; i < count; i++)
		out[i] = at[i].x > 3.3 ? e->right : e->left;
}

static const struct working_space linear = { TRANSFER_LINEAR, 1 };
static const struct edge black_white = { { 0, 0, 0, 0, 0 }, { 1, 1, 1, 0, 0 }, 0 };

/* Samples drawn for blocks `size` wide over the whole picture; the second row goes to `row`. */
static unsigned expose(int method, const struct antialias *aa, const struct working_space *working,
	struct edge edge, unsigned size, colour row[WIDTH])
{
	colour pixels[WIDTH * HEIGHT];
	struct film film = { WIDTH, HEIGHT, { 0, 0, WIDTH, HEIGHT }, pixels, NULL };
	struct sampler s;
	sampler_init(&s, sampling_of_method(method), aa, working, edge_samples, &edge);
	for (unsigned left = 0; left < WIDTH; left += size)
		sampler_take(&s, &film, (struct block){ left, 0, left + size, HEIGHT }, film.part);
	sampler_finish(&s);
	memcpy(row, pixels + WIDTH, WIDTH * sizeof *row);
	return edge.samples;
}

static void assert_greys(const colour row[WIDTH], const float expected[WIDTH])
{
	for (int i = 0; i < WIDTH; i++) {
		assert_true(row[i].r == expected[i]);
		assert_true(row[i].g == expected[i] && row[i].b == expected[i]);
	}
}

static void one_sample_per_pixel(void **state)
{
	(void)state;
	const struct antialias aa = { .threshold = 0.3 };
	colour row[WIDTH];
	assert_int_equal(expose(0, &aa, &linear, black_white, WIDTH, row), WIDTH * HEIGHT);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 0, 1, 1, 1, 1 });
}

/* Both pixels at the edge get 9 samples more; the first one keeps its weight. */
static void method_1_refines_both_sides(void **state)
{
	(void)state;
	const struct antialias aa = { .threshold = 0.3, .depth = 3, .gamma = 2.5 };
	colour row[WIDTH];
	const unsigned drawn = expose(1, &aa, &linear, black_white, WIDTH, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 3 / 10.0f, 1, 1, 1, 1 });
	/* centres, border row and column, refined pixels */
	assert_int_equal(drawn, WIDTH * HEIGHT + WIDTH + HEIGHT + 2 * HEIGHT * 9);
}

/* What is left of the block is compared with but not refined. */
static void method_1_sees_block_borders(void **state)
{
	(void)state;
	const struct antialias aa = { .threshold = 0.3, .depth = 3, .gamma = 2.5 };
	colour row[WIDTH];
	expose(1, &aa, &linear, black_white, 4, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 0, 1, 1, 1, 1 });
}

/* Cells of 1, 1/2 and 1/4 pixel at depth 3; the cell with the edge is half lit. */
static void method_2_divides_pixels(void **state)
{
	(void)state;
	struct antialias aa = { .threshold = 0.3, .depth = 3, .gamma = 2.5 };
	colour row[WIDTH];
	const unsigned drawn = expose(2, &aa, &linear, black_white, WIDTH, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 0.125f, 1, 1, 1, 1 });
	/* corners; 5 samples for the pixel, 5 and 4 for its right half, which share one */
	assert_int_equal(drawn, (WIDTH + 1) * (HEIGHT + 1) + HEIGHT * (5 + 5 + 4));
	expose(2, &aa, &linear, black_white, 4, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 0.125f, 1, 1, 1, 1 });
	aa.depth = 1;
	expose(2, &aa, &linear, black_white, WIDTH, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 0.5f, 1, 1, 1, 1 });
}

static bool refines(struct edge e, double threshold, double gamma, struct working_space working)
{
	const struct antialias aa = { .threshold = threshold, .depth = 3, .gamma = gamma };
	colour row[WIDTH];
	return expose(1, &aa, &working, e, WIDTH, row) > WIDTH * HEIGHT + WIDTH + HEIGHT;
}

/* 0.3 of linear light is 0.6178 to the eye at gamma 2.5; transmit counts as it is. */
static void colours_are_compared_as_seen(void **state)
{
	(void)state;
	const struct working_space none = { TRANSFER_NONE, 0 }, power = { TRANSFER_POWER, 2.5f };
	const struct edge red = { { 0, 0, 0, 0, 0 }, { 0.3f, 0, 0, 0, 0 }, 0 };
	assert_true(refines(red, 0.617, 2.5, linear));
	assert_false(refines(red, 0.619, 2.5, linear));
	assert_true(refines(red, 0.617, 2.5, none));
	assert_true(refines(red, 0.299, 2.5, power));
	assert_false(refines(red, 0.301, 2.5, power));
	assert_false(refines(red, 0.301, 0, linear));
	const struct edge clear = { { 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0.3f }, 0 };
	assert_true(refines(clear, 0.299, 2.5, linear));
	assert_false(refines(clear, 0.301, 2.5, linear));
	const struct edge negative = { { -1, -1, -1, 0, 0 }, { 0, 0, 0, 0, 0 }, 0 };
	assert_false(refines(negative, 0.01, 2.5, linear));
	const struct edge nan = { { NAN, NAN, NAN, 0, 0 }, { 1, 1, 1, 0, 0 }, 0 };
	assert_false(refines(nan, 0, 2.5, linear) && refines(nan, 0.1, 2.5, linear));
}

/* Averages are of the unclipped colours. */
static void bright_samples_dominate(void **state)
{
	(void)state;
	const struct antialias aa = { .threshold = 0.3, .depth = 3, .gamma = 2.5 };
	const struct edge e = { { 0, 0, 0, 0, 0 }, { 100, 100, 100, 0, 0 }, 0 };
	colour row[WIDTH];
	expose(1, &aa, &linear, e, WIDTH, row);
	assert_greys(row, (const float[WIDTH]){ 0, 0, 0, 30, 100, 100, 100, 100 });
}

/* ---- where jittered samples go ---- */

struct places {
	struct position at[64];
	size_t count;
};

static void record(void *user, size_t count, const struct position *at, colour *out)
{
	struct places *p = user;
	for (size_t i = 0; i < count; i++) {
		p->at[p->count++] = at[i];
		out[i] = (colour){ 0 };
	}
}

static void samples_are_displaced(void **state)
{
	(void)state;
	const struct antialias aa = { .threshold = 0, .depth = 2, .jitter = 0.5, .gamma = 2.5 };
	struct places p = { .count = 0 };
	colour pixels[12];
	struct film film = { 4, 3, { 0, 0, 4, 3 }, pixels, NULL };
	struct sampler s;
	sampler_init(&s, sampling_of_method(1), &aa, &linear, record, &p);
	sampler_take(&s, &film, (struct block){ 3, 2, 4, 3 }, film.part);
	sampler_finish(&s);
	assert_int_equal(p.count, 2 + 1 + 4); /* border, centre, four more */
	for (int i = 0; i < 4; i++) {
		const double x = 3 + (i % 2 ? 0.25 : -0.25), y = 2 + (i / 2 ? 0.25 : -0.25);
		const struct position j = sample_jitter((struct position){ .x = x, .y = y });
		assert_true(fabs(p.at[3 + i].x - (x + j.x * 0.25)) < 1e-12);
		assert_true(fabs(p.at[3 + i].y - (y + j.y * 0.25)) < 1e-12);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(hash_follows_its_formula),
		cmocka_unit_test(jitter_follows_its_formula),
		cmocka_unit_test(jitter_reference_values),
		cmocka_unit_test(one_sample_per_pixel),
		cmocka_unit_test(method_1_refines_both_sides),
		cmocka_unit_test(method_1_sees_block_borders),
		cmocka_unit_test(method_2_divides_pixels),
		cmocka_unit_test(colours_are_compared_as_seen),
		cmocka_unit_test(bright_samples_dominate),
		cmocka_unit_test(samples_are_displaced),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
