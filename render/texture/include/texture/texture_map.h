/* SPDX-License-Identifier: MIT */
/*
 * Textures chosen by a pattern, averaged, or placed at the uv coordinates.
 */
#ifndef LAMBERT_TEXTURE_TEXTURE_MAP_H
#define LAMBERT_TEXTURE_TEXTURE_MAP_H

#include "texture/pattern.h"
#include "texture/texture.h"
#include "texture/map.h"

enum texture_kind { TEXTURE_MAP, TEXTURE_AVERAGE, TEXTURE_UV };

struct texture_map {
	enum texture_kind kind;
	bool keeps_length; /* no_bump_scale */
	struct pattern pattern;
	struct map map; /* of an average: the weights as values */
	float total_weight;
	const struct texture *const *textures;
};

/* A patterned texture around a plain one: directions go through its space. */
struct texture_frame {
	const struct texture_frame *outer;
	const struct texture_map *map;
};

#endif
