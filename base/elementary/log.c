/* SPDX-License-Identifier: MIT */
/*
 * Logarithms; the method is in log.h.
 */
#include "base/elementary.h"
#include "base/elementary/log.h"

#include <math.h>
#include <stdbool.h>

/* For what has no logarithm, and for subnormal numbers, of which the bits of 2^54 times as much
 * are given, with an exponent that much lower. */
static bool is_ordinary(double x, uint64_t *bits)
{
	if (!(x > 0) || x == INFINITY)
		return false;
	if (*bits < UINT64_C(1) << 52)
		*bits = bits_of(x * 0x1p54) - (UINT64_C(54) << 52);
	return true;
}
static double no_logarithm(double x, double of_negative)
{
	return x == 0 ? -INFINITY : x < 0 ? of_negative : x;
}

double elementary_log(double x)
{
	uint64_t bits = bits_of(x);
	if (bits - (UINT64_C(1) << 52) >= UINT64_C(0x7fe) << 52 && !is_ordinary(x, &bits))
		return no_logarithm(x, no_value());
	const struct log_start s = log_start(bits);
	const double r = s.r.high, r2 = r * r;
	const struct pair sum = pair_ordered_sum(s.k * LN2_HEAD + s.step->head, r);
	const double low = s.r.low + (s.k * LN2_TAIL + s.step->tail) + sum.low;
	return sum.high + (low + (r2 * -0.5 + r * r2 * log_series(r, r2)));
}

double elementary_log10(double x)
{
	uint64_t bits = bits_of(x);
	if (!is_ordinary(x, &bits))
		return no_logarithm(x, NAN);
	const struct pair log = log_pair(bits);
	const struct pair p = pair_times(log, (struct pair){ PER_LN10_HEAD, PER_LN10_TAIL });
	return p.high + p.low;
}
