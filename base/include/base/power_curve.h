/* SPDX-License-Identifier: MIT */
/*
 * Powers of many numbers with one exponent, as gamma curves need them: twice
 * as quick as elementary_powf(), from tables that are made for the
 * exponent. Errors are below 0.501 units of the last place (0.5006), and the
 * bits are the same on every machine.
 *
 * The method is Tang's, as in base/elementary/log.h: x = 2^k z, c is near 1 / z,
 * r = z c - 1, and x^p = 2^(k p) c^-p (1 + r)^p; the first two are in tables, and
 * the last is the binomial series.
 */
#ifndef LAMBERT_BASE_POWER_CURVE_H
#define LAMBERT_BASE_POWER_CURVE_H

#include "base/elementary.h"
#include "base/elementary/log.h"

#include <stdbool.h>

enum { OCTAVES = 256 };

struct power_curve {
	float exponent;
	bool has_tables;
	double series[4]; /* of (1 + r)^exponent, from r on */
	double octave[OCTAVES];
	struct power_step {
		double reciprocal, power;
	} step[LOG_STEPS];
};

/* Large exponents and those that are no numbers have no tables. */
void power_curve_init(struct power_curve *, float exponent);

/* x to the power of the curve. */
static inline float power_curve_at(const struct power_curve *curve, float x)
{
	const uint64_t bits = bits_of((double)x);
	/* Zero, negative, subnormal, infinite and no numbers are for the other. */
	if (!curve->has_tables || bits - bits_of(0x1p-126) >= bits_of(0x1p128) - bits_of(0x1p-126))
		return elementary_powf(x, curve->exponent);
	const uint64_t place = bits - LOG_FIRST + (UINT64_C(1) << 44);
	const struct power_step *step = &curve->step[(place >> 45) & (LOG_STEPS - 1)];
	const double octave = curve->octave[((place >> 52) + 127) & (OCTAVES - 1)];
	const double z = double_of(bits - (place & UINT64_C(0xfff) << 52));
	const double r = z * step->reciprocal - 1, power = octave * step->power;
	const double *t = curve->series, r2 = r * r;
	return (float)(power + power * r * ((t[0] + r * t[1]) + r2 * (t[2] + r * t[3])));
}

#endif
