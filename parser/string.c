/* SPDX-License-Identifier: MIT */
/*
 * String literals: bytes of the text to UTF-8, with or without escapes.
 *
 * A string of the language is a sequence of 16-bit codes; codes beyond become
 * U+FFFD. How bytes above 127 are read depends on the charset in force.
 */
#include "expand.h"

#include <string.h>

char *string_put_code(char *out, uint32_t code)
{
	if (code > 0xFFFF)
		code = 0xFFFD;
	if (code < 0x80) {
		*out++ = (char)code;
	} else if (code < 0x800) {
		*out++ = (char)(0xC0 | code >> 6);
		*out++ = (char)(0x80 | (code & 0x3F));
	} else {
		*out++ = (char)(0xE0 | code >> 12);
		*out++ = (char)(0x80 | (code >> 6 & 0x3F));
		*out++ = (char)(0x80 | (code & 0x3F));
	}
	return out;
}

/* Decodes one sequence of 1 to 6 bytes; malformed ones are not diagnosed. */
static const char *take_utf8(const char *in, const char *end, uint32_t *code)
{
	const unsigned char lead = (unsigned char)*in++;
	unsigned more = 0;
	for (unsigned bit = 0x40; lead >= 0xC0 && bit >= 2 && (lead & bit); bit >>= 1)
		more++;
	*code = more ? lead & (0x3Fu >> more) : lead;
	for (; more && in < end && ((unsigned char)*in & 0xC0) == 0x80; more--)
		*code = *code << 6 | ((unsigned char)*in++ & 0x3F);
	return in;
}

static int hex_digit(char c)
{
	if (c >= '0' && c <= '9')
		return c - '0';
	if (c >= 'a' && c <= 'f')
		return c - 'a' + 10;
	return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The code of the escape behind a backslash; false: there is no such escape. */
static bool take_escape(const char **in, const char *end, uint32_t *code)
{
	static const char letters[] = "abfnrtv\\'\"", codes[] = "\a\b\f\n\r\t\v\\'\"";
	const char c = *(*in)++;
	const char *at = c ? strchr(letters, c) : NULL;
	if (at) {
		*code = (unsigned char)codes[at - letters];
		return true;
	}
	if (c != 'u' || end - *in < 4)
		return false;
	*code = 0;
	for (int i = 0; i < 4; i++) {
		const int digit = hex_digit(*(*in)++);
		if (digit < 0)
			return false;
		*code = *code << 4 | (uint32_t)digit;
	}
	return true;
}

/* Whether a byte is one that the charset in force does not have. */
static bool is_lost(const struct parser *p, char byte)
{
	return (unsigned char)byte > 127 && p->charset == CHARSET_ASCII && p->state->version >= 350;
}

static void warn_of_lost(struct parser *p, const char *text, size_t length, span where)
{
	size_t first = 0;
	while (first < length && !is_lost(p, text[first]))
		first++;
	if (first == length)
		return;
	where.offset += (uint32_t)first + 1;
	where.length = 1;
	diag_warning(p->diag, where,
		"a byte beyond ASCII (0x%02X) becomes a space: global_settings { charset utf8 } "
		"keeps UTF-8",
		(unsigned char)text[first]);
}

static const char *take_byte(struct parser *p, const char *in, const char *end, uint32_t *code)
{
	const unsigned char c = (unsigned char)*in;
	if (c > 127 && p->charset != CHARSET_ASCII)
		return take_utf8(in, end, code);
	if (c == '\r' || c == '\n') {
		*code = '\n';
		const bool pair = in + 1 < end && (in[1] == '\r' || in[1] == '\n') && in[1] != *in;
		return in + 1 + pair;
	}
	*code = is_lost(p, *in) ? ' ' : c;
	return in + 1;
}

static bool is_plain(const char *text, size_t length)
{
	for (size_t i = 0; i < length; i++)
		if ((unsigned char)text[i] > 127 || text[i] == '\r' || text[i] == 0)
			return false;
	return true;
}

const char *string_plain(struct parser *p, const char *text, size_t length)
{
	return is_plain(text, length) && !memchr(text, '\\', length)
		       ? arena_string(p->held.texts, text, length)
		       : NULL;
}

const char *string_literal(
	struct parser *p, const char *text, size_t length, span where, bool escapes)
{
	if (is_plain(text, length) && (!escapes || !memchr(text, '\\', length)))
		return arena_string(p->held.texts, text, length);
	if (!escapes) /* which every string is read for as well */
		warn_of_lost(p, text, length, where);
	char *const start = arena_alloc(p->held.texts, 3 * length + 1), *out = start;
	const char *end = text + length;
	for (const char *in = text; in < end;) {
		uint32_t code;
		if (*in == '\\' && escapes && in + 1 < end) {
			const char *escape = in++;
			if (!take_escape(&in, end, &code)) {
				where.offset += (uint32_t)(escape - text) + 1;
				where.length = 2;
				parser_error(
					p, where, "unknown escape '\\%c' in a string", escape[1]);
				return NULL;
			}
		} else {
			in = take_byte(p, in, end, &code);
		}
		if (code)
			out = string_put_code(out, code);
	}
	*out = 0;
	return start;
}

const char *string_bytes(struct parser *p, const char *text)
{
	char *const start = arena_string(p->held.texts, text, strlen(text)), *out = start;
	const char *end = text + strlen(text);
	while (text < end) {
		uint32_t code;
		text = take_utf8(text, end, &code);
		if (code > 127 && p->state->version >= 350)
			code = ' ';
		*out++ = (char)(code & 0xFF);
	}
	*out = 0;
	return start;
}
