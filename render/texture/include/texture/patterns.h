/* SPDX-License-Identifier: MIT */
/*
 * The classes, and the parameters of those patterns whose statements have a form of
 * their own, so that lowering fills them by hand.
 */
#ifndef LAMBERT_TEXTURE_PATTERNS_H
#define LAMBERT_TEXTURE_PATTERNS_H

#include "texture/pattern.h"

#define REFUSED(WORD)
#define PATTERN(word, file, form) extern const struct pattern_class pattern_##word;
#include "texture/patterns.def"
#undef PATTERN
#undef REFUSED

/* mandel, julia and magnet. */
struct fractal {
	bool is_julia;
	int magnet; /* 0: none, 1 or 2 */
	int iterations, exponent;
	int exterior, interior; /* colouring types */
	double exterior_factor, interior_factor;
	double real, imaginary; /* of julia */
};
/* For the mandel set of exponent 2; other fractals are grey. */
extern const struct default_map default_map_mandel;

struct slope {
	bool is_point; /* `direction` is a point to look at */
	bool has_altitude;
	vec3 direction, altitude; /* unit, unless is_point */
	double slope_weight, altitude_weight;
	double slope_low, slope_range, altitude_low, altitude_range; /* range 0: none */
};

struct program;
struct function_pattern {
	const struct program *program; /* of x, y, z */
};

struct object_pattern {
	const struct object *object;
};

struct pigment_pattern {
	const struct pigment *pigment;
};

/* The six colours of lists. */
extern const struct default_map default_map_primaries;

#endif
