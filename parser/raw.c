/* SPDX-License-Identifier: MIT */
/*
 * Raw tokens as the directives read them: before names are looked up and
 * anything is executed. Their places, too, which are measured in the text when
 * they are asked for.
 */
#include "expand.h"

size_t raw_word_length(const char *text)
{
	size_t length = 0;
	if (text[0] >= '0' && text[0] <= '9')
		return 0;
	while (is_word_character(text[length]))
		length++;
	return length;
}

static uint32_t raw_length(const struct expand *x, const struct frame *f, struct raw_token raw)
{
	size_t length = 1;
	switch (raw.kind) {
	case RAW_INTEGER:
	case RAW_NUMBER:
	case RAW_NUMBER_TEXT: {
		number_at(f->source->bytes + raw.offset, &length);
		break;
	}
	case RAW_STRING:
		length = raw.payload + 2;
		break;
	case RAW_KEYWORD: /* synonyms differ in length */
		length = raw_word_length(f->source->bytes + raw.offset);
		break;
	case RAW_NAME:
		length = x->names.list[raw.payload].length;
		break;
	case RAW_DIRECTIVE:
		length = f->source->directives[raw.payload].length;
		break;
	case RAW_LE:
	case RAW_GE:
	case RAW_NE:
		length = 2;
		break;
	case RAW_ERROR:
		length = f->source->error_length;
		break;
	default:
		break;
	}
	return (uint32_t)length;
}

span raw_span_of(const struct expand *x, const struct frame *f, struct raw_token raw)
{
	return (span){ f->source->number, raw.offset, raw_length(x, f, raw), f->site };
}

span raw_end_span(const struct frame *f)
{
	return (span){ f->source->number, (uint32_t)f->source->size, 1, f->site };
}

span raw_span(struct parser *p)
{
	const struct frame *f = top_frame(p->expand);
	return f->position == f->end && !next_piece(p->expand)
		       ? raw_end_span(f)
		       : raw_span_of(p->expand, f, f->tokens[f->position]);
}

span raw_span_at(struct parser *p, const struct raw_token *raw)
{
	return raw_span_of(p->expand, top_frame(p->expand), *raw);
}

const struct source *source_at(const struct expand *x, span where)
{
	const struct source *s = x->sources;
	while (s && s->number != where.source)
		s = s->previous;
	return s;
}

const struct raw_token *raw_before(struct parser *p, span where, unsigned steps)
{
	enum { AHEAD = 8 }; /* tokens may have been read beyond the place */
	const struct frame *f = top_frame(p->expand);
	if (where.source != f->source->number)
		return NULL;
	if (f->position == f->end && where.offset >= f->source->size)
		return f->end >= steps ? &f->tokens[f->end - steps] : NULL;
	for (uint32_t i = f->position; i + AHEAD > f->position && i >= steps && i > 0; i--)
		if (i < f->end && f->tokens[i].offset == where.offset)
			return &f->tokens[i - steps];
	return NULL;
}

span raw_gap_before(struct parser *p, span where)
{
	const struct raw_token *raw = raw_before(p, where, 1);
	if (!raw || raw->kind == RAW_ERROR)
		return where;
	span gap = raw_span_at(p, raw);
	gap.offset += gap.length;
	gap.length = 1;
	return diag_place(p->diag, gap).line < diag_place(p->diag, where).line ? gap : where;
}

void raw_report_lexical(struct parser *p, const struct frame *f)
{
	const struct source *s = f->source;
	parser_error(
		p, (span){ s->number, s->error_offset, s->error_length, f->site }, "%s", s->error);
}

const struct raw_token *raw_peek_at_end(struct parser *p)
{
	struct expand *x = p->expand;
	if (p->failed)
		return NULL;
	struct frame *f = top_frame(x);
	while (f->position == f->end && !next_piece(x)) {
		if (!f->is_macro || !expand_leave_frame(p))
			return NULL;
		f = top_frame(x);
	}
	const struct raw_token *raw = &f->tokens[f->position];
	if (raw->kind != RAW_ERROR)
		return raw;
	raw_report_lexical(p, f);
	return NULL;
}

span raw_take(struct parser *p)
{
	const span where = raw_span(p);
	raw_step(p);
	return where;
}

bool raw_accept(struct parser *p, unsigned kind)
{
	const struct raw_token *raw = raw_peek(p);
	if (!raw || raw->kind != kind)
		return false;
	raw_step(p);
	return true;
}

bool raw_accept_keyword(struct parser *p, enum keyword keyword)
{
	const struct raw_token *raw = raw_peek(p);
	if (!raw || raw->kind != RAW_KEYWORD || raw->payload != (uint32_t)keyword)
		return false;
	raw_step(p);
	return true;
}

const char *raw_describe(struct parser *p, const struct raw_token *raw)
{
	if (!raw)
		return "the end of the text";
	const struct expand *x = p->expand;
	const struct frame *f = &x->frames[x->frame_count - 1];
	if (raw->kind == RAW_STRING)
		return "a string";
	const char *text =
		arena_string(p->arena, f->source->bytes + raw->offset, raw_length(x, f, *raw));
	return arena_printf(
		p->arena, raw->kind == RAW_KEYWORD ? "the reserved word '%s'" : "'%s'", text);
}

bool raw_name(struct parser *p, const char *what, uint32_t *name, span *where)
{
	const struct raw_token *raw = raw_peek(p);
	if (!raw || raw->kind != RAW_NAME) {
		parser_error(p, raw_span(p), "expected %s, found %s", what, raw_describe(p, raw));
		return false;
	}
	const struct frame *f = top_frame(p->expand);
	*name = raw->payload;
	*where = (span){ f->source->number, raw->offset, p->expand->names.list[*name].length,
		f->site };
	raw_step(p);
	return true;
}

const char *raw_string(struct parser *p, bool escapes)
{
	const struct raw_token *raw = raw_peek(p);
	if (!raw || raw->kind != RAW_STRING)
		return NULL;
	const char *text = top_frame(p->expand)->source->bytes + raw->offset + 1;
	const size_t length = raw->payload;
	return string_literal(p, text, length, raw_take(p), escapes);
}
