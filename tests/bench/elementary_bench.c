/* SPDX-License-Identifier: MIT */
/*
 * Nanoseconds of the elementary functions, ours and those of the C library, over the
 * arguments that pictures have: one after the other, each waiting for the last
 * (chained), and side by side. The least of several rounds counts.
 */
#include "base/elementary.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

enum { ARGUMENTS = 2048, ROUNDS = 400 };

/* Every function as one of two arguments. */
typedef double function(double, double);

#define ONE(name)                                                                                  \
	static double ours_##name(double x, double unused)                                         \
	{                                                                                          \
		(void)unused;                                                                      \
		return elementary_##name(x);                                                       \
	}                                                                                          \
	static double theirs_##name(double x, double unused)                                       \
	{                                                                                          \
		(void)unused;                                                                      \
		return name(x);                                                                    \
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

static double ours_powf(double x, double y)
{
	return (double)elementary_powf((float)x, (float)y);
}
static double theirs_powf(double x, double y)
{
	return (double)powf((float)x, (float)y);
}

static const struct task {
	const char *name;
	function *ours, *theirs;
	double x[2], y[2]; /* least and largest */
} tasks[] = {
	{ "exp", ours_exp, theirs_exp, { -8, 2 }, { 0, 0 } },
	{ "log", ours_log, theirs_log, { 0.1, 10 }, { 0, 0 } },
	{ "log10", ours_log10, theirs_log10, { 0.1, 10 }, { 0, 0 } },
	{ "pow", elementary_pow, pow, { 0.01, 1 }, { 0.1, 60 } },
	{ "powf", ours_powf, theirs_powf, { 0.04, 1 }, { 2.4, 2.4 } },
	{ "sin 1", ours_sin, theirs_sin, { 0, 0.78 }, { 0, 0 } },
	{ "sin 7", ours_sin, theirs_sin, { 0, 6.3 }, { 0, 0 } },
	{ "sin 1e6", ours_sin, theirs_sin, { 1, 1e6 }, { 0, 0 } },
	{ "sin 1e30", ours_sin, theirs_sin, { 1e20, 1e30 }, { 0, 0 } },
	{ "cos 7", ours_cos, theirs_cos, { 0, 6.3 }, { 0, 0 } },
	{ "tan", ours_tan, theirs_tan, { 0, 6.3 }, { 0, 0 } },
	{ "asin", ours_asin, theirs_asin, { -1, 1 }, { 0, 0 } },
	{ "acos", ours_acos, theirs_acos, { -1, 1 }, { 0, 0 } },
	{ "atan 1", ours_atan, theirs_atan, { -1, 1 }, { 0, 0 } },
	{ "atan 9", ours_atan, theirs_atan, { 1, 9 }, { 0, 0 } },
	{ "atan2", elementary_atan2, atan2, { -1, 1 }, { -1, 1 } },
	{ "sinh", ours_sinh, theirs_sinh, { -3, 3 }, { 0, 0 } },
	{ "cosh", ours_cosh, theirs_cosh, { -3, 3 }, { 0, 0 } },
	{ "tanh", ours_tanh, theirs_tanh, { -3, 3 }, { 0, 0 } },
	{ "asinh", ours_asinh, theirs_asinh, { -3, 3 }, { 0, 0 } },
	{ "acosh", ours_acosh, theirs_acosh, { 1, 9 }, { 0, 0 } },
	{ "atanh", ours_atanh, theirs_atanh, { -0.99, 0.99 }, { 0, 0 } },
};

static double seconds(void)
{
	struct timespec t;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* chain is 0; multiplied with a result it makes the next call wait. */
static double measure(function *f, double (*arguments)[2], double chain)
{
	volatile double sink;
	double least = INFINITY;
	for (int round = 0; round < ROUNDS; round++) {
		const double start = seconds();
		double sum = 0;
		if (chain == 0)
			for (int i = 0; i < ARGUMENTS; i++)
				sum = f(arguments[i][0] + chain * sum, arguments[i][1]);
		else
			for (int i = 0; i < ARGUMENTS; i++)
				sum += f(arguments[i][0], arguments[i][1]);
		sink = sum;
		(void)sink;
		least = fmin(least, seconds() - start);
	}
	return 1e9 * least / ARGUMENTS;
}

int main(int count, char **words)
{
	(void)words;
	static double arguments[ARGUMENTS][2];
	const double zero = count > 100;
	printf("%-10s %17s %17s\n", "ns", "chained: ours, C", "side by side");
	for (size_t i = 0; i < sizeof tasks / sizeof *tasks; i++) {
		const struct task *t = &tasks[i];
		for (int k = 0; k < ARGUMENTS; k++) { /* spread by golden ratios, out of order */
			const double u = fmod(k * 0.6180339887498949, 1);
			const double v = fmod(k * 0.7548776662466927, 1);
			arguments[k][0] = t->x[0] + u * (t->x[1] - t->x[0]);
			arguments[k][1] = t->y[0] + v * (t->y[1] - t->y[0]);
		}
		printf("%-10s", t->name);
		for (double chain = zero; chain <= 1; chain++)
			printf(" %8.1f %8.1f", measure(t->ours, arguments, chain),
				measure(t->theirs, arguments, chain));
		putchar('\n');
	}
	return 0;
}
