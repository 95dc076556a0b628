/* SPDX-License-Identifier: MIT */
/*
 * The numbers of a map, or of a list (0, 1, 2 …): a value of the pattern finds one
 * entry or two neighbours to blend. What the entries are is up to the item.
 */
#ifndef LAMBERT_TEXTURE_MAP_H
#define LAMBERT_TEXTURE_MAP_H

#include <stdbool.h>
#include <stddef.h>

struct map {
	size_t count;
	const float *values;	  /* normally ascending */
	const float *differences; /* to the entry before; of the first: 0 */
	bool is_list;		  /* the values are 0, 1, 2 … */
};

/* low == high: that entry alone. Otherwise low + share * (high - low). */
struct blend {
	size_t low, high;
	double share;
};

/* The first entry that is not below v, blended with its predecessor unless v hits it; beyond the ends
 * the end entries. "Not a number" finds the first entry. */
static inline struct blend map_lookup(const struct map *map, double v)
{
	const size_t last = map->count - 1;
	if (v >= (double)map->values[last])
		return (struct blend){ last, last, 0 };
	size_t i = 0;
	while (i < last && v > (double)map->values[i])
		i++;
	if (i == 0 || !(v < (double)map->values[i]))
		return (struct blend){ i, i, 0 };
	return (struct blend){ i - 1, i,
		(v - (double)map->values[i - 1]) / (double)map->differences[i] };
}

#endif
