/* SPDX-License-Identifier: MIT */
/*
 * What an identifier can hold.
 */
#ifndef LAMBERT_PARSER_VALUE_H
#define LAMBERT_PARSER_VALUE_H

#include "parser/ast.h"

enum value_kind {
	VALUE_NONE,   /* declared, not yet assigned */
	VALUE_NUMBER, /* 1 to 4 terms */
	VALUE_COLOUR, /* 5 terms, each rounded to float */
	VALUE_STRING,
	VALUE_ARRAY,
	VALUE_NODE, /* object, texture, camera …: by node->keyword */
	VALUE_FUNCTION,
	VALUE_SPLINE,
	VALUE_MACRO,
	VALUE_FILE,
};

struct value {
	enum value_kind kind;
	/* VALUE_NODE, VALUE_FUNCTION: the terminal the identifier becomes (T_OBJECT, …). */
	int token;
	union {
		struct number number;
		const char *string;
		struct array *array;
		const struct node *node;
		const struct function *function;
		const struct spline *spline;
		struct macro *macro;
		struct scene_file *file;
	};
};

/* The terminal of the grammar that an identifier of such a value becomes. */
int value_terminal(const struct value *);

/* Row-major, last subscript fastest. Elements are VALUE_NONE until assigned; all assigned elements
 * have one kind (and, for nodes, one token). */
struct array {
	unsigned dimensions; /* 1 to 5 */
	size_t size[5], count;
	enum value_kind kind; /* VALUE_NONE: still open */
	int token;	      /* set with `kind` by array_accepts: value.token of nodes */
	unsigned terms;	      /* the same: terms of numbers */
	struct value *elements;
	struct array *next; /* of all held, see collect.c */
	bool reached;
};

/* Whether an element of the array may take the value; the first one decides the type of all. */
bool array_accepts(struct array *, const struct value *);

#endif
