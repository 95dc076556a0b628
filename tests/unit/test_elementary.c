/* SPDX-License-Identifier: MIT */
/*
 * The elementary functions: how near they come to the truth, in units of the last place
 * (half a unit is what rounding alone costs); their special cases as in annex F of the C
 * standard, and the sign of what is no number; and that every compiler and machine gets the same bits.
 */
#include "base/elementary.h"
#include "base/power_curve.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define ONES(F)                                                                                    \
	F(exp)                                                                                     \
	F(log)                                                                                     \
	F(log10)                                                                                   \
	F(sin)                                                                                     \
	F(cos)                                                                                     \
	F(tan)                                                                                     \
	F(asin)                                                                                    \
	F(acos)                                                                                    \
	F(atan)                                                                                    \
	F(sinh)                                                                                    \
	F(cosh)                                                                                    \
	F(tanh)                                                                                    \
	F(asinh)                                                                                   \
	F(acosh)                                                                                   \
	F(atanh)

/* The largest errors that elementary.h admits. */
static const double MOST_exp = 0.507, MOST_log = 0.503, MOST_log10 = 0.5005, MOST_sin = 0.5005,
		    MOST_cos = 0.5005, MOST_tan = 0.5005, MOST_asin = 0.5005, MOST_acos = 0.5005,
		    MOST_atan = 0.5005, MOST_sinh = 0.53, MOST_cosh = 0.507, MOST_tanh = 0.53,
		    MOST_asinh = 0.5005, MOST_acosh = 0.5005, MOST_atanh = 0.5005, MOST_pow = 0.51,
		    MOST_atan2 = 0.5005, MOST_powf = 0.5001, MOST_power_curve = 0.501;

/* A random number in [0, 1) from a counter; fixed, so that failures repeat. */
static double random_unit(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11) * 0x1p-53;
}
static double random_between(uint64_t *state, double least, double largest)
{
	return least + random_unit(state) * (largest - least);
}
/* Of any size from 2^least to 2^largest. */
static double random_size(uint64_t *state, int least, int largest)
{
	const double mantissa = 1 + random_unit(state);
	return ldexp(mantissa, least + (int)(random_unit(state) * (largest - least)));
}

static double last_place(double x)
{
	int exponent;
	frexp(x, &exponent);
	return ldexp(1, exponent < -1021 ? -1074 : exponent - 53);
}

/* Down to the sign of zero and of what is no number. */
static bool same(double a, double b)
{
	return ((isnan(a) && isnan(b)) || a == b) && signbit(a) == signbit(b);
}

/* The error of a result, when the truth is low last places beyond high. */
static double error_of(double result, double high, double low)
{
	return fabs((result - high) / last_place(high) - low);
}

/* ---- against tables of the truth ---- */

static const struct truth1 {
	const char *name;
	double (*f)(double);
	double x, high, low;
} truths1[] = {
#define ONE(name, x, high, low) { #name, elementary_##name, x, high, low },
#define TWO(name, x, y, high, low)
#include "elementary_truth.def"
#undef ONE
#undef TWO
};

static const struct truth2 {
	const char *name;
	double (*f)(double, double);
	double x, y, high, low;
} truths2[] = {
#define ONE(name, x, high, low)
#define TWO(name, x, y, high, low) { #name, elementary_##name, x, y, high, low },
#include "elementary_truth.def"
#undef ONE
#undef TWO
};

