/* SPDX-License-Identifier: MIT */
/*
 * The list of primitives, and finding one by its word.
 */
#include "geometry/shape.h"

#include <string.h>

#define SHAPE(name) extern const struct shape_class shape_##name;
#include "shape/shapes.def"
#undef SHAPE

static const struct shape_class *const shapes[] = {
#define SHAPE(name) &shape_##name,
#include "shape/shapes.def"
#undef SHAPE
};

const struct shape_class *shape_find(const char *word)
{
	for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
		if (strcmp(shapes[i]->name, word) == 0)
			return shapes[i];
	}
	return NULL;
}
