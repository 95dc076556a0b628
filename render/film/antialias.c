/* SPDX-License-Identifier: MIT */
/*
 * Antialiasing as the language defines it: adaptive, by the difference of
 * neighbouring samples, in two methods.
 *
 * Method 1 traces pixel centres and gives a pixel that differs from its left or
 * upper neighbour, and that neighbour, depth x depth more samples. Method 2
 * traces pixel corners and cuts the pixel in four wherever corners differ.
 *
 * Samples are compared after a power law near the eye's, but averaged as they
 * are, unclipped. The displacement of a sample is a function of its place
 * alone, so the picture does not depend on the order of work.
 */
#include "antialias.h"

#include "base/arena.h"
#include "noise/tables.h"

#include <stdlib.h>

/* Exponents this near to one are one, as in the reference. */
#define EXPONENT_ONE 0.01

/* ---- samples ---- */

static float srgb_decode(const struct sampler *s, float x)
{
	return x < 0.04045f ? x / 12.92f : power_curve_at(&s->srgb, (x + 0.055f) / 1.055f);
}

static float encode(const struct sampler *s, float x)
{
	if (s->decodes_srgb)
		x = srgb_decode(s, x);
	return power_curve_at(&s->gamma, x < 0 ? 0 : x); /* NaN stays, and compares as equal */
}

static struct sample sample_of(const struct sampler *s, colour c)
{
	struct sample out = { .colour = c, .code = { c.r, c.g, c.b } };
	if (s->encodes) {
		for (int k = 0; k < 3; k++)
			out.code[k] = encode(s, out.code[k]);
	}
	return out;
}

/* The first sample of a pixel: its centre, moved both ways by `shift`. */
static struct sample draw(struct sampler *s, int32_t x, int32_t y, double shift)
{
	return sample_of(
		s, s->source(s->user, x + shift, y + shift, (struct sample_place){ x, y, 0 }));
}

/* Truncates toward zero; positions are a few pixels outside a picture at most. */
static uint32_t lattice(double v)
{
	return (uint32_t)(int32_t)v;
}

static double jitter_entry(uint32_t column, uint32_t row)
{
	const uint32_t cell = hash_table[column & 4095] ^ row;
	return (double)jitter_table[hash_table[cell & 4095] & 255];
}

void sample_jitter(double x, double y, double out[2])
{
	out[0] = jitter_entry(lattice(1021 * x), lattice(1019 * y));
	out[1] = jitter_entry(lattice(1019 * x), lattice(1021 * y));
}

/* The sample that belongs to (x, y), drawn at a displaced position. */
static colour trace_jittered(struct sampler *s, double x, double y, struct sample_place place)
{
	if (s->jitter > 0) {
		double by[2];
		sample_jitter(x, y, by);
		return s->source(s->user, x + by[0] * s->jitter, y + by[1] * s->jitter, place);
	}
	return s->source(s->user, x, y, place);
}

/* NaN counts as equal. */
static bool differ(const struct sampler *s, const struct sample *a, const struct sample *b)
{
	const float distance = fabsf(a->code[0] - b->code[0]) + fabsf(a->code[1] - b->code[1]) +
			       fabsf(a->code[2] - b->code[2]) +
			       fabsf(a->colour.transmit - b->colour.transmit);
	return (double)distance >= s->settings.threshold;
}

static colour add(colour a, colour b)
{
	return (colour){ a.r + b.r, a.g + b.g, a.b + b.b, a.filter + b.filter,
		a.transmit + b.transmit };
}

static colour divide(colour c, float by)
{
	return (colour){ c.r / by, c.g / by, c.b / by, c.filter / by, c.transmit / by };
}

/* ---- blocks row by row ---- */

/* For the samples of a block and one more in each direction. */
static void make_room(struct sampler *s, struct block b)
{
	const size_t count = (size_t)(1 + b.right - b.left) * (1 + b.bottom - b.top);
	if (count <= s->room)
		return;
	free(s->samples);
	s->samples = memory_alloc(count, sizeof *s->samples);
	s->room = count;
}

static bool is_cancelled(const struct sampler *s)
{
	return s->cancelled && s->cancelled(s->cancelled_user);
}

static void block_plain(struct sampler *s, struct film *film, struct block b)
{
	for (unsigned y = b.top; y < b.bottom && !is_cancelled(s); y++) {
		for (unsigned x = b.left; x < b.right; x++)
			*film_pixel(film, x, y) = s->source(
				s->user, x, y, (struct sample_place){ (int32_t)x, (int32_t)y, 0 });
	}
}

/* ---- method 1 ---- */

