/* SPDX-License-Identifier: MIT */
/*
 * What the right side of a #declare becomes; array initialisers.
 */
#include "build.h"

#include "grammar.tab.h"

#include <string.h>

/* -- Plain values ------------------------------------------------------------------------- */

struct value value_colour(struct number n)
{
	for (unsigned i = 0; i < 5; i++)
		n.v[i] = (double)(float)n.v[i];
	n.leftover = false;
	return (struct value){ .kind = VALUE_COLOUR, .number = n };
}

struct value value_number(struct number n)
{
	return n.terms == 5 ? value_colour(n) : (struct value){ .kind = VALUE_NUMBER, .number = n };
}

struct value value_string(const char *text)
{
	return (struct value){ .kind = VALUE_STRING, .string = text };
}

struct value value_node(int token, const struct node *node)
{
	return (struct value){ .kind = VALUE_NODE, .token = token, .node = node };
}

static bool is_vector_function(const struct function *f)
{
	return f->kind == FUNCTION_PIGMENT || f->kind == FUNCTION_TRANSFORM ||
	       f->kind == FUNCTION_SPLINE;
}

struct value value_function(const struct function *f)
{
	return (struct value){ .kind = VALUE_FUNCTION,
		.token = is_vector_function(f) ? T_VECTOR_FUNCTION : T_FUNCTION,
		.function = f };
}

struct value value_spline(const struct spline *spline)
{
	return (struct value){ .kind = VALUE_SPLINE, .spline = spline };
}

struct value value_of_symbol(struct parser *p, struct symbol *symbol, span where)
{
	const struct value *value = symbol_value(symbol);
	if (value->kind == VALUE_NONE)
		parser_error(p, where, "'%s' has no value yet", symbol_name(symbol));
	return *value;
}

/* -- Arrays ------------------------------------------------------------------------------- */

struct elements *elements_new(struct parser *p)
{
	return ARENA_NEW(p->held.texts, struct elements);
}

static void add(struct parser *p, struct elements *e, struct element element)
{
	if (e->count == e->capacity) {
		const size_t capacity = e->capacity ? 2 * e->capacity : 8;
		struct element *items = ARENA_ARRAY(p->held.texts, capacity, struct element);
		if (e->count)
			memcpy(items, e->items, e->count * sizeof *items);
		e->items = items;
		e->capacity = capacity;
	}
	e->items[e->count++] = element;
}

/* No more can a declared value; the word is looked up only where it may have been. */
static bool begins_with_t(struct parser *p, const struct value *value, span where)
{
	if (value->kind != VALUE_NUMBER || value->number.terms < 4)
		return false;
	const struct name *name = expand_name_at(p, where);
	return name && name->keyword == K_T;
}

void elements_add(struct parser *p, struct elements *e, struct value value, span where)
{
	if (begins_with_t(p, &value, where))
		parser_error(p, where, "a value cannot begin with t: write +t");
	add(p, e, (struct element){ value, NULL, where });
}

void elements_add_inner(
	struct parser *p, struct elements *e, const struct elements *inner, span where)
{
	add(p, e, (struct element){ .inner = inner, .where = where });
}

enum { LARGEST_ARRAY = 100000000 };

static size_t dimension(struct parser *p, const struct arg *arg)
{
	const double size = number_to_float(p, arg->number, arg->span), cut = size + 1e-10;
	if (cut >= 1 && cut < LARGEST_ARRAY + 1.0)
		return (size_t)cut;
	if (size >= 1)
		parser_error(p, arg->span, "an array has at most %d elements, not %g",
			LARGEST_ARRAY, size);
	else
		parser_error(p, arg->span, "the size of an array must be 1 or more, not %g", size);
	return 1;
}

/* Fills dimension `d` and those below from the nested braces. */
static void fill(struct parser *p, struct array *a, unsigned d, size_t at,
	const struct elements *elements, span where)
{
	const bool last = d + 1 == a->dimensions;
	if (elements->count != a->size[d]) {
		parser_error(p, where, "the array has %zu elements here, but %zu are given",
			a->size[d], elements->count);
		if (elements->count < a->size[d])
			note_sign(p, where);
		return;
	}
	for (size_t i = 0; i < elements->count && !p->failed; i++) {
		const struct element *e = &elements->items[i];
		const size_t index = at * a->size[d] + i;
		if (!e->inner != last) {
			parser_error(p, e->where,
				last ? "unexpected { in the values of an array"
				     : "the values of this dimension need braces");
		} else if (e->inner) {
			fill(p, a, d + 1, index, e->inner, e->where);
		} else if (!array_accepts(a, &e->value)) {
			parser_error(p, e->where, "all elements of an array must be of one type");
		} else {
			a->elements[index] = e->value;
		}
	}
}

struct value value_array(
	struct parser *p, size_t start, span dims, const struct elements *elements, span where)
{
	struct grammar *g = p->grammar;
	struct array *a = memory_zeroed(1, sizeof *a);
	const size_t dimensions = g->arg_count - start;
	a->count = 1;
	if (dimensions > 5)
		parser_error(p, dims, "an array has at most 5 dimensions");
	for (size_t i = 0; i < dimensions && i < 5; i++) {
		a->size[a->dimensions] = dimension(p, &g->args[start + i]);
		a->count *= a->size[a->dimensions++];
		if (a->count > LARGEST_ARRAY) {
			parser_error(p, dims, "an array has at most %d elements, not %g",
				LARGEST_ARRAY, (double)a->count);
			a->count = 1;
		}
	}
	g->arg_count = start;
	if (p->failed)
		a->count = 1;
	array_keep(p, a);
	if (elements && !p->failed)
		fill(p, a, 0, 0, elements, where);
	return (struct value){ .kind = VALUE_ARRAY, .array = a };
}
