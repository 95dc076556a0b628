/* SPDX-License-Identifier: MIT */
/*
 * Open blocks: #if, #switch, loops and running macros, their #end, and #break.
 *
 * Skipping is a jump along the links made while lexing. Only a block that an
 * include file opens and the including file continues has to be looked for.
 */
#include "expand.h"

#include <string.h>

struct block *block_push(
	struct parser *p, enum block_kind kind, const struct directive *d, span where)
{
	struct expand *x = p->expand;
	if (x->block_count == MAX_BLOCKS) {
		parser_error(p, where,
			"conditionals, loops and macros are nested too deeply (%d are the limit)",
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

/* -- Blocks without an end ---------------------------------------------------------------- */

/* Blanks before a token; -1: it is not the first of its line. */
static int indent_of(const struct source *s, const struct raw_token *raw)
{
	uint32_t at = raw->offset;
	while (at > 0 && (s->bytes[at - 1] == ' ' || s->bytes[at - 1] == '\t'))
		at--;
	const bool first = at == 0 || s->bytes[at - 1] == '\n' || s->bytes[at - 1] == '\r';
	return first ? (int)(raw->offset - at) : -1;
}

/* The #end that belongs to an outer block by its place in the line: the inner one lacks its own. */
static bool note_misplaced_end(struct parser *p, const struct source *s, span opened)
{
	for (uint32_t i = 0; i < s->directive_count; i++) {
		const struct directive *d = &s->directives[i];
		if (!directive_opens(d->keyword) || d->token >= s->count || d->end >= s->count)
			continue;
		const struct raw_token *start = &s->tokens[d->token], *end = &s->tokens[d->end];
		const int indent = indent_of(s, start), end_indent = indent_of(s, end);
		if (start->offset <= opened.offset || end_indent < 0 || end_indent >= indent)
			continue;
		parser_note(p, (span){ s->number, start->offset, d->length, opened.site },
			"is the #end of this #%s missing?", keyword_name(d->keyword));
		parser_note(p, (span){ s->number, end->offset, 4, opened.site },
			"this #end, further left, is taken for it");
		return true;
	}
	return false;
}

/* #endif and the like, which mean nothing. */
static void note_foreign_end(struct parser *p, const struct source *s, span opened)
{
	for (uint32_t i = 0; i < s->count; i++) {
		const struct raw_token *raw = &s->tokens[i];
		if (raw->kind != RAW_NAME || raw->offset <= opened.offset ||
			s->bytes[raw->offset - 1] != '#' ||
			strncmp(s->bytes + raw->offset, "end", 3) != 0)
			continue;
		const char *word = p->expand->names.list[raw->payload].text;
		parser_note(p,
			(span){ s->number, raw->offset - 1, (uint32_t)strlen(word) + 1,
				opened.site },
			"every block ends with #end: #%s means nothing", word);
		return;
	}
}

bool block_report_unclosed(struct parser *p, span opened)
{
	raw_peek(p); /* the text may have gone wrong: that is the better message */
	const struct source *s = source_at(p->expand, opened);
	const char *word = s ? s->bytes + opened.offset : "";
	parser_error(p, opened, "no #end for the %.*s that begins here", (int)opened.length, word);
	if (s && !note_misplaced_end(p, s, opened))
		note_foreign_end(p, s, opened);
	return false;
}

/* -- Parts -------------------------------------------------------------------------------- */

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
			return block_report_unclosed(p, opened);
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
	if (b->kind == BLOCK_SWITCH) {
		parser_error(p, b->opened, "#switch has no #case and no #range before its #end");
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
	if (x->block_count)
		block_report_unclosed(p, x->blocks[x->block_count - 1].opened);
}
