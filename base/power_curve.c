/* SPDX-License-Identifier: MIT */
/*
 * The tables of a power curve.
 */
#include "base/power_curve.h"

#include <math.h>

/* The powers of single precision's range stay within that of double precision. */
static const float LARGEST_EXPONENT = 4;

void power_curve_init(struct power_curve *curve, float exponent)
{
	curve->exponent = exponent;
	curve->has_tables = fabsf(exponent) <= LARGEST_EXPONENT;
	if (!curve->has_tables)
		return;
	const double p = (double)exponent;
	double coefficient = 1;
	for (int i = 0; i < 4; i++)
		curve->series[i] = coefficient *= (p - i) / (i + 1);
	for (int i = 0; i < OCTAVES; i++)
		curve->octave[i] = elementary_pow(2, (i - 127) * p);
	for (int i = 0; i < LOG_STEPS; i++) {
		const double c = log_table[i].reciprocal;
		curve->step[i] = (struct power_step){ c, elementary_pow(c, -p) };
	}
}
