/* SPDX-License-Identifier: MIT */
/*
 * Colours are held in single precision, as the reference holds them: every
 * colour operation rounds its result to float. They are never clamped between
 * shading and output.
 */
#ifndef LAMBERT_BASE_COLOUR_H
#define LAMBERT_BASE_COLOUR_H

#include "base/elementary.h"

#include <math.h>
#include <stdbool.h>

/* Light. */
typedef struct {
	float r, g, b;
} rgb;

/* What a pigment yields. filter: share of light passing, tinted; transmit: untinted. */
typedef struct {
	float r, g, b, filter, transmit;
} colour;

static inline rgb rgb_grey(float v)
{
	return (rgb){ v, v, v };
}
static inline rgb rgb_add(rgb a, rgb b)
{
	return (rgb){ a.r + b.r, a.g + b.g, a.b + b.b };
}
static inline rgb rgb_mul(rgb a, rgb b)
{
	return (rgb){ a.r * b.r, a.g * b.g, a.b * b.b };
}
static inline rgb rgb_scale(rgb a, double s)
{
	return (rgb){ (float)(a.r * s), (float)(a.g * s), (float)(a.b * s) };
}
/* The one luminance weighting of the language. */
static inline float rgb_luminance(rgb a)
{
	return 0.297f * a.r + 0.589f * a.g + 0.114f * a.b;
}
static inline float rgb_max(rgb a)
{
	const float gb = a.g > a.b ? a.g : a.b; /* fmaxf would be a call */
	return a.r > gb ? a.r : gb;
}
static inline float rgb_max_abs(rgb a)
{
	return rgb_max((rgb){ fabsf(a.r), fabsf(a.g), fabsf(a.b) });
}
static inline bool rgb_is_zero(rgb a)
{
	return a.r == 0 && a.g == 0 && a.b == 0;
}
static inline bool rgb_is_dark(rgb a)
{
	return rgb_max_abs(a) < (float)NEARLY_ZERO;
}
static inline rgb colour_rgb(colour c)
{
	return (rgb){ c.r, c.g, c.b };
}
/* What light is multiplied by when it passes through. */
static inline rgb colour_tint(colour c)
{
	return (rgb){ c.r * c.filter + c.transmit, c.g * c.filter + c.transmit,
		c.b * c.filter + c.transmit };
}
/* May be negative when filter and transmit add up to more than 1. */
static inline float colour_opacity(colour c)
{
	return 1 - c.filter - c.transmit;
}

#endif
