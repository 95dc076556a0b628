/* SPDX-License-Identifier: MIT */
/*
 * The interiors a ray is in, in the order of entering. Lists too long for the
 * struct live in an arena; a copy of such a list is marked as borrowed and gets
 * an array of its own when it changes.
 */
#ifndef LAMBERT_MEDIUM_INTERIOR_STACK_H
#define LAMBERT_MEDIUM_INTERIOR_STACK_H

#include "scene/scene.h"

enum { INTERIOR_STACK_INLINE = 4 };
struct interior_stack {
	uint32_t count, room; /* room: of spill */
	bool borrowed;	      /* spill belongs to the list this is a copy of */
	const struct interior *own[INTERIOR_STACK_INLINE];
	const struct interior **spill; /* all of them, if room > 0 */
};

/* Makes *s a copy to be changed on its own, while the original stays as it is. */
static inline void interior_stack_borrow(
	struct interior_stack *s, const struct interior_stack *original)
{
	*s = *original;
	s->borrowed = true;
}
bool interior_stack_has(const struct interior_stack *, const struct interior *);
/* Removes the interior if it is there, appends it if not. */
void interior_stack_toggle(struct interior_stack *, const struct interior *, struct arena *);
/* Whether fog fills the space the ray is in. */
bool interior_stack_is_hollow(const struct interior_stack *);
/* Ratio of indices on crossing the surface of an interior. */
double interior_stack_ratio(const struct interior_stack *, const struct interior *);
/* Relative index for Fresnel's formula. */
double interior_stack_fresnel_ratio(const struct interior_stack *, const struct interior *);
/* All interiors around p. */
struct interior_stack interior_stack_at(const struct scene *, vec3 p, struct arena *);

#endif
