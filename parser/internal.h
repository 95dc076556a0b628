/* SPDX-License-Identifier: MIT */
/*
 * The state of one parse, shared by the directive layer (expand.c and its
 * helpers) and the grammar (grammar.y and its helpers). Nobody else sees it.
 *
 * Nested parses are C recursion: a #declare runs parse_declared from within
 * expand_next, which may itself run inside a parse. Keep the stack frame of a
 * bison parser small (YYINITDEPTH 40 or so, growing on the heap): up to
 * NESTED_PARSES of them can be active at once.
 */
#ifndef LAMBERT_PARSER_INTERNAL_H
#define LAMBERT_PARSER_INTERNAL_H

#include "base/arena.h"
#include "base/diag.h"
#include "base/pointer_map.h"
#include "parser/ast.h"
#include "names.h"
#include "parser/parser.h"
#include "token.h"
#include "value.h"

enum {
	REFERENCE_LEVELS = 4000, /* of declared values that use declared values */
	REFERENCE_PARTS =
		10000000,    /* declared values that one statement uses, each as often as it is */
	MOST_ERRORS = 20,    /* reported in one run */
	NESTED_PARSES = 200, /* active at once; more is an error (checked where parses begin) */
};

/* How bytes above 127 in string literals are read; global_settings { charset … } sets it. */
enum charset { CHARSET_ASCII, CHARSET_UTF8, CHARSET_SYS };

/* Strings and arrays of the scene's variables, and what was one; see collect.c. */
struct held {
	struct arena *texts; /* strings, and arrays while they are read */
	struct array *arrays;
	size_t array_bytes;
	size_t due; /* bytes of both that lead to the next collection */
};

enum {
	TEXT_WALKS = 4,
	TEXT_WALK_LEAST = 64, /* bytes; a walk through a shorter string is not worth keeping */
};

/* Where substr was last in a string: the next one mostly asks for what follows, and going there from
 * the beginning each time would make a loop over a string quadratic. */
struct text_walk {
	const char *text; /* NULL: of none */
	const char *at;
	size_t character; /* number of the one at `at`, from 0 */
	size_t length;	  /* of the text, in characters */
};

struct expand;	/* the directive layer's own state: expand.h */
struct grammar; /* the grammar's own state: build.h */

struct parser {
	struct diag *diag;
	struct arena *arena; /* for what may be used as long as text is read */
	struct arena *tree;  /* for nodes: of the scene's statements, which are handed over and
	                        forgotten, or, for declared values, `arena` */
	bool keeps_tree;     /* something lasting refers to statements: they stay */
	const struct parse_options *options;

	struct held held;

	/* What the text read so far has set; copied into each node made. Never written to: a
	 * change makes a new one, see parser_change_state. */
	const struct language_state *state;
	enum charset charset;
	bool version_is_first; /* the version is known before the first statement */

	/* While an expression is only tried (quick.c) nothing is reported, but noted. */
	bool trial, refused;

	/* An error was reported: expand_next returns 0 from now on, nested parsers unwind. */
	bool failed;
	/* After this error nothing else is worth reading. */
	bool stopped;
	/* Errors reported. What is read again, in a macro, is not reported again. */
	span reported[MOST_ERRORS];
	unsigned error_count;
	bool error_shown; /* the last error was: its notes follow */

	/* Levels of references below declared nodes (none: 0), and in the value being read: what
	 * follows references later recurses as deep. */
	struct pointer_map reference_levels;
	uintptr_t levels_read;
	/* The same for the number of references: each object used is made anew, and a union made of
	 * itself twice, a few dozen times over, is more than any memory can hold. */
	struct pointer_map reference_parts;
	uintptr_t parts_read;

	/* Random streams: seed() appends a state, rand() advances one. memory_grow'n, freed at
	 * the end of the parse. */
	uint32_t *seeds;
	size_t seed_count;
	size_t joined_bytes; /* of all strings that concat made */
	size_t passed_bytes; /* of the trees handed over */
	struct text_walk walks[TEXT_WALKS];
	unsigned walk_count; /* begun so far: the oldest makes room */
	/* User functions that were called while the text was read: calling them needs no message. */
	struct pointer_map called;

	struct grammar *grammar;

	struct expand *expand;
	size_t token_count; /* delivered to the grammar */
};

/* Frees what the grammar's state holds besides the arena. */
void grammar_finish(struct parser *);

void held_init(struct held *);
void held_release(struct held *);
/* Between two statements: gives back what no variable holds any more, if there may be much of it. */
void held_collect(struct parser *);
/* growth.c: whether there may be so many bytes more; false after an error. */
bool growth_permits(struct parser *, double more, span where);
/* Makes the elements of an array, unset, and owns it from now on; after an error just one. */
void array_keep(struct parser *, struct array *);
/* A copy that later changes of the original do not reach: arrays are copied. */
struct value value_copy(struct parser *, const struct value *);

/* A fresh, writable copy of the language state that is in force from now on. */
struct language_state *parser_change_state(struct parser *);

/* Reports an error and ends the token stream, so that what is its consequence is not shown. */
void parser_error(struct parser *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* The same, and nothing more is read. */
void parser_stop(struct parser *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* Says more about the error before, if that was shown. */
void parser_note(struct parser *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* Reports a warning of an expression. */
void parser_warning(struct parser *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* The error for a word that names nothing (T_UNDECLARED), with the nearest name that passes the
 * test. */
/* Whether a name means anything at the moment: a name_test. */
bool is_declared(const void *context, const struct name *);
void parser_error_undeclared(
	struct parser *, span where, const char *name, name_test *, const void *context);

/* Whether the word changes an object, and does nothing between statements. */
bool is_object_modifier(enum keyword);

/* Notes after an error at `token`, which stands behind an operand, if it is an operator: comparisons need
 * parentheses in most places. False: it is none. */
bool note_operator(struct parser *, int token, span where);

/* Notes after an error at a '(' or '[' that the name before it is not one to be called, or has no
 * elements. False: there is no name. */
bool note_bracket(struct parser *, int token, span where);

/* The span from the start of `first` to the end of `last`, if they come from the same text. */
static inline span span_join(span first, span last)
{
	const uint32_t end = last.offset + last.length;
	if (first.source == 0)
		return last;
	if (first.source == last.source && first.site == last.site && end > first.offset)
		first.length = end - first.offset;
	return first;
}

#endif
