/* SPDX-License-Identifier: MIT */
/*
 * Constants and tables of the elementary functions. Written by tables.py.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_TABLES_H
#define LAMBERT_BASE_ELEMENTARY_TABLES_H

#include <stdint.h>

enum {
	EXP_STEPS = 128,
	LOG_STEPS = 128,
	GRID = 64,
	SINE_LAST = 50,
	ASIN_LAST = 32,
	ARC_TERMS = 10,
	TWO_OVER_PI_WORDS = 40
};

/* with 42 bits: times any exponent it is exact */
#define LN2_HEAD 0x1.62e42fefa3800p-1
#define LN2_TAIL 0x1.ef35793c76730p-45
/* steps of the table of 2^x in an octave, over ln 2 */
#define STEPS_PER_UNIT 0x1.71547652b82fep+7
/* ln 2 over the steps; with 34 bits */
#define STEP_HEAD 0x1.62e42fef80000p-8
#define STEP_TAIL 0x1.1cf79abc9e3b4p-43
/* 1 / ln 10 */
#define PER_LN10_HEAD 0x1.bcb7b1526e50ep-2
#define PER_LN10_TAIL 0x1.95355baaafad3p-57
/* 2 / pi */
#define PER_HALF_PI 0x1.45f306dc9c883p-1
/* pi / 2 in two pieces of 33 bits, and the rest */
#define HALF_PI_FIRST  0x1.921fb54400000p+0
#define HALF_PI_SECOND 0x1.0b4611a600000p-34
#define HALF_PI_THIRD  0x1.3198a2e037073p-69
/* pi / 2 in two pieces */
#define HALF_PI_HEAD 0x1.921fb54442d18p+0
#define HALF_PI_TAIL 0x1.1a62633145c07p-54

/* 2^(i / EXP_STEPS) is value (1 + tail). */
struct exp_step {
	double value, tail;
};
extern const struct exp_step exp_table[EXP_STEPS];

/* Bits of the first argument of the table of logarithms. */
#define LOG_FIRST UINT64_C(0x3fe6a00000000000)
/* The reciprocal, of 12 bits, of about the middle of a step; minus its logarithm. */
struct log_step {
	double reciprocal, head, tail;
};
extern const struct log_step log_table[LOG_STEPS];

/* Sine, cosine and minus sine of j / GRID, each the derivative of the one before: heads with 26 bits, and
 * tails. The first is for -SINE_LAST. */
struct sine_step {
	double part[3][2];
};
extern const struct sine_step sine_table[2 * SINE_LAST + 1];

/* An arc function at j / GRID: its value; its slope, the head with 26 bits; the further terms of its
 * Taylor series. */
struct arc_step {
	double value, value_tail, slope, slope_tail, term[ARC_TERMS - 1];
};
extern const struct arc_step atan_table[GRID + 1];
extern const struct arc_step asin_table[ASIN_LAST + 1];

/* 2 / pi: its bits behind the point. */
extern const uint32_t two_over_pi[TWO_OVER_PI_WORDS];

#endif
