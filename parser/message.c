/* SPDX-License-Identifier: MIT */
/*
 * #debug, #warning, #error, #render, #statistics.
 *
 * The debug stream shows whole lines: text waits until its line is complete, and
 * what is incomplete at the end of the scene is never shown.
 */
#include "expand.h"

#include <string.h>

enum {
	LINE_MAX_LENGTH = 160, /* longer lines are wrapped */
	WRAP_WINDOW = 40,      /* at the last space among that many characters */
	DEBUG_MAX = 200,       /* longer strings are cut … */
	DEBUG_CUT = 156,       /* … to that many, and "..." */
	WARNING_MAX = 160,
	WARNING_CUT = 124,
};

static void put_line(struct parser *p, enum keyword stream, const char *line)
{
	const struct parse_options *o = p->options;
	if (o->text)
		o->text(o->text_user, stream, line);
	if (o->debug_stream)
		fprintf(o->debug_stream, "%s\n", line);
}

/* Shows the first `length` bytes that wait, and forgets them and `skip` more. */
static void flush_line(struct parser *p, size_t length, size_t skip)
{
	struct text_line *l = &p->expand->debug_line;
	put_line(p, K_DEBUG, arena_string(p->arena, l->bytes, length));
	l->length -= length + skip;
	memmove(l->bytes, l->bytes + length + skip, l->length);
}

static void wrap_line(struct parser *p)
{
	const struct text_line *l = &p->expand->debug_line;
	for (size_t i = LINE_MAX_LENGTH; i > LINE_MAX_LENGTH - WRAP_WINDOW; i--)
		if (l->bytes[i - 1] == ' ') {
			flush_line(p, i - 1, 1);
			return;
		}
	flush_line(p, LINE_MAX_LENGTH, 0);
}

static void put_text(struct parser *p, const char *text, size_t length)
{
	struct text_line *l = &p->expand->debug_line;
	if (!l->bytes) {
		l->room = LINE_MAX_LENGTH + 2;
		l->bytes = arena_alloc(p->arena, l->room);
	}
	for (size_t i = 0; i < length; i++) {
		if (text[i] == '\n') {
			flush_line(p, l->length, 0);
			continue;
		}
		l->bytes[l->length++] = text[i];
		if (l->length > LINE_MAX_LENGTH)
			wrap_line(p);
	}
}

static void debug_text(struct parser *p, const char *text)
{
	const size_t length = strlen(text);
	if (length <= DEBUG_MAX) {
		put_text(p, text, length);
		return;
	}
	put_text(p, text, DEBUG_CUT);
	put_text(p, "...", 3);
}

/* One line of at most WARNING_MAX characters. */
static const char *one_line(struct parser *p, const char *text)
{
	const size_t length = strlen(text);
	char *line = length > WARNING_MAX ? arena_printf(p->arena, "%.*s...", WARNING_CUT, text)
					  : arena_string(p->arena, text, length);
	for (char *c = line; *c; c++)
		if (*c == '\n')
			*c = ' ';
	for (size_t n = strlen(line); n && line[n - 1] == ' '; n--)
		line[n - 1] = 0;
	return line;
}

bool message_run(struct parser *p, enum keyword stream, span where)
{
	const char *text;
	struct gate gate;
	gate_open(p, &gate, true);
	const bool ok = parse_string(p, &text, false) && !p->failed;
	gate_close(p);
	if (!ok)
		return false;
	text = string_bytes(p, text);
	switch (stream) {
	case K_WARNING:
		diag_scene_warning(p->diag, where, one_line(p, text));
		return true;
	case K_ERROR:
		parser_stop(p, where, "%s", one_line(p, text));
		return false;
	case K_DEBUG:
		break;
	default:
		diag_warning(p->diag, where, "there is no %s stream any more: read as #debug",
			keyword_name(stream));
		break;
	}
	debug_text(p, text);
	return true;
}
