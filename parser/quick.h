/* SPDX-License-Identifier: MIT */
/*
 * The short way for numbers: reads plain expressions from the raw tokens, past
 * the grammar. Each function gives up (false) without a trace where the grammar
 * is needed.
 */
#ifndef LAMBERT_PARSER_QUICK_H
#define LAMBERT_PARSER_QUICK_H

#include "parser/expand.h"

enum quick_level {
	QUICK_SUM,  /* `<` opens a vector */
	QUICK_FULL, /* with relations */
};

/* Where, in a statement, a number may begin. */
enum quick_place {
	NEXT_NONE,	 /* nowhere */
	NEXT_ANY,	 /* behind an opening bracket or a comma */
	NEXT_AFTER_WORD, /* not with '(', which may belong to the word */
	NEXT_AFTER_SUM,	 /* only with what cannot continue the sum */
};

/* A sum before a comma, a semicolon or a closing bracket, which stays. */
bool quick_number(struct parser *, struct number *);
bool quick_value(struct parser *, struct value *);
/* The same, but it must be a float. */
bool quick_float(struct parser *, enum quick_level, double *);
/* A sum within brackets, and where it stands; not a word alone that stands
 * for more than a float. */
bool quick_sum(struct parser *, enum quick_place, struct number *, span *);
/* A variable or an element of an array alone, before a comma or ')', which stays: where its value
 * is. */
bool quick_variable(struct parser *, struct value **);

#endif
