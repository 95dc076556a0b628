/* SPDX-License-Identifier: MIT */
/*
 * Maps ([value entry] …) and the lists of integer patterns.
 */
#include "looks.h"

#include <string.h>

enum { ENTRIES_MAX = 256 };

static bool is_declared(const struct node *n)
{
	return n->children && n->children->keyword == K_REFERENCE;
}

const struct node *map_node(const struct node *n)
{
	return is_declared(n) ? node_resolve(n->children) : n;
}

static size_t count_children(const struct node *n, enum keyword word)
{
	size_t count = 0;
	for (const struct node *item = n->children; item; item = item->next)
		count += item->keyword == word;
	return count;
}

static colour read_colour(struct lowering *l, const struct node *entry)
{
	if (entry->arg_count > 1)
		return lower_colour(l, entry, 1);
	const struct node *value = node_child(entry, K_COLOUR_VALUE);
	if (value)
		return lower_colour(l, value, 0);
	diag_error(l->diag, entry->span, "a map entry needs a colour");
	return (colour){ 0, 0, 0, 0, 0 };
}

static struct slope_entry read_slope(struct lowering *l, const struct node *entry)
{
	const vec3 v = lower_vector(l, entry, 1, "a vector <height, slope>");
	return (struct slope_entry){ v.x, v.y };
}

static struct map_state *map_create(struct lowering *l, size_t count)
{
	struct map_state *map = ARENA_NEW(l->arena, struct map_state);
	map->count = count;
	map->values = ARENA_ARRAY(l->arena, count, float);
	return map;
}

/* Entries of an average without a weight have 1. */
static float read_value(struct lowering *l, const struct node *entry, bool is_average)
{
	if (entry->arg_count > 0)
		return (float)lower_float(l, entry, 0, "a value");
	if (!is_average)
		diag_error(
			l->diag, entry->span, "a map entry needs a value before it: [value ...]");
	return 1;
}

static struct map_state *read_map(struct lowering *l, const struct node *n, enum keyword word,
	map_entry_reader *entry_reader, bool is_average)
{
	const size_t count = count_children(n, K_ENTRY);
	if (n->keyword != word || count < 1 || count > ENTRIES_MAX) {
		diag_error(l->diag, n->span, "%s needs 1 to %d entries of its own kind",
			keyword_name(word), ENTRIES_MAX);
		return NULL;
	}
	struct map_state *map = map_create(l, count);
	if (word == K_COLOR_MAP)
		map->colours = ARENA_ARRAY(l->arena, count, colour);
	else if (word == K_SLOPE_MAP)
		map->slopes = ARENA_ARRAY(l->arena, count, struct slope_entry);
	else
		map->items = ARENA_ARRAY(l->arena, count, const void *);
	size_t i = 0;
	for (const struct node *entry = n->children; entry; entry = entry->next) {
		if (entry->keyword != K_ENTRY)
			continue;
		map->values[i] = read_value(l, entry, is_average);
		if (map->colours)
			map->colours[i] = read_colour(l, entry);
		else if (map->slopes)
			map->slopes[i] = read_slope(l, entry);
		else
			map->items[i] = entry_reader(l, entry);
		i++;
	}
	return map;
}

const struct map_state *lower_map(
	struct lowering *l, const struct node *n, map_entry_reader *entry_reader, bool is_average)
{
	const struct node *at = map_node(n);
	if (!is_declared(n))
		return read_map(l, at, n->keyword, entry_reader, is_average);
	struct map_state *map = looks_find(l, at);
	if (map)
		return map;
	struct arena *const before = lowering_keep(l);
	map = read_map(l, at, n->keyword, entry_reader, false);
	l->states = before;
	if (map)
		looks_remember(l, at, map);
	return map;
}

static struct map_state *list_create(struct lowering *l, unsigned count)
{
	struct map_state *map = map_create(l, count);
	map->is_list = true;
	for (unsigned i = 0; i < count; i++)
		map->values[i] = (float)i;
	return map;
}

static void check_list(
	struct lowering *l, const struct node *pattern, enum keyword word, unsigned count)
{
	if (count_children(pattern, word) > count)
		diag_error(l->diag, pattern->span, "%s takes at most %u items",
			keyword_name(pattern->keyword), count);
}

const struct map_state *lower_list(struct lowering *l, const struct node *pattern, unsigned count,
	enum keyword word, map_entry_reader *entry_reader, const void *filler)
{
	struct map_state *map = list_create(l, count);
	check_list(l, pattern, word, count);
	map->items = ARENA_ARRAY(l->arena, count, const void *);
	unsigned i = 0;
	for (const struct node *item = pattern->children; item && i < count; item = item->next)
		if (item->keyword == word)
			map->items[i++] = entry_reader(l, item);
	while (i < count)
		map->items[i++] = filler;
	return map;
}

const struct map_state *lower_colour_list(
	struct lowering *l, const struct node *pattern, const struct pattern_class *class)
{
	struct map_state *map = list_create(l, class->list_count);
	check_list(l, pattern, K_LIST_ITEM, class->list_count);
	map->colours =
		arena_copy(l->arena, class->map->colours, class->list_count * sizeof(colour));
	unsigned i = 0;
	for (const struct node *item = pattern->children; item && i < class->list_count;
		item = item->next)
		if (item->keyword == K_LIST_ITEM)
			map->colours[i++] = lower_colour(l, item, 0);
	return map;
}

const struct map_state *default_map_state(struct lowering *l, const struct pattern_class *class)
{
	const struct default_map *from = class->map ? class->map : &default_map_grey;
	struct map_state *map = looks_find(l, from);
	if (map)
		return map;
	map = map_create(l, from->count);
	memcpy(map->values, from->values, from->count * sizeof(float));
	map->colours = arena_copy(l->arena, from->colours, from->count * sizeof(colour));
	looks_remember(l, from, map);
	return map;
}

struct map map_build(struct lowering *l, const struct map_state *map)
{
	float *differences = ARENA_ARRAY(l->arena, map->count, float);
	for (size_t i = 1; i < map->count; i++)
		differences[i] = map->values[i] - map->values[i - 1];
	return (struct map){ map->count, map->values, differences, map->is_list };
}

float map_total(const struct map_state *map)
{
	float total = 0;
	for (size_t i = 0; i < map->count; i++)
		total += map->values[i];
	return total;
}
