/* SPDX-License-Identifier: MIT */
/*
 * Symbol tables. Table 1 is the global one; each include file and each macro
 * call has one more on top while it is read. Looking a word up is one load: the
 * name knows its innermost symbol, which knows the one it hides.
 */
#ifndef LAMBERT_PARSER_SYMBOL_H
#define LAMBERT_PARSER_SYMBOL_H

#include "names.h"
#include "value.h"

struct symbol {
	struct value value;
	struct value *slot;    /* where the value is: &value, or elsewhere for a parameter that
	                          stands for a variable of the caller */
	struct symbol *hidden; /* the next outer symbol of the same name */
	struct symbol *next;   /* in its table */
	const char *text;      /* its name */
	uint32_t name;	       /* id */
	unsigned table;	       /* number of its table; 0: removed */
	bool entered;	       /* its first value is being read: declared, but without a value */
	bool awaited;	       /* a #read was to give it a value: declared, even if none came */
	bool kept;	       /* somebody holds on to it: do not recycle */
	bool orphan;	       /* kept when its table went */
	bool deprecated, deprecated_once;
	const char *deprecation; /* message, NULL: a default text */
};

enum {
	SYMBOL_GLOBAL = 1, /* table 0 is that of the reserved words */
	SYMBOL_TABLES = 100,
	SYMBOL_ROUND = 4096, /* tokens */
};

struct symbols {
	struct names *names;
	struct arena *arena;
	unsigned table; /* the innermost */
	struct symbol *first[SYMBOL_TABLES];
	/* Symbols of tables that are gone; reused when nothing read ahead can refer to them. */
	struct symbol *unused, *dying, *dead;
	unsigned removed; /* since the latest symbols_drop_removed */
	size_t round;	  /* token_count / SYMBOL_ROUND of the latest change */
};

void symbols_init(struct symbols *, struct names *, struct arena *);
/* A new innermost table; false: there are too many. */
bool symbols_push(struct symbols *);
/* Removes the innermost table with all that is in it. */
void symbols_pop(struct symbols *);
/* Whether a round is over since the last symbols_recycle. */
static inline bool symbols_are_old(const struct symbols *s, size_t token_count)
{
	return token_count / SYMBOL_ROUND != s->round;
}
/* Once a round: lets symbols of tables long gone be used again. */
void symbols_recycle(struct symbols *, size_t token_count);

/* The innermost symbol of a name, or NULL. */
struct symbol *symbol_find(const struct symbols *, uint32_t name);
/* A new symbol without a value in a table. */
struct symbol *symbol_create(struct symbols *, uint32_t name, unsigned table);
/* A short-lived symbol that stands for an element of an array. */
struct symbol *symbol_of_element(struct symbols *, const struct symbol *array, struct value *slot);
/* Ends the holding on to a symbol, unless somebody did already. */
void symbol_let_go(struct symbols *, struct symbol *, bool kept_before);
/* Lets removed symbols be used again at last: nobody refers to them. */
void symbols_drop_removed(struct symbols *);
/* Forgets a symbol. */
void symbol_remove(struct symbols *, struct symbol *);

#endif
