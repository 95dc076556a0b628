/* SPDX-License-Identifier: MIT */
/*
 * Making nodes and lists of nodes. Arguments wait on a stack until the
 * statement they belong to is complete.
 */
#include "build.h"

#include <string.h>

const struct node *node_child(const struct node *node, enum keyword keyword)
{
	const struct node *child = node->children;
	while (child && child->keyword != keyword)
		child = child->next;
	return child;
}

/* -- Arguments ---------------------------------------------------------------------------- */

static struct arg *push(struct parser *p, enum arg_kind kind, span where)
{
	struct grammar *g = p->grammar;
	if (g->arg_count == g->arg_capacity) {
		const size_t capacity = g->arg_count ? 2 * g->arg_count : 64;
		g->args = memory_grow(g->args, capacity, sizeof *g->args);
		g->arg_capacity = capacity;
	}
	struct arg *arg = &g->args[g->arg_count++];
	arg->kind = kind;
	arg->span = where;
	return arg;
}

size_t args_height(struct parser *p)
{
	return p->grammar->arg_count;
}

size_t args_push_number(struct parser *p, struct number number, span where)
{
	push(p, ARG_NUMBER, where)->number = number;
	return p->grammar->arg_count - 1;
}

size_t args_push_string(struct parser *p, const char *string, span where)
{
	const char *copy = arena_string(p->tree, string, strlen(string)); /* it outlives values */
	push(p, ARG_STRING, where)->string = copy;
	return p->grammar->arg_count - 1;
}

size_t args_push_function(struct parser *p, const struct function *function, span where)
{
	push(p, ARG_FUNCTION, where)->function = function;
	return p->grammar->arg_count - 1;
}

size_t args_push_array(
	struct parser *p, const double *values, size_t count, unsigned stride, span where)
{
	struct arg *arg = push(p, ARG_ARRAY, where);
	arg->array.values = values;
	arg->array.count = count;
	arg->array.stride = stride;
	return p->grammar->arg_count - 1;
}

/* -- Nodes -------------------------------------------------------------------------------- */

struct node *node_new(struct parser *p, enum keyword keyword, span whole, span word)
{
	struct node *node = arena_pack(p->tree, sizeof *node);
	node->keyword = keyword;
	node->span = whole;
	node->word = word;
	node->state = p->state;
	return node;
}

struct node *node_args(struct parser *p, enum keyword keyword, span whole, span word, size_t start)
{
	struct grammar *g = p->grammar;
	struct node *node = node_new(p, keyword, whole, word);
	const size_t count = g->arg_count - start;
	if (count) {
		struct arg *args = arena_pack(p->tree, count * sizeof *args);
		node->args = memcpy(args, g->args + start, count * sizeof *args);
		node->arg_count = (uint32_t)count;
	}
	g->arg_count = start;
	return node;
}

struct node *node_number(struct parser *p, enum keyword keyword, span whole, span word,
	struct number number, span at)
{
	return node_args(p, keyword, whole, word, args_push_number(p, number, at));
}

struct node *node_float(struct parser *p, enum keyword keyword, span whole, span word, double value,
	span value_span)
{
	return node_number(p, keyword, whole, word, number_float(value), value_span);
}

struct node *node_string(
	struct parser *p, enum keyword keyword, span whole, span word, const char *text, span at)
{
	return node_args(p, keyword, whole, word, args_push_string(p, text, at));
}

struct node *node_function(struct parser *p, enum keyword keyword, span whole, span word,
	const struct function *function, span at)
{
	return node_args(p, keyword, whole, word, args_push_function(p, function, at));
}

struct node *node_block(
	struct parser *p, enum keyword keyword, span whole, span word, struct node_list list)
{
	struct node *node = node_new(p, keyword, whole, word);
	node->children = list.first;
	return node;
}

void reference_count_levels(struct parser *p, const void *declared, span where)
{
	const uintptr_t levels = 1 + (uintptr_t)pointer_map_find(&p->reference_levels, declared);
	if (levels > REFERENCE_LEVELS)
		parser_error(p, where, "declared values use each other more than %d levels deep",
			REFERENCE_LEVELS);
	if (levels > p->levels_read)
		p->levels_read = levels;
}

static void count_parts(struct parser *p, const struct node *declared, span where)
{
	p->parts_read += 1 + (uintptr_t)pointer_map_find(&p->reference_parts, declared);
	if (p->parts_read > REFERENCE_PARTS)
		parser_error(p, where,
			"declared values are used more than %d times here, counting their uses of "
			"each other",
			REFERENCE_PARTS);
}

struct node *node_reference(struct parser *p, struct reference reference, span where)
{
	reference_count_levels(p, reference.node, where);
	count_parts(p, reference.node, where);
	struct node *node = node_new(p, K_REFERENCE, where, where);
	node->ref = reference.node;
	node->name = reference.name;
	return node;
}

struct node *node_wrap(struct parser *p, enum keyword keyword, span whole, span word,
	struct reference reference, span at)
{
	return node_block(p, keyword, whole, word, list_one(node_reference(p, reference, at)));
}

