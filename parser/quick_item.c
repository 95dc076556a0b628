/* SPDX-License-Identifier: MIT */
/*
 * The short way for items. Most of a large scene is primitives with plain
 * numbers, in plain colours, moved about; this reads
 *
 *     sphere { <1, 2, 3>, 0.5 pigment { rgb x } translate y }
 *
 * and its like from the raw tokens, and the grammar gets it as one token, T_SHAPE
 * or T_MODIFIER. As in quick.c it is only a short cut: the nodes are made by the
 * functions that the grammar's actions call, and where anything else stands the
 * attempt leaves no trace and the grammar reads the item.
 *
 * The rules mirror those of grammar.y with the same names.
 */
#include "parser/build.h"

#include "grammar.tab.h"

/* The first token of an item, and whether the attempt goes on. */
struct item {
	enum keyword word;
	span at;
};

/* The keyword that comes next, or K_NONE. */
static enum keyword next_word(const struct quick *q)
{
	return quick_next(q) == RAW_KEYWORD ? (enum keyword)q->at->payload : K_NONE;
}

static struct item take_word(struct quick *q)
{
	const struct item item = { next_word(q), raw_span_at(q->p, q->at) };
	q->at++;
	return item;
}

/* From a place to the token read last. */
static span up_to_here(const struct quick *q, span from)
{
	return span_join(from, raw_span_at(q->p, q->at - 1));
}

/* -- Values ------------------------------------------------------------------------------- */

static bool read_argument(struct quick *q, size_t *index)
{
	struct number n;
	const struct raw_token *first = q->at;
	if (!quick_read_sum(q, &n) || !quick_ends_sum(q) || n.terms == 5)
		return false;
	span where = raw_span_at(q->p, q->at - 1);
	where.length += where.offset - first->offset;
	where.offset = first->offset;
	*index = args_push_number(q->p, n, where);
	return true;
}

static unsigned terms_of(enum keyword word)
{
	switch (word) {
	case K_RGB:
		return 3;
	case K_RGBF:
	case K_RGBT:
		return 4;
	case K_RGBFT:
		return 5;
	default:
		return 0;
	}
}

/* rgb E, or a variable that holds a colour; color before either. What follows must not be a part of
 * it, such as filter F: the caller sees to that. */
static bool read_colour(struct quick *q, struct number *colour, span *where)
{
	if (q->at == q->end)
		return false;
	*where = raw_span_at(q->p, q->at);
	if (next_word(q) == K_COLOR)
		q->at++;
	const enum keyword word = next_word(q);
	const unsigned terms = terms_of(word);
	if (terms) {
		struct number n;
		const span at = raw_span_at(q->p, q->at++);
		if (!quick_read_full(q, &n) || n.terms > terms)
			return false;
		*colour = colour_word(q->p, word, n, at);
	} else {
		const struct symbol *symbol;
		const struct value *slot =
			quick_next(q) == RAW_NAME ? quick_read_variable(q, &symbol) : NULL;
		if (!slot || slot->kind != VALUE_COLOUR)
			return false;
		*colour = slot->number;
	}
	*where = up_to_here(q, *where);
	return true;
}

/* -- Modifiers ---------------------------------------------------------------------------- */

static struct node *read_move(struct quick *q)
{
	const struct item item = take_word(q);
	size_t start;
	if (!read_argument(q, &start))
		return NULL;
	return node_fit(q->p, item.word, up_to_here(q, item.at), item.at, start, "v");
}

static struct node *read_pigment(struct quick *q)
{
	const struct item item = take_word(q);
	struct number n;
	span where;
	if (!quick_skip(q, '{') || !read_colour(q, &n, &where) || !quick_skip(q, '}'))
		return NULL;
	const struct colour_value colour = { n, NULL, true };
	return node_block(q->p, K_PIGMENT, up_to_here(q, item.at), item.at,
		list_one(colour_node(q->p, colour_full(q->p, colour, where), where)));
}

/* An item of a finish that is one float. */
static struct node *read_finish_item(struct quick *q)
{
	size_t start;
	switch (next_word(q)) {
	case K_BRILLIANCE:
	case K_CRAND:
	case K_DIFFUSE:
	case K_PHONG:
	case K_PHONG_SIZE:
	case K_ROUGHNESS:
	case K_SPECULAR:
		break;
	default:
		return NULL;
	}
	const struct item item = take_word(q);
	/* behind diffuse a second float may follow */
	if (!read_argument(q, &start) || (quick_next(q) != '}' && quick_next(q) != RAW_KEYWORD))
		return NULL;
	return node_fit(q->p, item.word, up_to_here(q, item.at), item.at, start, "f");
}

