/* SPDX-License-Identifier: MIT */
/*
 * POV-Ray's option syntax: switches (+W320), assignments (Width=320), and bare
 * words that name a scene, a folder of the library path, or an INI file. An
 * argument of the command line is a little line of its own, but where it gives a
 * name, all of it is the name: the shell has settled what belongs together. A
 * line of an INI file differs in what an assignment may hold.
 */
#include "nearest.h"
#include "options.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static bool is_blank(char c)
{
	return c == ' ' || c == '\t';
}

static const char *skip_blanks(const char *p)
{
	while (is_blank(*p))
		p++;
	return p;
}

static bool at_end(const char *p)
{
	return !*p || *p == ';' || *p == '#';
}

static bool is_quote(char c)
{
	return c == '"' || c == '\'';
}

/* Reads up to the matching quote; NULL after a message. */
static char *read_quoted(struct options *o, const char **p)
{
	const char *start = *p + 1;
	const char *end = strchr(start, **p);
	if (!end) {
		option_error(o, "the closing %c is missing", **p);
		return NULL;
	}
	*p = end + 1;
	return text_copy(&o->pool, start, (size_t)(end - start));
}

static char *read_until(struct options *o, const char **p, const char *stops)
{
	const char *start = *p;
	*p += strcspn(start, stops);
	return text_copy(&o->pool, start, (size_t)(*p - start));
}

/* Switches */

static const char *begins_with(const char *word, const char *letters)
{
	const size_t n = strlen(letters);
	return n && strncasecmp(word, letters, n) == 0 ? word + n : NULL;
}

static bool unknown_switch(const struct options *o, char sign, const char *word)
{
	if ((*word == 'a' || *word == 'A') && strspn(word + 1, "0123456789.") == strlen(word + 1))
		return option_error(o,
			"the threshold after %cA begins with 0 and goes on, as in %cA0.3; any "
			"other is "
			"written Antialias_Threshold=1.0 or --antialias=1:1.0",
			sign, sign);
	return option_error(o, "there is no switch %c%s", sign, word);
}

/* The option of a switch, with what is behind its letters. */
static const struct option_row *switch_row(const char *word, const char **rest)
{
	for (size_t i = 0; i < option_count; i++) {
		*rest = begins_with(word, option_rows[i].letters);
		if (*rest && (**rest != 0) == (option_rows[i].kind != KIND_BOOL))
			return &option_rows[i];
	}
	return NULL;
}

/* The option of a switch whose value stands in quotes behind it. */
static const struct option_row *quoted_row(const char *letters)
{
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].kind != KIND_BOOL && *option_rows[i].letters &&
			strcasecmp(option_rows[i].letters, letters) == 0)
			return &option_rows[i];
	return NULL;
}

/* Whether the value is a name, in which a blank or a # is as good as a letter. */
static bool is_name(const struct option_row *row)
{
	return row->use == USE_USED && (row->kind == KIND_TEXT || row->kind == KIND_FILE ||
					       row->kind == KIND_LIBRARY || row->kind == KIND_INI);
}

static bool read_switch(struct options *o, const char **p, bool in_file)
{
	const char sign = *(*p)++;
	const char *start = *p, *rest;
	const char *word = read_until(o, p, " \t;#\"'[]=");
	const struct option_row *row = is_quote(**p) ? quoted_row(word) : NULL;
	if (row) {
		const char *value = read_quoted(o, p);
		return value && option_apply(o, row, value, true, sign);
	}
	row = switch_row(word, &rest);
	if (row && is_name(row) && !in_file) {
		rest = start + strlen(row->letters);
		*p = start + strlen(start);
	}
	if (!row || is_quote(**p))
		return unknown_switch(o, sign, word);
	return option_apply(o, row, rest, true, sign);
}

/* Assignments */

/* The length of the name before an equals sign, 0 if there is none. */
static size_t assigned_name(const char *p, bool in_file)
{
	size_t n = 0;
	while (isalnum((unsigned char)p[n]) || p[n] == '_')
		n++;
	const char *after = in_file ? skip_blanks(p + n) : p + n;
	return *after == '=' ? n : 0;
}

