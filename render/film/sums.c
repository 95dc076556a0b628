/* SPDX-License-Identifier: MIT */
/*
 * Sums of samples; see sums.h.
 */
#include "film/sums.h"

#include "base/arena.h"

#include <math.h>
#include <stdlib.h>

struct film_sums *film_sums_create(struct block part)
{
	struct film_sums *sums = memory_alloc(1, sizeof *sums);
	const size_t count = (size_t)(part.right - part.left) * (part.bottom - part.top);
	*sums = (struct film_sums){ part, memory_zeroed(count, sizeof *sums->pixels) };
	return sums;
}

void film_sums_destroy(struct film_sums *sums)
{
	if (!sums)
		return;
	free(sums->pixels);
	free(sums);
}

void pixel_sum_add(struct pixel_sum *p, colour c)
{
	const double channels[SUM_CHANNELS] = { c.r, c.g, c.b, c.transmit };
	for (int i = 0; i < SUM_CHANNELS; i++) {
		p->sum[i] += channels[i];
		p->square[i] += channels[i] * channels[i];
	}
	p->count++;
}

colour pixel_sum_mean(const struct pixel_sum *p)
{
	const double n = p->count > 0 ? p->count : 1;
	return (colour){ (float)(p->sum[0] / n), (float)(p->sum[1] / n), (float)(p->sum[2] / n), 0,
		(float)(p->sum[3] / n) };
}

double pixel_sum_error(const struct pixel_sum *p)
{
	const double n = p->count;
	if (n < 2)
		return INFINITY;
	double largest = 0;
	for (int i = 0; i < SUM_CHANNELS; i++) {
		const double variance = (p->square[i] - p->sum[i] * p->sum[i] / n) / (n - 1);
		largest = fmax(largest, variance / n); /* below zero: rounding */
	}
	return sqrt(largest);
}
