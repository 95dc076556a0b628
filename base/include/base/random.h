/* SPDX-License-Identifier: MIT */
/*
 * A hash that makes random numbers of names: a key is mixed from the numbers
 * that say what it is for, never from what came before. The mixing function is
 * the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
 */
#ifndef LAMBERT_BASE_RANDOM_H
#define LAMBERT_BASE_RANDOM_H

#include <stdint.h>

static inline uint64_t random_mix(uint64_t key, uint64_t number)
{
	uint64_t z = (key ^ number) + 0x9e3779b97f4a7c15u;
	z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
	z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
	return z ^ (z >> 31);
}
/* Uniform in [0, 1). */
static inline double random_unit(uint64_t key)
{
	return (double)(key >> 11) * 0x1p-53;
}

#endif
