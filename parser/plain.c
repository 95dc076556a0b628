/* SPDX-License-Identifier: MIT */
/*
 * Vectors of literals straight from the raw tokens: what large meshes are made
 * of. Whatever else is met is left to the grammar.
 */
#include "expand.h"

/* A number of a plain vector: a literal with signs before it. Moves *at behind it. */
static bool plain_component(const struct frame *f, uint32_t *at, double *value)
{
	bool negative = false;
	for (; *at < f->end && f->tokens[*at].kind == '-'; ++*at)
		negative = !negative;
	if (*at == f->end)
		return false;
	const struct raw_token raw = f->tokens[(*at)++];
	if (raw.kind == RAW_INTEGER)
		*value = raw.payload;
	else if (raw.kind == RAW_NUMBER)
		*value = f->source->numbers[raw.payload];
	else
		return false;
	if (negative)
		*value = -*value;
	return true;
}

static bool ends_row(unsigned next)
{
	return next == ',' || next == '<' || next == '}' || next == RAW_INTEGER;
}

/* Whether the text goes on with another vector behind this piece of it. */
static bool is_split(const struct frame *f)
{
	return !f->is_macro && f->source->rest;
}

static void step_to(struct parser *p, uint32_t position)
{
	struct frame *f = top_frame(p->expand);
	p->expand->work += position - f->position;
	p->token_count += position - f->position;
	f->position = position;
}

bool expand_plain_row(struct parser *p, unsigned terms, double *v)
{
	struct expand *x = p->expand;
	struct frame *f = top_frame(x);
	uint32_t at = f->position;
	if (at == f->end || f->tokens[at++].kind != '<' || has_read_ahead(x))
		return false;
	for (unsigned i = 0; i < terms; i++) {
		if (!plain_component(f, &at, &v[i]) || at == f->end ||
			f->tokens[at++].kind != (i + 1 < terms ? ',' : '>'))
			return false;
	}
	if (at == f->end ? !is_split(f) : !ends_row(f->tokens[at].kind))
		return false;
	step_to(p, at);
	if (at < f->end || next_piece(x))
		step_to(p, f->position + (f->tokens[f->position].kind == ','));
	return true;
}

bool expand_plain_vector(struct parser *p, struct number *number, span *last)
{
	struct expand *x = p->expand;
	struct frame *f = top_frame(x);
	uint32_t at = f->position;
	unsigned terms = 0;
	if (has_read_ahead(x))
		return false;
	for (;;) {
		if (terms == 5 || !plain_component(f, &at, &number->v[terms++]) || at == f->end)
			return false;
		const unsigned kind = f->tokens[at].kind;
		if (kind == '>' && terms > 1)
			break;
		if (kind != ',' && kind != RAW_INTEGER && kind != RAW_NUMBER)
			return false;
		at += kind == ',';
	}
	*last = (span){ f->source->number, f->tokens[at].offset, 1, f->site };
	step_to(p, at + 1);
	x->before = *x->gate;
	gate_note(x->gate, '>', &(const struct token_value){ .keyword = K_NONE });
	number->terms = (uint8_t)terms;
	number->leftover = false;
	return true;
}
