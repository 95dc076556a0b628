/* SPDX-License-Identifier: MIT */
/*
 * Elementary functions whose results are the same bits with every processor,
 * compiler and C library; those of the library are not, because it chooses
 * them by processor and promises nothing of their last bit. What IEEE 754
 * defines to the bit (sqrt, floor, fmod, fma ...) may come from anywhere.
 *
 * Special cases are those of annex F of the C standard; a NaN that is made has
 * the sign that POV-Ray prints. Error bounds are in
 * units of the last place, of which rounding alone takes a half; the largest
 * ones found are in brackets (tests/bench/elementary_error.c).
 */
#ifndef LAMBERT_BASE_ELEMENTARY_H
#define LAMBERT_BASE_ELEMENTARY_H

double elementary_exp(double);	       /* 0.507 (0.5066) */
double elementary_log(double);	       /* 0.503 (0.5028) */
double elementary_log10(double);       /* 0.5005 (0.5000) */
double elementary_pow(double, double); /* 0.51 (0.5068); exact where the result is a double */
float elementary_powf(float, float);   /* 0.5001 (0.50003) */

/* All 0.5005 (0.5001), angles of any size. */
double elementary_sin(double);
double elementary_cos(double);
double elementary_tan(double);
double elementary_asin(double);
double elementary_acos(double);
double elementary_atan(double);
double elementary_atan2(double y, double x);

double elementary_sinh(double);	 /* 0.53 (0.5263) */
double elementary_cosh(double);	 /* 0.507 (0.5060) */
double elementary_tanh(double);	 /* 0.53 (0.5181) */
double elementary_asinh(double); /* the inverses 0.5005 (0.5000) */
double elementary_acosh(double);
double elementary_atanh(double);

/* Below this in magnitude, numbers of the language count as zero. */
#define NEARLY_ZERO 1e-10

/* pow(). The exponents of scenes are mostly whole numbers, and then a few products are faster. */
static inline double power_of(double base, double exponent)
{
	if (!(exponent >= 0 && exponent <= 4096) || exponent != (double)(int)exponent)
		return elementary_pow(base, exponent);
	double result = 1;
	for (unsigned n = (unsigned)exponent; n != 0; n >>= 1, base *= base)
		result *= n & 1 ? base : 1;
	return result;
}

#endif
