/* SPDX-License-Identifier: MIT */
/* The lists of picture formats and of kinds of dithering. */
#include "image/image.h"

#include "image/image_format.h"

#include <limits.h>
#include <string.h>
#include <strings.h>

#define FORMAT(id, ...) [IMAGE_##id] = { __VA_ARGS__ },
const struct image_format_class image_formats[IMAGE_FORMAT_COUNT] = {
#include "image/formats.def"
};
#undef FORMAT

const char *const image_dithers[DITHER_COUNT] = {
	[DITHER_NONE] = "",
	[DITHER_B2] = "B2",
	[DITHER_B3] = "B3",
	[DITHER_B4] = "B4",
	[DITHER_D1] = "D1",
	[DITHER_D2] = "D2",
	[DITHER_FS] = "FS",
};

/* Whether a list of words, with blanks between them, has this one. */
static bool has_word(const char *list, const char *word)
{
	const size_t length = strlen(word);
	for (const char *p = list; *p; p += strspn(p, " ")) {
		const size_t n = strcspn(p, " ");
		if (n == length && strncasecmp(p, word, n) == 0)
			return true;
		p += n;
	}
	return false;
}

bool image_find_format(const char *name, enum image_format *format)
{
	for (int i = 0; i < IMAGE_FORMAT_COUNT; i++) {
		const struct image_format_class *f = &image_formats[i];
		if (strcasecmp(f->name, name) == 0 || has_word(f->extensions, name)) {
			*format = (enum image_format)i;
			return true;
		}
	}
	return false;
}

bool image_find_dither(const char *name, enum dither *dither)
{
	for (int i = 0; i < DITHER_COUNT; i++) {
		if (strcasecmp(image_dithers[i], name) == 0) {
			*dither = (enum dither)i;
			return true;
		}
	}
	return false;
}
