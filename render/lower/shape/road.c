/* SPDX-License-Identifier: MIT */
/*
 * The list of roads, from the rows of shapes.def.
 */
#include "lower/road.h"

#define BLOCK					  SHAPE
#define SHAPE(WORD, word, room, file, parameters) SHAPE_##room(WORD, word)
#define SHAPE_geometry(WORD, word)
#define SHAPE_none(WORD, word)
#define SHAPE_lower(WORD, word) extern shape_road shape_road_##word;
#include "language/shapes.def"
#undef SHAPE_lower

static shape_road *const roads[KEYWORD_COUNT] = {
#define SHAPE_lower(WORD, word) [K_##WORD] = shape_road_##word,
#include "language/shapes.def"
};

shape_road *shape_road_find(enum keyword keyword)
{
	return roads[keyword];
}