static struct node *read_finish(struct quick *q)
{
	const struct item item = take_word(q);
	struct node_list list = list_none();
	if (!quick_skip(q, '{'))
		return NULL;
	while (!quick_skip(q, '}')) {
		struct node *node = read_finish_item(q);
		if (!node)
			return NULL;
		list = list_add(list, node);
	}
	return node_block(q->p, K_FINISH, up_to_here(q, item.at), item.at, list);
}

/* What may stand in a texture as well as in an object. */
static struct node *read_look(struct quick *q)
{
	switch (next_word(q)) {
	case K_TRANSLATE:
	case K_ROTATE:
	case K_SCALE:
		return read_move(q);
	case K_PIGMENT:
		return read_pigment(q);
	case K_FINISH:
		return read_finish(q);
	default:
		return NULL;
	}
}

/* A declared texture. */
static struct node *read_texture_name(struct quick *q)
{
	const struct symbol *symbol;
	const span where = raw_span_at(q->p, q->at);
	const struct value *slot = quick_read_variable(q, &symbol);
	if (!slot || slot->kind != VALUE_NODE || slot->token != T_TEXTURE)
		return NULL;
	const struct reference reference = { slot->node, symbol->text };
	return node_reference(q->p, reference, up_to_here(q, where));
}

static struct node *read_texture(struct quick *q)
{
	const struct item item = take_word(q);
	struct node_list list = list_none();
	if (!quick_skip(q, '{'))
		return NULL;
	while (!quick_skip(q, '}')) {
		struct node *node = quick_next(q) == RAW_NAME && !list.first ? read_texture_name(q)
									     : read_look(q);
		if (!node)
			return NULL;
		list = list_add(list, node);
	}
	return node_block(q->p, K_TEXTURE, up_to_here(q, item.at), item.at, list);
}

static struct node *read_modifier(struct quick *q)
{
	switch (next_word(q)) {
	case K_TEXTURE:
		return read_texture(q);
	case K_INVERSE:
	case K_NO_SHADOW: {
		const struct item item = take_word(q);
		return node_new(q->p, item.word, item.at, item.at);
	}
	default:
		return read_look(q);
	}
}

/* -- Primitives --------------------------------------------------------------------------- */

static bool is_shape(enum keyword word)
{
	switch (word) {
	case K_BOX:
	case K_CONE:
	case K_CYLINDER:
	case K_DISC:
	case K_PLANE:
	case K_SMOOTH_TRIANGLE:
	case K_SPHERE:
	case K_TORUS:
	case K_TRIANGLE:
		return true;
	default:
		return false;
	}
}

/* Commas may be left out between arguments. */
static bool read_arguments(struct quick *q, size_t *start)
{
	size_t index;
	if (!read_argument(q, start))
		return false;
	while (quick_next(q) != '}' && quick_next(q) != RAW_KEYWORD) {
		quick_skip(q, ',');
		if (!read_argument(q, &index))
			return false;
	}
	return true;
}

static struct node *read_shape(struct quick *q)
{
	const struct item item = take_word(q);
	struct body body = { .items = list_none() };
	if (!quick_skip(q, '{') || !read_arguments(q, &body.start))
		return NULL;
	while (!quick_skip(q, '}')) {
		struct node *node = read_modifier(q);
		if (!node)
			return NULL;
		body = body_add(body, node);
	}
	struct node *shape = shape_node(q->p, item.word, up_to_here(q, item.at), item.at, body);
	shape_check_items(q->p, shape);
	return shape;
}

/* -- Attempts ----------------------------------------------------------------------------- */

bool quick_item(struct parser *p, unsigned items, struct node **node, enum keyword *word, span *at,
	bool *modifier)
{
	struct quick q;
	if (!quick_begin(&q, p))
		return false;
	const size_t height = args_height(p);
	struct node *made = NULL;
	*word = next_word(&q);
	if (*word != K_NONE) {
		*at = raw_span_at(p, q.at);
		*modifier = !is_shape(*word);
		if (*modifier)
			made = items & ITEMS_MODIFIERS ? read_modifier(&q) : NULL;
		else
			made = items & ITEMS_OBJECTS ? read_shape(&q) : NULL;
	}
	*node = made;
	return quick_finish(&q, made != NULL, height);
}
