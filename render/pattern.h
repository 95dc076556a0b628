/* SPDX-License-Identifier: MIT */
/*
 * What a pattern must offer: one file under pattern/ with one struct
 * pattern_class, and one line PATTERN(name) in pattern/patterns.def.
 */
#ifndef LAMBERT_RENDER_PATTERN_H
#define LAMBERT_RENDER_PATTERN_H

#include "base/colour.h"
#include "base/transform.h"
#include "render/texture.h"

struct pattern;

enum wave { WAVE_RAMP, WAVE_TRIANGLE, WAVE_SINE, WAVE_SCALLOP, WAVE_CUBIC, WAVE_POLY };

struct turbulence {
	vec3 amount;
	int octaves;
	float omega, lambda;
};

struct pattern_class {
	const char *name;
	size_t size;		 /* of its own parameters, pattern.self */
	unsigned list_count;	 /* > 0: an integer pattern with that many list items */
	bool sets_triangle_wave; /* when named */
	bool sets_frequency_0;	 /* when named */
	bool own_turbulence;	 /* the item's turbulence does not displace the point */
	/* The raw value at the warped point. */
	double (*value)(const struct pattern *, vec3 q, struct surface *);
	/* A vector formula of its own when used as a normal: n after perturbation by `amount`.
	 * NULL: finite differences of the value. */
	vec3 (*perturb)(const struct pattern *, vec3 q, vec3 n, double amount, struct surface *);
};

/* An item's pattern with all its modifiers: the pipeline of textures.md section 5. */
struct pattern {
	const struct pattern_class *class;
	const void *self;
	const struct warp *warps; /* in order of application, or NULL */
	size_t warp_count;
	const transform *place; /* when the warps are transformations only: all in one; or NULL */
	const struct turbulence *turbulence; /* NULL: none */
	enum wave wave;
	float frequency, phase, exponent;
	int noise_generator;			 /* 1, 2 or 3: resolved */
	const struct wave_sources *wave_sources; /* for ripples and waves */
};

/* The point after warps and turbulence. */
vec3 pattern_warp(const struct pattern *, vec3 p);
/* The value after frequency, phase and wave, at a warped point. */
double pattern_value(const struct pattern *, vec3 q, struct surface *);

/* The class of a scene-language word, or NULL. */
const struct pattern_class *pattern_find(const char *word);

#endif
