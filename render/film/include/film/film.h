/* SPDX-License-Identifier: MIT */
/*
 * The film: a picture of float pixels, and the loop that exposes it: 32 x 32
 * blocks over threads, each pixel with as many samples as antialiasing
 * asks for. One block has one owner; nothing depends on the order of completion.
 */
#ifndef LAMBERT_FILM_FILM_H
#define LAMBERT_FILM_FILM_H

#include "scene/scene.h"
#include "integrate/trace.h"

#include <stdbool.h>

struct film {
	unsigned width, height;
	colour *pixels; /* row-major from the top left; working space, premultiplied, transmit = 1 - alpha */
};

struct antialias {
	int method;	  /* 0 none, 1 non-recursive, 2 recursive */
	double threshold; /* 0 to 1 */
	int depth;	  /* 1 to 9 */
	double jitter;	  /* 0 to 1; 0: none */
	double gamma;	  /* of the comparison, 2.5 */
};

struct exposure {
	struct antialias antialias;
	unsigned left, top, right, bottom; /* region: first and one past the last pixel */
	unsigned block_size;		   /* 32 */
	unsigned threads;		   /* at least 1 */
	/* Called after each block, and between the rows of slow ones, from one thread at a time;
	 * false: stop. May be NULL. */
	bool (*progress)(void *user, unsigned blocks_done, unsigned blocks);
	void *user;
};

struct film *film_create(unsigned width, unsigned height);
void film_destroy(struct film *);
/* False: stopped by `progress`. Adds to *stats when it is not NULL. */
bool film_expose(
	struct film *, const struct scene *, const struct exposure *, struct trace_stats *stats);

#endif
