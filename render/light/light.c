/* SPDX-License-Identifier: MIT */
/*
 * The list of lights, and finding one by its word.
 */
#include "light/light.h"

#include <string.h>

#define LIGHT(name) extern const struct light_class light_##name;
#include "lights.def"
#undef LIGHT

static const struct light_class *const lights[] = {
#define LIGHT(name) &light_##name,
#include "lights.def"
#undef LIGHT
};

const struct light_class *light_find(const char *word)
{
	for (size_t i = 0; i < sizeof lights / sizeof lights[0]; i++) {
		if (strcmp(lights[i]->name, word) == 0)
			return lights[i];
	}
	return NULL;
}
