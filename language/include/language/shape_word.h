/* SPDX-License-Identifier: MIT */
/*
 * What an object takes between its braces: a row of shapes.def as data. The
 * parser checks statements against it, lowering fills instances by it.
 */
#ifndef LAMBERT_LANGUAGE_SHAPE_WORD_H
#define LAMBERT_LANGUAGE_SHAPE_WORD_H

#include "language/keyword.h"

#include <stddef.h>

enum parameter_type {
	PARAMETER_END,
	/* arguments, in order */
	PARAMETER_FLOAT,
	PARAMETER_VECTOR,
	PARAMETER_PAIR,	    /* a vector of two numbers */
	PARAMETER_OPTIONAL, /* a float that may be absent */
	PARAMETER_FONT,	    /* a file or the number of an internal font */
	PARAMETER_STRING,
	PARAMETER_ARRAY, /* a list of elements */
	/* words among the items */
	PARAMETER_FLAG, /* a switch of the primitive */
	PARAMETER_ITEM, /* an item that lowering reads itself */
};

struct parameter {
	enum parameter_type type;
	const char *name;  /* of an argument, for messages: "a radius" */
	enum keyword word; /* of a flag or item */
	unsigned stride;   /* of an array: numbers per element */
	unsigned count;	   /* elements it must have; 0: as many as the float before it says */
};

struct shape_word {
	enum keyword keyword;		    /* K_NONE: no object */
	const struct parameter *parameters; /* arguments, then items */
	const char *letters; /* of the arguments but arrays, as node_fit wants them */
	bool is_plain;	     /* its arguments are floats and vectors alone */
};

/* What the word takes; NULL for words that begin no object. */
const struct shape_word *shape_word_of(enum keyword);
/* Whether an item may stand in that object: it is one that all may have, or one of its own. */
bool shape_word_takes(const struct shape_word *, enum keyword item);

#endif
