/* SPDX-License-Identifier: MIT */
/*
 * Perturbations of the surface normal.
 */
#ifndef LAMBERT_TEXTURE_NORMAL_H
#define LAMBERT_TEXTURE_NORMAL_H

#include "texture/pattern.h"
#include "texture/texture.h"
#include "texture/map.h"

enum normal_kind {
	NORMAL_VECTOR,	/* the pattern's own formula */
	NORMAL_BUMP,	/* differences of the pattern's value */
	NORMAL_MAP,	/* the pattern's value finds normals in `map` */
	NORMAL_AVERAGE, /* of `normals`, weighted */
	NORMAL_UV,	/* normals[0] at the uv coordinates */
};

struct slope_entry {
	double height, slope;
};

struct normal {
	enum normal_kind kind;
	bool keeps_length; /* no_bump_scale: bumps scale with the pattern */
	struct pattern pattern;
	double amount, accuracy;
	struct map map; /* normals, or slopes; of an average: the weights as values */
	float total_weight;
	const struct normal *const *normals; /* entries may be NULL: no perturbation */
	const struct slope_entry *slopes;    /* NULL: the value itself is the height */
};

#endif
