/* SPDX-License-Identifier: MIT */
/*
 * The film: the float pixels of a picture or of a part of it, and the loop that
 * exposes it: 32 x 32 blocks over threads, each pixel with as many samples as a
 * strategy of sampling asks for. One block has one owner; nothing depends on the
 * order of completion.
 */
#ifndef LAMBERT_FILM_FILM_H
#define LAMBERT_FILM_FILM_H

#include "scene/scene.h"
#include "integrate/trace.h"

#include <stdbool.h>

/* First and one past the last pixel. */
struct block {
	unsigned left, top, right, bottom;
};

static inline struct block block_common(struct block a, struct block b)
{
	return (struct block){ a.left > b.left ? a.left : b.left, a.top > b.top ? a.top : b.top,
		a.right < b.right ? a.right : b.right, a.bottom < b.bottom ? a.bottom : b.bottom };
}

struct film {
	unsigned width, height; /* of the picture */
	struct block part;	/* of it that is kept; the rest is black */
	colour *pixels; /* of the part, row-major from its top left; working space, premultiplied, transmit = 1 - alpha */
	struct film_sums *sums; /* NULL: the strategy needs none; see sums.h */
};

/* Where the film keeps the pixel (x, y) of the picture, which lies in its part. */
static inline colour *film_pixel(const struct film *film, unsigned x, unsigned y)
{
	const struct block *p = &film->part;
	return &film->pixels[(size_t)(y - p->top) * (p->right - p->left) + (x - p->left)];
}

/* A strategy of sampling; see sampling.h. */
struct sampling_class;
/* 0 no antialiasing, 1 non-recursive, 2 recursive. */
const struct sampling_class *sampling_of_method(int method);

struct antialias {
	double threshold; /* 0 to 1 */
	int depth;	  /* 1 to 9 */
	double jitter;	  /* 0 to 1; 0: none */
	double gamma;	  /* of the comparison, 2.5 */
};

struct exposure {
	const struct sampling_class *sampling;
	struct antialias antialias;
	struct block region; /* within the film's part */
	unsigned block_size; /* 32 */
	unsigned threads;    /* at least 1 */
	/* Called after each block, and between the rows of slow ones, from one thread at a time;
	 * false: stop. Blocks count once for each pass that the strategy may make. May be NULL. */
	bool (*progress)(void *user, unsigned blocks_done, unsigned blocks);
	void *user;
};

/* Black films: for a whole picture, for a part of one. */
struct film *film_create(unsigned width, unsigned height);
struct film *film_create_part(unsigned width, unsigned height, struct block part);
void film_destroy(struct film *);
/* False: stopped by `progress`. Adds to *stats when it is not NULL. */
bool film_expose(
	struct film *, const struct scene *, const struct exposure *, struct trace_stats *stats);

#endif