/* depth x depth samples and the first one, all of the same weight. */
static void supersample(struct sampler *s, struct sample *pixel, double x, double y)
{
	const int n = s->settings.depth;
	const double step = 1.0 / n;
	colour sum = pixel->colour;
	struct sample_place place = { (int32_t)x, (int32_t)y, 0 };
	double oy = -0.5 + 0.5 * step;
	for (int i = 0; i < n; i++, oy += step) {
		double ox = -0.5 + 0.5 * step;
		for (int j = 0; j < n; j++, ox += step) {
			place.index++;
			sum = add(sum, trace_jittered(s, x + ox, y + oy, place));
		}
	}
	*pixel = sample_of(s, divide(sum, (float)(n * n + 1)));
	pixel->fine = true;
}

/* Compares a new pixel with its neighbours and refines what differs: left, up, then itself. */
static void refine(struct sampler *s, struct sample *here, size_t stride, double x, double y)
{
	struct sample *left = here - 1, *up = here - stride;
	const bool left_differs = differ(s, left, here), up_differs = differ(s, up, here);
	if (left_differs && !left->fine)
		supersample(s, left, x - 1, y);
	if (up_differs && !up->fine)
		supersample(s, up, x, y - 1);
	if (left_differs || up_differs)
		supersample(s, here, x, y);
}

/* The row above the block and the column left of it serve for comparison only. */
static void draw_border(struct sampler *s, struct block b, size_t stride)
{
	for (unsigned x = b.left; x < b.right; x++) {
		struct sample *border = &s->samples[1 + x - b.left];
		*border = draw(s, (int32_t)x, (int32_t)b.top - 1, 0);
		border->fine = true;
	}
	for (unsigned y = b.top; y < b.bottom; y++) {
		struct sample *border = &s->samples[(1 + y - b.top) * stride];
		*border = draw(s, (int32_t)b.left - 1, (int32_t)y, 0);
		border->fine = true;
	}
}

static void store_flat(
	const struct sampler *s, struct film *film, struct block b, struct block inner)
{
	const size_t stride = 1 + b.right - b.left;
	for (unsigned y = inner.top; y < inner.bottom; y++) {
		const struct sample *row = &s->samples[(1 + y - b.top) * stride + 1];
		for (unsigned x = inner.left; x < inner.right; x++)
			*film_pixel(film, x, y) = row[x - b.left].colour;
	}
}

/* What the pixels of `inner` depend on within their block: all that is drawn before them, because
 * each comparison sees what earlier ones have made of the neighbours, and the next column and row,
 * which may refine them. */
static struct block reach(struct block b, struct block inner)
{
	if (inner.right < b.right)
		b.right = inner.right + 1;
	if (inner.bottom < b.bottom)
		b.bottom = inner.bottom + 1;
	return b;
}

static void block_flat(struct sampler *s, struct film *film, struct block whole, struct block inner)
{
	const struct block b = reach(whole, inner);
	const size_t stride = 1 + b.right - b.left;
	make_room(s, b);
	draw_border(s, b, stride);
	for (unsigned y = b.top; y < b.bottom; y++) {
		if (is_cancelled(s))
			return;
		struct sample *row = &s->samples[(1 + y - b.top) * stride + 1];
		for (unsigned x = b.left; x < b.right; x++) {
			row[x - b.left] = draw(s, (int32_t)x, (int32_t)y, 0);
			refine(s, &row[x - b.left], stride, x, y);
		}
	}
	store_flat(s, film, b, inner);
}

/* ---- method 2 ---- */

/* The pixel in hand: `size` cells a side, samples on all corners of cells. */
struct cell {
	double left, top;    /* of the pixel */
	unsigned x, y, size; /* of the cell, in smallest cells */
};

static unsigned grid_side(const struct sampler *s)
{
	return (1u << (s->settings.depth - 1)) + 1;
}

static const struct sample *grid_sample(
	struct sampler *s, const struct cell *c, unsigned x, unsigned y)
{
	const unsigned side = grid_side(s);
	const size_t at = (size_t)y * side + x;
	if (s->drawn[at] != s->pixel) {
		const double step = 1.0 / (side - 1);
		s->drawn[at] = s->pixel;
		s->place.index++;
		s->grid[at] = sample_of(
			s, trace_jittered(s, c->left + x * step, c->top + y * step, s->place));
	}
	return &s->grid[at];
}

