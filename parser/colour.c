/* SPDX-License-Identifier: MIT */
/*
 * Colours: the words in front of an expression, the parts behind it, and the
 * maps made of them. Components are computed in double and stored as float.
 */
#include "build.h"

#include "base/elementary.h"
#include "expand.h"

#include <math.h>
#include <string.h>

/* -- rgb, rgbf … srgbft ------------------------------------------------------------------- */

static bool is_srgb(enum keyword word)
{
	return word == K_SRGB || word == K_SRGBF || word == K_SRGBT || word == K_SRGBFT;
}

static unsigned word_terms(enum keyword word)
{
	switch (word) {
	case K_RGB:
	case K_SRGB:
		return 3;
	case K_RGBFT:
	case K_SRGBFT:
		return 5;
	default:
		return 4;
	}
}

/* From sRGB to the working gamma, all in single precision as the reference does. */
static float decode(float c, float gamma)
{
	if (gamma < 0)
		return c;
	const float linear =
		c > 0.04045f ? elementary_powf((c + 0.055f) / 1.055f, 2.4f) : c / 12.92f;
	return gamma == 1 ? linear : elementary_powf(linear, 1.0f / gamma);
}

struct number colour_word(struct parser *p, enum keyword word, struct number n, span where)
{
	const unsigned terms = word_terms(word);
	struct number out = { .terms = 5 };
	if (n.terms > terms)
		diag_warning(p->diag, where,
			"%s is for %u components: all %u of this value are used",
			keyword_name(word), terms, n.terms);
	const unsigned count = n.terms > terms ? n.terms : terms;
	for (unsigned i = 0; i < count; i++)
		out.v[i] = i < n.terms ? n.v[i] : n.terms == 1 ? n.v[0] : 0;
	if (word == K_RGBT || word == K_SRGBT) {
		out.v[4] = out.v[3];
		out.v[3] = 0;
	}
	if (!is_srgb(word))
		return out;
	if (p->state->assumed_gamma == 0)
		parser_error(
			p, where, "%s needs assumed_gamma to be set before", keyword_name(word));
	else
		for (unsigned i = 0; i < 3; i++)
			out.v[i] = (double)decode((float)out.v[i], p->state->assumed_gamma);
	return out;
}

struct colour_value colour_black(void)
{
	return (struct colour_value){ .number = { .terms = 5 }, .words = true };
}

struct colour_parts *colour_part(
	struct parser *p, struct colour_parts *parts, enum keyword word, double value, span at)
{
	unsigned i = 3; /* filter */
	if (!parts)
		parts = ARENA_NEW(p->held.texts, struct colour_parts);
	if (word == K_RED)
		i = 0;
	else if (word == K_GREEN)
		i = 1;
	else if (word == K_BLUE)
		i = 2;
	else if (word == K_TRANSMIT)
		i = 4;
	else if (word == K_ALPHA)
		diag_warning(p->diag, at, "alpha is obsolete, write filter");
	parts->set[i] = true;
	parts->value[i] = value;
	return parts;
}

/* -- Five terms --------------------------------------------------------------------------- */

/* `grey`: how many components a float is copied to. */
static struct number finish(struct colour_value colour, unsigned grey)
{
	struct number out = { .terms = 5 };
	for (unsigned i = 0; i < 5; i++) {
		double v = 0;
		if (i < colour.number.terms)
			v = colour.number.v[i];
		else if (colour.number.terms == 1 && i < grey)
			v = colour.number.v[0];
		if (colour.parts && colour.parts->set[i])
			v = colour.parts->value[i];
		out.v[i] = (double)(float)v;
	}
	return out;
}

struct number colour_full(struct parser *p, struct colour_value colour, span where)
{
	(void)p;
	(void)where;
	return finish(colour, 5);
}

struct number colour_rgb_only(struct parser *p, struct colour_value colour, span where)
{
	struct number out = finish(colour, 3);
	if (out.v[3] != 0 || out.v[4] != 0)
		diag_warning(p->diag, where, "filter and transmit have no effect here");
	out.v[3] = out.v[4] = 0;
	return out;
}

/* Whether what stands at a place is surely no colour identifier. A name from a macro that has ended
 * may mean nothing any more. */
static bool begins_otherwise(struct parser *p, span where)
{
	const struct name *name = expand_name_at(p, where);
	return !name || (name->binding && name->binding->slot->kind == VALUE_NUMBER);
}

struct colour_value colour_bare(struct parser *p, struct colour_value colour, span where)
{
	if (colour.number.terms != 5 || begins_otherwise(p, where))
		parser_error(p, where, "a colour needs the word rgb or color before it here");
	return colour;
}

struct node *colour_node(struct parser *p, struct number number, span where)
{
	return node_number(p, K_COLOUR_VALUE, where, where, number, where);
}

