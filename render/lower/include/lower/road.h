/* SPDX-License-Identifier: MIT */
/*
 * The road of primitives that become several objects, or one that takes more
 * than values to make: lower/shape/<file>.c, found through the word's row in
 * shapes.def.
 */
#ifndef LAMBERT_LOWER_ROAD_H
#define LAMBERT_LOWER_ROAD_H

#include "lower/lower.h"

/* Makes the objects of a statement, each with shape, self and place, in order; `place` (NULL: none)
 * holds the transformations of the statement. What has no surface but counts in the extent (the blanks
 * of a text) goes to `emit_blank`, or nowhere if that is NULL. False after an error. */
typedef bool shape_road(struct lowering *, const struct node *, const transform *place,
	void (*emit)(void *user, struct object *), void (*emit_blank)(void *user, struct object *),
	void *user);

/* The road of a word, or NULL. */
shape_road *shape_road_find(enum keyword);

#endif
