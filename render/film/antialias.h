/* SPDX-License-Identifier: MIT */
/*
 * From samples to the pixels of one block, with or without antialiasing.
 */
#ifndef LAMBERT_FILM_ANTIALIAS_H
#define LAMBERT_FILM_ANTIALIAS_H

#include "base/power_curve.h"
#include "film/film.h"

#include <stdint.h>

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
	size_t room;		   /* for so many */
	struct sample *grid;	   /* method 2: of the pixel in hand */
	uint32_t *drawn;	   /* the pixel a sample of the grid was drawn for */
	uint32_t pixel;		   /* counts pixels */
	struct sample_place place; /* method 2: of the last sample drawn in that pixel */
};

void sampler_init(struct sampler *, const struct antialias *, const struct working_space *,
	sample_source *, void *user);
void sampler_finish(struct sampler *);
/* Fills the pixels of the block that lie in the region, reading no others of the film: blocks do not
 * depend on each other, and what a pixel becomes does not depend on the region. A cancelled block is
 * left unfinished. */
void sampler_block(struct sampler *, struct film *, struct block, struct block region);

/* The displacement of the sample at (x, y), each component in [-1/2, 1/2). Pixel units: integers
 * are pixel centres, (0, 0) is the top left pixel of the whole picture. */
void sample_jitter(double x, double y, double out[2]);

#endif
