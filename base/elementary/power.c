/* SPDX-License-Identifier: MIT */
/*
 * Powers: x^y = e^(y ln x), the logarithm and the product as pairs, so that
 * the error of y ln x is below 2^-59 even where the result nearly overflows
 * (Tang's tables as in exp.h and log.h; Muller, Elementary Functions, section
 * 11.2). Results that are doubles therefore come out exactly.
 */
#include "base/elementary.h"
#include "elementary/exp.h"
#include "base/elementary/log.h"

#include <math.h>
#include <stdbool.h>

enum parity { FRACTION, EVEN, ODD };

/* Of a number that is finite. */
static enum parity parity_of(double y)
{
	const double size = fabs(y);
	if (size >= 0x1p53)
		return EVEN;
	if (size < 1)
		return size == 0 ? EVEN : FRACTION;
	if (size >= 0x1p52) /* the last bit is the unit */
		return bits_of(size) & 1 ? ODD : EVEN;
	const double whole = (size + 0x1p52) - 0x1p52;
	if (whole != size)
		return FRACTION;
	return bits_of(size + 0x1p52) & 1 ? ODD : EVEN;
}

/* Where x or y is zero, infinite or not a number, or x is 1; true: that is all. */
static bool power_special(double x, double y, double *result)
{
	const double size = fabs(x);
	if (y == 0 || x == 1)
		*result = 1;
	else if (isnan(x) || isnan(y))
		*result = x + y;
	else if (isinf(y))
		*result = size == 1 ? 1 : (size > 1) == (y > 0) ? INFINITY : 0;
	else if (size == 0 || isinf(x))
		*result = copysign(
			(size == 0) == (y > 0) ? 0 : INFINITY, parity_of(y) == ODD ? x : 1);
	else
		return false;
	return true;
}

double elementary_pow(double x, double y)
{
	uint64_t bits = bits_of(x);
	double sign = 1;
	/* An unusual x: zero, negative, subnormal, infinite, not a number. An unusual y: beyond
	 * 2^+-64. */
	if (bits - (UINT64_C(1) << 52) >= UINT64_C(0x7fe) << 52 ||
		(bits_of(y) & INT64_MAX) - bits_of(0x1p-64) > bits_of(0x1p64) - bits_of(0x1p-64)) {
		double result;
		if (power_special(x, y, &result))
			return result;
		if (x < 0) {
			const enum parity parity = parity_of(y);
			if (parity == FRACTION)
				return no_value();
			sign = parity == ODD ? -1 : 1;
			bits = bits_of(-x);
		}
		if (bits == bits_of(1) || fabs(y) < 0x1p-64)
			return sign;
		if (fabs(y) > 0x1p64)
			return (bits > bits_of(1)) == (y > 0) ? INFINITY : 0;
		if (bits < UINT64_C(1) << 52)
			bits = bits_of(fabs(x) * 0x1p54) - (UINT64_C(54) << 52);
	}
	const struct pair log = log_pair(bits);
	/* The product of heads is exact. */
	const double yh = head_of(y), lh = head_of(log.high), ll = (log.high - lh) + log.low;
	const struct pair e = { yh * lh, (y - yh) * lh + y * ll };
	if (fabs(e.high) < 700) {
		const struct exponential p = exponential(e.high, e.low);
		return sign * (p.value + p.rest) * power_of_two(p.exponent);
	}
	if (fabs(e.high) >= 750)
		return e.high < 0 ? sign * 0 : sign * INFINITY;
	return sign * exponential_at_the_edge(exponential(e.high, e.low));
}

/* In double precision throughout: that leaves an error of 2^-35 before the only rounding. What is
 * unusual is left to the other function; its result is rounded again, then. */
float elementary_powf(float x, float y)
{
	const uint64_t bits = bits_of((double)x);
	if (bits - bits_of(0x1p-149) >= bits_of(0x1p128) - bits_of(0x1p-149))
		return (float)elementary_pow((double)x, (double)y);
	const uint64_t place = bits - LOG_FIRST + (UINT64_C(1) << 44);
	const struct log_step *step = &log_table[(place >> 45) & (LOG_STEPS - 1)];
	const double k = (double)(int)((int64_t)place >> 52);
	const double z = double_of(bits - (place & UINT64_C(0xfff) << 52));
	const double r = z * step->reciprocal - 1, r2 = r * r;
	const double log = (k * (LN2_HEAD + LN2_TAIL) + step->head) +
			   (r + r2 * ((r * (1. / 3) - 0.5) - r2 * 0.25));
	const double e = log * (double)y;
	if (!(fabs(e) < 200))
		return (float)elementary_pow((double)x, (double)y);
	const double rounded = e * STEPS_PER_UNIT + ROUNDER;
	const double d = e - (rounded - ROUNDER) * (STEP_HEAD + STEP_TAIL);
	const int n = whole_of(rounded);
	const double value = exp_table[n & (EXP_STEPS - 1)].value * power_of_two(n >> 7);
	return (float)(value + value * (d + d * d * (0.5 + d * (1. / 6))));
}
