/* SPDX-License-Identifier: MIT */
/*
 * The short way: reads plain expressions and items from the raw tokens, past the
 * grammar. Each function gives up (false) without a trace where the grammar
 * is needed.
 */
#ifndef LAMBERT_PARSER_QUICK_H
#define LAMBERT_PARSER_QUICK_H

#include "expand.h"

/* Texts of older versions read sums and textures by rules of their own. */
enum { QUICK_VERSION = 300 };

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
/* An argument of a macro that is a variable, an element of an array or a sum, before a comma or ')',
 * which stays. */
bool quick_argument(struct parser *, struct argument *);
/* As many of them as said, in parentheses. */
bool quick_arguments(struct parser *, struct argument *, unsigned count);

/* Objects made of objects. */
static inline bool is_csg(enum keyword word)
{
	return word == K_UNION || word == K_MERGE || word == K_INTERSECTION || word == K_DIFFERENCE;
}

/* quick_item.c: which items may stand next. */
enum quick_items {
	ITEMS_NONE = 0,
	ITEMS_OBJECTS = 1,
	ITEMS_MODIFIERS = 2,
};
/* A primitive, or a modifier of an object, that is written with plain numbers; its word and where that
 * stands. *modifier: which of the two it is. */
bool quick_item(struct parser *, unsigned items, struct node **, enum keyword *, span *word,
	bool *modifier);

/* -- between the files of the short way -- */

enum {
	QUICK_DRAWS = 8,  /* calls of rand() in one attempt */
	QUICK_DEPTH = 50, /* nested brackets, signs and objects; more is left to the grammar */
};

/* One attempt. */
struct quick {
	struct parser *p;
	const struct frame *frame;
	const struct raw_token *at, *end;
	unsigned depth;
	const struct raw_token *object; /* the innermost that is open, or was at the failure */
	size_t arg_count;		/* before */
	/* What rand() has changed, to be put back if the attempt fails. */
	struct draw {
		size_t stream;
		uint32_t state;
	} draws[QUICK_DRAWS];
	unsigned draw_count;
};

/* Whether one can be made at all. */
bool quick_begin(struct quick *, struct parser *);
/* Ends the attempt. If it was good the text goes on behind it and the gate has seen one operand;
 * else all is as it was. */
bool quick_finish(struct quick *, bool good);
/* Kind of the next raw token, 0 behind the last of the text. */
unsigned quick_next(const struct quick *);
bool quick_skip(struct quick *, unsigned kind);
/* Into brackets, if they are not too deep, and out. */
static inline bool quick_go_down(struct quick *q)
{
	return q->depth < QUICK_DEPTH && ++q->depth;
}
static inline void quick_go_up(struct quick *q)
{
	q->depth--;
}
/* A sum; a full expression. */
bool quick_read_sum(struct quick *, struct number *);
bool quick_read_full(struct quick *, struct number *);
/* quick_text.c: a string; asc, strcmp or strlen of strings. */
bool quick_read_text(struct quick *, const char **);
bool quick_read_text_function(struct quick *, enum keyword, struct number *);
/* Whether the next token cannot continue a sum. */
bool quick_ends_sum(const struct quick *);
/* Where the value of the variable or element that comes next is; NULL: gives up. */
struct value *quick_read_variable(struct quick *, const struct symbol **found);

#endif