/* -- Maps --------------------------------------------------------------------------------- */

enum { MAP_ENTRIES = 256 };

struct colour_pair *colour_pair(
	struct parser *p, struct colour_value first, const struct colour_value *second)
{
	struct colour_pair *pair = ARENA_NEW(p->arena, struct colour_pair);
	pair->colours[0] = first;
	pair->count = 1;
	if (second) {
		pair->colours[1] = *second;
		pair->count = 2;
	}
	return pair;
}

static struct node *entry(struct parser *p, span whole, double value, struct number colour)
{
	const size_t start = args_push_number(p, number_float((double)(float)value), whole);
	args_push_number(p, colour, whole);
	return node_args(p, K_ENTRY, whole, whole, start);
}

/* The colours of an entry in order; at most two. */
static unsigned entry_list(struct parser *p, const struct arg *args, size_t count,
	const struct colour_pair *pair, struct number out[2], size_t *numbers)
{
	unsigned n = 0;
	*numbers = count;
	if (count > 1 && args[count - 1].number.terms == 5) {
		struct colour_value last = { args[count - 1].number, NULL, true };
		const bool with_parts = pair && pair->count == 1 && !pair->colours[0].words;
		if (with_parts)
			last.parts = pair->colours[0].parts;
		out[n++] = colour_full(p, last, args[count - 1].span);
		*numbers = count - 1;
		if (with_parts)
			return n;
	}
	for (unsigned i = 0; pair && i < pair->count && n < 2; i++)
		out[n++] = colour_full(p, pair->colours[i], NO_SPAN);
	return n;
}

struct node_list colour_map_entry(
	struct parser *p, span whole, size_t start, const struct colour_pair *pair)
{
	struct grammar *g = p->grammar;
	const struct arg *args = g->args + start;
	struct number colours[2] = { { .terms = 5 }, { .terms = 5 } };
	double positions[2] = { 0, 0 };
	size_t numbers;
	const unsigned count = entry_list(p, args, g->arg_count - start, pair, colours, &numbers);
	for (size_t i = 0; i < numbers && i < 2; i++)
		positions[i] = number_to_float(p, args[i].number, args[i].span);
	g->arg_count = start;
	if (numbers == 1 && count == 1)
		return list_one(entry(p, whole, positions[0], colours[0]));
	if (numbers != 2 || count != 2) {
		parser_error(p, whole,
			"an entry of a color_map is [value colour] or [value value color A color "
			"B]");
		return list_none();
	}
	return list_add(list_one(entry(p, whole, positions[0], colours[0])),
		entry(p, whole, positions[1], colours[1]));
}

static bool same_entry(const struct node *a, const struct node *b)
{
	return a->args[0].number.v[0] == b->args[0].number.v[0] &&
	       memcmp(a->args[1].number.v, b->args[1].number.v, sizeof a->args[1].number.v) == 0;
}

struct node *colour_map_node(struct parser *p, span whole, span word, struct node_list list)
{
	struct node_list kept = list_none();
	unsigned count = 0;
	for (struct node *n = list.first, *next; n; n = next) {
		next = n == list.last ? NULL : (struct node *)n->next;
		if (kept.last && same_entry(kept.last, n))
			continue;
		n->next = NULL;
		kept = list_add(kept, n);
		count++;
	}
	if (count > MAP_ENTRIES)
		parser_error(p, whole, "a map has at most %d entries", MAP_ENTRIES);
	return node_block(p, K_COLOR_MAP, whole, word, kept);
}

struct node *map_entry(
	struct parser *p, span whole, size_t start, struct node_list items, bool colours)
{
	struct grammar *g = p->grammar;
	const size_t count = g->arg_count - start;
	size_t numbers = count;
	if (colours && count && g->args[start + count - 1].number.terms == 5) {
		const struct arg *arg = &g->args[start + count - 1];
		struct node *node = colour_node(p,
			colour_full(p, (struct colour_value){ arg->number, NULL, true }, arg->span),
			arg->span);
		items = list_join(list_one(node), items);
		numbers--;
	}
	if (numbers > 1)
		parser_error(p, g->args[start + 1].span, "unexpected number in an entry of a map");
	g->arg_count = start + (numbers ? 1 : 0);
	if (numbers) {
		struct arg *arg = &g->args[start];
		arg->number =
			number_float((double)(float)number_to_float(p, arg->number, arg->span));
	}
	struct node *node = node_args(p, K_ENTRY, whole, whole, start);
	node->children = items.first;
	return node;
}

struct node *slope_entry(struct parser *p, span whole, size_t start)
{
	struct arg *arg = &p->grammar->args[start];
	arg->number = number_float((double)(float)number_to_float(p, arg->number, arg->span));
	return node_fit(p, K_ENTRY, whole, whole, start, "f2");
}
