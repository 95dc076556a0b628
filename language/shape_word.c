/* SPDX-License-Identifier: MIT */
/*
 * The rows of shapes.def as tables. Each is read four times: as parameters, as
 * letters, for whether it is plain, and for the items it has of its own.
 */
#include "language/shape_word.h"

#define BLOCK SHAPE

#define FLOAT(name)	     { PARAMETER_FLOAT, name, K_NONE, 0, 0 },
#define VECTOR(name)	     { PARAMETER_VECTOR, name, K_NONE, 0, 0 },
#define PAIR(name)	     { PARAMETER_PAIR, name, K_NONE, 0, 0 },
#define OPTIONAL(name)	     { PARAMETER_OPTIONAL, name, K_NONE, 0, 0 },
#define FONT(name)	     { PARAMETER_FONT, name, K_NONE, 0, 0 },
#define STRING(name)	     { PARAMETER_STRING, name, K_NONE, 0, 0 },
#define ARRAY(name, per, of) { PARAMETER_ARRAY, name, K_NONE, per, of },
#define FLAG(WORD)	     { PARAMETER_FLAG, NULL, K_##WORD, 0, 0 },
#define ITEM(WORD)	     { PARAMETER_ITEM, NULL, K_##WORD, 0, 0 },
#define SHAPE(WORD, word, room, file, parameters)                                                  \
	static const struct parameter word##_parameters[] = { parameters{                          \
		PARAMETER_END, NULL, K_NONE, 0, 0 } };
#include "language/shapes.def"
#undef FLOAT
#undef VECTOR
#undef PAIR
#undef OPTIONAL
#undef FONT
#undef STRING
#undef ARRAY
#undef FLAG
#undef ITEM
#undef SHAPE

#define FLOAT(name)	     "f"
#define VECTOR(name)	     "v"
#define PAIR(name)	     "2"
#define OPTIONAL(name)	     "f?"
#define FONT(name)	     "s"
#define STRING(name)	     "s"
#define ARRAY(name, per, of) ""
#define FLAG(WORD)
#define ITEM(WORD)
#define SHAPE(WORD, word, room, file, parameters)                                                  \
	static const char word##_letters[] = "" parameters;
#include "language/shapes.def"
#undef FLOAT
#undef VECTOR
#undef PAIR
#undef OPTIONAL
#undef FONT
#undef STRING
#undef ARRAY
#undef SHAPE
#undef BLOCK

#define FLOAT(name)
#define VECTOR(name)
#define PAIR(name) &&false
#define OPTIONAL(name)
#define FONT(name)	     &&false
#define STRING(name)	     &&false
#define ARRAY(name, per, of) &&false
#define SHAPE(WORD, word, room, file, parameters)                                                  \
	[K_##WORD] = { K_##WORD, word##_parameters, word##_letters, true parameters },
#define BLOCK(WORD, word, room, file, parameters)                                                  \
	[K_##WORD] = { K_##WORD, word##_parameters, word##_letters, false },
static const struct shape_word words[KEYWORD_COUNT] = {
#include "language/shapes.def"
};
#undef PAIR
#undef FONT
#undef STRING
#undef ARRAY
#undef FLAG
#undef ITEM
#undef SHAPE
#undef BLOCK

/* The items that some objects have and others do not; most stand in several rows. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverride-init"
#define PAIR(name)
#define FONT(name)
#define STRING(name)
#define ARRAY(name, per, of)
#define FLAG(WORD)				  [K_##WORD] = true,
#define ITEM					  FLAG
#define BLOCK					  SHAPE
#define SHAPE(WORD, word, room, file, parameters) parameters
static const bool is_special[KEYWORD_COUNT] = {
#include "language/shapes.def"
};
#pragma GCC diagnostic pop

const struct shape_word *shape_word_of(enum keyword keyword)
{
	const bool is_object = keyword < KEYWORD_COUNT && words[keyword].keyword != K_NONE;
	return is_object ? &words[keyword] : NULL;
}

bool keyword_is_object(enum keyword keyword)
{
	return shape_word_of(keyword) != NULL;
}

bool shape_word_takes(const struct shape_word *shape, enum keyword item)
{
	if (item >= KEYWORD_COUNT || !is_special[item])
		return true;
	for (const struct parameter *p = shape->parameters; p->type != PARAMETER_END; p++)
		if (p->word == item)
			return true;
	return false;
}
