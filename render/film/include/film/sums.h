/* SPDX-License-Identifier: MIT */
/*
 * The film as an accumulator: sum, sum of squares and count of the samples of each
 * pixel, for strategies of sampling that ask how certain a pixel is. The order of
 * additions is that of the samples of one pixel, so sums are the same for any
 * number of threads.
 */
#ifndef LAMBERT_FILM_SUMS_H
#define LAMBERT_FILM_SUMS_H

#include "film/film.h"

#include <stdint.h>

/* Red, green, blue, transmit. */
enum { SUM_CHANNELS = 4 };

struct pixel_sum {
	double sum[SUM_CHANNELS], square[SUM_CHANNELS];
	uint32_t count;
	uint32_t wanted; /* in the pass at hand; see sampling.h */
};

struct film_sums {
	struct block part; /* of the picture */
	struct pixel_sum *pixels;
};

struct film_sums *film_sums_create(struct block part);
void film_sums_destroy(struct film_sums *);

/* Where the sum of the pixel (x, y) of the picture is. */
static inline struct pixel_sum *film_sum(const struct film_sums *sums, unsigned x, unsigned y)
{
	const struct block *p = &sums->part;
	return &sums->pixels[(size_t)(y - p->top) * (p->right - p->left) + (x - p->left)];
}

void pixel_sum_add(struct pixel_sum *, colour);
/* The mean; black without samples. */
colour pixel_sum_mean(const struct pixel_sum *);
/* The standard error of the mean, of the channel where it is largest; infinite below two samples. */
double pixel_sum_error(const struct pixel_sum *);

#endif
