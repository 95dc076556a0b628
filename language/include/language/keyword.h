/* SPDX-License-Identifier: MIT */
/*
 * The reserved words of the scene language as numbers.
 */
#ifndef LAMBERT_LANGUAGE_KEYWORD_H
#define LAMBERT_LANGUAGE_KEYWORD_H

#include <stdbool.h>

enum keyword {
	K_NONE,
#define KEYWORD(word, WORD) K_##WORD,
#define SYNONYM(word, WORD)
#include "language/keywords.def"
#undef KEYWORD
#undef SYNONYM
	KEYWORD_COUNT,
	/* Nodes of the tree without a word of their own: */
	K_REFERENCE, /* use of a declared value: `ref`, `name` */
	K_LAYERS,    /* a declared texture with several layers: children K_TEXTURE, bottom first */
	K_COLOUR_VALUE,	     /* a colour: one argument of 5 terms (r, g, b, filter, transmit) */
	K_ENTRY,	     /* [ value body ] of a map: argument 0 the value (absent: none), then a
	                     colour or slope argument, or children as in the map's statement */
	K_LIST_ITEM,	     /* colour of a colour list: argument 0, five terms */
	K_TRIANGLE_TEXTURES, /* texture choice of a mesh face */
	K_IMAGE_FILE,	     /* an image named without its type: argument 0 the name */
};

/* The word of a keyword, or a name for the others ("reference"). */
const char *keyword_name(enum keyword);
/* Whether it begins an object, which may be a light. */
bool keyword_is_object(enum keyword);

#endif
