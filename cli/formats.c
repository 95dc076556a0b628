/* SPDX-License-Identifier: MIT */
/* Questions about the picture formats of the library, and their lists for messages. */
#include "formats.h"

#include <string.h>

bool formats_find_letter(char letter, struct lambert_format *format)
{
	for (size_t i = 0; lambert_format_describe(i, format); i++)
		if (format->letter == letter)
			return true;
	return false;
}

bool formats_find_path(const char *path, struct lambert_format *format)
{
	const char *dot = strrchr(path, '.');
	return dot && !strchr(dot, '/') && lambert_format_find(dot + 1, format);
}

const char *formats_extension(struct text_pool *pool, const struct lambert_format *f)
{
	return text_printf(pool, ".%.*s", (int)strcspn(f->extensions, " "), f->extensions);
}

/* The list with one more text. */
static const char *longer(
	struct text_pool *pool, const char *list, const char *between, const char *text)
{
	return *list ? text_printf(pool, "%s%s%s", list, between, text) : text;
}

const char *formats_names(struct text_pool *pool)
{
	const char *list = "";
	struct lambert_format f;
	for (size_t i = 0; lambert_format_describe(i, &f); i++)
		list = longer(pool, list, ", ", f.name);
	return list;
}

const char *formats_extensions(struct text_pool *pool)
{
	const char *list = "";
	struct lambert_format f;
	for (size_t i = 0; lambert_format_describe(i, &f); i++) {
		const char *extension = formats_extension(pool, &f);
		if (!strstr(list, extension))
			list = longer(pool, list, " ", extension);
	}
	return list;
}

const char *formats_letters(struct text_pool *pool)
{
	const char *list = "";
	struct lambert_format f;
	for (size_t i = 0; lambert_format_describe(i, &f); i++)
		list = longer(pool, list, ", ",
			text_printf(pool, i ? "%c %s" : "%c is %s", f.letter, f.name));
	return list;
}

const char *formats_dithers(struct text_pool *pool)
{
	const char *list = "", *name;
	for (size_t i = 0; (name = lambert_dither_name(i)); i++)
		list = longer(pool, list, ", ", name);
	return list;
}
