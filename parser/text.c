/* SPDX-License-Identifier: MIT */
/*
 * The string functions. Strings are UTF-8; the language counts characters of
 * 16 bits, which are the code points here.
 */
#include "build.h"

#include "grammar.tab.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* -- Code points -------------------------------------------------------------------------- */

/* Reads one code point; `*s` moves behind it. */
static unsigned next_code(const char **s)
{
	const unsigned char *b = (const unsigned char *)*s;
	unsigned code = b[0], more = 0;
	if (code >= 0xF0) {
		code &= 0x07;
		more = 3;
	} else if (code >= 0xE0) {
		code &= 0x0F;
		more = 2;
	} else if (code >= 0xC0) {
		code &= 0x1F;
		more = 1;
	}
	unsigned i = 1;
	for (; i <= more && (b[i] & 0xC0) == 0x80; i++)
		code = code << 6 | (b[i] & 0x3Fu);
	*s += i;
	return code;
}

static size_t count_codes(const char *s)
{
	size_t n = 0;
	while (*s) {
		next_code(&s);
		n++;
	}
	return n;
}

double text_asc(const char *s)
{
	return *s ? (double)next_code(&s) : 0;
}

double text_compare(const char *a, const char *b)
{
	while (*a && *b) {
		const unsigned x = next_code(&a), y = next_code(&b);
		if (x != y)
			return (double)x - (double)y;
	}
	return text_asc(a) - text_asc(b);
}

struct number text_relation(int op, const char *a, const char *b)
{
	const double order = text_compare(a, b);
	bool result = false;
	switch (op) {
	case '<':
		result = order < 0;
		break;
	case '>':
		result = order > 0;
		break;
	case '=':
		result = order == 0;
		break;
	case T_NE:
		result = order != 0;
		break;
	case T_LE:
		result = order <= 0;
		break;
	default:
		result = order >= 0;
		break;
	}
	return number_float(result);
}

double text_val(const char *s)
{
	return strtod(s, NULL);
}

/* -- Making strings ----------------------------------------------------------------------- */

struct text_value text_both(const char *text)
{
	return (struct text_value){ text, text };
}

/* Of one string, and of all that concat makes: far beyond any use of them. */
#define STRING_BYTES 100000000
#define JOINED_BYTES 4000000000

struct texts {
	size_t count, room;
	struct text_value *items;
};

struct texts *texts_new(struct parser *p)
{
	return ARENA_NEW(p->held.texts, struct texts);
}

struct texts *texts_add(struct parser *p, struct texts *t, struct text_value text)
{
	if (t->count == t->room) {
		t->room = t->room ? 2 * t->room : 4;
		struct text_value *items = ARENA_ARRAY(p->held.texts, t->room, struct text_value);
		if (t->count)
			memcpy(items, t->items, t->count * sizeof *items);
		t->items = items;
	}
	t->items[t->count++] = text;
	return t;
}

static const char *part(const struct texts *t, size_t i, bool raw)
{
	return raw ? t->items[i].raw : t->items[i].text;
}

/* Whether there is room for a string of that length; a string that is doubled in an endless loop must
 * end with a message. */
static bool has_room(struct parser *p, size_t length, span where)
{
	p->joined_bytes += length;
	if (length > STRING_BYTES)
		parser_stop(
			p, where, "a string of %zu bytes: %d are the limit", length, STRING_BYTES);
	else if (!growth_permits(p, (double)length, where))
		return false;
	else if (p->joined_bytes > JOINED_BYTES)
		parser_stop(p, where, "the strings made by concat take more than %zu bytes",
			(size_t)JOINED_BYTES);
	else
		return true;
	return false;
}

static const char *join(struct parser *p, const struct texts *t, bool raw, span where)
{
	size_t length = 0;
	for (size_t i = 0; i < t->count; i++)
		length += strlen(part(t, i, raw));
	if (!has_room(p, length, where))
		return "";
	char *const out = arena_alloc(p->held.texts, length + 1);
	char *end = out;
	for (size_t i = 0; i < t->count; i++) {
		const size_t size = strlen(part(t, i, raw));
		memcpy(end, part(t, i, raw), size);
		end += size;
	}
	return out;
}

struct text_value text_concat(struct parser *p, const struct texts *t, span where)
{
	bool same = true;
	for (size_t i = 0; i < t->count && same; i++)
		same = t->items[i].text == t->items[i].raw;
	const char *text = join(p, t, false, where);
	return (struct text_value){ text, same ? text : join(p, t, true, where) };
}

enum {
	STR_LIMIT = 254,   /* longer results of str are written with %g */
	WIDTH_LIMIT = 1000 /* of fields and precisions, far beyond STR_LIMIT */
};

static int limited(double value)
{
	const int n = number_truncate(value);
	return n > WIDTH_LIMIT ? WIDTH_LIMIT : n < -WIDTH_LIMIT ? -WIDTH_LIMIT : n;
}

