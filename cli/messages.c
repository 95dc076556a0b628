/* SPDX-License-Identifier: MIT */
/*
 * Messages, as compilers print them:
 *
 *     first.pov:12:9: error: torus needs a minor radius
 *        12 | torus { 1 }
 *           |         ^~~
 *     scene.pov:3:1: note: included from here
 *
 * Long lines are shown around the place; tabs and what is no printable character
 * become blanks, so that the caret stands where it should.
 */
#include "messages.h"
#include "names.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TAB = 8, EXCERPT = 100, LEAD = 60 };

static const char *const severity_names[] = {
	[LAMBERT_NOTE] = "note",
	[LAMBERT_WARNING] = "warning",
	[LAMBERT_ERROR] = "error",
};
static const char *const severity_colours[] = {
	[LAMBERT_NOTE] = "\033[1;36m",
	[LAMBERT_WARNING] = "\033[1;35m",
	[LAMBERT_ERROR] = "\033[1;31m",
};
static const char BOLD[] = "\033[1m", PLAIN[] = "\033[0m";

static bool wants_colour(void)
{
	const char *no = getenv("NO_COLOR"), *term = getenv("TERM");
	return !(no && *no) && term && strcmp(term, "dumb") != 0;
}

/* Stream files */

static bool open_stream(
	struct messages *m, struct options *o, enum stream stream, const char *picture, bool append)
{
	const char *name = o->stream_file[stream];
	if (!name)
		return true;
	if (strchr(name, '/')) {
		fprintf(stderr,
			"lambert: error: %s: a text file is written beside the picture; give its "
			"name "
			"without a folder\n",
			name);
		return false;
	}
	const char *slash = picture ? strrchr(picture, '/') : NULL;
	char path[4096];
	snprintf(path, sizeof path, "%.*s%s", slash ? (int)(slash - picture) + 1 : 0,
		slash ? picture : "", name);
	if (!names_may_write(o, path))
		return false;
	m->files[stream] = fopen(path, append ? "a" : "w");
	if (!m->files[stream])
		fprintf(stderr, "lambert: error: the text file %s cannot be written: %s\n", path,
			strerror(errno));
	return m->files[stream] != NULL;
}

bool messages_init(struct messages *m, struct options *options, const char *picture, bool append)
{
	const bool terminal = isatty(STDERR_FILENO);
	*m = (struct messages){
		.options = options,
		.terminal = terminal,
		.colour = terminal && wants_colour(),
		.last = STREAM_WARNING,
	};
	bool ok = true;
	for (int i = 0; i < STREAM_COUNT; i++)
		ok = ok && open_stream(m, options, (enum stream)i, picture,
				   append || options->append_file);
	return ok;
}

void messages_finish(struct messages *m)
{
	for (int i = 0; i < STREAM_COUNT; i++)
		if (m->files[i])
			fclose(m->files[i]);
}

/* Whether the console shows a stream; a setting for all of them has the last word. */
static bool on_console(const struct messages *m, enum stream stream)
{
	const struct options *o = m->options;
	const bool all_set = options_set(o, "All_Console") || options_set(o, "All_File");
	return all_set ? o->all_console : o->console[stream];
}

void messages_clear_line(struct messages *m)
{
	if (m->line_open)
		fputs("\r\033[K", stderr);
	m->line_open = false;
}

/* What a scene writes, and a name of a file, may have any bytes in it. A terminal would obey some of
 * them. Redirected, the bytes are what they are. */
static void put_text(FILE *file, const char *text, bool plain)
{
	if (plain)
		fputs(text, file);
	else
		text_show(file, text);
}

/* Excerpts */

/* A character of more bytes begins where this is false. */
static bool continues_character(char c)
{
	return (c & 0xC0) == 0x80;
}

struct excerpt {
	char text[2 * EXCERPT * TAB], marks[2 * EXCERPT * TAB];
	size_t text_length, marks_length;
};

static void put(struct excerpt *e, char c, char mark, size_t times)
{
	for (size_t i = 0; i < times; i++) {
		e->text[e->text_length++] = c;
		if (!continues_character(c))
			e->marks[e->marks_length++] = mark;
	}
}

static void make_excerpt(struct excerpt *e, const struct lambert_place *p)
{
	const size_t length = strlen(p->text), at = p->column - 1 - p->text_offset;
	size_t first = at > LEAD ? at - LEAD : 0;
	while (first < length && continues_character(p->text[first]))
		first++;
	const size_t end = length > first + EXCERPT ? first + EXCERPT : length;
	e->text_length = e->marks_length = 0;
	for (size_t i = first; i < end; i++) {
		const char c = p->text[i];
		const char mark = i == at ? '^' : i > at && i < at + p->length ? '~' : ' ';
		if (c == '\t')
			put(e, ' ', mark, TAB - e->marks_length % TAB);
		else
			put(e, (unsigned char)c < ' ' || c == 127 ? ' ' : c, mark, 1);
	}
	if (at >= end)
		e->marks[e->marks_length++] = '^';
	while (e->marks_length > 0 && e->marks[e->marks_length - 1] == ' ')
		e->marks_length--;
	e->text[e->text_length] = 0;
	e->marks[e->marks_length] = 0;
	/* A tab is one place wide for the caret. */
	char *caret = strchr(e->marks, '^');
	for (char *p2 = caret ? caret + 1 : NULL; p2 && *p2 == '^'; p2++)
		*p2 = '~';
}

