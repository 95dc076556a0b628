/* SPDX-License-Identifier: MIT */
/*
 * Turbulence: octaves of noise, each finer and lower than the one before; and
 * the wave sources, which are also made of noise.
 */
#include "noise/noise.h"

vec3 noise_turbulence(vec3 p, int octaves, double omega, double lambda)
{
	vec3 sum = noise_vector(p);
	double l = lambda, o = omega;
	for (int i = 2; i <= octaves; i++) {
		sum = vec_mad(sum, o, noise_vector(vec_scale(p, l)));
		l *= lambda;
		o *= omega;
	}
	return sum;
}

double noise_turbulence_scalar(vec3 p, int octaves, float omega, float lambda, int generator)
{
	const bool original = generator < 2;
	double sum = noise_scalar(p, generator);
	if (!original) {
		sum = 2 * sum - 0.5;
		sum = sum < 0 ? 0 : sum > 1 ? 1 : sum;
	}
	double l = (double)lambda, o = (double)omega;
	for (int i = 2; i <= octaves; i++) {
		const double n = noise_scalar(vec_scale(p, l), generator);
		sum += o * (original ? n : 2 * n - 0.5);
		l *= (double)lambda;
		o *= (double)omega;
	}
	return sum;
}

struct wave_sources wave_sources_make(struct arena *arena, size_t count)
{
	struct wave_source *items = ARENA_ARRAY(arena, count, struct wave_source);
	uint32_t state = (uint32_t)-560851967;
	for (size_t i = 0; i < count; i++) {
		state = 1812433253u * state + 12345u;
		items[i].centre = vec_normalize(noise_vector(vec((double)i, 0, 0)));
		items[i].frequency = (state >> 16 & 0x7fff) * 0.000030518509476 + 0.01;
	}
	return (struct wave_sources){ count, items };
}
