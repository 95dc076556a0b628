/* SPDX-License-Identifier: MIT */
/*
 * The film: the float pixels of a picture or of a part of it, and the loop that
 * exposes it: 32 x 32 blocks over threads, each pixel with as many samples as
 * antialiasing asks for. One block has one owner; nothing depends on the order of
 * completion.
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

struct film {
	unsigned width, height; /* of the picture */
	struct block part;	/* of it that is kept; the rest is black */
	colour *pixels; /* of the part, row-major from its top left; working space, premultiplied, transmit = 1 - alpha */
};

/* Where the film keeps the pixel (x, y) of the picture, which lies in its part. */
static inline colour *film_pixel(const struct film *film, unsigned x, unsigned y)
{
	const struct block *p = &film->part;
	return &film->pixels[(size_t)(y - p->top) * (p->right - p->left) + (x - p->left)];
}

struct antialias {
	int method;	  /* 0 none, 1 non-recursive, 2 recursive */
	double threshold; /* 0 to 1 */
	int depth;	  /* 1 to 9 */
	double jitter;	  /* 0 to 1; 0: none */
	double gamma;	  /* of the comparison, 2.5 */
};

struct exposure {
	struct antialias antialias;
	struct block region; /* within the film's part */
	unsigned block_size; /* 32 */
	unsigned threads;    /* at least 1 */
	/* Called after each block, and between the rows of slow ones, from one thread at a time;
	 * false: stop. May be NULL. */
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
