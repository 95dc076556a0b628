/* SPDX-License-Identifier: MIT */
/*
 * Antialiasing as the language defines it, method 1: traces pixel centres and
 * gives a pixel that differs from its left or upper neighbour, and that neighbour,
 * depth x depth more samples. A block also draws the row above it and the column
 * left of it, for comparison only.
 */
#include "contrast.h"

#include "base/arena.h"

#include <stdlib.h>

struct neighbours {
	struct contrast contrast;
	struct sample_room room;
	int depth;
	double jitter;	     /* displacement at most, in pixels */
	struct position *at; /* depth x depth samples */
	colour *seen;
};

static void neighbours_init(
	void *self, const struct antialias *settings, const struct working_space *working)
{
	struct neighbours *m = self;
	const size_t depth = (size_t)settings->depth;
	m->depth = settings->depth;
	m->jitter = settings->jitter / settings->depth;
	m->at = memory_alloc(depth * depth, sizeof *m->at);
	m->seen = memory_alloc(depth * depth, sizeof *m->seen);
	contrast_init(&m->contrast, settings, working);
}

static void neighbours_finish(void *self)
{
	struct neighbours *m = self;
	free(m->room.samples);
	free(m->at);
	free(m->seen);
}

/* depth x depth samples and the first one, all of the same weight. */
static void supersample(const struct neighbours *m, const struct sampler *s, struct sample *pixel,
	double x, double y)
{
	const int n = m->depth;
	const double step = 1.0 / n;
	size_t count = 0;
	struct sample_place place = { (int32_t)x, (int32_t)y, 0 };
	double oy = -0.5 + 0.5 * step;
	for (int i = 0; i < n; i++, oy += step) {
		double ox = -0.5 + 0.5 * step;
		for (int j = 0; j < n; j++, ox += step) {
			place.index++;
			m->at[count++] = sample_displaced(
				(struct position){ x + ox, y + oy, place }, m->jitter);
		}
	}
	s->source(s->user, count, m->at, m->seen);
	colour sum = pixel->colour;
	for (size_t i = 0; i < count; i++)
		sum = colour_sum(sum, m->seen[i]);
	*pixel = contrast_sample(&m->contrast, colour_share(sum, (float)(n * n + 1)));
	pixel->fine = true;
}

/* Compares a new pixel with its neighbours and refines what differs: left, up, then itself. */
static void refine(const struct neighbours *m, const struct sampler *s, struct sample *here,
	size_t stride, double x, double y)
{
	struct sample *left = here - 1, *up = here - stride;
	const bool left_differs = contrast_differs(&m->contrast, left, here);
	const bool up_differs = contrast_differs(&m->contrast, up, here);
	if (left_differs && !left->fine)
		supersample(m, s, left, x - 1, y);
	if (up_differs && !up->fine)
		supersample(m, s, up, x, y - 1);
	if (left_differs || up_differs)
		supersample(m, s, here, x, y);
}

static void draw_border(
	const struct neighbours *m, const struct sampler *s, struct block b, size_t stride)
{
	struct sample *samples = m->room.samples;
	contrast_row(&m->contrast, s, (int32_t)b.left, (int32_t)b.top - 1, 0, b.right - b.left,
		samples + 1);
	for (unsigned x = b.left; x < b.right; x++)
		samples[1 + x - b.left].fine = true;
	for (unsigned y = b.top; y < b.bottom; y++) {
		struct sample *border = &samples[(1 + y - b.top) * stride];
		contrast_row(&m->contrast, s, (int32_t)b.left - 1, (int32_t)y, 0, 1, border);
		border->fine = true;
	}
}

static void store(const struct neighbours *m, struct film *film, struct block b, struct block inner)
{
	const size_t stride = 1 + b.right - b.left;
	for (unsigned y = inner.top; y < inner.bottom; y++) {
		const struct sample *row = &m->room.samples[(1 + y - b.top) * stride + 1];
		for (unsigned x = inner.left; x < inner.right; x++)
			*film_pixel(film, x, y) = row[x - b.left].colour;
	}
}

/* What the pixels of `inner` depend on within their block: all that is drawn before them, because
 * each comparison sees what earlier ones have made of the neighbours, and the next column and row,
 * which may refine them. */
static struct block context_of(struct block inner, struct block b)
{
	if (inner.right < b.right)
		b.right = inner.right + 1;
	if (inner.bottom < b.bottom)
		b.bottom = inner.bottom + 1;
	return b;
}

static void neighbours_take(
	void *self, struct sampler *s, struct film *film, struct block block, struct block inner)
{
	struct neighbours *m = self;
	const struct block b = context_of(inner, block);
	const size_t width = b.right - b.left, stride = 1 + width;
	struct sample *samples = sample_room_for(&m->room, b);
	draw_border(m, s, b, stride);
	for (unsigned y = b.top; y < b.bottom; y++) {
		if (sampler_is_cancelled(s))
			return;
		struct sample *row = &samples[(1 + y - b.top) * stride + 1];
		contrast_row(&m->contrast, s, (int32_t)b.left, (int32_t)y, 0, width, row);
		for (unsigned x = b.left; x < b.right; x++)
			refine(m, s, &row[x - b.left], stride, x, y);
	}
	store(m, film, b, inner);
}

const struct sampling_class sampling_neighbours = {
	.name = "neighbours",
	.size = sizeof(struct neighbours),
	.init = neighbours_init,
	.finish = neighbours_finish,
	.take = neighbours_take,
};
