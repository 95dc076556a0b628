/* SPDX-License-Identifier: MIT */
/*
 * The acceleration structure over all objects of a scene: one 8-wide bounding
 * volume hierarchy over the bounded ones, and a short list of the others.
 */
#ifndef LAMBERT_ACCEL_ACCEL_H
#define LAMBERT_ACCEL_ACCEL_H

#include "geometry/object.h"

struct accel;

struct accel *accel_build(struct object *const *objects, size_t count, unsigned threads);
void accel_destroy(struct accel *);

/* The nearest hit with tmin <= t < tmax on an object with a bit of `kinds` in visible_to. Exact
 * ties go to the lower rank. The ray's direction is unit. */
bool accel_nearest(const struct accel *, const ray *, double tmin, double tmax, uint32_t kinds,
	struct hit *found);
/* Whether anything with a bit of `kinds` lies strictly between tmin and tmax. */
bool accel_any(const struct accel *, const ray *, double tmin, double tmax, uint32_t kinds);
/* Some such object, or NULL. `guess` (NULL: none), say what has blocked the ray before this one, is
 * asked first. */
const struct object *accel_blocker(const struct accel *, const ray *, double tmin, double tmax,
	uint32_t kinds, const struct object *guess);
/* All objects whose inside contains p, in declaration order (bounded ones first). Returns the
 * count, at most `room`. */
size_t accel_containing(const struct accel *, vec3 p, const struct object **found, size_t room);

struct accel_stats {
	size_t objects, unbounded, nodes, depth, bytes;
};
struct accel_stats accel_statistics(const struct accel *);

#endif
