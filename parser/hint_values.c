/* SPDX-License-Identifier: MIT */
/*
 * Hints about values that ran together or fell apart: a minus that was meant as
 * a sign and read as a subtraction, several numbers where a vector must stand.
 */
#include "build.h"
#include "expand.h"

#include <stdlib.h>
#include <string.h>

/* The first token of the present text that does not stand before an offset. */
static uint32_t first_from(const struct frame *f, uint32_t offset)
{
	uint32_t low = 0, high = f->end;
	while (low < high) {
		const uint32_t middle = low + (high - low) / 2;
		if (f->tokens[middle].offset < offset)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

const struct raw_token *raw_inside(struct parser *p, const struct opening *open)
{
	const struct frame *f = top_frame(p->expand);
	const uint32_t i = first_from(f, open->where.offset + 1);
	return open->where.source == f->source->number && i < f->end ? &f->tokens[i] : NULL;
}

static bool is_number(const struct raw_token *raw)
{
	return raw->kind == RAW_INTEGER || raw->kind == RAW_NUMBER || raw->kind == RAW_NUMBER_TEXT;
}

static bool is_sign(const struct raw_token *raw)
{
	return raw->kind == '-' || raw->kind == '+';
}

static bool is_operand_end(struct parser *p, const struct raw_token *raw)
{
	double value;
	const enum keyword word = raw->kind == RAW_KEYWORD ? (enum keyword)raw->payload : K_NONE;
	return is_number(raw) || raw->kind == RAW_NAME || raw->kind == '>' || raw->kind == ')' ||
	       raw->kind == ']' || is_axis(word) || constant_value(p, word, &value);
}

/* -- Signs -------------------------------------------------------------------------------- */

/* Whether a '+' or '-' behind an operand stands close to what follows, as a sign does. */
static bool looks_like_sign(struct parser *p, const struct frame *f, uint32_t i)
{
	const struct raw_token *raw = &f->tokens[i];
	return is_sign(raw) && i > 0 && raw->offset + 1 < f->source->size &&
	       !strchr(" \t\r\n", f->source->bytes[raw->offset + 1]) && is_operand_end(p, raw - 1);
}

void note_sign(struct parser *p, span values)
{
	const struct frame *f = top_frame(p->expand);
	if (values.source != f->source->number)
		return;
	const uint32_t end = first_from(f, values.offset + values.length);
	for (uint32_t i = first_from(f, values.offset); i < end; i++) {
		if (!looks_like_sign(p, f, i))
			continue;
		const bool minus = f->tokens[i].kind == '-';
		parser_note(p, raw_span_at(p, &f->tokens[i]),
			"the '%c' was read as %s: is a comma missing before it?", minus ? '-' : '+',
			minus ? "a subtraction" : "an addition");
		return;
	}
}

void note_sign_in(struct parser *p, size_t start)
{
	const struct grammar *g = p->grammar;
	if (start < g->arg_count)
		note_sign(p, span_join(g->args[start].span, g->args[g->arg_count - 1].span));
}

/* -- Rows of numbers ---------------------------------------------------------------------- */

/* Whether a word takes a colour or a vector. */
static bool takes_vector(enum keyword word)
{
	switch (word) {
	case K_AMBIENT:
	case K_DIRECTION:
	case K_EMISSION:
	case K_GRADIENT:
	case K_LOCATION:
	case K_LOOK_AT:
	case K_OFFSET:
	case K_POINT_AT:
	case K_REFLECTION:
	case K_RIGHT:
	case K_ROTATE:
	case K_SCALE:
	case K_SKY:
	case K_TRANSLATE:
	case K_TURBULENCE:
	case K_UP:
		return true;
	default:
		return is_colour_word(word);
	}
}

/* Numbers with their signs, and what stands before them. */
struct row {
	const struct raw_token *before, *first, *end;
	unsigned count;
};

static struct row find_row(const struct frame *f, const struct raw_token *at)
{
	const struct raw_token *const limit = f->tokens + f->end;
	struct row row = { .first = at };
	while (row.first > f->tokens && (is_number(row.first - 1) || is_sign(row.first - 1)))
		row.first--;
	row.before = row.first > f->tokens ? row.first - 1 : NULL;
	for (row.end = row.first; row.end < limit && (is_number(row.end) || is_sign(row.end));
		row.end++)
		row.count += is_number(row.end);
	return row;
}

/* The row as a vector, "<1, -2, 3>"; `*high`: whether a number is above 1. */
static const char *row_as_vector(struct parser *p, const struct row *row, bool *high)
{
	const char *text = "<", *comma = "";
	*high = false;
	for (const struct raw_token *raw = row->first; raw < row->end; raw++) {
		const span where = raw_span_at(p, raw);
		const char *bytes = source_at(p->expand, where)->bytes + where.offset;
		text = arena_printf(p->arena, "%s%s%.*s", text, comma, (int)where.length, bytes);
		comma = is_sign(raw) ? "" : ", ";
		*high |= is_number(raw) && strtod(bytes, NULL) > 1;
	}
	return arena_printf(p->arena, "%s>", text);
}

bool note_row(struct parser *p, span where)
{
	enum { MOST = 5 };
	const struct raw_token *at = raw_before(p, where, 0);
	if (!at)
		return false;
	const struct row row = find_row(top_frame(p->expand), at);
	if (!row.before || row.count < 2 || row.count > MOST)
		return false;
	const enum keyword word =
		row.before->kind == RAW_KEYWORD ? (enum keyword)row.before->payload : K_NONE;
	const bool is_rgb = word == K_RGB || word == K_SRGB;
	if (word ? !takes_vector(word) : row.before->kind != '{')
		return false;
	if (is_rgb && row.count != 3)
		return false;
	bool high;
	const char *vector = row_as_vector(p, &row, &high);
	const bool bytes = high && is_colour_word(word);
	parser_note(p, where, "several numbers are written as one vector%s: %s%s%s%s",
		bytes ? ", and those of a colour go from 0 to 1" : "",
		word ? keyword_name(word) : "", word ? " " : "", vector, bytes ? "/255" : "");
	return true;
}

void note_point(struct parser *p, const struct arg *args, size_t count)
{
	for (size_t i = 0; i < 3; i++)
		if (i >= count || args[i].kind != ARG_NUMBER || args[i].number.terms != 1)
			return;
	parser_note(p, span_join(args[0].span, args[2].span),
		"a point is written as one vector: <a, b, c>");
}
