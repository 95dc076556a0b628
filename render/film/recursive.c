/* SPDX-License-Identifier: MIT */
/*
 * Antialiasing as the language defines it, method 2: traces pixel corners and cuts
 * the pixel in four wherever corners differ.
 */
#include "contrast.h"

#include "base/arena.h"

#include <math.h>
#include <stdlib.h>

struct recursive {
	struct contrast contrast;
	struct sample_room corners; /* of the pixels of a block */
	double jitter;		    /* displacement at most, in pixels */
	unsigned size;		    /* of a pixel, in smallest cells */
	struct sample *grid;	    /* on the corners of the cells of the pixel in hand */
	uint32_t *drawn;	    /* the pixel a sample of the grid was drawn for */
	uint32_t pixel;		    /* counts pixels */
	struct sample_place place;  /* of the last sample drawn in that pixel */
};

static void recursive_init(
	void *self, const struct antialias *settings, const struct working_space *working)
{
	struct recursive *m = self;
	m->size = 1u << (settings->depth - 1);
	m->jitter = settings->jitter / (ldexp(1, settings->depth) + 1);
	contrast_init(&m->contrast, settings, working);
	const size_t side = m->size + 1;
	m->grid = memory_alloc(side * side, sizeof *m->grid);
	m->drawn = memory_zeroed(side * side, sizeof *m->drawn);
}

static void recursive_finish(void *self)
{
	struct recursive *m = self;
	free(m->corners.samples);
	free(m->grid);
	free(m->drawn);
}

/* Of the pixel in hand. */
struct cell {
	double left, top;    /* of the pixel */
	unsigned x, y, size; /* of the cell, in smallest cells */
};

static const struct sample *grid_sample(
	struct recursive *m, const struct sampler *s, const struct cell *c, unsigned x, unsigned y)
{
	const size_t at = (size_t)y * (m->size + 1) + x;
	if (m->drawn[at] != m->pixel) {
		const double step = 1.0 / m->size;
		m->place.index++;
		const struct position p = sample_displaced(
			(struct position){ c->left + x * step, c->top + y * step, m->place },
			m->jitter);
		colour seen;
		s->source(s->user, 1, &p, &seen);
		m->drawn[at] = m->pixel;
		m->grid[at] = contrast_sample(&m->contrast, seen);
	}
	return &m->grid[at];
}

static bool is_uneven(const struct recursive *m, const struct sample *const corners[4])
{
	for (int i = 0; i < 4; i++) {
		for (int j = i + 1; j < 4; j++) {
			if (contrast_differs(&m->contrast, corners[i], corners[j]))
				return true;
		}
	}
	return false;
}

static colour subdivide(struct recursive *m, const struct sampler *s, const struct cell *c)
{
	const unsigned end_x = c->x + c->size, end_y = c->y + c->size, half = c->size / 2;
	/* upper left, lower left, upper right, lower right */
	const struct sample *const corners[4] = { grid_sample(m, s, c, c->x, c->y),
		grid_sample(m, s, c, c->x, end_y), grid_sample(m, s, c, end_x, c->y),
		grid_sample(m, s, c, end_x, end_y) };
	const bool uneven = c->size > 1 && is_uneven(m, corners);
	colour sum = { 0 };
	for (unsigned i = 0; i < 4; i++) {
		const struct cell quarter = { c->left, c->top, c->x + i / 2 * half,
			c->y + i % 2 * half, half };
		const colour part = uneven ? subdivide(m, s, &quarter) : corners[i]->colour;
		sum = i == 0 ? part : colour_sum(sum, part);
	}
	return colour_share(sum, 4);
}

/* A pixel from its corners, which its neighbours in the block share. */
static colour pixel_from_corners(struct recursive *m, const struct sampler *s,
	const struct sample *upper, const struct sample *lower, double x, double y)
{
	const unsigned size = m->size;
	const struct cell whole = { x - 0.5, y - 0.5, 0, 0, size };
	const size_t at[4] = { 0, size, (size_t)size * (size + 1),
		(size_t)size * (size + 1) + size };
	const struct sample *const corners[4] = { upper, upper + 1, lower, lower + 1 };
	m->pixel++;
	m->place = (struct sample_place){ (int32_t)x, (int32_t)y, 0 };
	for (int i = 0; i < 4; i++) {
		m->grid[at[i]] = *corners[i];
		m->drawn[at[i]] = m->pixel;
	}
	return subdivide(m, s, &whole);
}

static void recursive_take(
	void *self, struct sampler *s, struct film *film, struct block block, struct block b)
{
	struct recursive *m = self;
	const size_t stride = 1 + b.right - b.left;
	struct sample *samples = sample_room_for(&m->corners, b);
	(void)block;
	for (unsigned y = b.top; y <= b.bottom; y++)
		contrast_row(&m->contrast, s, (int32_t)b.left, (int32_t)y, -0.5, stride,
			&samples[(y - b.top) * stride]);
	for (unsigned y = b.top; y < b.bottom; y++) {
		if (sampler_is_cancelled(s))
			return;
		const struct sample *upper = &samples[(y - b.top) * stride];
		for (unsigned x = b.left; x < b.right; x++, upper++)
			*film_pixel(film, x, y) =
				pixel_from_corners(m, s, upper, upper + stride, x, y);
	}
}

const struct sampling_class sampling_recursive = {
	.name = "recursive",
	.size = sizeof(struct recursive),
	.init = recursive_init,
	.finish = recursive_finish,
	.take = recursive_take,
};