/* How a stream takes text. */
struct manner {
	bool colour, terminal;
	bool shown; /* the line of the place was just shown */
};

static void print_place(FILE *file, const struct lambert_place *p, enum lambert_severity severity,
	const char *text, struct manner manner)
{
	const char *bold = manner.colour ? BOLD : "", *plain = manner.colour ? PLAIN : "";
	const char *colour = manner.colour ? severity_colours[severity] : "";
	fputs(bold, file);
	put_text(file, p->file ? p->file : "lambert", !manner.terminal);
	if (p->file)
		fprintf(file, ":%u:%u", p->line, p->column);
	fprintf(file, ":%s %s%s:%s ", plain, colour, severity_names[severity], plain);
	put_text(file, text, !manner.terminal);
	fputc('\n', file);
	if (!p->file || !p->text || !p->column || manner.shown)
		return;
	struct excerpt e;
	make_excerpt(&e, p);
	fprintf(file, "%6u | ", p->line);
	put_text(file, e.text, !manner.terminal);
	fprintf(file, "\n       | %s%s%s\n", colour, e.marks, plain);
}

static void print_message(FILE *file, const struct lambert_message *message, struct manner manner)
{
	print_place(file, &message->place, message->severity, message->text, manner);
	manner.shown = false;
	for (size_t i = 0; i < message->chain_length; i++) {
		const struct lambert_place *p = &message->chain[i];
		print_place(file, p, LAMBERT_NOTE, p->context ? p->context : "reached from here",
			manner);
	}
}

/* JSON */

static void print_json_place(FILE *file, const struct lambert_place *p)
{
	fputs("\"file\":", file);
	if (p->file)
		lambert_print_json_string(p->file, file);
	else
		fputs("null", file);
	fprintf(file, ",\"line\":%u,\"column\":%u,\"length\":%u", p->line, p->column, p->length);
}

static void print_json(FILE *file, const struct lambert_message *message)
{
	fprintf(file, "{\"severity\":\"%s\",\"message\":", severity_names[message->severity]);
	lambert_print_json_string(message->text, file);
	fputc(',', file);
	print_json_place(file, &message->place);
	fputs(",\"chain\":[", file);
	for (size_t i = 0; i < message->chain_length; i++) {
		fputs(i ? ",{" : "{", file);
		print_json_place(file, &message->chain[i]);
		fputs(",\"context\":", file);
		lambert_print_json_string(
			message->chain[i].context ? message->chain[i].context : "", file);
		fputc('}', file);
	}
	fputs("]}\n", file);
}

/* What arrives */

/* Whether the message is a note at the very place shown last; that place is this one from now on. */
static bool take_place(struct messages *m, const struct lambert_message *message)
{
	const struct lambert_place *p = &message->place;
	const bool same = message->severity == LAMBERT_NOTE && p->file && p->line == m->line &&
			  p->column == m->column && strcmp(p->file, m->file) == 0;
	if (message->chain_length)
		p = &message->chain[message->chain_length - 1];
	snprintf(m->file, sizeof m->file, "%s", p->file ? p->file : "");
	m->line = p->line;
	m->column = p->column;
	return same;
}

void messages_take(void *user, const struct lambert_message *message)
{
	struct messages *m = user;
	const bool shown = take_place(m, message);
	m->errors += message->severity == LAMBERT_ERROR;
	m->warnings += message->severity == LAMBERT_WARNING;
	const enum stream stream = message->severity == LAMBERT_NOTE	? m->last
				   : message->severity == LAMBERT_ERROR ? STREAM_FATAL
									: STREAM_WARNING;
	m->last = stream;
	for (int i = 0; i < STREAM_COUNT; i++)
		if (m->files[i] && (i == STREAM_ALL || i == (int)stream))
			print_message(m->files[i], message, (struct manner){ .shown = shown });
	if (m->json) {
		print_json(m->json, message);
		return;
	}
	const bool is_muted = m->options->quiet && stream != STREAM_FATAL;
	/* What is wrong is always said: an exit status alone helps nobody. */
	if (stream == STREAM_FATAL || (on_console(m, stream) && !is_muted)) {
		messages_clear_line(m);
		print_message(stderr, message, (struct manner){ m->colour, m->terminal, shown });
	}
}

static void say(struct messages *m, enum stream stream, const char *line)
{
	const char *end = *line && line[strlen(line) - 1] == '\n' ? "" : "\n";
	for (int i = 0; i < STREAM_COUNT; i++)
		if (m->files[i] && (i == STREAM_ALL || i == (int)stream))
			fprintf(m->files[i], "%s%s", line, end);
	if (!on_console(m, stream))
		return;
	messages_clear_line(m);
	put_text(stderr, line, !m->terminal);
	fputs(end, stderr);
}

/* #render and #statistics text goes the way of #debug text, as in POV-Ray. */
void messages_take_text(void *user, const char *stream, const char *line)
{
	say(user, strcmp(stream, "warning") == 0 ? STREAM_WARNING : STREAM_DEBUG, line);
}

void messages_say(struct messages *m, enum stream stream, const char *format, ...)
{
	char line[2048];
	va_list args;
	va_start(args, format);
	vsnprintf(line, sizeof line, format, args);
	va_end(args);
	say(m, stream, line);
}
