/* SPDX-License-Identifier: MIT */
/*
 * #while and #for. A pass is a jump back to the tokens of the condition or of
 * the body.
 */
#include "expand.h"

#include <math.h>

/* Counts a pass of the innermost loop. */
static bool is_within_limit(struct parser *p)
{
	struct expand *x = p->expand;
	const double most = p->options->max_loop_tokens;
	const span opened = x->blocks[x->block_count - 1].opened;
	if (most == 0 || (double)++x->work <= most)
		return growth_permits(p, 0, opened);
	parser_stop(p, opened,
		"this loop does not seem to end: the scene has come to %g tokens (--loop-limit "
		"permits more)",
		most);
	return false;
}

/* On behind the #end, out of the loop that is the innermost block. */
static bool leave_loop(struct parser *p)
{
	struct expand *x = p->expand;
	const struct block *b = &x->blocks[--x->block_count];
	if (b->end == NO_TOKEN)
		return block_report_unclosed(p, b->opened);
	top_frame(x)->position = b->end + 1;
	return true;
}

/* -- #while ------------------------------------------------------------------------------- */

bool loop_while(struct parser *p, const struct directive *d, span where)
{
	struct expand *x = p->expand;
	const uint32_t start = top_frame(x)->position;
	const unsigned frame = x->frame_count;
	double value;
	if (!condition_read(p, &value))
		return false;
	struct block *b = block_push(p, BLOCK_WHILE, d, where);
	if (!b)
		return false;
	b->start = start;
	b->frame = frame;
	return fabs(value) > EPSILON || leave_loop(p);
}

static bool while_again(struct parser *p)
{
	struct expand *x = p->expand;
	const unsigned index = x->block_count - 1;
	double value;
	top_frame(x)->position = x->blocks[index].start;
	if (!condition_read(p, &value))
		return false;
	return !(fabs(value) < EPSILON) || leave_loop(p);
}

/* -- #for --------------------------------------------------------------------------------- */

struct range {
	double from, to, step;
};

static bool read_range(struct parser *p, struct range *r)
{
	if (!parse_float(p, &r->from))
		return false;
	accept(p, ',');
	if (!parse_float(p, &r->to))
		return false;
	r->step = 1;
	if (accept(p, ',')) {
		if (accept(p, ')')) /* a comma without a step */
			return true;
		if (!parse_float(p, &r->step))
			return false;
	}
	return expect(p, ')', "')' behind the range of #for");
}

/* "( N, from, to, step )", with or without the step. */
static bool read_header(struct parser *p, uint32_t *name, struct range *r, span *where)
{
	if (!expect(p, '(', "'(' behind #for") || !raw_name(p, "the variable of #for", name, where))
		return false;
	const struct raw_token *raw = raw_peek(p);
	if (raw && raw->kind == '[') {
		parser_error(p, *where, "the variable of #for cannot be an element of an array");
		return false;
	}
	if (raw && raw->kind == '=') {
		parser_error(p, raw_span(p),
			"expected ',' behind the variable of #for, as in #for (I, 0, 9)");
		return false;
	}
	struct gate gate;
	gate_open(p, &gate, true);
	accept(p, ',');
	gate_close(p);
	gate_open(p, &gate, true);
	const bool ok = read_range(p, r);
	gate_close(p);
	if (!ok)
		return false;
	if (!(fabs(r->step) >= EPSILON)) {
		parser_error(p, *where, "the step of #for is 0");
		return false;
	}
	return true;
}

static bool is_beyond(double value, double to, double step)
{
	return step > 0 ? value > to + EPSILON : value < to - EPSILON;
}

bool loop_for(struct parser *p, const struct directive *d, span opened)
{
	struct expand *x = p->expand;
	uint32_t name;
	struct range r;
	span where;
	if (!read_header(p, &name, &r, &where))
		return false;
	struct symbols *s = &x->symbols;
	struct symbol *symbol = symbol_find(s, name);
	if (!symbol || symbol->table != s->table)
		symbol = symbol_create(s, name, s->table);
	if (symbol->slot->kind == VALUE_MACRO || symbol->slot->kind == VALUE_FUNCTION) {
		parser_error(p, where, "'%s' is declared and cannot be the variable of #for",
			symbol->text);
		return false;
	}
	*symbol->slot = (struct value){ .kind = VALUE_NUMBER, .number = { 1, false, { r.from } } };
	struct block *b = block_push(p, BLOCK_FOR, d, opened);
	if (!b)
		return false;
	b->start = top_frame(x)->position;
	b->name = name;
	b->to = r.to;
	b->step = r.step;
	const bool runs = r.step > 0 ? r.from < r.to + EPSILON : r.from > r.to - EPSILON;
	return runs || leave_loop(p);
}

static bool for_again(struct parser *p, span where)
{
	struct expand *x = p->expand;
	const struct block *b = &x->blocks[x->block_count - 1];
	const struct symbol *symbol = symbol_find(&x->symbols, b->name);
	if (!symbol || symbol->slot->kind != VALUE_NUMBER || symbol->slot->number.terms != 1) {
		parser_error(p, where, "the variable '%s' of #for is no float any more",
			x->names.list[b->name].text);
		parser_note(p, b->opened, "the loop begins here");
		return false;
	}
	double *value = &symbol->slot->number.v[0];
	*value += b->step;
	if (is_beyond(*value, b->to, b->step))
		return leave_loop(p);
	top_frame(x)->position = b->start;
	return true;
}

bool loop_again(struct parser *p, span where)
{
	const struct expand *x = p->expand;
	if (!is_within_limit(p))
		return false;
	return x->blocks[x->block_count - 1].kind == BLOCK_WHILE ? while_again(p)
								 : for_again(p, where);
}
