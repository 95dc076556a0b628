/* SPDX-License-Identifier: MIT */
/*
 * The reduction of Payne and Hanek (Radian reduction for trigonometric
 * functions, 1983; Muller, Elementary Functions, section 9.4): of x 2/pi only
 * the last two bits before the point and what is behind it are worked out, in
 * whole numbers, from as many bits of 2/pi as matter to x. No double comes
 * nearer to a multiple of pi/2 than 2^-62 of itself, and the fraction is right to
 * 2^-137.
 */
#include "elementary/reduce.h"
#include "base/elementary/tables.h"

enum {
	USED = 7,	  /* words of 2/pi that matter */
	LIMBS = USED + 2, /* words of their product with x */
	BITS = 32 * LIMBS
};

/* Least word first. */
static void shift_left(uint32_t *limbs, unsigned count)
{
	for (; count >= 32; count -= 32) {
		for (int i = LIMBS - 1; i > 0; i--)
			limbs[i] = limbs[i - 1];
		limbs[0] = 0;
	}
	for (int i = LIMBS - 1; i >= 0 && count > 0; i--)
		limbs[i] = limbs[i] << count | (i > 0 ? limbs[i - 1] >> (32 - count) : 0);
}

/* The product of a whole number and the words of 2/pi from first on. */
static void multiply(uint32_t *limbs, uint64_t whole, int first)
{
	const uint32_t factor[2] = { (uint32_t)whole, (uint32_t)(whole >> 32) };
	for (int i = 0; i < LIMBS; i++)
		limbs[i] = 0;
	for (int f = 0; f < 2; f++) {
		uint64_t carry = 0;
		for (int i = 0; i < USED; i++) {
			carry += limbs[i + f] +
				 (uint64_t)factor[f] * two_over_pi[first + USED - 1 - i];
			limbs[i + f] = (uint32_t)carry;
			carry >>= 32;
		}
		limbs[USED + f] = (uint32_t)carry;
	}
}

struct reduced reduce_exactly(double x)
{
	const uint64_t bits = bits_of(x) & INT64_MAX;
	const uint64_t whole = (bits & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
	const int exponent = (int)(bits >> 52) - 1075; /* |x| = whole 2^exponent */
	/* Earlier words of 2/pi make multiples of four of the product. */
	const int first = exponent < 2 ? 0 : (exponent - 2) / 32;
	uint32_t limbs[LIMBS];
	multiply(limbs, whole, first);
	/* Now the last two bits before the point go to the top. */
	const int behind = 32 * (first + USED) - exponent;
	shift_left(limbs, (unsigned)(BITS - 2 - behind));
	unsigned quadrant = limbs[LIMBS - 1] >> 30;
	shift_left(limbs, 2);
	double sign = 1;
	if (limbs[LIMBS - 1] >> 31) { /* the next multiple is nearer */
		quadrant++;
		sign = -1;
		uint32_t carry = 1;
		for (int i = 0; i < LIMBS; i++) {
			limbs[i] = ~limbs[i] + carry;
			carry = carry && limbs[i] == 0;
		}
	}
	struct pair turns = { 0, 0 };
	double unit = power_of_two(-BITS);
	for (int i = 0; i < LIMBS; i++, unit *= 0x1p32) {
		const struct pair sum = pair_sum(limbs[i] * unit, turns.high);
		turns = pair_ordered_sum(sum.high, sum.low + turns.low);
	}
	struct pair r = pair_times(turns, (struct pair){ HALF_PI_HEAD, HALF_PI_TAIL });
	if (x < 0) {
		sign = -sign;
		quadrant = 0 - quadrant;
	}
	return (struct reduced){ { sign * r.high, sign * r.low }, quadrant };
}
