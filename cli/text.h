/* SPDX-License-Identifier: MIT */
/*
 * Strings that live as long as the pool they come from. Running out of memory
 * ends the program with status 1.
 */
#ifndef LAMBERT_CLI_TEXT_H
#define LAMBERT_CLI_TEXT_H

#include <stdbool.h>
#include <stddef.h>

struct text_block;
struct text_pool {
	struct text_block *blocks;
};
void text_pool_finish(struct text_pool *);

/* Zeroed memory. */
void *text_alloc(struct text_pool *, size_t size);
char *text_copy(struct text_pool *, const char *text, size_t length);
char *text_printf(struct text_pool *, const char *format, ...)
	__attribute__((format(printf, 2, 3), nonnull(2)));

/* A growing list of strings; zeroed, it is empty. */
struct text_list {
	const char **items;
	size_t count, room;
};
void text_list_add(struct text_pool *, struct text_list *, const char *item);

/* Whether `text` ends with `end`, in any letter case. */
bool text_ends_with(const char *text, const char *end);
/* A whole file, zero-terminated; NULL when it cannot be read (errno says why). */
char *text_of_file(struct text_pool *, const char *path);

#endif
