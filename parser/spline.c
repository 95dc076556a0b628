/* SPDX-License-Identifier: MIT */
/*
 * Splines of the language: the sorted list of entries, and calls. The curves
 * themselves are in base/spline.c.
 */
#include "build.h"

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

/* Worked out when it is first needed, and kept. */
static void need_curvature(struct parser *p, const struct spline *s)
{
	if (!s->curvature)
		((struct spline *)(uintptr_t)s)->curvature = spline_curvature(p->arena, s);
}

/* With another type than its own: the same entries. */
struct number spline_call(
	struct parser *p, const struct spline *s, enum keyword type, double at, span where)
{
	(void)where;
	const enum spline_type as = type == K_NONE ? s->type : type_of(type);
	if (as == SPLINE_NATURAL)
		need_curvature(p, s);
	struct spline other = *s;
	other.type = as;
	struct number out = { .terms = (uint8_t)s->terms };
	spline_value(&other, at, out.v);
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

/* Room for entries. Splines made of each other share it while each only adds at the end: a spline that
 * grows in a loop is not copied every time. */
struct spline_room {
	double *keys;
	double (*values)[5];
	size_t used, capacity;
};

/* Keeps the keys sorted. An equal key replaces the value, but not that of the largest key. */
static void insert(struct spline_room *e, double key, const double value[5])
{
	size_t i = e->used;
	while (i > 0 && e->keys[i - 1] >= key)
		i--;
	if (i < e->used && e->keys[i] == key) {
		if (i + 1 < e->used || e->used < 2)
			memcpy(e->values[i], value, sizeof e->values[i]);
		return;
	}
	memmove(e->keys + i + 1, e->keys + i, (e->used - i) * sizeof *e->keys);
	memmove(e->values + i + 1, e->values + i, (e->used - i) * sizeof *e->values);
	e->keys[i] = key;
	memcpy(e->values[i], value, sizeof e->values[i]);
	e->used++;
}

static bool only_adds(const struct spline *base, const struct arg *args, size_t added)
{
	double last = base->keys[base->count - 1];
	for (size_t i = 0; i < added; i++) {
		const double key = args[2 * i].number.v[0];
		if (!(key > last))
			return false;
		last = key;
	}
	return true;
}

static struct spline_room *make_room(struct parser *p, const struct spline *base, size_t capacity)
{
	struct spline_room *room = ARENA_NEW(p->arena, struct spline_room);
	room->capacity = capacity;
	room->keys = ARENA_ARRAY(p->arena, capacity, double);
	room->values = arena_array(p->arena, capacity, sizeof(double[5]));
	if (base) {
		memcpy(room->keys, base->keys, base->count * sizeof *room->keys);
		memcpy(room->values, base->values, base->count * sizeof *room->values);
		room->used = base->count;
	}
	return room;
}

static struct spline_room *room_for(
	struct parser *p, const struct spline *base, const struct arg *args, size_t added)
{
	if (!base || !base->count)
		return make_room(p, NULL, added + 1);
	const size_t needed = base->count + added;
	if (!only_adds(base, args, added))
		return make_room(p, base, needed);
	if (base->room->used == base->count && needed <= base->room->capacity)
		return base->room;
	return make_room(p, base, 2 * needed);
}

const struct spline *spline_build(
	struct parser *p, const struct spline *base, enum keyword type, size_t start, span where)
{
	struct grammar *g = p->grammar;
	const size_t added = (g->arg_count - start) / 2;
	const struct arg *args = added ? g->args + start : NULL;
	struct spline_room *room = room_for(p, base, args, added);
	struct spline *spline = ARENA_NEW(p->arena, struct spline);
	unsigned terms = base ? base->terms : 2;
	for (size_t i = 0; i < added; i++) {
		const struct number value = args[2 * i + 1].number;
		double v[5] = { 0 };
		memcpy(v, value.v, value.terms * sizeof *v);
		terms = value.terms > terms ? value.terms : terms;
		insert(room, args[2 * i].number.v[0], v);
	}
	g->arg_count = start;
	if (!room->used)
		parser_error(p, where, "a spline needs at least one entry");
	*spline = (struct spline){
		.type = type != K_NONE ? type_of(type)
			: base	       ? base->type
				       : SPLINE_LINEAR,
		.terms = terms,
		.count = room->used,
		.keys = room->keys,
		.values = (const double(*)[5])room->values,
		.room = room,
	};
	return spline;
}
