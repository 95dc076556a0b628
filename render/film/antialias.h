/* SPDX-License-Identifier: MIT */
/*
 * From samples to the pixels of one block, with or without antialiasing.
 */
#ifndef LAMBERT_FILM_ANTIALIAS_H
#define LAMBERT_FILM_ANTIALIAS_H

#include "base/power_curve.h"
#include "film/film.h"

#include <stdint.h>

/* First and one past the last pixel. */
struct block {
	unsigned left, top, right, bottom;
};

/* A sample and what comparisons see of it. */
struct sample {
	colour colour;
	float code[3];
	bool fine; /* method 1: has been supersampled */
};

/* The colour at (x, y) in pixel units, as trace_sample gives it. */
typedef colour sample_source(void *user, double x, double y, struct sample_place);

/* One thread's sampling of blocks. */
struct sampler {
	sample_source *source;
	void *user;
	bool (*cancelled)(void *); /* asked for each row of pixels; NULL: never */
	void *cancelled_user;
	struct antialias settings;
	bool encodes, decodes_srgb; /* how comparisons see colours */
	struct power_curve srgb, gamma;
	double jitter;		   /* displacement at most, in pixels */
	struct sample *samples;	   /* of the block: pixel centres or corners, and a border */
	struct sample *grid;	   /* method 2: of the pixel in hand */
	uint32_t *drawn;	   /* the pixel a sample of the grid was drawn for */
	uint32_t pixel;		   /* counts pixels */
	struct sample_place place; /* method 2: of the last sample drawn in that pixel */
};

/* A sampler for blocks of at most block_size pixels a side. */
void sampler_init(struct sampler *, const struct antialias *, const struct working_space *,
	unsigned block_size, sample_source *, void *user);
void sampler_finish(struct sampler *);
/* Fills the pixels of the block, reading no others: blocks do not depend on each other. A
 * cancelled block is left unfinished. */
void sampler_block(struct sampler *, struct film *, struct block);

/* The displacement of the sample at (x, y), each component in [-1/2, 1/2). Pixel units: integers
 * are pixel centres, (0, 0) is the top left pixel of the whole picture. */
void sample_jitter(double x, double y, double out[2]);

#endif
