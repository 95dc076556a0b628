/* SPDX-License-Identifier: MIT */
/*
 * The table of the built-in functions.
 */
#include "function/internal.h"

#include <stddef.h>

static const struct internal_entry entries[INTERNAL_COUNT] = {
#define INTERNAL(number, name, parameters) [number] = { "f_" #name, parameters, f_##name },
#include "function/internal.def"
#undef INTERNAL
};

const struct internal_entry *internal_find(int number)
{
	if (number < 0 || number >= INTERNAL_COUNT || !entries[number].call)
		return NULL;
	return &entries[number];
}
