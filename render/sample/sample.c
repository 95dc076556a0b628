/* SPDX-License-Identifier: MIT */
/*
 * Owen-scrambled Sobol points by hashing, after Burley, "Practical Hash-based
 * Owen Scrambling" (2020). A point's number is its index with the bits shuffled
 * in the same nested way as its coordinates are scrambled: every block of 2^k
 * numbers stays a block, but each dimension takes the blocks in an order of its
 * own. So pairs of dimensions are independent although all use the same points.
 */
#include "sample/sample.h"

/* A number with its bits in reverse. */
static uint32_t reverse_bits(uint32_t x)
{
	x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
	x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
	x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
	return __builtin_bswap32(x);
}

/* A permutation in which each bit depends on lower bits alone (Laine and Karras 2011). For one x it
 * is a permutation of the seeds, too: over all seeds a point is uniform. */
static uint32_t permute_upwards(uint32_t x, uint32_t seed)
{
	x += seed;
	x ^= x * 0x6c50b47cu;
	x ^= x * 0xb82f1e52u;
	x ^= x * 0xc7afe638u;
	x ^= x * 0x8d22f6e6u;
	return x;
}

/* Owen's scrambling of a number whose bits are given in reverse: each bit is flipped by a hash of
 * those above it. */
static uint32_t scramble_reversed(uint32_t reversed, uint32_t seed)
{
	return reverse_bits(permute_upwards(reversed, seed));
}

/* The point a sample takes in the dimension of this seed. */
static uint32_t point_number(struct sample_id id, uint64_t seed)
{
	const uint32_t of_order = (uint32_t)(seed >> 16) * 0x9e3779b1u;
	return scramble_reversed(reverse_bits(id.index), of_order);
}

/* The second coordinate of Sobol's sequence, bits in reverse; the first is the index itself. The
 * matrix is Pascal's triangle modulo 2: five steps multiply with it, each for one bit of the row. */
static uint32_t sobol_reversed(uint32_t index)
{
	index ^= (index & 0xaaaaaaaau) >> 1;
	index ^= (index & 0xccccccccu) >> 2;
	index ^= (index & 0xf0f0f0f0u) >> 4;
	index ^= (index & 0xff00ff00u) >> 8;
	index ^= (index & 0xffff0000u) >> 16;
	return index;
}

double sample_1d(struct sample_id id, uint64_t dimension)
{
	const uint64_t seed = random_mix(id.pixel, dimension);
	return sample_unit(scramble_reversed(point_number(id, seed), (uint32_t)seed));
}

struct sample_family sample_family(struct sample_id id, uint64_t dimension)
{
	const uint64_t seed = random_mix(id.pixel, dimension);
	const uint32_t number = point_number(id, seed);
	return (struct sample_family){ seed, scramble_reversed(number, (uint32_t)seed),
		scramble_reversed(sobol_reversed(number), (uint32_t)(seed >> 32)) };
}

struct sample_pair sample_2d(struct sample_id id, uint64_t dimension)
{
	const struct sample_family f = sample_family(id, dimension);
	return (struct sample_pair){ sample_unit(f.u), sample_unit(f.v) };
}