static const char *format_float(
	struct parser *p, double value, double length, double precision, bool shorten)
{
	const int l = limited(length), digits = limited(precision);
	const int width = l < 0 ? -l : l, places = digits < 0 ? 6 : digits;
	const char *text = l < 0 ? arena_printf(p->held.texts, "%0*.*f", width, places, value)
				 : arena_printf(p->held.texts, "%*.*f", width, places, value);
	if (!shorten || strlen(text) <= STR_LIMIT)
		return text;
	return l < 0 ? arena_printf(p->held.texts, "%0*.*g", width, places, value)
		     : arena_printf(p->held.texts, "%*.*g", width, places, value);
}

const char *text_str(struct parser *p, double value, double length, double precision)
{
	return format_float(p, value, length, precision, true);
}

const char *text_vstr(struct parser *p, double count, struct number value, const char *between,
	double length, double precision, span where)
{
	int n = number_truncate(count);
	n = n < 2 ? 2 : n > 5 ? 5 : n;
	struct texts *out = texts_new(p);
	for (int i = 0; i < n; i++) {
		const double v = i < value.terms || value.leftover ? value.v[i] : 0;
		if (i)
			texts_add(p, out, text_both(between));
		texts_add(p, out, text_both(format_float(p, v, length, precision, false)));
	}
	return join(p, out, false, where);
}

const char *text_chr(struct parser *p, double value, span where)
{
	const int code = number_truncate(value);
	char *out = arena_alloc(p->held.texts, 4);
	if (code < 0 || code > 0xFFFF)
		parser_error(p, where, "chr needs a code between 0 and 65535");
	else if (code)
		string_put_code(out, (uint32_t)code);
	return out;
}

/* Where the substrs of this string have come to; `fresh` is for one that is short. */
static struct text_walk *walk_through(struct parser *p, const char *s, struct text_walk *fresh)
{
	for (unsigned i = 0; i < TEXT_WALKS; i++)
		if (p->walks[i].text == s)
			return &p->walks[i];
	const bool is_long = strnlen(s, TEXT_WALK_LEAST) == TEXT_WALK_LEAST;
	struct text_walk *w = is_long ? &p->walks[p->walk_count++ % TEXT_WALKS] : fresh;
	*w = (struct text_walk){ .text = s, .at = s, .length = count_codes(s) };
	return w;
}

/* Goes on to a character of the string, from where the walk is or from the beginning. */
static const char *walk_to(struct text_walk *w, size_t character)
{
	if (character < w->character) {
		w->character = 0;
		w->at = w->text;
	}
	for (; w->character < character; w->character++)
		next_code(&w->at);
	return w->at;
}

double text_length(struct parser *p, const char *s)
{
	struct text_walk fresh;
	return (double)walk_through(p, s, &fresh)->length;
}

/* Position 0, one before the first character, is allowed and gives nothing. */
const char *text_substr(struct parser *p, const char *s, double first, double count, span where)
{
	const int from = number_truncate(first), n = number_truncate(count);
	struct text_walk fresh, *w = walk_through(p, s, &fresh);
	if (from < 0 || n < 0 || (double)from + n - 1 > (double)w->length) {
		parser_error(p, where, "substr reaches outside the string");
		return "";
	}
	if (from == 0 || n == 0)
		return "";
	const char *begin = walk_to(w, (size_t)from - 1);
	const char *end = begin;
	for (int i = 0; i < n; i++)
		next_code(&end);
	return arena_string(p->held.texts, begin, (size_t)(end - begin));
}

const char *text_case(struct parser *p, const char *s, bool upper, span where)
{
	char *out = arena_string(p->held.texts, s, strlen(s));
	bool foreign = false;
	for (char *c = out; *c; c++) {
		if (upper && *c >= 'a' && *c <= 'z')
			*c = (char)(*c - 'a' + 'A');
		else if (!upper && *c >= 'A' && *c <= 'Z')
			*c = (char)(*c - 'A' + 'a');
		foreign |= (unsigned char)*c > 127;
	}
	if (foreign)
		diag_warning(p->diag, where, "only the letters A to Z change their case");
	return out;
}

const char *text_datetime(struct parser *p, double days, const char *format, span where)
{
	enum { LIMIT = 200 };
	const double seconds = floor(86400 * (days + 10957) + 0.5);
	char out[LIMIT] = "";
	struct tm parts;
	if (!format)
		format = "%Y-%m-%d %H:%M:%SZ";
	if (!(fabs(seconds) < 1e15)) {
		parser_error(p, where, "no such date");
		return "";
	}
	const time_t time = (time_t)seconds;
	if (!*format || strlen(format) >= LIMIT || !gmtime_r(&time, &parts) ||
		!strftime(out, sizeof out, format, &parts))
		parser_error(p, where, "bad format of datetime");
	return arena_string(p->held.texts, out, strlen(out));
}