static double most_of(const char *name)
{
#define MOST(f)                                                                                    \
	if (strcmp(name, #f) == 0)                                                                 \
		return MOST_##f;
	ONES(MOST)
	MOST(pow)
	MOST(atan2)
#undef MOST
	return 0;
}

static void agrees_with_table(void **unused)
{
	(void)unused;
	for (size_t i = 0; i < sizeof truths1 / sizeof *truths1; i++) {
		const struct truth1 *t = &truths1[i];
		const double error = error_of(t->f(t->x), t->high, t->low);
		if (!(error <= most_of(t->name)))
			fail_msg("%s(%a) is %a: off by %g", t->name, t->x, t->f(t->x), error);
	}
	for (size_t i = 0; i < sizeof truths2 / sizeof *truths2; i++) {
		const struct truth2 *t = &truths2[i];
		const double error = error_of(t->f(t->x, t->y), t->high, t->low);
		if (!(error <= most_of(t->name)))
			fail_msg("%s(%a, %a) is %a: off by %g", t->name, t->x, t->y,
				t->f(t->x, t->y), error);
	}
}

/* ---- against longer registers, where the C library has such ---- */

/* What their own error may add. */
static const double DOUBT = 0.002;

static void compare(const char *name, double x, double y, double result, long double truth)
{
	const double high = (double)truth;
	const double low = (double)(truth - (long double)high) / last_place(high);
	const double error = error_of(result, high, low);
	if (!(error <= most_of(name) + DOUBT))
		fail_msg("%s(%a, %a) is %a: off by %g", name, x, y, result, error);
}

static void agrees_with_long_double(void **unused)
{
	(void)unused;
	if (LDBL_MANT_DIG < 64)
		skip();
	uint64_t state = 1;
#define NEAR(f, x)                                                                                 \
	do {                                                                                       \
		const double a = (x);                                                              \
		compare(#f, a, 0, elementary_##f(a), f##l((long double)a));                        \
	} while (0)
	for (int i = 0; i < 30000; i++) {
		const double s = random_between(&state, -1, 1), wide = 600 * s;
		const double sign = s < 0 ? -1 : 1, size = random_size(&state, -30, 0);
		NEAR(exp, s);
		NEAR(exp, wide);
		NEAR(log, 1 + s / 2);
		NEAR(log, random_size(&state, -1000, 1000));
		NEAR(log10, 1 + s / 2);
		NEAR(log10, random_size(&state, -1000, 1000));
		NEAR(sin, sign * size);
		NEAR(sin, wide);
		NEAR(cos, s);
		NEAR(cos, wide);
		NEAR(tan, sign * size);
		NEAR(tan, wide);
		NEAR(asin, s);
		NEAR(asin, sign * size);
		NEAR(acos, s);
		NEAR(atan, s);
		NEAR(atan, random_size(&state, -30, 60));
		NEAR(sinh, sign * size);
		NEAR(sinh, wide);
		NEAR(cosh, s);
		NEAR(cosh, wide);
		NEAR(tanh, sign * size);
		NEAR(tanh, 20 * s);
		NEAR(asinh, sign * size);
		NEAR(asinh, random_size(&state, 0, 1000));
		NEAR(acosh, 1 + size);
		NEAR(acosh, random_size(&state, 0, 1000));
		NEAR(atanh, sign * size);
		const double x = random_size(&state, -4, 4), y = random_between(&state, -150, 150);
		compare("pow", x, y, elementary_pow(x, y), powl((long double)x, (long double)y));
		const double p = random_between(&state, -1, 1), q = random_size(&state, -20, 20);
		compare("atan2", p, q, elementary_atan2(p, q),
			atan2l((long double)p, (long double)q));
		compare("atan2", p, s, elementary_atan2(p, s),
			atan2l((long double)p, (long double)s));
	}
#undef NEAR
}

/* Any bits: numbers of all sizes, infinite ones and what is no number. */
static double random_bits(uint64_t *state)
{
	const uint64_t high = (uint64_t)(random_unit(state) * 0x1p32);
	const uint64_t bits = high << 32 | (uint64_t)(random_unit(state) * 0x1p32);
	double x;
	memcpy(&x, &bits, sizeof x);
	return x;
}

static void compare_any(const char *name, double x, double y, double result, long double truth)
{
	if (isfinite((double)truth))
		compare(name, x, y, result, truth);
	else if (isnan(result) != isnan(truth) || (!isnan(truth) && result != (double)truth))
		fail_msg("%s(%a, %a) is %a", name, x, y, result);
}

static void agrees_with_long_double_for_any_bits(void **unused)
{
	(void)unused;
	if (LDBL_MANT_DIG < 64)
		skip();
	uint64_t state = 5;
	for (int i = 0; i < 50000; i++) {
		const double x = random_bits(&state), y = random_bits(&state);
#define ANY(f) compare_any(#f, x, 0, elementary_##f(x), f##l((long double)x));
		ONES(ANY)
#undef ANY
		compare_any(
			"pow", x, y, elementary_pow(x, y), powl((long double)x, (long double)y));
		compare_any("atan2", x, y, elementary_atan2(x, y),
			atan2l((long double)x, (long double)y));
	}
}

static void float_powers_agree_with_double(void **unused)
{
	(void)unused;
	uint64_t state = 2;
	for (int i = 0; i < 200000; i++) {
		const float x = (float)random_size(&state, -8, 8);
		const float y = (float)random_between(&state, -12, 12);
		const double truth = elementary_pow((double)x, (double)y);
		const double error =
			fabs((double)elementary_powf(x, y) - truth) / (last_place(truth) * 0x1p29);
		if (!(error <= MOST_powf))
			fail_msg("powf(%a, %a): off by %g", (double)x, (double)y, error);
	}
}

static void power_curves_agree_with_double(void **unused)
{
	(void)unused;
	static const float exponents[] = { 2.4f, 1 / 2.4f, 1 / 2.2f, 0.5f, 1, 0, -0.1f, -4, 4, 7 };
	uint64_t state = 4;
	for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
		struct power_curve curve;
		power_curve_init(&curve, exponents[i]);
		for (int k = 0; k < 50000; k++) {
			const float x = (float)(k % 2 != 0 ? random_unit(&state)
							   : random_size(&state, -126, 127));
			const double truth = elementary_pow((double)x, (double)exponents[i]);
			const float result = power_curve_at(&curve, x);
			if (!(truth > 0x1p-126 && truth < 0x1.fffffep127)) {
				assert_true(truth > 1 ? result > 3e38f : result <= 0x1p-126f);
				continue;
			}
			const double error =
				fabs((double)result - truth) / (last_place(truth) * 0x1p29);
			if (!(error <= MOST_power_curve))
				fail_msg("power curve (%a, %a): off by %g", (double)x,
					(double)exponents[i], error);
		}
		static const float others[] = { 0, -0.0f, -1, 1, 1e-40f, INFINITY, -INFINITY, NAN };
		for (size_t k = 0; k < sizeof others / sizeof *others; k++)
			assert_true(same((double)power_curve_at(&curve, others[k]),
				(double)elementary_powf(others[k], exponents[i])));
	}
}

/* ---- exact results, and order ---- */

static void exact_powers_are_exact(void **unused)
{
	(void)unused;
	for (int base = 2; base < 100; base++) {
		double product = 1;
		for (int n = 1; product * base < 0x1p53; n++) {
			product *= base;
			assert_true(elementary_pow(base, n) == product);
			assert_true(elementary_pow(-base, n) == (n % 2 != 0 ? -product : product));
			assert_true(n % 2 != 0 || elementary_pow(product, 0.5) == sqrt(product));
		}
	}
	for (int n = -1074; n < 1024; n++)
		assert_true(elementary_pow(2, n) == ldexp(1, n));
	for (int n = 0; n <= 22; n++) /* the powers of ten that are doubles */
		assert_true(elementary_log10(elementary_pow(10, n)) == n);
	for (int i = -1000; i < 1000; i++) {
		const double x = i * 0x1p-20;
		assert_true(elementary_pow(1 + x, 2) == (1 + x) * (1 + x));
	}
}

static void is_monotone(void **unused)
{
	(void)unused;
	/* Across the borders of cases and of steps of tables, one double after the other. */
	static const struct {
		double (*f)(double);
		double x;
	} places[] = {
		{ elementary_exp, -708 },
		{ elementary_exp, 708 },
		{ elementary_exp, 0 },
		{ elementary_log, 1 },
		{ elementary_log, 0x1.69p-1 },
		{ elementary_log10, 1 },
		{ elementary_sin, 0x1p-27 },
		{ elementary_sin, 0x1p-40 },
		{ elementary_sin, 1. / 128 },
		{ elementary_sin, 0.78539816339744828 },
		{ elementary_tan, 0.78539816339744828 },
		{ elementary_tan, 0x1p-27 },
		{ elementary_atan, 1 },
		{ elementary_atan, 0x1p-27 },
		{ elementary_atan, 0x1p60 },
		{ elementary_asin, 0.5 },
		{ elementary_asin, -0.5 },
		{ elementary_asin, 3. / 128 },
		{ elementary_sinh, 0.125 },
		{ elementary_sinh, 40 },
		{ elementary_tanh, 0.125 },
		{ elementary_tanh, 22 },
		{ elementary_asinh, 0x1p-27 },
		{ elementary_asinh, 0x1p60 },
		{ elementary_acosh, 0x1p60 },
		{ elementary_atanh, 0x1p-27 },
	};
	for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
		double x = places[i].x;
		for (int k = 0; k < 500; k++)
			x = nextafter(x, -INFINITY);
		double before = places[i].f(x);
		for (int k = 0; k < 1000; k++) {
			x = nextafter(x, INFINITY);
			const double value = places[i].f(x);
			if (!(value >= before))
				fail_msg("place %zu falls at %a", i, x);
			before = value;
		}
	}
}

/* ---- special cases ---- */

#define IS(call, wanted)                                                                           \
	do {                                                                                       \
		const double is = (call);                                                          \
		if (!same(is, wanted))                                                             \
			fail_msg(#call " is %a", is);                                              \
	} while (0)

static const double PI = 3.14159265358979323846;

static void special_arguments(void **unused)
{
	(void)unused;
#define SPECIAL(f, of_zero, of_minus_zero, of_infinity, of_minus_infinity)                         \
	IS(elementary_##f(NAN), NAN);                                                              \
	IS(elementary_##f(0.0), of_zero);                                                          \
	IS(elementary_##f(-0.0), of_minus_zero);                                                   \
	IS(elementary_##f(INFINITY), of_infinity);                                                 \
	IS(elementary_##f(-INFINITY), of_minus_infinity);
	SPECIAL(exp, 1, 1, INFINITY, 0.0)
	SPECIAL(log, -INFINITY, -INFINITY, INFINITY, -NAN)
	SPECIAL(log10, -INFINITY, -INFINITY, INFINITY, NAN)
	SPECIAL(sin, 0.0, -0.0, -NAN, -NAN)
	SPECIAL(cos, 1, 1, -NAN, -NAN)
	SPECIAL(tan, 0.0, -0.0, -NAN, -NAN)
	SPECIAL(asin, 0.0, -0.0, NAN, NAN)
	SPECIAL(acos, PI / 2, PI / 2, NAN, NAN)
	SPECIAL(atan, 0.0, -0.0, PI / 2, -PI / 2)
	SPECIAL(sinh, 0.0, -0.0, INFINITY, -INFINITY)
	SPECIAL(cosh, 1, 1, INFINITY, INFINITY)
	SPECIAL(tanh, 0.0, -0.0, 1, -1)
	SPECIAL(asinh, 0.0, -0.0, INFINITY, -INFINITY)
	SPECIAL(acosh, -NAN, -NAN, INFINITY, -NAN)
	SPECIAL(atanh, 0.0, -0.0, -NAN, -NAN)
#undef SPECIAL
	IS(elementary_exp(709.782712893384), 0x1.fffffffffff2ap+1023);
	IS(elementary_exp(709.79), INFINITY);
	IS(elementary_exp(-745.13), 0x1p-1074);
	IS(elementary_exp(-745.14), 0.0);
	IS(elementary_exp(-746), 0.0);
	IS(elementary_log(1), 0.0);
	IS(elementary_log(-1), -NAN);
	IS(elementary_log10(-1), NAN);
	IS(elementary_asin(1), PI / 2);
	IS(elementary_asin(-1), -PI / 2);
	IS(elementary_asin(1.0000000000000002), NAN);
	IS(elementary_acos(1), 0.0);
	IS(elementary_acos(-1), PI);
	IS(elementary_acos(-1.0000000000000002), NAN);
	IS(elementary_acosh(1), 0.0);
	IS(elementary_acosh(0.9999999999999999), -NAN);
	IS(elementary_atanh(1), INFINITY);
	IS(elementary_atanh(-1), -INFINITY);
	IS(elementary_atanh(1.5), -NAN);
	IS(elementary_sinh(710.5), INFINITY);
	IS(elementary_sinh(-1e6), -INFINITY);
	IS(elementary_cosh(-710.5), INFINITY);
	IS(elementary_tanh(1e300), 1);
	static const double small[] = { 0x1p-1074, 0x1.8p-1030, 0x1p-1022, 1e-100 };
	for (size_t i = 0; i < sizeof small / sizeof *small; i++) {
		const double x = small[i];
		IS(elementary_sin(-x), -x);
		IS(elementary_tan(x), x);
		IS(elementary_asin(x), x);
		IS(elementary_atan(-x), -x);
		IS(elementary_sinh(x), x);
		IS(elementary_tanh(x), x);
		IS(elementary_asinh(-x), -x);
		IS(elementary_atanh(x), x);
		IS(elementary_cos(x), 1);
		IS(elementary_atan2(x, 1), x);
	}
}

static void special_powers(void **unused)
{
	(void)unused;
	static const double any[] = { NAN, 0, -0.0, 1, -1, 2.5, -2.5, 1e300, INFINITY, -INFINITY };
	for (size_t i = 0; i < sizeof any / sizeof *any; i++) {
		IS(elementary_pow(any[i], 0.0), 1);
		IS(elementary_pow(any[i], -0.0), 1);
		IS(elementary_pow(1, any[i]), 1);
	}
	IS(elementary_pow(NAN, 2), NAN);
	IS(elementary_pow(2, NAN), NAN);
	IS(elementary_pow(0.0, 3), 0.0);
	IS(elementary_pow(-0.0, 3), -0.0);
	IS(elementary_pow(-0.0, 2), 0.0);
	IS(elementary_pow(-0.0, 2.5), 0.0);
	IS(elementary_pow(0.0, -3), INFINITY);
	IS(elementary_pow(-0.0, -3), -INFINITY);
	IS(elementary_pow(-0.0, -2), INFINITY);
	IS(elementary_pow(-0.0, -0.5), INFINITY);
	IS(elementary_pow(-1, INFINITY), 1);
	IS(elementary_pow(-1, -INFINITY), 1);
	IS(elementary_pow(0.5, INFINITY), 0.0);
	IS(elementary_pow(-0.5, -INFINITY), INFINITY);
	IS(elementary_pow(-2, INFINITY), INFINITY);
	IS(elementary_pow(2, -INFINITY), 0.0);
	IS(elementary_pow(INFINITY, 0.5), INFINITY);
	IS(elementary_pow(INFINITY, -0.5), 0.0);
	IS(elementary_pow(-INFINITY, 3), -INFINITY);
	IS(elementary_pow(-INFINITY, 2), INFINITY);
	IS(elementary_pow(-INFINITY, -3), -0.0);
	IS(elementary_pow(-INFINITY, -2), 0.0);
	IS(elementary_pow(-8, 1. / 3), -NAN);
	IS(elementary_pow(-8, 3), -512);
	IS(elementary_pow(-1, 0x1p53), 1);
	IS(elementary_pow(-1, 0x1p53 - 1), -1);
	IS(elementary_pow(-1, 0x1.0000000000001p52), -1);
	IS(elementary_pow(-1, 0x1p51 + 0.5), -NAN);
	IS(elementary_pow(-2, 1e300), INFINITY);
	IS(elementary_pow(-0.5, 1025), -0x1p-1025);
	IS(elementary_pow(-2, 1025), -INFINITY);
	IS(elementary_pow(-0.5, 2001), -0.0);
	IS(elementary_pow(0x1p-1074, 0.5), 0x1p-537);
	IS(elementary_pow(0x1p-1074, -0.5), 0x1p537);
	IS(elementary_pow(0x1.fffffffffffffp+1023, 1), 0x1.fffffffffffffp+1023);
	IS(elementary_pow(3, 1e-300), 1);
	IS(elementary_pow(0.99999999999999989, 1e300), 0.0);
	IS(elementary_pow(1.0000000000000002, 1e300), INFINITY);
	IS(elementary_pow(1.0000000000000002, 0x1p52), 0x1.5bf0a8b145769p+1);
	IS((double)elementary_powf(0.0f, 2.4f), 0.0);
	IS((double)elementary_powf(0.0f, -1), INFINITY);
	IS((double)elementary_powf(-2, 3), -8);
	IS((double)elementary_powf(-2, 0.5f), -NAN);
	IS((double)elementary_powf(NAN, 2.4f), NAN);
	IS((double)elementary_powf(2, NAN), NAN);
	IS((double)elementary_powf(NAN, 0), 1);
	IS((double)elementary_powf(2, 200), INFINITY);
	IS((double)elementary_powf(2, INFINITY), INFINITY);
	IS((double)elementary_powf(2, -200), 0.0);
	IS((double)elementary_powf(0x1p-149f, 0.5f), (double)(float)0x1.6a09e667f3bcdp-75);
	IS((double)elementary_powf(2, -140), 0x1p-140);
}

static void special_directions(void **unused)
{
	(void)unused;
	IS(elementary_atan2(0.0, 1), 0.0);
	IS(elementary_atan2(-0.0, 1), -0.0);
	IS(elementary_atan2(0.0, -1), PI);
	IS(elementary_atan2(-0.0, -1), -PI);
	IS(elementary_atan2(0.0, 0.0), 0.0);
	IS(elementary_atan2(-0.0, 0.0), -0.0);
	IS(elementary_atan2(0.0, -0.0), PI);
	IS(elementary_atan2(-0.0, -0.0), -PI);
	IS(elementary_atan2(1, 0.0), PI / 2);
	IS(elementary_atan2(-1, -0.0), -PI / 2);
	IS(elementary_atan2(INFINITY, 1), PI / 2);
	IS(elementary_atan2(-INFINITY, -1), -PI / 2);
	IS(elementary_atan2(1, INFINITY), 0.0);
	IS(elementary_atan2(-1, INFINITY), -0.0);
	IS(elementary_atan2(1, -INFINITY), PI);
	IS(elementary_atan2(-1, -INFINITY), -PI);
	IS(elementary_atan2(INFINITY, INFINITY), PI / 4);
	IS(elementary_atan2(INFINITY, -INFINITY), 3 * (PI / 4));
	IS(elementary_atan2(-INFINITY, INFINITY), -PI / 4);
	IS(elementary_atan2(-INFINITY, -INFINITY), -3 * (PI / 4));
	IS(elementary_atan2(NAN, 1), NAN);
	IS(elementary_atan2(1, NAN), NAN);
	IS(elementary_atan2(1, 1), PI / 4);
	IS(elementary_atan2(-0x1p-1074, 0x1p-1074), -PI / 4);
	IS(elementary_atan2(0x1p1023, -0x1p1023), 3 * (PI / 4));
	IS(elementary_atan2(0x1p-1074, 0x1p1023), 0.0);
	IS(elementary_atan2(0x1p1023, 0x1p-1074), PI / 2);
	IS(elementary_atan2(0x1p-1074, 0x1p-1), 0x1p-1073);
}

/* ---- the same bits everywhere ---- */

static uint64_t stir(uint64_t hash, double x)
{
	uint64_t bits;
	memcpy(&bits, &x, sizeof bits);
	return (hash ^ bits) * 0x100000001b3u;
}

static void bits_are_the_known_ones(void **unused)
{
	(void)unused;
	uint64_t hash = 0xcbf29ce484222325u, state = 3;
	for (int i = 0; i < 20000; i++) {
		const double s = random_between(&state, -1, 1), size = random_size(&state, -40, 10);
		const double huge = random_size(&state, -1000, 1000);
		hash = stir(hash, elementary_exp(700 * s));
		hash = stir(hash, elementary_exp(s));
		hash = stir(hash, elementary_log(size));
		hash = stir(hash, elementary_log(huge));
		hash = stir(hash, elementary_log10(size));
		hash = stir(hash, elementary_sin(size));
		hash = stir(hash, elementary_sin(huge));
		hash = stir(hash, elementary_cos(100 * s));
		hash = stir(hash, elementary_cos(huge));
		hash = stir(hash, elementary_tan(100 * s));
		hash = stir(hash, elementary_tan(huge));
		hash = stir(hash, elementary_asin(s));
		hash = stir(hash, elementary_acos(s));
		hash = stir(hash, elementary_atan(s));
		hash = stir(hash, elementary_atan(size));
		hash = stir(hash, elementary_atan2(s, size));
		hash = stir(hash, elementary_atan2(huge, -size));
		hash = stir(hash, elementary_sinh(700 * s));
		hash = stir(hash, elementary_sinh(s));
		hash = stir(hash, elementary_cosh(700 * s));
		hash = stir(hash, elementary_cosh(s));
		hash = stir(hash, elementary_tanh(s));
		hash = stir(hash, elementary_tanh(size));
		hash = stir(hash, elementary_asinh(s));
		hash = stir(hash, elementary_asinh(huge));
		hash = stir(hash, elementary_acosh(1 + size));
		hash = stir(hash, elementary_atanh(s));
		hash = stir(hash, elementary_pow(size, 10 * s));
		hash = stir(hash, elementary_pow(huge, s));
		hash = stir(hash, (double)elementary_powf((float)size, (float)s * 3));
	}
	if (hash != 0x9ccc974a21e236d0u)
		fail_msg("the hash of the results is 0x%llx", (unsigned long long)hash);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(agrees_with_table),
		cmocka_unit_test(agrees_with_long_double),
		cmocka_unit_test(agrees_with_long_double_for_any_bits),
		cmocka_unit_test(float_powers_agree_with_double),
		cmocka_unit_test(power_curves_agree_with_double),
		cmocka_unit_test(exact_powers_are_exact),
		cmocka_unit_test(is_monotone),
		cmocka_unit_test(special_arguments),
		cmocka_unit_test(special_powers),
		cmocka_unit_test(special_directions),
		cmocka_unit_test(bits_are_the_known_ones),
	};
	return cmocka_run_group_tests_name("elementary", tests, NULL, NULL);
}
