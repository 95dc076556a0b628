/* SPDX-License-Identifier: MIT */
/*
 * Files that are no texts, by their first bytes or by the zeros in them. A few
 * zeros do no harm, and at the end of a text there may be any number: old editors
 * filled up their blocks.
 */
#include "source.h"

#include <string.h>

enum { ZEROS_MAX = 64 };

static const struct {
	size_t length;
	const char *bytes, *kind;
} signatures[] = {
	{ 4, "\x89PNG", "a PNG picture" },
	{ 3, "\xFF\xD8\xFF", "a JPEG picture" },
	{ 4, "GIF8", "a GIF picture" },
	{ 4, "II*\0", "a TIFF picture" },
	{ 4, "MM\0*", "a TIFF picture" },
	{ 4, "\x76\x2F\x31\x01", "an OpenEXR picture" },
	{ 10, "#?RADIANCE", "a Radiance picture" },
	{ 4, "%PDF", "a PDF document" },
	{ 4, "PK\3\4", "a zip archive" },
	{ 2, "\x1F\x8B", "a gzip archive" },
	{ 4,
		"\x7F"
		"ELF",
		"a program" },
	{ 2, "\xFF\xFE", "a text in UTF-16 (save it as UTF-8)" },
	{ 2, "\xFE\xFF", "a text in UTF-16 (save it as UTF-8)" },
};

static bool has_many_zeros(const char *bytes, size_t size)
{
	const char *const end = bytes + size;
	unsigned count = 0;
	while (count <= ZEROS_MAX && (bytes = memchr(bytes, 0, (size_t)(end - bytes))) != NULL) {
		bytes++;
		count++;
	}
	return count > ZEROS_MAX;
}

size_t text_size(const char *bytes, size_t size)
{
	while (size && !bytes[size - 1])
		size--;
	return size;
}

const char *binary_kind(const char *bytes, size_t size)
{
	for (size_t i = 0; i < sizeof signatures / sizeof *signatures; i++)
		if (size >= signatures[i].length &&
			!memcmp(bytes, signatures[i].bytes, signatures[i].length))
			return signatures[i].kind;
	const size_t length = text_size(bytes, size);
	return has_many_zeros(bytes, length ? length : size) ? "a binary file" : NULL;
}
