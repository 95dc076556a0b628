/* SPDX-License-Identifier: MIT */
/*
 * ripples and waves: sine waves around a few random centres, for waves each with a
 * length of its own. The item's frequency and phase act here and again afterwards.
 */
#include "texture/patterns.h"
#include "noise/noise.h"

static double distance_to(const struct wave_source *source, vec3 q, vec3 *d)
{
	*d = vec_sub(q, source->centre);
	const double length = vec_length(*d);
	return length == 0 ? 1 : length;
}

static double ripples_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct wave_sources *sources = pattern->wave_sources;
	double sum = 0;
	vec3 d;
	for (size_t i = 0; i < sources->count; i++)
		sum += cycloid((double)pattern->frequency * distance_to(&sources->items[i], q, &d) +
			       (double)pattern->phase);
	return 0.5 * (1 + sum / (double)sources->count);
}

static vec3 ripples_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)surface;
	const struct wave_sources *sources = pattern->wave_sources;
	for (size_t i = 0; i < sources->count; i++) {
		vec3 d;
		const double length = distance_to(&sources->items[i], q, &d);
		const double height =
			cycloid((double)pattern->frequency * length + (double)pattern->phase);
		n = vec_mad(n, amount / ((double)sources->count * length) * height, d);
	}
	return n;
}

static double waves_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct wave_sources *sources = pattern->wave_sources;
	double sum = 0;
	vec3 d;
	for (size_t i = 0; i < sources->count; i++) {
		const struct wave_source *source = &sources->items[i];
		sum += cycloid((double)pattern->frequency * source->frequency *
				       distance_to(source, q, &d) +
			       (double)pattern->phase) /
		       source->frequency;
	}
	return 0.2 * (2.5 + sum / (double)sources->count);
}

static vec3 waves_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)surface;
	const struct wave_sources *sources = pattern->wave_sources;
	for (size_t i = 0; i < sources->count; i++) {
		const struct wave_source *source = &sources->items[i];
		vec3 d;
		const double length = distance_to(source, q, &d);
		const double height =
			cycloid((double)pattern->frequency * source->frequency * length +
				(double)pattern->phase);
		n = vec_mad(n,
			amount / (source->frequency * (double)sources->count * length) * height, d);
	}
	return n;
}

const struct pattern_class pattern_ripples = {
	.name = "ripples",
	.needs_wave_sources = true,
	.value = ripples_value,
	.perturb = ripples_perturb,
};
const struct pattern_class pattern_waves = {
	.name = "waves",
	.needs_wave_sources = true,
	.value = waves_value,
	.perturb = waves_perturb,
};
