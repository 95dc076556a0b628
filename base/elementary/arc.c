/* SPDX-License-Identifier: MIT */
/*
 * The arc functions. Between 0 and 1 the arc tangent is a Taylor series around
 * the nearest multiple of 1/64, from a table; the arc sine between 0 and 1/2
 * likewise. The rest follows by atan t = pi/2 - atan 1/t and
 * acos x = 2 asin sqrt((1 - x) / 2), with quotient and root as pairs (Muller,
 * Elementary Functions, sections 4.2 and 11; Gal and Bachelis 1991 for the tables).
 */
#include "base/elementary.h"
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <math.h>
#include <stdbool.h>

static const struct pair HALF_PI = { HALF_PI_HEAD, HALF_PI_TAIL };
static const struct pair WHOLE_PI = { 2 * HALF_PI_HEAD, 2 * HALF_PI_TAIL };

/* Below this, one more term than the first is enough. */
static const double SMALL = 0x1p-20;

/* The function of a table, at x >= 0. */
static inline struct pair arc_at(const struct arc_step *table, struct pair x)
{
	const double rounded = x.high + ROUNDER / GRID;
	const double near = x.high - (rounded - ROUNDER / GRID), d = near + x.low;
	const double head = (near + HEAD_ROUNDER) - HEAD_ROUNDER, tail = (near - head) + x.low;
	const struct arc_step *a = &table[whole_of(rounded)];
	const double *t = a->term, d2 = d * d, d4 = d2 * d2;
	const double high = (t[4] + d * t[5]) + d2 * ((t[6] + d * t[7]) + d2 * t[8]);
	const double more = (t[0] + d * t[1]) + d2 * (t[2] + d * t[3]) + d4 * high;
	/* The first term is an exact product and a small rest. */
	const struct pair sum = pair_ordered_sum(a->value, a->slope * head);
	const double low = a->slope * tail + (a->slope_tail * d + a->value_tail);
	return (struct pair){ sum.high, (sum.low + low) + d2 * more };
}

/* base - a, or with a negative sign base + a. */
static inline double pair_less(struct pair base, struct pair a, double sign)
{
	const struct pair s = pair_sum(base.high, -sign * a.high);
	return s.high + (s.low + (base.low - sign * a.low));
}

double elementary_atan(double x)
{
	const double size = fabs(x);
	if (!(size > SMALL))
		return size < 0x1p-40 ? x : x - x * x * x * (1. / 3);
	if (size <= 1) {
		const struct pair a = arc_at(atan_table, (struct pair){ size, 0 });
		return copysign(a.high + a.low, x);
	}
	if (!(size < 0x1p60))
		return isnan(x) ? x : copysign(HALF_PI_HEAD, x);
	const struct pair q = pair_quotient((struct pair){ 1, 0 }, (struct pair){ size, 0 });
	return copysign(pair_less(HALF_PI, arc_at(atan_table, q), 1), x);
}

/* Where x or y is zero, infinite or not a number. */
static double atan2_special(double y, double x)
{
	if (isnan(x) || isnan(y))
		return x + y;
	if (y == 0)
		return signbit(x) ? copysign(WHOLE_PI.high, y) : y;
	if (isinf(x) && isinf(y))
		return copysign(x > 0 ? HALF_PI_HEAD / 2 : 3 * (HALF_PI_HEAD / 2), y);
	if (x == 0 || isinf(y))
		return copysign(HALF_PI_HEAD, y);
	return copysign(x > 0 ? 0 : WHOLE_PI.high, y);
}

double elementary_atan2(double y, double x)
{
	double up = fabs(y), along = fabs(x);
	if (!(up > 0 && up < INFINITY && along > 0 && along < INFINITY))
		return atan2_special(y, x);
	const bool steep = up > along;
	/* Out of reach of overflow in the products below, and of underflow. */
	const double large = steep ? up : along;
	const double scale = large > 0x1p500 ? 0x1p-600 : large < 0x1p-400 ? 0x1p600 : 1;
	if (!steep && x > 0 && up < along * 0x1p-40)
		return y / x;
	up *= scale;
	along *= scale;
	const struct pair q =
		steep ? pair_quotient((struct pair){ along, 0 }, (struct pair){ up, 0 })
		      : pair_quotient((struct pair){ up, 0 }, (struct pair){ along, 0 });
	if (steep)
		return copysign(pair_less(HALF_PI, arc_at(atan_table, q), x > 0 ? 1 : -1), y);
	if (x < 0)
		return copysign(pair_less(WHOLE_PI, arc_at(atan_table, q), 1), y);
	if (q.high < SMALL)
		return copysign(q.high + (q.low - q.high * q.high * q.high * (1. / 3)), y);
	const struct pair a = arc_at(atan_table, q);
	return copysign(a.high + a.low, y);
}

/* Twice the arc sine of sqrt((1 - size) / 2), for 1/2 < size < 1. */
static inline struct pair arc_of_complement(double size)
{
	const double square = (1 - size) * 0.5;
	const struct pair root = pair_root((struct pair){ square, 0 }, sqrt(square));
	const struct pair a = arc_at(asin_table, root);
	return (struct pair){ 2 * a.high, 2 * a.low };
}

double elementary_asin(double x)
{
	const double size = fabs(x);
	if (!(size > SMALL))
		return size < 0x1p-40 ? x : x + x * x * x * (1. / 6);
	if (size <= 0.5) {
		const struct pair a = arc_at(asin_table, (struct pair){ size, 0 });
		return copysign(a.high + a.low, x);
	}
	if (size < 1)
		return copysign(pair_less(HALF_PI, arc_of_complement(size), 1), x);
	return size == 1 ? copysign(HALF_PI_HEAD, x) : isnan(x) ? x : NAN;
}

double elementary_acos(double x)
{
	const double size = fabs(x);
	if (size <= 0.5) {
		const struct pair a = arc_at(asin_table, (struct pair){ size, 0 });
		return pair_less(HALF_PI, a, x < 0 ? -1 : 1);
	}
	if (size < 1) {
		const struct pair a = arc_of_complement(size);
		return x < 0 ? pair_less(WHOLE_PI, a, 1) : a.high + a.low;
	}
	return x == 1 ? 0 : x == -1 ? WHOLE_PI.high : isnan(x) ? x : NAN;
}
