/* SPDX-License-Identifier: MIT */
/*
 * Goes on behind a faulty statement, so that one run shows more than one error.
 *
 * That is sound only where the end of the statement is certain: it begins and
 * ends in one file, outside of loops, and its braces close. Whatever the text
 * passed over would have declared is not known now and no further message is
 * due for it: its names are marked as lost. In all other cases the parse ends
 * with the first error.
 */
#include "expand.h"

enum { MOST_RECOVERIES = 100 }; /* also from errors that are not shown */

/* -- Names that would have been declared -------------------------------------------------- */

static void lose_name(struct parser *p, uint32_t id)
{
	struct symbols *s = &p->expand->symbols;
	struct name *name = &s->names->list[id];
	name->lost = true;
	if (name->binding)
		symbol_remove(s, name->binding);
}

/* The names behind the declaring directives between two tokens of a text, and those that were to be
 * declared without one. */
static void lose_names(struct parser *p, const struct frame *f, uint32_t from, uint32_t to)
{
	enum { NEAR = 4 }; /* `deprecated once "text"` or a bracket may stand before the name */
	for (uint32_t i = from; i < to; i++) {
		if (f->tokens[i].kind == RAW_NAME && i + 1 < f->end &&
			f->tokens[i + 1].kind == '=' &&
			!p->expand->names.list[f->tokens[i].payload].binding)
			lose_name(p, f->tokens[i].payload);
		if (f->tokens[i].kind != RAW_DIRECTIVE)
			continue;
		const enum keyword k = f->source->directives[f->tokens[i].payload].keyword;
		if (k != K_DECLARE && k != K_LOCAL && k != K_MACRO && k != K_FOR && k != K_FOPEN)
			continue;
		uint32_t at = i + 1;
		while (at < f->end && at <= i + NEAR && f->tokens[at].kind != RAW_NAME)
			at++;
		if (at < f->end && f->tokens[at].kind == RAW_NAME)
			lose_name(p, f->tokens[at].payload);
	}
}

/* -- Where the statement ends ------------------------------------------------------------- */

/* A walk over raw tokens. Of the branches of a conditional it sees the first. */
struct walk {
	const struct frame *frame;
	uint32_t at;
	unsigned braces, blocks;
};

/* Steps over a directive; false: the walk cannot go on. */
static bool step_directive(struct walk *w)
{
	const struct raw_token raw = w->frame->tokens[w->at++];
	const struct directive *d = &w->frame->source->directives[raw.payload];
	if (directive_opens(d->keyword)) {
		w->blocks++;
		if (d->keyword == K_MACRO)
			w->at = d->end;
		return d->end != NO_TOKEN;
	}
	if (!directive_continues(d->keyword))
		return true;
	if (!w->blocks)
		return false;
	if (d->keyword == K_END) {
		w->blocks--;
		return true;
	}
	w->at = d->end;
	return d->end != NO_TOKEN;
}

static bool step(struct walk *w)
{
	switch (w->frame->tokens[w->at].kind) {
	case RAW_ERROR:
		return false;
	case RAW_DIRECTIVE:
		return step_directive(w);
	case '{':
		w->braces++;
		break;
	case '}':
		w->braces -= w->braces != 0;
		break;
	default:
		break;
	}
	w->at++;
	return true;
}

/* Whether a token may be the first of a statement; what belongs in an object may not. */
static bool may_begin(struct raw_token raw)
{
	if (raw.kind != RAW_KEYWORD)
		return raw.kind == RAW_NAME;
	return !is_object_modifier((enum keyword)raw.payload);
}

/* Whether a statement can begin here. */
static bool at_statement(const struct walk *w)
{
	if (w->braces || w->blocks)
		return false;
	if (w->at == w->frame->end)
		return true;
	const struct raw_token next = w->frame->tokens[w->at];
	const unsigned last = w->at ? w->frame->tokens[w->at - 1].kind : ';';
	if (next.kind == RAW_DIRECTIVE)
		return true;
	return (last == '}' || last == ';') && may_begin(next);
}

/* -- Going on ----------------------------------------------------------------------------- */

/* Leaves the macros and files that the statement has entered. */
static struct frame *leave_inner_texts(struct parser *p, unsigned frames)
{
	struct expand *x = p->expand;
	while (x->frame_count > frames) {
		const struct frame *f = top_frame(x);
		lose_names(p, f, f->position, f->end);
		x->file_count -= !f->is_macro;
		symbols_pop(&x->symbols);
		x->frame_count--;
	}
	return top_frame(x);
}

static bool is_in_loop(const struct expand *x)
{
	for (unsigned i = 0; i < x->statement.blocks; i++)
		if (x->blocks[i].kind == BLOCK_WHILE || x->blocks[i].kind == BLOCK_FOR)
			return true;
	return false;
}

/* As between two statements. */
static void reset(struct parser *p)
{
	struct expand *x = p->expand;
	x->scene_gate = x->before = (struct gate){ .outer = NULL };
	x->gate = &x->scene_gate;
	x->unread_count = 0;
	x->nesting = 0;
	x->block_count = x->statement.blocks;
	while (x->hidden)
		expand_pop_names(p);
	p->failed = false;
}

bool expand_recover(struct parser *p)
{
	struct expand *x = p->expand;
	const struct statement_start start = x->statement;
	if (p->stopped || !start.frames || !start.skippable || x->frame_count < start.began_in ||
		is_in_loop(x) || p->error_count == MOST_ERRORS || ++x->recoveries > MOST_RECOVERIES)
		return false;
	struct frame *f = leave_inner_texts(p, start.frames);
	complete_text(x);
	struct walk w = { .frame = f, .at = start.position };
	const uint32_t reached = f->position;
	const bool by_macro = start.began_in > start.frames; /* it ends with the macro */
	while (w.at < reached || !(at_statement(&w) || (by_macro && w.at == start.position)))
		if (w.at >= f->end || !step(&w))
			return false;
	if (w.at == f->end && start.frames == 1)
		return false; /* nothing is left */
	lose_names(p, f, start.position, w.at);
	reset(p);
	f->position = w.at;
	return true;
}
