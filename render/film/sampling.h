/* SPDX-License-Identifier: MIT */
/*
 * Which samples a picture takes: a strategy is a struct sampling_class, one file
 * each. It works block by block and, if it likes, in several passes: what it
 * decides in one pass it decides from passes that are finished, so nothing depends
 * on threads or on the order of blocks.
 *
 * Strategies ask for many samples in one call. That is the door for rays that are
 * traced together.
 */
#ifndef LAMBERT_FILM_SAMPLING_H
#define LAMBERT_FILM_SAMPLING_H

#include "film/film.h"

#include <stddef.h>
#include <stdint.h>

/* In pixel units: integers are pixel centres, (0, 0) is the top left pixel of the whole picture. */
struct position {
	double x, y;
	struct sample_place place; /* names the sample, for its random numbers */
};

/* Fills in the colours at `count` positions, as trace_sample gives them. */
typedef void sample_source(void *user, size_t count, const struct position *, colour *);

/* One thread's sampling of blocks. */
struct sampler {
	const struct sampling_class *strategy;
	void *self; /* the strategy's */
	sample_source *source;
	void *user;
	bool (*cancelled)(void *); /* asked for each row of pixels; NULL: never */
	void *cancelled_user;
};

struct sampling_class {
	const char *name;
	size_t size; /* of its memory, one for each thread */
	/* NULL: it needs none. */
	void (*init)(void *self, const struct antialias *, const struct working_space *);
	void (*finish)(void *self);
	/* Takes the samples of a pass for the pixels `inner` of a block, and writes to no others. */
	void (*take)(void *self, struct sampler *, struct film *, struct block, struct block inner);

	/* How many samples the pixel (x, y) wants in this pass. It may look at all sums: they are what
	 * earlier passes have left. `take` finds the answer in the pixel's sum and adds its samples
	 * there, and the next pass begins, until no pixel wants any more.
	 * NULL: there is one pass, `take` writes colours, and the film keeps no sums. */
	uint32_t (*wanted)(
		const void *self, const struct film_sums *, unsigned pass, unsigned x, unsigned y);
	unsigned passes; /* with `wanted`: at most so many */
	unsigned reach;	 /* with `wanted`: how far away, in pixels, are the sums it looks at */
};

extern const struct sampling_class sampling_plain, sampling_neighbours, sampling_recursive;

void sampler_init(struct sampler *, const struct sampling_class *, const struct antialias *,
	const struct working_space *, sample_source *, void *user);
void sampler_finish(struct sampler *);
/* Before a pass: finds out what the pixels of the block want, and adds it up. */
uint64_t sampler_plan(
	const struct sampler *, struct film *, unsigned pass, struct block, struct block region);
/* Takes the samples of a pass for the pixels of the block that lie in the region. What a pixel
 * becomes does not depend on the region. A cancelled block is left unfinished. */
void sampler_take(struct sampler *, struct film *, struct block, struct block region);

/* ---- for strategies ---- */

/* The first samples of `count` pixels from (x, y) on to the right, at their centres moved both ways by
 * `shift`. */
void sampler_row(
	const struct sampler *, int32_t x, int32_t y, double shift, size_t count, colour *);

static inline bool sampler_is_cancelled(const struct sampler *s)
{
	return s->cancelled && s->cancelled(s->cancelled_user);
}

/* The displacement of the sample at a position, each component in [-1/2, 1/2). It is a function of
 * the place alone. */
struct position sample_jitter(struct position);
/* The position displaced by so many pixels at most in each direction. */
static inline struct position sample_displaced(struct position p, double by)
{
	if (!(by > 0))
		return p;
	const struct position jitter = sample_jitter(p);
	return (struct position){ p.x + jitter.x * by, p.y + jitter.y * by, p.place };
}

#endif
