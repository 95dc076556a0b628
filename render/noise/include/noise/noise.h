/* SPDX-License-Identifier: MIT */
/*
 * Noise: smooth random functions of space, and sums of them. Functions of the
 * point alone; they never depend on the scene.
 */
#ifndef LAMBERT_NOISE_NOISE_H
#define LAMBERT_NOISE_NOISE_H

#include "base/arena.h"
#include "base/elementary.h"
#include "base/vec3.h"
#include "noise/tables.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* Vector noise: three unbounded components around 0. The same for every generator. */
vec3 noise_vector(vec3 p);
/* Scalar noise, 0 to 1. Generators: 1 original, 2 range corrected, 3 gradients; 0 counts as 1. */
double noise_scalar(vec3 p, int generator);

/* Vector noise summed over octaves, 1 to 10: each has `lambda` times the frequency and `omega` times the
 * height of the one before. */
vec3 noise_turbulence(vec3 p, int octaves, double omega, double lambda);
/* The same of scalar noise; may exceed 1. */
double noise_turbulence_scalar(vec3 p, int octaves, float omega, float lambda, int generator);

/* Where the ripples and waves patterns start from. */
struct wave_source {
	vec3 centre;
	double frequency;
};
struct wave_sources {
	size_t count;
	const struct wave_source *items;
};
struct wave_sources wave_sources_make(struct arena *, size_t count);

/* The hash of a unit cell, for cell_uniforms. */
static inline unsigned cell_hash(int64_t x, int64_t y, int64_t z)
{
	const unsigned h = hash_table[x & 0xfff] ^ ((unsigned)y & 0xfff);
	return hash_table[hash_table[h] ^ ((unsigned)z & 0xfff)];
}

/* floor() of a number below 2^62, without a call. */
static inline int64_t floor_index(double x)
{
	const int64_t i = (int64_t)x;
	return i - (x < (double)i);
}

/* sin(2 pi v), from the fraction of v. */
static inline double cycloid(double v)
{
	return v >= 0 ? elementary_sin(2 * M_PI * (v - floor(v)))
		      : -elementary_sin(2 * M_PI * (-v - floor(-v)));
}

/* 0 at integers, 1 in the middle between them. */
static inline double triangle(double v)
{
	const double o = v >= 0 ? v - floor(v) : v + 1 + floor(fabs(v));
	return o >= 0.5 ? 2 * (1 - o) : 2 * o;
}

static inline double clamp01(double v)
{
	v = v > 0 ? v : 0;
	return v < 1 ? v : 1;
}

#endif
