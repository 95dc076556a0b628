/* SPDX-License-Identifier: MIT */
/*
 * The heart of the logarithms, after Tang, Table-driven implementation of the
 * logarithm function in IEEE floating-point arithmetic (1990): x = 2^k z, and
 * for z a table has a reciprocal c of few bits near 1 / z and -ln c. Then
 * ln x = k ln 2 - ln c + ln(1 + r) with r = z c - 1, |r| < 1/200, and the last is a
 * series. Because c has 12 bits, r is found exactly without fused operations;
 * around 1, c is 1 and r is x - 1.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_LOG_H
#define LAMBERT_BASE_ELEMENTARY_LOG_H

#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

struct log_start {
	struct pair r;
	double k; /* the exponent of two */
	const struct log_step *step;
};

/* For the bits of a positive normal number, whose exponent may have left its field downwards. */
static inline struct log_start log_start(uint64_t bits)
{
	/* The steps are centred: half a step is added before cutting. */
	const uint64_t place = bits - LOG_FIRST + (UINT64_C(1) << 44);
	const struct log_step *step = &log_table[(place >> 45) & (LOG_STEPS - 1)];
	const int k = (int)((int64_t)place >> 52);
	const double z = double_of(bits - (place & UINT64_C(0xfff) << 52));
	const double head = double_of(bits_of(z) & ~UINT64_C(0xffffffff));
	/* Both products are exact, and so is the difference; if the first is the smaller, so is the
	 * sum. */
	const double rh = head * step->reciprocal - 1, rl = (z - head) * step->reciprocal;
	return (struct log_start){ pair_ordered_sum(rh, rl), k, step };
}

/* (ln(1 + r) - r + r^2 / 2) / r^3 */
static inline double log_series(double r, double r2)
{
	const double a = 1. / 3 - r * (1. / 4), b = 1. / 5 - r * (1. / 6);
	const double c = 1. / 7 - r * (1. / 8) + r2 * (1. / 9);
	return a + r2 * (b + r2 * c);
}

/* ln x to about 2^-68 of it, x given by its bits as above. The low part may be 2^-16 of the high. */
static inline struct pair log_pair(uint64_t bits)
{
	const struct log_start s = log_start(bits);
	const double r = s.r.high, r2 = r * r;
	const struct pair sum = pair_ordered_sum(s.k * LN2_HEAD + s.step->head, r);
	/* r^2 / 2 is the exact square of a head, and a rest. */
	const double head = (r + HEAD_ROUNDER) - HEAD_ROUNDER;
	const double rest = (head - r) * (head + r) * 0.5 - r * s.r.low;
	const struct pair squared = pair_ordered_sum(sum.high, head * head * -0.5);
	const double low = s.r.low + (s.k * LN2_TAIL + s.step->tail) + sum.low + squared.low;
	return (struct pair){ squared.high, (low + rest) + r * r2 * log_series(r, r2) };
}

#endif
