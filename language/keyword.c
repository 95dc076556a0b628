/* SPDX-License-Identifier: MIT */
/*
 * The spelling of keywords, for messages and for the printed AST.
 */
#include "language/keyword.h"

const char *keyword_name(enum keyword keyword)
{
	static const char *const words[] = {
		[K_NONE] = "nothing",
#define KEYWORD(word, WORD) [K_##WORD] = #word,
#define SYNONYM(word, WORD)
#include "language/keywords.def"
#undef KEYWORD
#undef SYNONYM
		[KEYWORD_COUNT] = "nothing",
		[K_REFERENCE] = "reference",
		[K_LAYERS] = "layers",
		[K_COLOUR_VALUE] = "colour_value",
		[K_ENTRY] = "entry",
		[K_LIST_ITEM] = "list_item",
		[K_TRIANGLE_TEXTURES] = "triangle_textures",
		[K_IMAGE_FILE] = "image_file",
	};
	return words[keyword];
}
