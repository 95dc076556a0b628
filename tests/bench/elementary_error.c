/* SPDX-License-Identifier: MIT */
/*
 * The largest errors of the elementary functions, ours and those of the C library, in
 * units of the last place, and how many results of a million are not the nearest double,
 * by comparison with quadruple precision: elementary_error [COUNT [FUNCTION]]. Only with
 * gcc and its libquadmath. `hard` as a third word prints arguments whose truth is next to
 * the middle of two doubles.
 */
#include "base/elementary.h"

#include <math.h>
#include <quadmath.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef __float128 quad;

/* Every function as one of two arguments. */
#define ONE(f)                                                                                     \
	static double ours_##f(double x, double unused)                                            \
	{                                                                                          \
		(void)unused;                                                                      \
		return elementary_##f(x);                                                          \
	}                                                                                          \
	static double theirs_##f(double x, double unused)                                          \
	{                                                                                          \
		(void)unused;                                                                      \
		return f(x);                                                                       \
	}                                                                                          \
	static quad truth_##f(quad x, quad unused)                                                 \
	{                                                                                          \
		(void)unused;                                                                      \
		return f##q(x);                                                                    \
	}
ONE(exp)
ONE(log)
ONE(log10)
ONE(sin)
ONE(cos)
ONE(tan)
ONE(asin)
ONE(acos)
ONE(atan)
ONE(sinh)
ONE(cosh)
ONE(tanh)
ONE(asinh)
ONE(acosh)
ONE(atanh)

/* x or y: from least to largest, or of any size between, with both signs where least is negative. */
struct range {
	double least, largest;
	bool any_size;
};
#define EVEN(a, b)                                                                                 \
	{                                                                                          \
		a, b, false                                                                        \
	}
#define SIZES(a, b)                                                                                \
	{                                                                                          \
		a, b, true                                                                         \
	}

static const struct task {
	const char *name;
	double (*ours)(double, double), (*theirs)(double, double);
	quad (*truth)(quad, quad);
	struct range x, y;
} tasks[] = {
#define TASK(f, ...)                                                                               \
	{                                                                                          \
#f, ours_##f, theirs_##f, truth_##f, __VA_ARGS__, EVEN(0, 0)                       \
	}
	TASK(exp, EVEN(-1, 1)),
	TASK(exp, EVEN(-745, 709)),
	TASK(log, EVEN(0.5, 2)),
	TASK(log, EVEN(0.98, 1.02)),
	TASK(log, SIZES(1e-150, 1e150)),
	TASK(log10, EVEN(0.5, 2)),
	TASK(log10, SIZES(1e-150, 1e150)),
	TASK(sin, EVEN(-1, 1)),
	TASK(sin, EVEN(-100, 100)),
	TASK(sin, SIZES(1e-12, 1)),
	TASK(sin, SIZES(1, 1e300)),
	TASK(cos, EVEN(-1, 1)),
	TASK(cos, EVEN(-100, 100)),
	TASK(cos, SIZES(1, 1e300)),
	TASK(tan, EVEN(-1, 1)),
	TASK(tan, EVEN(-100, 100)),
	TASK(tan, SIZES(1e-12, 1)),
	TASK(tan, SIZES(1, 1e300)),
	TASK(asin, EVEN(-1, 1)),
	TASK(asin, SIZES(1e-12, 1)),
	TASK(acos, EVEN(-1, 1)),
	TASK(acos, EVEN(0.99, 1)),
	TASK(atan, EVEN(-1, 1)),
	TASK(atan, EVEN(-20, 20)),
	TASK(atan, SIZES(1e-12, 1e20)),
	TASK(sinh, EVEN(-1, 1)),
	TASK(sinh, EVEN(-709, 709)),
	TASK(cosh, EVEN(-1, 1)),
	TASK(cosh, EVEN(-709, 709)),
	TASK(tanh, EVEN(-1, 1)),
	TASK(tanh, EVEN(-30, 30)),
	TASK(asinh, EVEN(-1, 1)),
	TASK(asinh, SIZES(1e-12, 1e150)),
	TASK(acosh, EVEN(1, 2)),
	TASK(acosh, SIZES(1, 1e300)),
	TASK(atanh, EVEN(-1, 1)),
	TASK(atanh, SIZES(1e-12, 1)),
#undef TASK
	{ "pow", elementary_pow, pow, powq, EVEN(0, 3), EVEN(-20, 20) },
	{ "pow", elementary_pow, pow, powq, SIZES(1e-3, 1e3), EVEN(-100, 100) },
	{ "pow", elementary_pow, pow, powq, SIZES(1e-150, 1e150), EVEN(-1, 1) },
	{ "pow", elementary_pow, pow, powq, EVEN(0.9, 1.1), EVEN(-5000, 5000) },
	{ "atan2", elementary_atan2, atan2, atan2q, EVEN(-1, 1), EVEN(-1, 1) },
	{ "atan2", elementary_atan2, atan2, atan2q, SIZES(1e-9, 1e9), SIZES(1e-9, 1e9) },
};

static double random_unit(uint64_t *state)
{
	uint64_t z = (*state += 0x9e3779b97f4a7c15u);
	z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
	z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
	return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}
static double pick(struct range range, uint64_t *state)
{
	const double u = random_unit(state);
	if (range.any_size)
		return range.least * pow(range.largest / range.least, u);
	return range.least + u * (range.largest - range.least);
}

static double last_place(double x)
{
	int exponent;
	frexp(x, &exponent);
	return ldexp(1, exponent < -1021 ? -1074 : exponent - 53);
}

struct tally {
	double worst, x, y;
	long wrong;
};
static double count(struct tally *tally, double result, quad truth, double x, double y)
{
	const double error = (double)fabsq((result - truth) / last_place((double)truth));
	if (!(error <= tally->worst))
		*tally = (struct tally){ error, x, y, tally->wrong };
	tally->wrong += result != (double)truth;
	return error;
}

int main(int words, char **word)
{
	const long rounds = words > 1 ? atol(word[1]) : 1000000;
	const bool hard = words > 3 && strcmp(word[3], "hard") == 0;
	printf("%-31s %-22s %-22s\n", "", "ours: worst, wrong/1e6", "theirs");
	for (size_t i = 0; i < sizeof tasks / sizeof *tasks; i++) {
		const struct task *t = &tasks[i];
		if (words > 2 && strcmp(word[2], t->name) != 0)
			continue;
		struct tally ours = { 0 }, theirs = { 0 };
		uint64_t state = 1;
		for (long k = 0; k < rounds; k++) {
			const double x = pick(t->x, &state), y = pick(t->y, &state);
			const quad truth = t->truth(x, y);
			if (fabsq(truth) > 1.7e308Q)
				continue;
			count(&theirs, t->theirs(x, y), truth, x, y);
			const double error = count(&ours, t->ours(x, y), truth, x, y);
			if (hard && fabs(error - 0.5) < 1e-6)
				printf("%s %a %a\n", t->name, x, y);
		}
		printf("%-5s %9.3g to %-9.3g %s  %.5f %9.0f      %.5f %9.0f  (%a %a)\n", t->name,
			t->x.least, t->x.largest, t->x.any_size ? "sizes" : "even ", ours.worst,
			1e6 * (double)ours.wrong / (double)rounds, theirs.worst,
			1e6 * (double)theirs.wrong / (double)rounds, ours.x, ours.y);
	}
	return 0;
}
