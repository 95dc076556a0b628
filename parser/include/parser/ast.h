/* SPDX-License-Identifier: MIT */
/*
 * What the parser makes of a scene: plain data, read only once made.
 *
 * A statement is a node: a keyword, the values that follow it, and the items
 * between its braces as children, in source order. So
 *
 *     sphere { <0,1,0>, 2  pigment { rgb x }  translate y }
 *
 * is a node K_SPHERE with two number arguments and the children K_PIGMENT and
 * K_TRANSLATE. Using an identifier makes a node K_REFERENCE whose `ref` is the
 * declared value: the AST is a graph whose shared parts are never copied, and a
 * texture that is declared but never used costs nothing after parsing.
 *
 * Everything lives in the arena of the parse.
 */
#ifndef LAMBERT_PARSER_AST_H
#define LAMBERT_PARSER_AST_H

#include "base/diag.h"
#include "base/spline.h"
#include "language/keyword.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* 1 to 5 terms. `leftover`: the value came from selecting a component, and v[1] to v[4] still
 * hold that vector's components (the language shows them where a vector is wanted). */
struct number {
	uint8_t terms;
	bool leftover;
	double v[5];
};

enum arg_kind {
	ARG_NUMBER, /* number */
	ARG_STRING, /* string: UTF-8, zero-terminated; code points up to 0xFFFF */
	ARG_ARRAY,  /* array: count numbers, e.g. the coefficients of a poly, vertices of a mesh2 */
	ARG_FUNCTION, /* function */
};

struct arg {
	enum arg_kind kind;
	span span;
	union {
		struct number number;
		const char *string;
		struct {
			const double *values;
			size_t count;
			unsigned stride; /* numbers per element: 3 for vectors */
		} array;
		const struct function *function;
	};
};

/* What the text before a statement has set; shared by all nodes until it changes. */
struct language_state {
	int version;			 /* hundredths: 370 */
	bool version_set;		 /* by a directive or an option */
	const struct defaults *defaults; /* #default in force, newest first; NULL: none */
	float assumed_gamma;		 /* 0: not set yet, < 0: sRGB */
	int noise_generator;		 /* 0: not set in global_settings */
};

/* One item of a #default block: a texture, pigment, normal, finish, camera or radiosity node. */
struct defaults {
	const struct defaults *previous;
	const struct node *node;
};

struct node {
	enum keyword keyword;
	uint32_t arg_count;
	span span;			    /* of the whole statement */
	span word;			    /* of its keyword */
	const struct language_state *state; /* when the statement began */
	const struct node *next;	    /* the next item of the same block */
	const struct node *children;	    /* items between the braces */
	const struct node *ref;		    /* K_REFERENCE */
	const char *name;		    /* K_REFERENCE: the identifier */
	const struct arg *args;
};

/* A user-defined function, as written; render compiles it. */
enum function_kind {
	FUNCTION_EXPRESSION, /* body */
	FUNCTION_INTERNAL,   /* internal(number) */
	FUNCTION_PATTERN,    /* node: K_PATTERN */
	FUNCTION_PIGMENT,    /* node: K_PIGMENT */
	FUNCTION_TRANSFORM,  /* node: K_TRANSFORM */
	FUNCTION_SPLINE,     /* spline */
};

enum expr_kind {
	EXPR_CONSTANT,
	EXPR_PARAMETER,
	EXPR_NEGATE,
	EXPR_ADD,
	EXPR_SUBTRACT,
	EXPR_MULTIPLY,
	EXPR_DIVIDE,
	EXPR_LESS,
	EXPR_LESS_EQUAL,
	EXPR_EQUAL,
	EXPR_NOT_EQUAL,
	EXPR_GREATER_EQUAL,
	EXPR_GREATER,
	EXPR_AND,
	EXPR_OR,
	EXPR_CALL, /* a built-in: `builtin` (K_SIN …), operands */
	EXPR_FUNCTION, /* a declared function: `function`, operands, `component` for a vector function */
	EXPR_SUM,
	EXPR_PROD, /* operands: from, to, body; the loop variable is parameter `index` */
};

struct expr {
	enum expr_kind kind;
	span span;
	double constant;
	uint16_t index;	   /* EXPR_PARAMETER: 0-based; loop variables follow the parameters */
	uint8_t component; /* 0 r/x … 4 transmit, 5 gray, 6 hf */
	bool literal;	   /* a bare unsigned literal or float identifier (constant merging asks) */
	bool grouped;	   /* stood in parentheses */
	enum keyword builtin;
	const struct function *function;
	uint32_t depth; /* levels of operands below: 0 for a constant */
	uint32_t operand_count;
	const struct expr *const *operands;
};

struct function {
	enum function_kind kind;
	span span;
	const char *name;			  /* NULL: anonymous */
	unsigned parameter_count, variable_count; /* parameters; parameters and loop variables */
	size_t calls; /* of functions, those in the functions called included */
	const struct expr *body;
	int internal;
	const struct node *node;
	const struct spline *spline;
};

/* The whole scene. */
struct ast {
	const struct node *statements; /* of the top level, in source order; #default is not among
	                                  them: see language_state */
	struct language_state final;   /* at the end of the text */
	size_t token_count;	       /* for statistics */
};

/* The first child with that keyword, or NULL. */
const struct node *node_child(const struct node *, enum keyword);

#endif