static const char *similar_name(const char *name, size_t length)
{
	const char *best = NULL;
	size_t least = length;
	for (size_t i = 0; i < option_count; i++) {
		const size_t distance = nearest_distance(name, length, option_rows[i].ini);
		if (nearest_is_near(distance, length) && distance < least) {
			best = option_rows[i].ini;
			least = distance;
		}
	}
	return best;
}

static bool unknown_name(const struct options *o, const char *name, size_t length)
{
	const char *similar = similar_name(name, length);
	return option_error(o, "there is no option %.*s%s%s%s", (int)length, name,
		similar ? "; perhaps " : "", similar ? similar : "", similar ? " is meant" : "");
}

/* The rest of the line up to a comment outside quotes. */
static const char *read_raw(struct options *o, const char **p)
{
	const char *start = *p;
	char quote = 0;
	for (; **p && (quote || !at_end(*p)); ++*p) {
		if (quote)
			quote = **p == quote ? 0 : quote;
		else if (is_quote(**p))
			quote = **p;
	}
	const char *end = *p;
	while (end > start && is_blank(end[-1]))
		end--;
	return text_copy(&o->pool, start, (size_t)(end - start));
}

/* Whether the text after a value is something of its own. */
static bool starts_anew(const char *p)
{
	size_t n = 0;
	while (isalnum((unsigned char)p[n]) || p[n] == '_')
		n++;
	return at_end(p) || *p == ',' || option_find(p, n) ||
	       ((*p == '+' || *p == '-') && isalpha((unsigned char)p[1]));
}

/* One value; in a file an unquoted one may hold blanks, by mistake. */
static const char *read_value(struct options *o, const char **p, bool in_file)
{
	if (is_quote(**p))
		return read_quoted(o, p);
	const char *start = *p;
	const char *value = read_until(o, p, " \t,;#\"'");
	const char *next = skip_blanks(*p);
	if (!in_file || next == *p || starts_anew(next))
		return value;
	*p = start;
	value = read_raw(o, p);
	option_note(o, "\"%s\" has blanks and should stand in quotes", value);
	return value;
}

static bool read_assignment(struct options *o, const char **p, size_t length, bool in_file)
{
	const struct option_row *row = option_find(*p, length);
	if (!row)
		return unknown_name(o, *p, length);
	*p = strchr(*p, '=') + 1;
	if (in_file)
		*p = skip_blanks(*p);
	if (row->kind == KIND_COMMAND)
		return option_apply(o, row, read_raw(o, p), false, '+');
	if (is_name(row) && !in_file && !is_quote(**p)) {
		const char *value = *p;
		*p += strlen(*p);
		return option_apply(o, row, value, false, '+');
	}
	for (;;) {
		const char *value = read_value(o, p, in_file);
		if (!value || !option_apply(o, row, value, false, '+'))
			return false;
		const char *next = skip_blanks(*p);
		if (!in_file || *next != ',')
			break;
		*p = skip_blanks(next + 1);
	}
	/* What follows on the line does not count. */
	*p += strlen(*p);
	return true;
}

/* Bare words */

static bool apply_word(struct options *o, const char *word)
{
	if (text_ends_with(word, ".pov"))
		return option_scene(o, word);
	if (text_ends_with(word, "/"))
		return option_set(o, "Library_Path", word);
	return ini_read(o, word);
}

static bool read_word(struct options *o, const char **p)
{
	const char *word = is_quote(**p) ? read_quoted(o, p) : read_until(o, p, " \t;#\"'");
	return word && apply_word(o, word);
}

/* Whether the argument as a whole names a file, blanks and all. */
static bool is_file_with_blanks(const char *argument)
{
	return strpbrk(argument, " \t;#") && access(argument, R_OK) == 0;
}

bool switches_read(struct options *o, const char *text, bool in_file)
{
	if (!in_file && is_file_with_blanks(text))
		return apply_word(o, text);
	for (const char *p = skip_blanks(text); !at_end(p); p = skip_blanks(p)) {
		const size_t name = assigned_name(p, in_file);
		const bool ok = *p == '+' || *p == '-' ? read_switch(o, &p, in_file)
				: name		       ? read_assignment(o, &p, name, in_file)
						       : read_word(o, &p);
		if (!ok)
			return false;
	}
	return true;
}
