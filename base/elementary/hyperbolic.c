/* SPDX-License-Identifier: MIT */
/*
 * The hyperbolic functions and their inverses, by their definitions, in pairs
 * (Muller, Elementary Functions, sections 1 and 11): sums of e^x and e^-x, and
 * logarithms. Only the hyperbolic sine needs a series, next to 0.
 */
#include "base/elementary.h"
#include "elementary/exp.h"
#include "base/elementary/log.h"

#include <math.h>

/* e^x, for |x| < 700. */
static struct pair exp_pair(double x)
{
	const struct exponential e = exponential(x, 0);
	const double scale = power_of_two(e.exponent);
	return pair_ordered_sum(scale * e.value, scale * e.rest);
}

/* For 0 <= x < 40. */
static struct pair sinh_pair(double x)
{
	if (x < 0.125) {
		const double s = x * x;
		const double low = 1. / 5040 + s * (1. / 362880 + s * (1. / 39916800));
		return (struct pair){ x, x * s * (1. / 6 + s * (1. / 120 + s * low)) };
	}
	const struct pair up = exp_pair(x), down = exp_pair(-x);
	const struct pair d = pair_add(up, (struct pair){ -down.high, -down.low });
	return (struct pair){ d.high * 0.5, d.low * 0.5 };
}
static struct pair cosh_pair(double x)
{
	const struct pair s = pair_add(exp_pair(x), exp_pair(-x));
	return (struct pair){ s.high * 0.5, s.low * 0.5 };
}
/* e^x / 2, for x from 40 on. */
static double half_exp(double x)
{
	if (!(x < 720))
		return x * INFINITY;
	struct exponential e = exponential(x, 0);
	e.exponent--;
	return exponential_at_the_edge(e);
}

double elementary_sinh(double x)
{
	const double size = fabs(x);
	if (!(size >= 0x1p-40)) /* not a number, too */
		return x;
	if (size >= 40)
		return copysign(half_exp(size), x);
	const struct pair s = sinh_pair(size);
	return copysign(s.high + s.low, x);
}

double elementary_cosh(double x)
{
	const double size = fabs(x);
	if (!(size < 40))
		return half_exp(size);
	const struct pair c = cosh_pair(size);
	return c.high + c.low;
}

double elementary_tanh(double x)
{
	const double size = fabs(x);
	if (!(size >= 0x1p-40))
		return x;
	if (size >= 24)
		return copysign(1, x);
	const struct pair t = pair_quotient(sinh_pair(size), cosh_pair(size));
	return copysign(t.high + t.low, x);
}

/* factor ln a; the low part of a is beneath the last bit of the high. */
static double log_of(struct pair a, double factor)
{
	const struct pair log = log_pair(bits_of(a.high));
	return (log.high + (log.low + a.low / a.high)) * factor;
}
/* ln 2 x, for large x. */
static double log_of_double(double x)
{
	if (!(x < INFINITY))
		return x;
	const struct pair log = log_pair(bits_of(x) + (UINT64_C(1) << 52));
	return log.high + log.low;
}

double elementary_asinh(double x)
{
	const double size = fabs(x);
	if (!(size >= 0x1p-20)) /* one more term than the first is enough */
		return size < 0x1p-40 ? x : x - x * x * x * (1. / 6);
	if (!(size < 0x1p60))
		return copysign(log_of_double(size), x);
	/* ln(x + sqrt(x^2 + 1)) */
	const struct pair square = pair_add(pair_product(size, size), (struct pair){ 1, 0 });
	const struct pair root = pair_root(square, sqrt(square.high));
	return copysign(log_of(pair_add(root, (struct pair){ size, 0 }), 1), x);
}

double elementary_acosh(double x)
{
	if (!(x > 1))
		return x == 1 ? 0 : isnan(x) ? x : no_value();
	if (!(x < 0x1p60))
		return log_of_double(x);
	/* ln(x + sqrt((x - 1) (x + 1))) */
	const struct pair square = pair_times(pair_sum(x, -1), pair_sum(x, 1));
	const struct pair root = pair_root(square, sqrt(square.high));
	return log_of(pair_add(root, (struct pair){ x, 0 }), 1);
}

double elementary_atanh(double x)
{
	const double size = fabs(x);
	if (!(size >= 0x1p-20)) /* one more term than the first is enough */
		return size < 0x1p-40 ? x : x + x * x * x * (1. / 3);
	if (!(size < 1))
		return size == 1 ? x * INFINITY : isnan(x) ? x : no_value();
	/* ln((1 + x) / (1 - x)) / 2, the quotient as 1 + 2 x / (1 - x) */
	const struct pair q = pair_quotient((struct pair){ 2 * size, 0 }, pair_sum(1, -size));
	struct pair sum = pair_sum(1, q.high);
	sum = pair_sum(sum.high, sum.low + q.low);
	return copysign(log_of(sum, 0.5), x);
}