struct node *layers_node(struct parser *p, struct node_list list, span whole)
{
	return list.first == list.last ? list.first
				       : node_block(p, K_LAYERS, whole, list.first->word, list);
}

struct node *copy_node(struct parser *p, struct reference reference, span at, span whole, span word,
	struct node_list modifiers)
{
	struct node_list items = list_one(node_reference(p, reference, at));
	return node_block(p, K_OBJECT, whole, word, list_join(items, modifiers));
}

/* -- Checked arguments -------------------------------------------------------------------- */

static bool is_optional(const char *letters)
{
	return letters[0] && letters[1] == '?';
}

static unsigned least_arguments(const char *letters)
{
	unsigned n = 0;
	for (; *letters; letters++)
		n += *letters != '?' && !is_optional(letters);
	return n;
}

static void check_argument(struct parser *p, struct arg *arg, char letter)
{
	if (arg->kind != ARG_NUMBER)
		return; /* the grammar has seen to it */
	const struct number *n = &arg->number;
	if (!n->leftover && n->terms == (letter == 'f' ? 1 : letter == 'v' ? 3 : 0))
		return;
	switch (letter) {
	case 'f':
		arg->number = number_float(number_to_float(p, arg->number, arg->span));
		break;
	case '2':
		arg->number = number_check(p, arg->number, 2, arg->span);
		break;
	case 'v':
		arg->number = number_check(p, arg->number, 3, arg->span);
		break;
	case '4':
		arg->number = number_check(p, arg->number, 4, arg->span);
		break;
	default:
		break;
	}
}

struct node *node_fit(struct parser *p, enum keyword keyword, span whole, span word, size_t start,
	const char *letters)
{
	struct grammar *g = p->grammar;
	const size_t count = g->arg_count - start;
	const unsigned least = least_arguments(letters);
	const char *const form = letters;
	size_t i = 0;
	for (; *letters && i < count; letters += is_optional(letters) ? 2 : 1)
		check_argument(p, &g->args[start + i++], *letters);
	if (i < count) {
		parser_error(p, g->args[start + i].span, "%s takes no further value",
			keyword_name(keyword));
		if (form[0] == 'v')
			note_point(p, &g->args[start], count);
	} else if (count < least) {
		parser_error(p, word, "%s needs %u value%s, found %zu", keyword_name(keyword),
			least, least == 1 ? "" : "s", count);
		note_sign_in(p, start);
	}
	return node_args(p, keyword, whole, word, start);
}

/* -- Statements of the top level ---------------------------------------------------------- */

/* Whether what has been read has come to a size at which it is handed over. A token that was read
 * ahead may be a part of what follows. */
static bool is_due(const struct parser *p, bool ahead)
{
	const struct parse_options *o = p->options;
	return o->statements && p->tree == o->passing && !ahead && !p->keeps_tree &&
	       arena_used(p->tree) >= PASSING_BYTES;
}

static void forget_tree(struct parser *p)
{
	p->passed_bytes += arena_used(p->tree);
	arena_reset(p->tree);
}

static void pass_statements(struct parser *p)
{
	struct node_list *list = &p->grammar->statements;
	if (list->first)
		p->options->statements(p->options->statements_user, list->first);
	*list = list_none();
}

void scene_add(struct parser *p, struct node *statement, bool ahead)
{
	struct node_list *list = &p->grammar->statements;
	*list = list_add(*list, statement);
	p->parts_read = 0;
	if (!is_due(p, ahead))
		return;
	pass_statements(p);
	forget_tree(p);
}

/* The opening of the union or merge that is the present statement, if nothing is open within; or
 * NULL. What is behind its members does not decide what becomes of each. */
static const struct opening *open_compound(const struct parser *p, const struct run *run)
{
	const struct opening *open = &p->grammar->openings[run->base];
	return run->depth == 1 && (open->keyword == K_UNION || open->keyword == K_MERGE) ? open
											 : NULL;
}

struct node_list member_add(struct parser *p, const struct run *run, struct node_list members,
	struct node *member, bool ahead)
{
	const struct parse_options *o = p->options;
	const struct node_list list = list_add(members, member);
	const struct opening *open = is_due(p, ahead) ? open_compound(p, run) : NULL;
	if (!open)
		return list;
	pass_statements(p);
	if (o->members(o->statements_user, open->word, list.first))
		forget_tree(p);
	return list_none();
}

/* -- Lists -------------------------------------------------------------------------------- */

struct node_list list_none(void)
{
	return (struct node_list){ NULL, NULL };
}

struct node_list list_one(struct node *node)
{
	return (struct node_list){ node, node };
}

struct node_list list_add(struct node_list list, struct node *node)
{
	if (!list.first)
		return list_one(node);
	list.last->next = node;
	list.last = node;
	return list;
}

struct node_list list_join(struct node_list a, struct node_list b)
{
	if (!a.first)
		return b;
	if (!b.first)
		return a;
	a.last->next = b.first;
	return (struct node_list){ a.first, b.last };
}
