/* SPDX-License-Identifier: MIT */
/*
 * Interned words. Every word of the text is known by a small number from the
 * lexer on; what it means at the moment is one load away.
 */
#ifndef LAMBERT_PARSER_NAMES_H
#define LAMBERT_PARSER_NAMES_H

#include "base/arena.h"
#include "parser/ast.h"

#include <stdint.h>

struct symbol;

struct name {
	const char *text;
	uint32_t length, hash;
	enum keyword keyword;	/* K_NONE: not reserved */
	bool lost;		/* its declaration was passed over behind an error */
	unsigned hidden;	/* times it is a function parameter at the moment */
	struct symbol *binding; /* innermost symbol of that name, NULL: none */
};

struct names {
	struct arena *arena;
	struct name *list; /* by id */
	uint32_t count, room;
	uint32_t *buckets; /* id + 1, 0: free */
	uint32_t bucket_count;
};

/* Knows all reserved words. */
void names_init(struct names *, struct arena *);
void names_finish(struct names *);

/* The id of a word, entered if it is new. */
uint32_t names_intern(struct names *, const char *text, size_t length);
/* Whether `known` is like `word`, and more so than `*least` tells, which is then set; it begins as
 * UINT_MAX. */
bool names_is_nearer(const char *word, const char *known, unsigned *least);
/* Whether a name could stand at some place. */
typedef bool name_test(const void *context, const struct name *);
/* The word nearest in spelling among those that pass the test, NULL if none is near. */
const char *names_nearest(const struct names *, const char *word, name_test *, const void *context);
/* One of them that differs from the word in letter case only, NULL if there is none. */
const char *names_in_other_case(
	const struct names *, const char *word, name_test *, const void *context);

#endif
