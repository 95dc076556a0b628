/* SPDX-License-Identifier: MIT */
/*
 * The spelling of keywords, for messages and for the printed AST, and which of
 * them begin an object.
 */
#include "parser/ast.h"

const char *keyword_name(enum keyword keyword)
{
	static const char *const words[] = {
		[K_NONE] = "nothing",
#define KEYWORD(word, WORD) [K_##WORD] = #word,
#define SYNONYM(word, WORD)
#include "parser/keywords.def"
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

/* Every one of the language, also those that are refused. Asked of each item: no search by name. */
bool keyword_is_object(enum keyword keyword)
{
	switch (keyword) {
	case K_BICUBIC_PATCH:
	case K_BLOB:
	case K_BOX:
	case K_COMPOSITE:
	case K_CONE:
	case K_CUBIC:
	case K_CYLINDER:
	case K_DIFFERENCE:
	case K_DISC:
	case K_HEIGHT_FIELD:
	case K_INTERSECTION:
	case K_ISOSURFACE:
	case K_JULIA_FRACTAL:
	case K_LATHE:
	case K_LIGHT_GROUP:
	case K_LIGHT_SOURCE:
	case K_MERGE:
	case K_MESH:
	case K_MESH2:
	case K_OBJECT:
	case K_OVUS:
	case K_PARAMETRIC:
	case K_PLANE:
	case K_POLY:
	case K_POLYGON:
	case K_POLYNOMIAL:
	case K_PRISM:
	case K_QUADRIC:
	case K_QUARTIC:
	case K_SMOOTH_TRIANGLE:
	case K_SOR:
	case K_SPHERE:
	case K_SPHERE_SWEEP:
	case K_SUPERELLIPSOID:
	case K_TEXT:
	case K_TORUS:
	case K_TRIANGLE:
	case K_UNION:
		return true;
	default:
		return false;
	}
}
