/* SPDX-License-Identifier: MIT */
/*
 * The interiors a ray is inside of. Crossing the surface of an interior toggles
 * its membership, and the last member is the medium the ray travels in: nested
 * objects are carved out of the one around them, and where two overlap the space
 * belongs to the one entered last.
 */
#include "render/shading.h"

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
	return c->count > CONTAINMENT_INLINE ? c->spill : c->own;
}

static void replace(struct containment *c, const struct interior *const *items, uint32_t count,
	struct arena *arena)
{
	if (count > CONTAINMENT_INLINE)
		c->spill = arena_copy(arena, items, count * sizeof *items);
	else
		memcpy(c->own, items, count * sizeof *items);
	c->count = count;
}

static void append(struct containment *c, const struct interior *interior, struct arena *arena)
{
	if (c->count < CONTAINMENT_INLINE) {
		c->own[c->count++] = interior;
		return;
	}
	const struct interior **grown = ARENA_ARRAY(arena, c->count + 1, const struct interior *);
	memcpy(grown, members(c), c->count * sizeof *grown);
	grown[c->count++] = interior;
	c->spill = grown;
}

static void take_out(struct containment *c, uint32_t index, struct arena *arena)
{
	const struct interior *const *old = members(c);
	if (c->count <= CONTAINMENT_INLINE) {
		for (uint32_t i = index; i + 1 < c->count; i++)
			c->own[i] = c->own[i + 1];
		c->count--;
		return;
	}
	const struct interior **kept = ARENA_ARRAY(arena, c->count, const struct interior *);
	memcpy(kept, old, index * sizeof *kept);
	memcpy(kept + index, old + index + 1, (c->count - index - 1) * sizeof *kept);
	replace(c, kept, c->count - 1, arena);
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
	for (size_t i = 0; i < count; i++)
		append(&c, object_interior(found[i]), arena);
	return c;
}
