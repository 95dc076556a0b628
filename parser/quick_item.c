/* SPDX-License-Identifier: MIT */
/*
 * The short way for items. Most of a large scene is primitives with plain
 * numbers, in plain colours, moved about and put together; this reads
 *
 *     union {
 *         sphere { <1, 2, 3>, 0.5 pigment { rgb x } translate y }
 *         object { Wheel scale 2 }
 *     }
 *
 * and its like from the raw tokens, and the grammar gets it as one token, T_SHAPE
 * or T_MODIFIER. As in quick.c it is only a short cut: the nodes are made by the
 * functions that the grammar's actions call, and where anything else stands the
 * attempt leaves no trace and the grammar reads the item.
 *
 * An object within objects is attempted again where the attempt at the outer one
 * has failed. To keep that from taking long, those that were open at the failure
 * are left to the grammar at once, see struct frame.
 *
 * The rules mirror those of grammar.y with the same names.
 */
#include "build.h"
#include "language/shape_word.h"

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

/* From a place in the text to the token read last, most often a bracket. */
static span up_to_here(const struct quick *q, span from)
{
	const struct raw_token *last = q->at - 1;
	const uint32_t length = last->kind < RAW_INTEGER ? 1 : raw_span_at(q->p, last).length;
	from.length = last->offset + length - from.offset;
	return from;
}

/* -- Values ------------------------------------------------------------------------------- */

static span since(const struct quick *q, const struct raw_token *first)
{
	const struct frame *f = q->frame;
	return up_to_here(q, (span){ f->source->number, first->offset, 0, f->site });
}

static bool read_argument(struct quick *q, size_t *index)
{
	struct number n;
	const struct raw_token *first = q->at;
	if (!quick_read_sum(q, &n) || !quick_ends_sum(q) || n.terms == 5)
		return false;
	*index = args_push_number(q->p, n, since(q, first));
	return true;
}

