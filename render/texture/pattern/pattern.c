/* SPDX-License-Identifier: MIT */
/*
 * From a point to a pattern's number: warp, raw value, frequency and phase, wave.
 */
#include "texture/pattern.h"

#include "base/elementary.h"
#include "texture/patterns.h"
#include "noise/noise.h"

#include <string.h>

/* Coordinates of patterns stay below this. */
#define COORDINATE_LIMIT 1e17
/* Values wrap a little beyond 1, so that exactly 1 stays what it is; the language has it so. */
#define WRAP 1.00001

static const struct pattern_class *const classes[] = {
#define REFUSED(WORD)
#define PATTERN(word, file, form) &pattern_##word,
#include "texture/patterns.def"
#undef PATTERN
#undef REFUSED
};

const struct pattern_class *pattern_find(const char *word)
{
	for (size_t i = 0; i < sizeof classes / sizeof *classes; i++)
		if (strcmp(classes[i]->name, word) == 0)
			return classes[i];
	return NULL;
}

/* Also turns "not a number" into a number. */
static double limited(double v)
{
	v = v > -COORDINATE_LIMIT ? v : -COORDINATE_LIMIT;
	return v < COORDINATE_LIMIT ? v : COORDINATE_LIMIT;
}

vec3 pattern_warp(const struct pattern *pattern, vec3 p)
{
	if (pattern->place)
		p = transform_point_back(pattern->place, p);
	for (size_t i = 0; i < pattern->warp_count; i++)
		p = pattern->warps[i].apply(pattern->warps[i].self, p);
	if (pattern->displaces)
		p = warp_turbulence(pattern->turbulence, p);
	return vec(limited(p.x), limited(p.y), limited(p.z));
}

static double wave_value(const struct pattern *pattern, double v)
{
	switch (pattern->wave) {
	case WAVE_RAMP:
		break;
	case WAVE_TRIANGLE:
		return triangle(v);
	case WAVE_SINE:
		return (1 + cycloid(v)) / 2;
	case WAVE_SCALLOP:
		return fabs(cycloid(v / 2));
	case WAVE_CUBIC:
		return v * v * (3 - 2 * v);
	case WAVE_POLY:
		return elementary_pow(v, (double)pattern->exponent);
	}
	return v;
}

double pattern_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	double v = pattern->class->value(pattern, q, surface);
	if (pattern->frequency != 0) {
		v = v * (double)pattern->frequency + (double)pattern->phase;
		if (fabs(v) >= WRAP)
			v = fmod(v, WRAP);
	}
	if (v < 0)
		v -= floor(v);
	return pattern->wave == WAVE_RAMP ? v : wave_value(pattern, v);
}

static const float grey_values[] = { 0, 1 };
static const colour grey_colours[] = { { 0, 0, 0, 0, 0 }, { 1, 1, 1, 0, 0 } };
const struct default_map default_map_grey = { 2, grey_values, grey_colours };

static const float primaries_values[] = { 0, 1, 2, 3, 4, 5 };
static const colour primaries_colours[] = { { 1, 0, 0, 0, 0 }, { 0, 1, 0, 0, 0 }, { 0, 0, 1, 0, 0 },
	{ 1, 1, 0, 0, 0 }, { 0, 1, 1, 0, 0 }, { 1, 0, 1, 0, 0 } };
const struct default_map default_map_primaries = { 6, primaries_values, primaries_colours };
