/* SPDX-License-Identifier: MIT */
/*
 * No antialiasing: each pixel is the sample at its centre.
 */
#include "sampling.h"

static void plain_take(
	void *self, struct sampler *s, struct film *film, struct block block, struct block inner)
{
	(void)self, (void)block;
	for (unsigned y = inner.top; y < inner.bottom && !sampler_is_cancelled(s); y++)
		sampler_row(s, (int32_t)inner.left, (int32_t)y, 0, inner.right - inner.left,
			film_pixel(film, inner.left, y));
}

const struct sampling_class sampling_plain = { .name = "plain", .take = plain_take };
