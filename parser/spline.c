/* SPDX-License-Identifier: MIT */
/*
 * Splines of the language: the sorted list of entries, and calls. The curves
 * themselves are in base/spline.c.
 */
#include "parser/build.h"

#include <string.h>

static enum spline_type type_of(enum keyword word)
{
	switch (word) {
	case K_QUADRATIC_SPLINE:
		return SPLINE_QUADRATIC;
	case K_CUBIC_SPLINE:
		return SPLINE_CUBIC;
	case K_NATURAL_SPLINE:
		return SPLINE_NATURAL;
	default:
		return SPLINE_LINEAR;
	}
}

/* With another type than its own: the same entries. */
struct number spline_call(
	struct parser *p, const struct spline *s, enum keyword type, double at, span where)
{
	(void)where;
	struct spline as = *s;
	as.type = type == K_NONE ? s->type : type_of(type);
	if (as.type == SPLINE_NATURAL && !as.curvature)
		as = *spline_naturalize(p->arena, s);
	struct number out = { .terms = (uint8_t)s->terms };
	spline_value(&as, at, out.v);
	return out;
}

/* -- Building ----------------------------------------------------------------------------- */

void spline_entry(struct parser *p, double key, span key_at, struct number value, span at)
{
	if (value.terms == 1) { /* at least a 2-vector */
		value.terms = 2;
		value.v[1] = value.v[0];
	}
	args_push_number(p, number_float(key), key_at);
	args_push_number(p, value, at);
}

struct entries {
	double *keys;
	double (*values)[5];
	size_t count;
};

/* Keeps the keys sorted. An equal key replaces the value, but not that of the largest key. */
static void insert(struct entries *e, double key, const double value[5])
{
	size_t i = e->count;
	while (i > 0 && e->keys[i - 1] >= key)
		i--;
	if (i < e->count && e->keys[i] == key) {
		if (i + 1 < e->count || e->count < 2)
			memcpy(e->values[i], value, sizeof e->values[i]);
		return;
	}
	memmove(e->keys + i + 1, e->keys + i, (e->count - i) * sizeof *e->keys);
	memmove(e->values + i + 1, e->values + i, (e->count - i) * sizeof *e->values);
	e->keys[i] = key;
	memcpy(e->values[i], value, sizeof e->values[i]);
	e->count++;
}

const struct spline *spline_build(
	struct parser *p, const struct spline *base, enum keyword type, size_t start, span where)
{
	struct grammar *g = p->grammar;
	const size_t added = (g->arg_count - start) / 2, old = base ? base->count : 0;
	struct entries e = { ARENA_ARRAY(p->arena, old + added + 1, double),
		arena_array(p->arena, old + added + 1, sizeof(double[5])), old };
	struct spline *spline = ARENA_NEW(p->arena, struct spline);
	unsigned terms = base ? base->terms : 2;
	if (!g->spline_warned)
		diag_warning(p->diag, where, "splines are an experimental feature of the language");
	g->spline_warned = true;
	if (old) {
		memcpy(e.keys, base->keys, old * sizeof *e.keys);
		memcpy(e.values, base->values, old * sizeof *e.values);
	}
	for (size_t i = 0; i < added; i++) {
		const struct number value = g->args[start + 2 * i + 1].number;
		double v[5] = { 0 };
		memcpy(v, value.v, value.terms * sizeof *v);
		terms = value.terms > terms ? value.terms : terms;
		insert(&e, g->args[start + 2 * i].number.v[0], v);
	}
	g->arg_count = start;
	if (!e.count)
		parser_error(p, where, "a spline needs at least one entry");
	spline->type = type != K_NONE ? type_of(type) : base ? base->type : SPLINE_LINEAR;
	spline->terms = terms;
	spline->count = e.count;
	spline->keys = e.keys;
	spline->values = (const double(*)[5])e.values;
	return spline->type == SPLINE_NATURAL ? spline_naturalize(p->arena, spline) : spline;
}
