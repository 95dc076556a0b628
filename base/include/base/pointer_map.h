/* SPDX-License-Identifier: MIT */
/*
 * A map from pointers to pointers: what has been made of a node already.
 * Zero-initialise; release with pointer_map_release.
 */
#ifndef LAMBERT_BASE_POINTER_MAP_H
#define LAMBERT_BASE_POINTER_MAP_H

#include <stddef.h>

struct pointer_map {
	size_t size, count; /* size: a power of two, or 0 */
	struct pointer_pair {
		const void *key;
		void *value;
	} * pairs;
};

/* NULL when the key is not there. */
void *pointer_map_find(const struct pointer_map *, const void *key);
/* The key must not be NULL and not be there yet. */
void pointer_map_add(struct pointer_map *, const void *key, void *value);
void pointer_map_release(struct pointer_map *);

#endif
