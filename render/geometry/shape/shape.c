/* SPDX-License-Identifier: MIT */
/*
 * The list of primitives, and finding one by its word.
 */
#include "geometry/shape.h"

#include <string.h>

#define BLOCK					  SHAPE
#define SHAPE(WORD, word, room, file, parameters) SHAPE_##room(word)
#define SHAPE_lower(word)
#define SHAPE_none(word)
#define SHAPE_geometry(word) extern const struct shape_class shape_##word;
#include "language/shapes.def"
#undef SHAPE_geometry

static const struct shape_class *const shapes[] = {
#define SHAPE_geometry(word) &shape_##word,
#include "language/shapes.def"
};

const struct shape_class *shape_find(const char *word)
{
	for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
		if (strcmp(shapes[i]->name, word) == 0)
			return shapes[i];
	}
	return NULL;
}
