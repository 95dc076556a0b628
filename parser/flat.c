/* SPDX-License-Identifier: MIT */
/*
 * Textures of versions before 3.0, in which the items of pigment, normal and finish
 * stand by themselves: each becomes a block of its own, which changes what the
 * blocks before it made.
 */
#include "build.h"

/* Below this version POV-Ray warns about them. */
enum { VERSION_BLOCKS = 150 };

struct node *flat_block(struct parser *p, enum keyword block, span whole, struct node_list items)
{
	const struct node *first = items.first;
	if (p->state->version < VERSION_BLOCKS)
		diag_warning(p->diag, first->word, "%s belongs in %s", keyword_name(first->keyword),
			keyword_name(block));
	return node_block(p, block, whole, first->word, items);
}

/* marble and wood, which have a wave of their own only in a pigment { … }. */
struct node *flat_ramp(struct parser *p, enum keyword pattern, span where)
{
	struct node *ramp = node_new(p, K_RAMP_WAVE, where, where);
	return flat_block(
		p, K_PIGMENT, where, list_add(list_one(node_new(p, pattern, where, where)), ramp));
}

struct node *flat_number(struct parser *p, struct colour_value value, span where)
{
	if (value.number.terms > 1 || value.parts) {
		const struct number colour = colour_full(p, colour_bare(p, value, where), where);
		return flat_block(p, K_PIGMENT, where, list_one(colour_node(p, colour, where)));
	}
	return flat_block(p, K_FINISH, where,
		list_one(node_number(p, K_CRAND, where, where, value.number, where)));
}
