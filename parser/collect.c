/* SPDX-License-Identifier: MIT */
/*
 * The memory of strings and arrays, which loops make without end. Now and then,
 * between two statements, what no variable holds any more is given back: arrays
 * that are not reached from a symbol are freed, and the strings that are move to
 * a new arena.
 *
 * That is sound only where nothing else can hold a value: outside of all
 * expressions, with no token read ahead, and with no macro running, whose
 * parameters may stand for elements of arrays. Nodes have strings of their own.
 */
#include "expand.h"

#include <stdlib.h>
#include <string.h>

enum {
	LEAST = 4 << 20,	 /* bytes that are not worth the trouble */
	LEAST_SYMBOLS = 1 << 14, /* removed ones */
};

/* -- Arrays ------------------------------------------------------------------------------- */

static size_t array_bytes(const struct array *a)
{
	return sizeof *a + a->count * sizeof *a->elements;
}

void array_keep(struct parser *p, struct array *a)
{
	if (!growth_permits(p, (double)array_bytes(a), NO_SPAN))
		a->count = 1;
	a->elements = memory_zeroed(a->count, sizeof *a->elements);
	a->next = p->held.arrays;
	p->held.arrays = a;
	p->held.array_bytes += array_bytes(a);
}

struct value value_copy(struct parser *p, const struct value *v)
{
	struct value copy = *v;
	if (v->kind != VALUE_ARRAY)
		return copy;
	copy.array = memory_alloc(1, sizeof *copy.array);
	*copy.array = *v->array;
	array_keep(p, copy.array);
	for (size_t i = 0; i < v->array->count && !p->failed; i++)
		copy.array->elements[i] = value_copy(p, &v->array->elements[i]);
	return copy;
}

static void array_destroy(struct array *a)
{
	free(a->elements);
	free(a);
}

/* Frees the arrays that were not reached. */
static void sweep(struct held *h)
{
	struct array **link = &h->arrays;
	h->array_bytes = 0;
	for (struct array *a; (a = *link) != NULL;) {
		if (!a->reached) {
			*link = a->next;
			array_destroy(a);
			continue;
		}
		a->reached = false;
		h->array_bytes += array_bytes(a);
		link = &a->next;
	}
}

/* -- Collecting --------------------------------------------------------------------------- */

static void reach(struct value *v, struct arena *texts)
{
	if (v->kind == VALUE_STRING)
		v->string = arena_string(texts, v->string, strlen(v->string));
	if (v->kind != VALUE_ARRAY || v->array->reached)
		return;
	v->array->reached = true;
	for (size_t i = 0; i < v->array->count; i++)
		reach(&v->array->elements[i], texts);
}

static bool is_sound(const struct expand *x)
{
	for (unsigned i = 0; i < x->frame_count; i++)
		if (x->frames[i].is_macro)
			return false;
	return !x->unread_count && x->gate == &x->scene_gate && !x->gate->depth;
}

void held_collect(struct parser *p)
{
	struct symbols *s = &p->expand->symbols;
	struct held *h = &p->held;
	const bool due =
		arena_used(h->texts) + h->array_bytes >= h->due || s->removed >= LEAST_SYMBOLS;
	if (!due || !is_sound(p->expand))
		return;
	struct arena *texts = arena_create(0);
	symbols_drop_removed(s);
	for (unsigned table = SYMBOL_GLOBAL; table <= s->table; table++)
		for (struct symbol *symbol = s->first[table]; symbol; symbol = symbol->next)
			reach(&symbol->value, texts);
	arena_destroy(h->texts);
	h->texts = texts;
	memset(p->walks, 0, sizeof p->walks);
	sweep(h);
	h->due = 2 * (arena_used(texts) + h->array_bytes) + LEAST;
}

void held_init(struct held *h)
{
	*h = (struct held){ .texts = arena_create(0), .due = LEAST };
}

void held_release(struct held *h)
{
	while (h->arrays) {
		struct array *a = h->arrays;
		h->arrays = a->next;
		array_destroy(a);
	}
	arena_destroy(h->texts);
}
