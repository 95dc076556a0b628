/* SPDX-License-Identifier: MIT */
/*
 * Numbers of twice the precision: pairs of doubles whose sum is meant. The
 * sums are Knuth's and Dekker's, the product is Dekker's with the heads cut
 * off by a mask (Muller et al., Handbook of Floating-Point Arithmetic,
 * chapter 4). They hold for the ordinary rounding of doubles and nothing else:
 * no wider registers, no fused operations, no reassociation.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_PAIR_H
#define LAMBERT_BASE_ELEMENTARY_PAIR_H

#include <float.h>
#include <stdint.h>
#include <string.h>

_Static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded to double");

struct pair {
	double high, low;
};

static inline uint64_t bits_of(double x)
{
	uint64_t bits;
	memcpy(&bits, &x, sizeof bits);
	return bits;
}
static inline double double_of(uint64_t bits)
{
	double x;
	memcpy(&x, &bits, sizeof x);
	return x;
}
/* 2^n, for an exponent that a normal number has. */
static inline double power_of_two(int n)
{
	return double_of((uint64_t)(n + 1023) << 52);
}

/* What a function gives where it has no value. The sign is seen where numbers are printed: POV-Ray
 * prints "-nan" for most and "nan" for asin, acos and log10. A processor would add its own. */
static inline double no_value(void)
{
	return double_of(UINT64_C(0xfff8000000000000));
}

/* Adding and subtracting it rounds to a whole number, which then stands in the low bits of the sum. */
#define ROUNDER 0x1.8p52

/* The number in the low bits of ROUNDER + x, for |x| < 2^31. */
static inline int whole_of(double rounded)
{
	return (int)(uint32_t)bits_of(rounded);
}

/* Adding and subtracting it leaves a multiple of 2^-33: 26 bits of what is below 2^-7. */
#define HEAD_ROUNDER (0x1.8p52 * 0x1p-33)

/* The upper 26 bits of a; what is left has at most 27. */
static inline double head_of(double a)
{
	return double_of(bits_of(a) & ~UINT64_C(0x7ffffff));
}

/* a + b, exactly; when the exponent of a is not less than that of b, or a is 0. */
static inline struct pair pair_ordered_sum(double a, double b)
{
	const double sum = a + b;
	return (struct pair){ sum, (a - sum) + b };
}
/* a + b, exactly. */
static inline struct pair pair_sum(double a, double b)
{
	const double sum = a + b, of_b = sum - a;
	return (struct pair){ sum, (a - (sum - of_b)) + (b - of_b) };
}
/* a b, to the last bit or nearly: the product of the tails may be rounded. */
static inline struct pair pair_product(double a, double b)
{
	const double ah = head_of(a), al = a - ah, bh = head_of(b), bl = b - bh, high = a * b;
	return (struct pair){ high, ((ah * bh - high) + ah * bl + al * bh) + al * bl };
}
static inline struct pair pair_scale(struct pair a, double factor)
{
	struct pair p = pair_product(a.high, factor);
	p.low += a.low * factor;
	return pair_ordered_sum(p.high, p.low);
}
static inline struct pair pair_add(struct pair a, struct pair b)
{
	struct pair s = pair_sum(a.high, b.high);
	s.low += a.low + b.low;
	return pair_ordered_sum(s.high, s.low);
}
static inline struct pair pair_times(struct pair a, struct pair b)
{
	struct pair p = pair_product(a.high, b.high);
	p.low += a.high * b.low + a.low * b.high;
	return pair_ordered_sum(p.high, p.low);
}
/* a / b: a head of the quotient of the high parts, and what is then missing. */
static inline struct pair pair_quotient(struct pair a, struct pair b)
{
	const double per_b = 1 / b.high, q = a.high * per_b, head = head_of(q);
	const double bh = head_of(b.high), bl = b.high - bh;
	const double rest = ((a.high - head * bh) - head * bl) + (a.low - q * b.low);
	return (struct pair){ head, rest * per_b };
}
/* The square root of a > 0: a head of the ordinary one, which is given, and what is missing. */
static inline struct pair pair_root(struct pair a, double root)
{
	const double head = head_of(root);
	return (struct pair){ head, ((a.high - head * head) + a.low) / (root + head) };
}

#endif