static bool read_full_at(struct quick *q, struct number *n, span *where)
{
	const struct raw_token *first = q->at;
	if (!quick_read_full(q, n))
		return false;
	*where = since(q, first);
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

/* Whether a name follows that holds what `token` stands for. */
static bool at_name(const struct quick *q, int token)
{
	if (quick_next(q) != RAW_NAME)
		return false;
	const struct symbol *symbol = symbol_find(&q->p->expand->symbols, q->at->payload);
	return symbol && symbol->slot->kind == VALUE_NODE && symbol->slot->token == token;
}

/* The same and elements of arrays, read. */
static struct node *read_name(struct quick *q, int token)
{
	const struct symbol *symbol;
	if (quick_next(q) != RAW_NAME)
		return NULL;
	const span where = raw_span_at(q->p, q->at);
	const struct value *slot = quick_read_variable(q, &symbol);
	if (!slot || slot->kind != VALUE_NODE || slot->token != token)
		return NULL;
	const struct reference reference = { slot->node, symbol->text };
	return node_reference(q->p, reference, up_to_here(q, where));
}

/* -- Modifiers ---------------------------------------------------------------------------- */

static bool is_move(enum keyword word)
{
	return word == K_TRANSLATE || word == K_ROTATE || word == K_SCALE;
}

static struct node *read_move(struct quick *q)
{
	const struct item item = take_word(q);
	size_t start;
	if (!read_argument(q, &start))
		return NULL;
	return node_fit(q->p, item.word, up_to_here(q, item.at), item.at, start, "v");
}

static struct node *read_plain_colour(struct quick *q)
{
	struct number n;
	span where;
	if (!read_colour(q, &n, &where))
		return NULL;
	const struct colour_value colour = { n, NULL, true };
	return colour_node(q->p, colour_full(q->p, colour, where), where);
}

/* A colour or a declared pigment, moved about. */
static struct node *read_pigment(struct quick *q)
{
	const struct item item = take_word(q);
	if (!quick_skip(q, '{'))
		return NULL;
	struct node *node = at_name(q, T_PIGMENT) ? read_name(q, T_PIGMENT) : read_plain_colour(q);
	struct node_list list = list_none();
	for (; node; node = is_move(next_word(q)) ? read_move(q) : NULL) {
		list = list_add(list, node);
		if (quick_skip(q, '}'))
			return node_block(q->p, K_PIGMENT, up_to_here(q, item.at), item.at, list);
	}
	return NULL;
}

/* An item of a finish that is a colour, or an expression that is one without saying so. */
static struct node *read_finish_colour(struct quick *q)
{
	const struct item item = take_word(q);
	const enum keyword word = next_word(q);
	struct number n;
	span where;
	if (word == K_COLOR || terms_of(word) ? !read_colour(q, &n, &where)
					      : !read_full_at(q, &n, &where))
		return NULL;
	const bool lets_light_through =
		(n.terms > 3 && n.v[3] != 0) || (n.terms > 4 && n.v[4] != 0);
	if (lets_light_through)
		return NULL; /* that has no effect, which is to be said */
	const struct colour_value colour = { n, NULL, true };
	return node_number(q->p, item.word, up_to_here(q, item.at), item.at,
		colour_rgb_only(q->p, colour, where), where);
}

static struct node *read_finish_item(struct quick *q)
{
	size_t start;
	switch (next_word(q)) {
	case K_AMBIENT:
	case K_EMISSION:
		return read_finish_colour(q);
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

typedef struct node *item_reader(struct quick *);

/* A block of items; the first may be a name for what `token` stands for. */
static struct node *read_block(struct quick *q, int token, item_reader *read)
{
	const struct item item = take_word(q);
	struct node_list list = list_none();
	if (!quick_skip(q, '{'))
		return NULL;
	while (!quick_skip(q, '}')) {
		struct node *node =
			quick_next(q) == RAW_NAME && !list.first ? read_name(q, token) : read(q);
		if (!node)
			return NULL;
		list = list_add(list, node);
	}
	return node_block(q->p, item.word, up_to_here(q, item.at), item.at, list);
}

/* What may stand in a texture as well as in an object. */
static struct node *read_look(struct quick *q)
{
	const enum keyword word = next_word(q);
	return is_move(word)	   ? read_move(q)
	       : word == K_PIGMENT ? read_pigment(q)
	       : word == K_FINISH  ? read_block(q, T_FINISH, read_finish_item)
				   : NULL;
}

static bool is_flag(enum keyword word)
{
	return word == K_INVERSE || word == K_NO_SHADOW;
}

/* None of those that only some objects may have. */
static struct node *read_modifier(struct quick *q)
{
	const enum keyword word = next_word(q);
	if (word == K_TEXTURE)
		return read_block(q, T_TEXTURE, read_look);
	if (!is_flag(word))
		return read_look(q);
	const struct item item = take_word(q);
	return node_new(q->p, item.word, item.at, item.at);
}

/* -- Primitives --------------------------------------------------------------------------- */

static bool is_shape(enum keyword word)
{
	const struct shape_word *shape = shape_word_of(word);
	return shape && shape->is_plain;
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
	return shape_node(q->p, item.word, up_to_here(q, item.at), item.at, body);
}

/* -- Compounds ---------------------------------------------------------------------------- */

static struct node *read_object(struct quick *q);

static bool is_object(enum keyword word)
{
	return is_shape(word) || is_csg(word) || word == K_OBJECT;
}

static struct node *read_member(struct quick *q)
{
	return quick_next(q) == RAW_NAME ? read_name(q, T_OBJECT) : read_object(q);
}

static bool at_member(const struct quick *q)
{
	return quick_next(q) == RAW_NAME || is_object(next_word(q));
}

/* Objects, as many as `most`, and what is done to them. */
static bool read_members(struct quick *q, size_t most, struct node_list *list)
{
	while (!quick_skip(q, '}')) {
		const bool member = most && at_member(q);
		struct node *node = member ? read_member(q) : read_modifier(q);
		if (!node)
			return false;
		most = member ? most - 1 : 0; /* none behind the first modifier */
		*list = list_add(*list, node);
	}
	return true;
}

static struct node *read_compound(struct quick *q)
{
	const struct item item = take_word(q);
	struct node_list list = list_none();
	const bool copies = item.word == K_OBJECT;
	/* A name alone in the first place is a copy for the grammar, whatever the word says. */
	if (!quick_skip(q, '{') || (copies ? !at_member(q) : quick_next(q) == RAW_NAME) ||
		!read_members(q, copies ? 1 : SIZE_MAX, &list))
		return NULL;
	return node_block(q->p, item.word, up_to_here(q, item.at), item.at, list);
}

static struct node *read_object(struct quick *q)
{
	const struct raw_token *outer = q->object;
	if (is_shape(next_word(q)))
		return read_shape(q);
	if (!quick_go_down(q))
		return NULL;
	q->object = q->at;
	struct node *object = read_compound(q);
	quick_go_up(q);
	if (object)
		q->object = outer;
	return object;
}

/* -- Attempts ----------------------------------------------------------------------------- */

/* What making nodes changes; nothing else is allocated. */
struct before {
	struct arena_mark tree;
	uintptr_t levels_read, parts_read;
};

static void undo(struct parser *p, const struct before *before)
{
	arena_rewind(p->tree, before->tree);
	p->levels_read = before->levels_read;
	p->parts_read = before->parts_read;
}

/* Whether the object that begins next was open when an attempt failed. */
static bool has_failed(const struct quick *q)
{
	const uint32_t position = (uint32_t)(q->at - q->frame->tokens);
	return position >= q->frame->failed_from && position < q->frame->failed_to;
}

static void note_failure(struct parser *p, const struct quick *q)
{
	struct frame *f = top_frame(p->expand);
	f->failed_from = f->position;
	f->failed_to = (uint32_t)(q->object - f->tokens) + 1;
}

bool quick_item(struct parser *p, unsigned items, struct node **node, enum keyword *word, span *at,
	bool *modifier)
{
	struct quick q;
	if (!quick_begin(&q, p))
		return false;
	const struct before before = { arena_mark(p->tree), p->levels_read, p->parts_read };
	struct node *made = NULL;
	*word = next_word(&q);
	if (*word != K_NONE && !is_flag(*word)) { /* messages name a flag that stands last */
		*at = raw_span_at(p, q.at);
		*modifier = !is_object(*word);
		if (*modifier)
			made = items & ITEMS_MODIFIERS ? read_modifier(&q) : NULL;
		else
			made = items & ITEMS_OBJECTS && !has_failed(&q) ? read_object(&q) : NULL;
	}
	*node = made;
	if (quick_finish(&q, made != NULL))
		return true;
	undo(p, &before);
	if (q.object)
		note_failure(p, &q);
	return false;
}
