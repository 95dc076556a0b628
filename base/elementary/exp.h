/* SPDX-License-Identifier: MIT */
/*
 * The heart of the exponential functions, after Tang, Table-driven
 * implementation of the exponential function in IEEE floating-point arithmetic
 * (1989): x = (128 k + i) ln 2 / 128 + r with |r| <= ln 2 / 256, and
 * e^x = 2^k 2^(i/128) e^r, of which the middle is in a table and the last is a
 * polynomial.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_EXP_H
#define LAMBERT_BASE_ELEMENTARY_EXP_H

#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

/* 2^exponent (value + rest), and value, from 1 to 2, is at least 2^7 times the rest. */
struct exponential {
	double value, rest;
	int exponent;
};

_Static_assert(EXP_STEPS == 1 << 7, "the shift below");

/* e^(x + tail), for |x| < 800 and a small tail. */
static inline struct exponential exponential(double x, double tail)
{
	const double rounded = x * STEPS_PER_UNIT + ROUNDER, steps = rounded - ROUNDER;
	const int n = whole_of(rounded);
	/* The first difference is exact: STEP_HEAD has bits to spare. */
	const double r = (x - steps * STEP_HEAD) + (tail - steps * STEP_TAIL), r2 = r * r;
	const struct exp_step *step = &exp_table[n & (EXP_STEPS - 1)];
	const double high = 1. / 24 + r * (1. / 120) + r2 * (1. / 720);
	const double rest = step->tail + r + (r2 * (0.5 + r * (1. / 6)) + r2 * r2 * high);
	return (struct exponential){ step->value, step->value * rest, n >> 7 };
}

/* 2^exponent (value + rest), where it overflows, has fewer bits than usual, or vanishes. */
double exponential_at_the_edge(struct exponential e);

#endif