static colour subdivide(struct sampler *s, const struct cell *c)
{
	const unsigned end_x = c->x + c->size, end_y = c->y + c->size;
	/* upper left, lower left, upper right, lower right */
	const struct sample *const corners[4] = { grid_sample(s, c, c->x, c->y),
		grid_sample(s, c, c->x, end_y), grid_sample(s, c, end_x, c->y),
		grid_sample(s, c, end_x, end_y) };
	bool uneven = false;
	for (int i = 0; i < 4 && c->size > 1; i++) {
		for (int j = i + 1; j < 4; j++)
			uneven = uneven || differ(s, corners[i], corners[j]);
	}
	colour sum = { 0 };
	for (unsigned i = 0; i < 4; i++) {
		const unsigned half = c->size / 2;
		const struct cell quarter = { c->left, c->top, c->x + i / 2 * half,
			c->y + i % 2 * half, half };
		const colour part = uneven ? subdivide(s, &quarter) : corners[i]->colour;
		sum = i == 0 ? part : add(sum, part);
	}
	return divide(sum, 4);
}

/* A pixel from its corners, which its neighbours in the block share. */
static colour pixel_from_corners(struct sampler *s, const struct sample *upper,
	const struct sample *lower, double x, double y)
{
	const unsigned size = grid_side(s) - 1;
	const struct cell whole = { x - 0.5, y - 0.5, 0, 0, size };
	const size_t at[4] = { 0, size, (size_t)size * (size + 1),
		(size_t)size * (size + 1) + size };
	const struct sample *const corners[4] = { upper, upper + 1, lower, lower + 1 };
	s->pixel++;
	s->place = (struct sample_place){ (int32_t)x, (int32_t)y, 0 };
	for (int i = 0; i < 4; i++) {
		s->grid[at[i]] = *corners[i];
		s->drawn[at[i]] = s->pixel;
	}
	return subdivide(s, &whole);
}

static void block_recursive(struct sampler *s, struct film *film, struct block b)
{
	const size_t stride = 1 + b.right - b.left;
	make_room(s, b);
	for (unsigned y = b.top; y <= b.bottom; y++) {
		for (unsigned x = b.left; x <= b.right; x++)
			s->samples[(y - b.top) * stride + x - b.left] =
				draw(s, (int32_t)x, (int32_t)y, -0.5);
	}
	for (unsigned y = b.top; y < b.bottom; y++) {
		if (is_cancelled(s))
			return;
		const struct sample *upper = &s->samples[(y - b.top) * stride];
		for (unsigned x = b.left; x < b.right; x++, upper++)
			*film_pixel(film, x, y) =
				pixel_from_corners(s, upper, upper + stride, x, y);
	}
}

/* ---- blocks ---- */

/* How comparisons see colours: linear light to the power of 1 / gamma. */
static void set_metric(struct sampler *s, const struct working_space *working)
{
	const double gamma = s->settings.gamma;
	if (!(gamma > 0))
		return;
	const bool power = working->transfer == TRANSFER_POWER;
	const double exponent = (power ? (double)working->gamma : 1) / gamma;
	s->decodes_srgb = working->transfer == TRANSFER_SRGB;
	s->encodes = s->decodes_srgb || fabs(1 - exponent) > EXPONENT_ONE;
	if (s->decodes_srgb)
		power_curve_init(&s->srgb, 2.4f);
	if (s->encodes)
		power_curve_init(&s->gamma, (float)exponent);
}

void sampler_init(struct sampler *s, const struct antialias *settings,
	const struct working_space *working, sample_source *source, void *user)
{
	*s = (struct sampler){ .source = source, .user = user, .settings = *settings };
	if (settings->method == 0)
		return;
	const double depth = settings->depth;
	set_metric(s, working);
	s->jitter =
		settings->jitter / (settings->method == 1 ? depth : ldexp(1, settings->depth) + 1);
	if (settings->method == 2) {
		const size_t side = grid_side(s);
		s->grid = memory_alloc(side * side, sizeof *s->grid);
		s->drawn = memory_alloc(side * side, sizeof *s->drawn);
		for (size_t i = 0; i < side * side; i++)
			s->drawn[i] = 0;
	}
}

void sampler_finish(struct sampler *s)
{
	free(s->samples);
	free(s->grid);
	free(s->drawn);
}

static unsigned larger(unsigned a, unsigned b)
{
	return a > b ? a : b;
}

static unsigned smaller(unsigned a, unsigned b)
{
	return a < b ? a : b;
}

static struct block common(struct block a, struct block b)
{
	return (struct block){ larger(a.left, b.left), larger(a.top, b.top),
		smaller(a.right, b.right), smaller(a.bottom, b.bottom) };
}

void sampler_block(struct sampler *s, struct film *film, struct block b, struct block region)
{
	const struct block inner = common(b, region);
	switch (s->settings.method) {
	case 1:
		block_flat(s, film, b, inner);
		break;
	case 2:
		block_recursive(s, film, inner);
		break;
	default:
		block_plain(s, film, inner);
	}
}
