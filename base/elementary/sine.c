/* SPDX-License-Identifier: MIT */
/*
 * Sine, cosine and tangent. The angle is reduced to r, |r| <= pi / 4, by Cody and
 * Waite's method with pi / 2 in three pieces (Software Manual for the Elementary
 * Functions, 1980), or exactly (reduce.c) where that leaves too few bits: for
 * large angles, and next to a multiple of pi / 2. Then r = u + d, where u is the
 * nearest multiple of 1/64, whose sine and cosine are in a table, and
 * sin(u + d) = sin u cos d + cos u sin d with short series for d (after Tang, Some
 * table lookup algorithms, 1991; Gal and Bachelis 1991).
 *
 * The largest correction, d cos u, is made of a product of heads that is exact,
 * so that the sum of all has an error far below that of its last rounding.
 */
#include "base/elementary.h"
#include "elementary/reduce.h"
#include "base/elementary/tables.h"

#include <math.h>
#include <stdbool.h>

/* Below this, three pieces of pi / 2 do. */
static const double COMMON = 0x1p20;
/* Nearer to a multiple of pi / 2 they do not. So many second pieces stay below this, too. */
static const double NEAR = 0x1p-13;
/* Below this, one more term than the first is enough. */
static const double SMALL = 0x1p-20;

static inline struct reduced reduce(double x)
{
	if (fabs(x) <= 0x1.921fb54442d18p-1)
		return (struct reduced){ { x, 0 }, 0 };
	if (fabs(x) < COMMON) {
		const double rounded = x * PER_HALF_PI + ROUNDER, turns = rounded - ROUNDER;
		/* The difference and the products of the first two pieces are exact. */
		const double rest = x - turns * HALF_PI_FIRST;
		if (fabs(rest) >= NEAR) {
			const struct pair r = pair_ordered_sum(rest, -(turns * HALF_PI_SECOND));
			return (struct reduced){ { r.high, r.low - turns * HALF_PI_THIRD },
				(unsigned)whole_of(rounded) };
		}
	}
	return reduce_exactly(x);
}

/* The sine of r, or for an odd quadrant the cosine. */
static inline struct pair sine_of(struct pair r, unsigned quadrant)
{
	if (fabs(r.high) < SMALL) {
		const double square = r.high * r.high;
		return quadrant & 1 ? (struct pair){ 1, square * -0.5 }
				    : (struct pair){ r.high, r.low - r.high * square * (1. / 6) };
	}
	const double rounded = r.high + ROUNDER / GRID, u = rounded - ROUNDER / GRID;
	const struct sine_step *step = &sine_table[whole_of(rounded) + SINE_LAST];
	const double *value = step->part[quadrant & 1], *slope = step->part[(quadrant & 1) + 1];
	const double near = r.high - u, d = near + r.low, d2 = d * d;
	const double head = (near + HEAD_ROUNDER) - HEAD_ROUNDER, tail = (near - head) + r.low;
	const struct pair sum = pair_ordered_sum(value[0], slope[0] * head);
	const double odd = d * d2 * ((-1. / 6 + d2 * (1. / 120)) + d2 * d2 * (-1. / 5040));
	const double even = d2 * ((-0.5 + d2 * (1. / 24)) + d2 * d2 * (-1. / 720));
	const double low = (slope[0] * tail + (slope[1] * d + value[1])) + sum.low +
			   ((slope[0] + slope[1]) * odd + (value[0] + value[1]) * even);
	return (struct pair){ sum.high, low };
}
/* The same, for any quadrant, rounded. */
static inline double sine_at(struct pair r, unsigned quadrant)
{
	const struct pair s = sine_of(r, quadrant);
	return double_of(bits_of(s.high + s.low) ^ (uint64_t)(quadrant & 2) << 62);
}

/* Angles that are their own sine and tangent to the last bit, and those that are none. */
static inline bool is_extreme(double x)
{
	return !(fabs(x) >= 0x1p-40 && fabs(x) < INFINITY);
}

double elementary_sin(double x)
{
	if (is_extreme(x))
		return fabs(x) < 1 ? x : isnan(x) ? x : no_value();
	const struct reduced a = reduce(x);
	return sine_at(a.r, a.quadrant);
}

double elementary_cos(double x)
{
	if (is_extreme(x))
		return fabs(x) < 1 ? 1 : isnan(x) ? x : no_value();
	const struct reduced a = reduce(x);
	return sine_at(a.r, a.quadrant + 1);
}

double elementary_tan(double x)
{
	if (is_extreme(x))
		return fabs(x) < 1 ? x : isnan(x) ? x : no_value();
	const struct reduced a = reduce(x);
	struct pair s = sine_of(a.r, 0), c = sine_of(a.r, 1);
	s = pair_ordered_sum(s.high, s.low);
	c = pair_ordered_sum(c.high, c.low);
	const struct pair q = a.quadrant & 1 ? pair_quotient((struct pair){ -c.high, -c.low }, s)
					     : pair_quotient(s, c);
	return q.high + q.low;
}
