/* SPDX-License-Identifier: MIT */
/*
 * How the language's two methods of antialiasing compare samples: after a power
 * law near the eye's. They average them as they are, unclipped.
 */
#ifndef LAMBERT_FILM_CONTRAST_H
#define LAMBERT_FILM_CONTRAST_H

#include "base/power_curve.h"
#include "sampling.h"

/* A sample and what comparisons see of it. */
struct sample {
	colour colour;
	float code[3];
	bool fine; /* method 1: has been supersampled */
};

struct contrast {
	double threshold;
	bool encodes, decodes_srgb;
	struct power_curve srgb, gamma;
};

void contrast_init(struct contrast *, const struct antialias *, const struct working_space *);
struct sample contrast_sample(const struct contrast *, colour);
/* Whether two samples differ by the threshold or more. */
bool contrast_differs(const struct contrast *, const struct sample *, const struct sample *);
/* The same as sampler_row, for comparison. */
void contrast_row(const struct contrast *, const struct sampler *, int32_t x, int32_t y,
	double shift, size_t count, struct sample *);

/* Samples of a block, and as much room for them as the largest one took. */
struct sample_room {
	struct sample *samples;
	size_t count;
};
/* Room for the samples of a block and one more in each direction. */
struct sample *sample_room_for(struct sample_room *, struct block);

static inline colour colour_sum(colour a, colour b)
{
	return (colour){ a.r + b.r, a.g + b.g, a.b + b.b, a.filter + b.filter,
		a.transmit + b.transmit };
}

static inline colour colour_share(colour c, float of)
{
	return (colour){ c.r / of, c.g / of, c.b / of, c.filter / of, c.transmit / of };
}

#endif
