/* SPDX-License-Identifier: MIT */
/*
 * Open blocks: #if, #switch, loops and running macros, their #end, and #break.
 *
 * Skipping is a jump along the links made while lexing. Only a block that an
 * include file opens and the including file continues has to be looked for.
 */
#include "parser/expand.h"

struct block *block_push(
	struct parser *p, enum block_kind kind, const struct directive *d, span where)
{
	struct expand *x = p->expand;
	if (x->block_count == MAX_BLOCKS) {
		parser_error(p, where, "too many nested conditionals, loops and macros (%d)",
			MAX_BLOCKS);
		return NULL;
	}
	struct block *b = &x->blocks[x->block_count++];
	*b = (struct block){
		.kind = kind,
		.frame = x->frame_count,
		.end = d ? d->end : NO_TOKEN,
		.opened = where,
		.opener = d ? d->keyword : K_MACRO,
	};
	return b;
}

/* Looks through the rest of a text for the next part of a block that began before. */
static bool find_loose_part(struct frame *f)
{
	for (; f->position < f->end; f->position++) {
		if (f->tokens[f->position].kind != RAW_DIRECTIVE)
			continue;
		const struct directive *d = &f->source->directives[f->tokens[f->position].payload];
		if (directive_continues(d->keyword))
			return true;
		if (!directive_opens(d->keyword))
			continue;
		if (d->end == NO_TOKEN)
			return false;
		f->position = d->end; /* over a whole block */
	}
	return false;
}

static bool report_unclosed(struct parser *p, span opened)
{
	raw_peek(p); /* the text may have gone wrong: that is the better message */
	parser_error(p, opened, "no #end for the block that begins here");
	return false;
}

/* Moves to the next part when the block began in another text than the present one: further down,
 * or in the texts that include this one. */
static bool find_unlinked_part(struct parser *p, span opened)
{
	struct expand *x = p->expand;
	for (;;) {
		struct frame *f = top_frame(x);
		complete_text(x);
		if (find_loose_part(f))
			return true;
		f->position = f->end;
		if (f->end && f->tokens[f->end - 1].kind == RAW_ERROR)
			f->position--;
		if (f->is_macro || x->frame_count == 1 || raw_peek(p) || p->failed)
			return report_unclosed(p, opened);
		x->file_count--;
		symbols_pop(&x->symbols);
		x->frame_count--;
	}
}

const struct directive *block_skip_to_part(
	struct parser *p, const struct directive *part, span opened, span *where)
{
	struct frame *f = top_frame(p->expand);
	if (part->next != NO_TOKEN)
		f->position = part->next;
	else if (!find_unlinked_part(p, opened))
		return NULL;
	f = top_frame(p->expand);
	const uint32_t index = f->tokens[f->position].payload;
	*where = raw_take(p);
	return &f->source->directives[index];
}

bool block_end(struct parser *p, span where)
{
	struct expand *x = p->expand;
	const struct frame *f = top_frame(x);
	const struct block *b = x->block_count ? &x->blocks[x->block_count - 1] : NULL;
	if (!b || b->kind == BLOCK_MACRO) {
		parser_error(p, where, "#end without anything to end");
		return false;
	}
	if (b->kind == BLOCK_WHILE || b->kind == BLOCK_FOR) {
		if (b->frame == x->frame_count)
			return loop_again(p, where);
		parser_error(
			p, where, "#%s must end in the file it begins in", keyword_name(b->opener));
		parser_note(p, b->opened, "it begins here");
		return false;
	}
	x->block_count--;
	if (f->is_macro && x->block_count < f->blocks) {
		parser_error(p, where, "#end without anything to end");
		return false;
	}
	return true;
}

/* Leaves a loop or the cases of a #switch: on behind its #end. */
static bool leave_block(struct parser *p, unsigned index)
{
	struct expand *x = p->expand;
	const struct block b = x->blocks[index];
	struct frame *f = top_frame(x);
	if (b.end == NO_TOKEN || b.frame != x->frame_count) {
		parser_error(p, b.opened, "#%s must end in the file it begins in",
			keyword_name(b.opener));
		return false;
	}
	x->block_count = index;
	f->position = b.end + 1;
	return true;
}

bool block_break(struct parser *p, span where)
{
	struct expand *x = p->expand;
	for (unsigned i = x->block_count; i-- > 0;) {
		switch (x->blocks[i].kind) {
		case BLOCK_WHILE:
		case BLOCK_FOR:
		case BLOCK_CASE:
			return leave_block(p, i);
		case BLOCK_MACRO:
			/* An include file cannot return from the macro that includes it. */
			if (x->blocks[i].frame != x->frame_count)
				break;
			top_frame(x)->position = top_frame(x)->end;
			x->block_count = i + 1;
			return true;
		default:
			break;
		}
	}
	parser_error(p, where, "#break outside of a loop, #case or macro");
	return false;
}

void block_report_open(struct parser *p)
{
	const struct expand *x = p->expand;
	if (x->block_count) {
		const struct block *b = &x->blocks[x->block_count - 1];
		parser_error(p, b->opened, "no #end for the #%s that begins here",
			keyword_name(b->opener));
	}
}
