/* SPDX-License-Identifier: MIT */
/*
 * Open addressing, grown at half load.
 */
#include "base/pointer_map.h"

#include "base/arena.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Where the key is, or the free place where it belongs. */
static size_t place_of(const struct pointer_map *m, const void *key)
{
	size_t place = (uintptr_t)key * 0x9E3779B97F4A7C15u >> 20;
	for (place &= m->size - 1; m->pairs[place].key && m->pairs[place].key != key;)
		place = (place + 1) & (m->size - 1);
	return place;
}

void *pointer_map_find(const struct pointer_map *m, const void *key)
{
	return m->size ? m->pairs[place_of(m, key)].value : NULL;
}

static void grow(struct pointer_map *m)
{
	const struct pointer_map old = *m;
	m->size = old.size ? 2 * old.size : 64;
	m->pairs = memory_alloc(m->size, sizeof *m->pairs);
	memset(m->pairs, 0, m->size * sizeof *m->pairs);
	for (size_t i = 0; i < old.size; i++) {
		if (old.pairs[i].key)
			m->pairs[place_of(m, old.pairs[i].key)] = old.pairs[i];
	}
	free(old.pairs);
}

void pointer_map_add(struct pointer_map *m, const void *key, void *value)
{
	if (2 * (m->count + 1) > m->size)
		grow(m);
	m->pairs[place_of(m, key)] = (struct pointer_pair){ key, value };
	m->count++;
}

void pointer_map_release(struct pointer_map *m)
{
	free(m->pairs);
	*m = (struct pointer_map){ 0, 0, NULL };
}
