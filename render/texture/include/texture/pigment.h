/* SPDX-License-Identifier: MIT */
/*
 * Pigments that are more than a colour.
 */
#ifndef LAMBERT_TEXTURE_PIGMENT_H
#define LAMBERT_TEXTURE_PIGMENT_H

#include "texture/pattern.h"
#include "texture/texture.h"
#include "texture/map.h"

enum pigment_kind {
	PIGMENT_COLOURS,  /* the pattern's value finds colours in `map` */
	PIGMENT_PIGMENTS, /* the same with pigments */
	PIGMENT_AVERAGE,  /* of `pigments`, weighted */
	PIGMENT_UV,	  /* pigments[0] at the uv coordinates */
};

struct pigment_source {
	enum pigment_kind kind;
	struct pattern pattern; /* no class: for average, only its warps */
	struct map map;		/* of an average: the weights as values */
	float total_weight;
	const colour *colours;
	const struct pigment *const *pigments;
};

/* The point (u, v, 0) of a surface, for what is mapped there; the origin when there is none. */
vec3 surface_uv_point(const struct surface *);

#endif
