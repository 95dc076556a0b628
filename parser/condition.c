/* SPDX-License-Identifier: MIT */
/*
 * #if, #ifdef, #ifndef, #elseif, #else; #switch, #case, #range.
 */
#include "expand.h"

#include <math.h>

bool condition_read(struct parser *p, double *value)
{
	struct gate gate;
	if (!expect(p, '(', "'(' before the condition"))
		return false;
	gate_open(p, &gate, true);
	const bool ok = parse_condition(p, value) && expect(p, ')', "')' behind the condition");
	gate_close(p);
	return ok;
}

static struct block *top_block(struct parser *p)
{
	struct expand *x = p->expand;
	return x->block_count ? &x->blocks[x->block_count - 1] : NULL;
}

/* Whether the branch of an #if, #ifdef, #ifndef or #elseif is to be taken. */
static bool read_test(struct parser *p, enum keyword keyword, bool *taken)
{
	if (keyword == K_IFDEF || keyword == K_IFNDEF) {
		if (!identifier_defined(p, taken))
			return false;
		*taken ^= keyword == K_IFNDEF;
		return true;
	}
	double value;
	if (!condition_read(p, &value))
		return false;
	*taken = fabs(value) > EPSILON;
	return true;
}

bool condition_if(struct parser *p, const struct directive *d, span opened)
{
	bool taken;
	if (!read_test(p, d->keyword, &taken))
		return false;
	struct block *b = block_push(p, BLOCK_IF, d, opened);
	if (!b)
		return false;
	while (!taken) {
		span where;
		d = block_skip_to_part(p, d, opened, &where);
		if (!d)
			return false;
		switch (d->keyword) {
		case K_END:
			return block_end(p, where);
		case K_ELSE:
			top_block(p)->kind = BLOCK_ELSE;
			return true;
		case K_ELSEIF:
			if (!read_test(p, K_ELSEIF, &taken))
				return false;
			break;
		default:
			parser_error(p, where, "#%s in an #if", keyword_name(d->keyword));
			return false;
		}
	}
	return true;
}

/* From the end of a taken branch to the #end. */
static bool skip_to_end(struct parser *p, const struct directive *d)
{
	span where;
	do {
		d = block_skip_to_part(p, d, top_block(p)->opened, &where);
	} while (d && d->keyword != K_END);
	return d && block_end(p, where);
}

bool condition_else(struct parser *p, const struct directive *d, span where)
{
	struct block *b = top_block(p);
	switch (b ? b->kind : BLOCK_MACRO) {
	case BLOCK_IF:
		return skip_to_end(p, d);
	case BLOCK_SWITCH:
		parser_error(p, where, "expected #case or #range before the #else of a #switch");
		parser_note(p, b->opened, "the block begins here");
		return false;
	case BLOCK_CASE:
		return true;
	case BLOCK_ELSE:
		parser_error(p, where, "a second #else");
		parser_note(p, b->opened, "the block begins here");
		return false;
	default:
		parser_error(p, where, "#else without #if or #switch");
		return false;
	}
}

bool condition_elseif(struct parser *p, const struct directive *d, span where)
{
	const struct block *b = top_block(p);
	if (b && b->kind == BLOCK_IF)
		return skip_to_end(p, d);
	parser_error(p, where, "#elseif without #if");
	return false;
}

/* -- Switch ------------------------------------------------------------------------------- */

/* Whether the value of the switch is that of a #case or within a #range, whose operands follow. */
static bool read_case(struct parser *p, enum keyword keyword, double value, bool *match)
{
	double a, b;
	if (keyword == K_CASE) {
		if (!condition_read(p, &a))
			return false;
		*match = fabs(a - value) < EPSILON;
		return true;
	}
	if (!expect(p, '(', "'(' behind #range"))
		return false;
	struct gate gate;
	gate_open(p, &gate, true);
	bool ok = parse_float(p, &a);
	if (ok)
		accept(p, ',');
	ok = ok && parse_float(p, &b) && expect(p, ')', "')' behind the range");
	gate_close(p);
	*match = ok && a <= value && value <= b;
	return ok;
}

/* Tries parts from `d` on, whose word was read, until one matches. */
static bool try_cases(struct parser *p, const struct directive *d, span where)
{
	const span opened = top_block(p)->opened;
	const double value = top_block(p)->value;
	for (;;) {
		bool match = d->keyword == K_ELSE;
		if (d->keyword == K_END) {
			top_block(p)->kind = BLOCK_CASE;
			return block_end(p, where);
		}
		if (d->keyword == K_ELSEIF) {
			parser_error(p, where, "#elseif in a #switch");
			return false;
		}
		if (d->keyword != K_ELSE && !read_case(p, d->keyword, value, &match))
			return false;
		if (match) {
			top_block(p)->kind = BLOCK_CASE;
			return true;
		}
		d = block_skip_to_part(p, d, opened, &where);
		if (!d)
			return false;
	}
}

bool condition_switch(struct parser *p, const struct directive *d, span opened)
{
	double value;
	if (!condition_read(p, &value))
		return false;
	struct block *b = block_push(p, BLOCK_SWITCH, d, opened);
	if (!b)
		return false;
	b->value = value;
	const struct raw_token *raw = raw_peek(p);
	if (raw && raw->kind == RAW_DIRECTIVE)
		return true; /* other directives may stand before the first #case */
	parser_error(p, raw_span(p), "expected #case or #range behind #switch, found %s",
		raw_describe(p, raw));
	return false;
}

bool condition_case(struct parser *p, const struct directive *d, span where)
{
	const struct block *b = top_block(p);
	if (!b || (b->kind != BLOCK_SWITCH && b->kind != BLOCK_CASE)) {
		parser_error(p, where, "#%s without #switch", keyword_name(d->keyword));
		return false;
	}
	if (b->kind == BLOCK_SWITCH)
		return try_cases(p, d, where);
	bool match; /* falling through: the operands are read all the same */
	return read_case(p, d->keyword, b->value, &match);
}
