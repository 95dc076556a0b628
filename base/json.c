/* SPDX-License-Identifier: MIT */
/*
 * Text as JSON strings; see json.h.
 */
#include "base/json.h"

#include <stdbool.h>
#include <stdint.h>

/* Length of the UTF-8 sequence at s, as RFC 3629 has it: none longer than needed, no surrogates,
 * nothing beyond U+10FFFF. 0: there is none. */
static unsigned sequence_length(const unsigned char *s)
{
	static const uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
	if (s[0] < 0x80)
		return 1;
	const unsigned length = s[0] < 0xC2   ? 0
				: s[0] < 0xE0 ? 2
				: s[0] < 0xF0 ? 3
				: s[0] < 0xF5 ? 4
					      : 0;
	uint32_t code = s[0] & (0xFFu >> (length + 1));
	for (unsigned i = 1; i < length; i++) {
		if ((s[i] & 0xC0) != 0x80)
			return 0;
		code = code << 6 | (s[i] & 0x3Fu);
	}
	const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
	return code < least[length] || is_surrogate || code > 0x10FFFF ? 0 : length;
}

void json_print_string(FILE *file, const char *text)
{
	const unsigned char *s = (const unsigned char *)text;
	fputc('"', file);
	while (*s) {
		const unsigned length = sequence_length(s);
		if (*s == '"' || *s == '\\')
			fprintf(file, "\\%c", *s);
		else if (*s < ' ' || *s == 127 || length == 0)
			fprintf(file, "\\u%04x", *s);
		else
			fwrite(s, 1, length, file);
		s += length ? length : 1;
	}
	fputc('"', file);
}
