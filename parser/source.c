/* SPDX-License-Identifier: MIT */
/*
 * Source texts: reading, the token arrays, the links between the parts of
 * blocks.
 */
#include "source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { PIECE = 1 << 15 }; /* tokens: they fit into a cache */

static inline bool is_digit(char c)
{
	return c >= '0' && c <= '9';
}

/* Literals of up to 15 digits and small exponents are exact with one division or product of
 * doubles; strtod does the rest. */
double number_behind(const char *text, size_t digits, uint64_t mantissa, size_t *length)
{
	static const double powers[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10,
		1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
	const char *p = text + digits;
	int exponent = 0;
	for (; is_digit(*p); p++, digits++)
		mantissa = mantissa * 10 + (uint64_t)(*p - '0');
	if (*p == '.') {
		const char *const point = p++;
		for (; is_digit(*p); p++)
			mantissa = mantissa * 10 + (uint64_t)(*p - '0');
		exponent = (int)(point + 1 - p);
		digits += (size_t)-exponent;
	}
	if (*p == 'e' || *p == 'E') {
		const bool negative = p[1] == '-';
		p += 1 + (p[1] == '+' || p[1] == '-');
		int value = 0;
		for (; is_digit(*p); p++)
			value = value < 10000 ? value * 10 + (*p - '0') : value;
		exponent += negative ? -value : value;
	}
	*length = (size_t)(p - text);
	if (digits <= 15 && exponent >= -22 && exponent <= 22)
		return exponent < 0 ? (double)mantissa / powers[-exponent]
				    : (double)mantissa * powers[exponent];
	return strtod(text, NULL);
}

double number_at(const char *text, size_t *length)
{
	return number_behind(text, 0, 0, length);
}

static uint32_t grown(uint32_t room, uint32_t least)
{
	return room < least ? least : room > UINT32_MAX / 2 ? UINT32_MAX : 2 * room;
}

void source_grow(struct source *s)
{
	s->room = grown(s->room, 256);
	s->tokens = memory_grow(s->tokens, s->room, sizeof *s->tokens);
}

void source_push_number(struct source *s, uint32_t offset, double value)
{
	if (s->number_count > RAW_PAYLOAD_MAX) {
		source_push(s, RAW_NUMBER_TEXT, offset, 0);
		return;
	}
	if (s->number_count == s->number_room) {
		s->number_room = grown(s->number_room, 64);
		s->numbers = memory_grow(s->numbers, s->number_room, sizeof *s->numbers);
	}
	source_push(s, RAW_NUMBER, offset, s->number_count);
	s->numbers[s->number_count++] = value;
}

void source_push_directive(struct source *s, enum keyword keyword, uint32_t offset, uint32_t length)
{
	if (s->directive_count > RAW_PAYLOAD_MAX) {
		s->error = "too many directives in one file";
		s->error_offset = offset;
		source_push(s, RAW_ERROR, offset, 0);
		return;
	}
	if (s->directive_count == s->directive_room) {
		s->directive_room = grown(s->directive_room, 64);
		s->directives =
			memory_grow(s->directives, s->directive_room, sizeof *s->directives);
	}
	s->directives[s->directive_count] = (struct directive){
		.keyword = keyword,
		.token = s->count,
		.length = length,
		.next = NO_TOKEN,
		.end = NO_TOKEN,
	};
	source_push(s, RAW_DIRECTIVE, offset, s->directive_count++);
}

bool is_directive(enum keyword keyword)
{
	switch (keyword) {
	case K_BREAK:
	case K_CASE:
	case K_DEBUG:
	case K_DECLARE:
	case K_DEFAULT:
	case K_ELSE:
	case K_ELSEIF:
	case K_END:
	case K_ERROR:
	case K_FCLOSE:
	case K_FOPEN:
	case K_FOR:
	case K_IF:
	case K_IFDEF:
	case K_IFNDEF:
	case K_INCLUDE:
	case K_LOCAL:
	case K_MACRO:
	case K_RANGE:
	case K_READ:
	case K_RENDER:
	case K_STATISTICS:
	case K_SWITCH:
	case K_UNDEF:
	case K_VERSION:
	case K_WARNING:
	case K_WHILE:
	case K_WRITE:
		return true;
	default:
		return false;
	}
}

bool directive_opens(enum keyword keyword)
{
	return keyword == K_IF || keyword == K_IFDEF || keyword == K_IFNDEF || keyword == K_WHILE ||
	       keyword == K_FOR || keyword == K_SWITCH || keyword == K_MACRO;
}

bool directive_continues(enum keyword keyword)
{
	return keyword == K_ELSE || keyword == K_ELSEIF || keyword == K_CASE ||
	       keyword == K_RANGE || keyword == K_END;
}

/* A block that is open while linking: its first part and the latest. */
struct open_block {
	uint32_t first, latest;
};

static void close_block(struct source *s, struct open_block block, uint32_t end)
{
	for (uint32_t i = block.first; s->directives[i].keyword != K_END;) {
		struct directive *d = &s->directives[i];
		d->end = end;
		i = s->tokens[d->next].payload;
	}
}

/* Links the parts of all blocks among the directives from `first` on. */
static void link_blocks(struct source *s, uint32_t first)
{
	struct open_block *open = NULL;
	uint32_t count = 0, room = 0;
	for (uint32_t i = first; i < s->directive_count; i++) {
		struct directive *d = &s->directives[i];
		if (directive_opens(d->keyword)) {
			if (count == room) {
				room = grown(room, 64);
				open = memory_grow(open, room, sizeof *open);
			}
			open[count++] = (struct open_block){ i, i };
		} else if (directive_continues(d->keyword) && count) {
			s->directives[open[count - 1].latest].next = d->token;
			open[count - 1].latest = i;
			if (d->keyword == K_END)
				close_block(s, open[--count], d->token);
		}
	}
	free(open);
}

static bool has_macro(const struct source *s, uint32_t first)
{
	for (uint32_t i = first; i < s->directive_count; i++)
		if (s->directives[i].keyword == K_MACRO)
			return true;
	return false;
}

bool source_continue(struct source *s, bool forget, bool all)
{
	if (!s->rest)
		return false;
	if (forget && !has_macro(s, s->piece_directive)) {
		/* but the last one: it may have been read only to see what it is */
		s->tokens[s->piece] = s->tokens[s->count - 1];
		s->count = s->piece + 1;
		s->number_count = s->piece_number;
	}
	if (forget) {
		s->piece = s->count;
		s->piece_number = s->number_count;
		s->piece_directive = s->directive_count;
	}
	const uint32_t first = s->directive_count;
	const uint32_t least = all || s->count > NO_TOKEN - PIECE ? NO_TOKEN : s->count + PIECE;
	if (!lex_source(s->rest, least)) {
		lex_end(s->rest);
		s->rest = NULL;
	}
	link_blocks(s, first);
	return true;
}

static struct source *begin(struct arena *arena, const char *name, size_t size)
{
	struct source *s = ARENA_NEW(arena, struct source);
	s->name = arena_string(arena, name, strlen(name));
	s->bytes = arena_alloc(arena, size + 2);
	s->size = size;
	return s;
}

/* Room for the tokens of most texts: what is not used is never touched, and growing would copy. */
static void reserve(struct source *s)
{
	s->room = (uint32_t)(s->size / 2 + 64);
	s->tokens = memory_grow(NULL, s->room, sizeof *s->tokens);
	s->number_room = (uint32_t)(s->size / 8 + 16);
	s->numbers = memory_grow(NULL, s->number_room, sizeof *s->numbers);
}

/* No text to show, nothing to read but the error. */
static void refuse(struct source *s, struct arena *arena, const char *kind)
{
	s->size = 0;
	s->error = arena_printf(arena, "this is %s, not a text of the scene language", kind);
	s->error_length = 1;
	source_push(s, RAW_ERROR, 0, 0);
}

static void complete(struct source *s, struct arena *arena, struct diag *diag, struct names *names,
	bool main_file)
{
	const char *kind = binary_kind(s->bytes, s->size);
	if (kind)
		refuse(s, arena, kind);
	else
		s->size = text_size(s->bytes, s->size);
	s->number = diag_add_source(diag, s->name, s->bytes, s->size);
	if (kind)
		return;
	if (s->size > UINT32_MAX - 16) {
		s->error = "file too large: 4 GB are the limit";
		source_push(s, RAW_ERROR, 0, 0);
		return;
	}
	for (size_t i = 0; main_file && i < s->size && (unsigned char)s->bytes[i] > 127; i++) {
		s->has_mark = true;
		s->bytes[i] = ' ';
	}
	reserve(s);
	s->rest = lex_begin(s, names, arena);
	source_continue(s, false, !main_file);
	s->is_piecewise = s->rest != NULL;
	if (s->is_piecewise)
		return;
	s->tokens = memory_grow(s->tokens, s->count, sizeof *s->tokens);
	s->numbers = memory_grow(s->numbers, s->number_count, sizeof *s->numbers);
}

struct source *source_create(struct arena *arena, struct diag *diag, struct names *names,
	const char *name, const char *text, size_t size, bool main_file)
{
	struct source *s = begin(arena, name, size);
	if (size)
		memcpy(s->bytes, text, size);
	complete(s, arena, diag, names, main_file);
	return s;
}

/* Reads what a pipe or a device has to say. */
static char *read_stream(FILE *file, size_t *size)
{
	char *bytes = NULL;
	size_t room = 0;
	*size = 0;
	do {
		if (*size == room) {
			room = room ? 2 * room : 1 << 16;
			bytes = memory_grow(bytes, room, 1);
		}
		*size += fread(bytes + *size, 1, room - *size, file);
	} while (!feof(file) && !ferror(file));
	return bytes;
}

struct source *source_read(struct arena *arena, struct diag *diag, struct names *names,
	const char *path, bool main_file)
{
	struct stat info;
	if (!stat(path, &info) && S_ISDIR(info.st_mode)) {
		errno = EISDIR;
		return NULL;
	}
	FILE *file = fopen(path, "rb");
	if (!file)
		return NULL;
	struct source *s;
	const long end = fseek(file, 0, SEEK_END) ? -1 : ftell(file);
	if (end > 0 && !fseek(file, 0, SEEK_SET)) {
		s = begin(arena, path, (size_t)end);
		s->size = fread(s->bytes, 1, (size_t)end, file);
		memset(s->bytes + s->size, 0, 2);
	} else {
		size_t size;
		char *bytes = read_stream(file, &size);
		s = begin(arena, path, size);
		memcpy(s->bytes, bytes, size);
		free(bytes);
	}
	const bool failed = ferror(file);
	fclose(file);
	if (failed) {
		errno = EIO;
		return NULL;
	}
	complete(s, arena, diag, names, main_file);
	return s;
}

struct source *source_open(struct arena *arena, struct diag *diag, struct names *names,
	const struct parse_options *o, const char *path)
{
	size_t size;
	const char *text = scratch_read(o->scratch, path, &size);
	return text ? source_create(arena, diag, names, path, text, size, false)
		    : source_read(arena, diag, names, path, false);
}

void source_finish(struct source *s)
{
	if (s->rest)
		lex_end(s->rest);
	s->rest = NULL;
	free(s->tokens);
	free(s->numbers);
	free(s->directives);
	s->tokens = NULL;
	s->numbers = NULL;
	s->directives = NULL;
}
