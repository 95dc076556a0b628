/* SPDX-License-Identifier: MIT */
/*
 * Random numbers as functions of what they are for, never of what came before:
 * a key is mixed from numbers that name the draw (sample position, light,
 * index), so the picture does not depend on threads or on order. The mixing
 * function is the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
 */
#ifndef LAMBERT_BASE_RANDOM_H
#define LAMBERT_BASE_RANDOM_H

#include <stdint.h>
#include <string.h>

static inline uint64_t random_mix(uint64_t key, uint64_t number)
{
	uint64_t z = (key ^ number) + 0x9e3779b97f4a7c15u;
	z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
	z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
	return z ^ (z >> 31);
}
/* A key for a point of the plane, such as the position of a sample. */
static inline uint64_t random_key(double x, double y)
{
	uint64_t bits[2];
	memcpy(&bits[0], &x, sizeof x);
	memcpy(&bits[1], &y, sizeof y);
	return random_mix(random_mix(0, bits[0]), bits[1]);
}
/* Uniform in [0, 1). */
static inline double random_unit(uint64_t key)
{
	return (double)(key >> 11) * 0x1p-53;
}

#endif
