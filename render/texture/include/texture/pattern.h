/* SPDX-License-Identifier: MIT */
/*
 * What a pattern must offer: one struct pattern_class in a file under pattern/,
 * and one line in texture/patterns.def.
 *
 * A pattern turns a point into a number. An item that has a pattern (pigment,
 * normal, texture) owns a struct pattern: the class with its parameters, and
 * what the modifiers of the language do to the point before and to the number
 * afterwards.
 */
#ifndef LAMBERT_TEXTURE_PATTERN_H
#define LAMBERT_TEXTURE_PATTERN_H

#include "base/colour.h"
#include "base/transform.h"
#include "texture/texture.h"
#include "texture/warp.h"

#include <stddef.h>

struct pattern;
struct wave_sources;

enum wave { WAVE_RAMP, WAVE_TRIANGLE, WAVE_SINE, WAVE_SCALLOP, WAVE_CUBIC, WAVE_POLY };

/* The parameters of a pattern's instance: those that stand behind its word (no word of their own),
 * in order, and those that are modifiers. */
enum pattern_param_type {
	PATTERN_END,
	PATTERN_FLOAT,	/* float */
	PATTERN_DOUBLE, /* double */
	PATTERN_VECTOR, /* vec3 */
	PATTERN_X,	/* double: the x component of a vector */
	PATTERN_FLAG,	/* bool: the word alone */
};
struct pattern_param {
	const char *word; /* NULL: behind the pattern's word */
	enum pattern_param_type type;
	size_t offset;
};

/* A colour map for items that bring none. Integer patterns take `colours` alone as their list. */
struct default_map {
	size_t count;
	const float *values;
	const colour *colours;
};
extern const struct default_map default_map_grey;

struct pattern_class {
	const char *name;
	size_t size;			    /* of its own parameters, pattern.self */
	const struct pattern_param *params; /* NULL: none, or lower_pattern.c fills the instance */
	const void *defaults;		    /* the instance to start from; NULL: zeros */
	unsigned list_count;		    /* > 0: an integer pattern with that many list items */
	bool keeps_parameters;		    /* naming it again does not reset them */
	bool sets_triangle_wave;	    /* when named */
	bool sets_frequency_0;		    /* when named */
	bool own_turbulence;		    /* the item's turbulence does not displace the point */
	bool needs_wave_sources;
	bool only_normals;	       /* no colour: the surface is its whole effect */
	const struct default_map *map; /* NULL: default_map_grey */
	/* Derives what evaluation needs, once all parameters are set. NULL: nothing to do. */
	void (*build)(void *self);
	/* What is wrong with the parameters once all are set, as a message; NULL, also returned: nothing. */
	const char *(*complaint)(const void *self);
	/* The raw value at the warped point. */
	double (*value)(const struct pattern *, vec3 q, struct surface *);
	/* A vector formula of its own when used as a normal: n after perturbation by `amount`.
	 * NULL: finite differences of the value. */
	vec3 (*perturb)(const struct pattern *, vec3 q, vec3 n, double amount, struct surface *);
};

/* An item's pattern with all its modifiers: warp, raw value, frequency and phase, wave. */
struct pattern {
	const struct pattern_class *class;
	const void *self;
	const struct warp *warps; /* in order of application, or NULL */
	size_t warp_count;
	const transform *place; /* when the warps are transformations only: all in one; or NULL */
	const transform *frame; /* all transformations in one, for directions; NULL: none */
	const struct turbulence *turbulence; /* NULL: none */
	bool displaces;			     /* the turbulence moves the point */
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
