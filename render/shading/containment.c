/* SPDX-License-Identifier: MIT */
/*
 * The interiors a ray is inside of. Crossing the surface of an interior toggles
 * its membership, and the last member is the medium the ray travels in: nested
 * objects are carved out of the one around them, and where two overlap the space
 * belongs to the one entered last.
 */
#include "shading.h"

#include <string.h>

/* Of objects that were given none. */
static const struct interior solid = { .ior = 1, .dispersion = 1 };
static const struct interior hollow = { .ior = 1, .dispersion = 1, .hollow = true };

const struct interior *object_interior(const struct object *object)
{
	if (object->interior)
		return object->interior;
	return object->hollow ? &hollow : &solid;
}

static const struct interior *const *members(const struct containment *c)
{
	return c->room ? c->spill : c->own;
}

/* Moves the list to an array of its own with room for `room`. */
static void move_out(struct containment *c, uint32_t room, struct arena *arena)
{
	const struct interior **grown = ARENA_ARRAY(arena, room, const struct interior *);
	memcpy(grown, members(c), c->count * sizeof *grown);
	c->spill = grown;
	c->room = room;
	c->borrowed = false;
}

/* Makes the list changeable, with room for one more. */
static const struct interior **writable(struct containment *c, struct arena *arena)
{
	if (c->room == 0 && c->count < CONTAINMENT_INLINE)
		return c->own;
	if (c->count >= c->room || c->borrowed)
		move_out(c, 2 * (c->count + 1), arena);
	return c->spill;
}

static void append(struct containment *c, const struct interior *interior, struct arena *arena)
{
	writable(c, arena)[c->count] = interior;
	c->count++;
}

static void take_out(struct containment *c, uint32_t index, struct arena *arena)
{
	const struct interior **items = c->room ? writable(c, arena) : c->own;
	for (uint32_t i = index; i + 1 < c->count; i++)
		items[i] = items[i + 1];
	c->count--;
}

bool containment_has(const struct containment *c, const struct interior *interior)
{
	const struct interior *const *m = members(c);
	for (uint32_t i = 0; i < c->count; i++)
		if (m[i] == interior)
			return true;
	return false;
}

void containment_toggle(struct containment *c, const struct interior *interior, struct arena *arena)
{
	const struct interior *const *m = members(c);
	for (uint32_t i = c->count; i-- > 0;) {
		if (m[i] == interior) {
			take_out(c, i, arena);
			return;
		}
	}
	append(c, interior, arena);
}

bool containment_is_hollow(const struct containment *c)
{
	const struct interior *const *m = members(c);
	for (uint32_t i = 0; i < c->count; i++)
		if (!m[i]->hollow)
			return false;
	return true;
}

double containment_ratio(const struct containment *c, const struct interior *interior)
{
	if (c->count == 0)
		return 1 / interior->ior;
	const struct interior *const *m = members(c);
	const struct interior *last = m[c->count - 1];
	if (last == interior)
		return c->count == 1 ? interior->ior : interior->ior / m[c->count - 2]->ior;
	return containment_has(c, interior) ? 1 : last->ior / interior->ior;
}

double containment_fresnel_ratio(const struct containment *c, const struct interior *interior)
{
	if (c->count == 0)
		return interior->ior;
	const struct interior *last = members(c)[c->count - 1];
	if (!containment_has(c, interior))
		return interior->ior / last->ior;
	return c->count == 1 ? 1 / interior->ior : last->ior / interior->ior;
}

struct containment containment_at(const struct scene *scene, vec3 p, struct arena *arena)
{
	struct containment c = { 0 };
	const struct object *few[32];
	const struct object **found = few;
	size_t room = sizeof few / sizeof *few;
	size_t count = accel_containing(scene->accel, p, found, room);
	while (count == room) {
		room *= 2;
		found = ARENA_ARRAY(arena, room, const struct object *);
		count = accel_containing(scene->accel, p, found, room);
	}
	for (size_t i = 0; i < count; i++) {
		if (!found[i]->is_repeat)
			append(&c, object_interior(found[i]), arena);
	}
	return c;
}
