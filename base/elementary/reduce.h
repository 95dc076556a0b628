/* SPDX-License-Identifier: MIT */
/*
 * Angles less multiples of a right angle.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_REDUCE_H
#define LAMBERT_BASE_ELEMENTARY_REDUCE_H

#include "base/elementary/pair.h"

/* x is quadrant right angles and r, |r| <= pi / 4 and a little; of the quadrant two bits count. */
struct reduced {
	struct pair r;
	unsigned quadrant;
};

/* Of any finite x: exactly enough, and slow. */
struct reduced reduce_exactly(double x);

#endif
