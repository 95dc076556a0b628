/* SPDX-License-Identifier: MIT */
/*
 * The exponential function; the method is in exp.h.
 */
#include "base/elementary.h"
#include "elementary/exp.h"

#include <math.h>

double exponential_at_the_edge(struct exponential e)
{
	if (e.exponent > 1024)
		return INFINITY;
	if (e.exponent > 0)
		return (e.value + e.rest) * power_of_two(e.exponent - 1) * 2;
	if (e.exponent > -1022 || (e.exponent == -1022 && e.value + e.rest >= 1))
		return (e.value + e.rest) * power_of_two(e.exponent);
	if (e.exponent < -1080)
		return 0;
	/* To be rounded once, and where the result ends: one bit of the grid is then the least number. */
	const double grid = power_of_two(-1074 + 52 - e.exponent);
	const struct pair s = pair_ordered_sum(grid, e.value);
	return ((s.high + (s.low + e.rest)) - grid) * power_of_two(-1022) *
	       power_of_two(e.exponent + 1022);
}

double elementary_exp(double x)
{
	if (fabs(x) < 708) {
		const struct exponential e = exponential(x, 0);
		return (e.value + e.rest) * power_of_two(e.exponent);
	}
	if (!(fabs(x) < 746)) /* not a number, or infinite, or so large or small */
		return x < 0 ? 0 : x * INFINITY;
	return exponential_at_the_edge(exponential(x, 0));
}
