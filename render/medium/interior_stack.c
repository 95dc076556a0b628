/* SPDX-License-Identifier: MIT */
/*
 * The interiors a ray is inside of. Crossing the surface of an interior toggles
 * its membership, and the last member is the medium the ray travels in: nested
 * objects are carved out of the one around them, and where two overlap the space
 * belongs to the one entered last.
 */
#include "medium/interior_stack.h"

#include "accel/accel.h"
#include "base/arena.h"
#include "medium/interior.h"

#include <string.h>

static const struct interior *const *members(const struct interior_stack *s)
{
	return s->room ? s->spill : s->own;
}

/* Moves the list to an array of its own with room for `room`. */
static void move_out(struct interior_stack *s, uint32_t room, struct arena *arena)
{
	const struct interior **grown = ARENA_ARRAY(arena, room, const struct interior *);
	memcpy(grown, members(s), s->count * sizeof *grown);
	s->spill = grown;
	s->room = room;
	s->borrowed = false;
}

/* Makes the list changeable, with room for one more. */
static const struct interior **writable(struct interior_stack *s, struct arena *arena)
{
	if (s->room == 0 && s->count < INTERIOR_STACK_INLINE)
		return s->own;
	if (s->count >= s->room || s->borrowed)
		move_out(s, 2 * (s->count + 1), arena);
	return s->spill;
}

static void append(struct interior_stack *s, const struct interior *interior, struct arena *arena)
{
	writable(s, arena)[s->count] = interior;
	s->count++;
}

static void take_out(struct interior_stack *s, uint32_t index, struct arena *arena)
{
	const struct interior **items = s->room ? writable(s, arena) : s->own;
	for (uint32_t i = index; i + 1 < s->count; i++)
		items[i] = items[i + 1];
	s->count--;
}

bool interior_stack_has(const struct interior_stack *s, const struct interior *interior)
{
	const struct interior *const *m = members(s);
	for (uint32_t i = 0; i < s->count; i++)
		if (m[i] == interior)
			return true;
	return false;
}

void interior_stack_toggle(
	struct interior_stack *s, const struct interior *interior, struct arena *arena)
{
	const struct interior *const *m = members(s);
	for (uint32_t i = s->count; i-- > 0;) {
		if (m[i] == interior) {
			take_out(s, i, arena);
			return;
		}
	}
	append(s, interior, arena);
}

bool interior_stack_is_hollow(const struct interior_stack *s)
{
	const struct interior *const *m = members(s);
	for (uint32_t i = 0; i < s->count; i++)
		if (!m[i]->hollow)
			return false;
	return true;
}

double interior_stack_ratio(const struct interior_stack *s, const struct interior *interior)
{
	if (s->count == 0)
		return 1 / interior->ior;
	const struct interior *const *m = members(s);
	const struct interior *last = m[s->count - 1];
	if (last == interior)
		return s->count == 1 ? interior->ior : interior->ior / m[s->count - 2]->ior;
	return interior_stack_has(s, interior) ? 1 : last->ior / interior->ior;
}

double interior_stack_fresnel_ratio(const struct interior_stack *s, const struct interior *interior)
{
	if (s->count == 0)
		return interior->ior;
	const struct interior *last = members(s)[s->count - 1];
	if (!interior_stack_has(s, interior))
		return interior->ior / last->ior;
	return s->count == 1 ? 1 / interior->ior : last->ior / interior->ior;
}

struct interior_stack interior_stack_at(const struct scene *scene, vec3 p, struct arena *arena)
{
	struct interior_stack s = { 0 };
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
			append(&s, object_interior(found[i]), arena);
	}
	return s;
}
