/* SPDX-License-Identifier: MIT */
/*
 * Strings that live as long as the pool they come from. Running out of memory
 * ends the program with status 1.
 */
#ifndef LAMBERT_CLI_TEXT_H
#define LAMBERT_CLI_TEXT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

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
char *text_vprintf(struct text_pool *, const char *format, va_list)
	__attribute__((format(printf, 2, 0), nonnull(2)));

/* Prints a text whose bytes may be anything, such as a name or a line of a file: control characters, which a
 * terminal would obey, come as \x1b. Newlines and tabs stay. */
void text_show(FILE *, const char *text);

/* A growing list of strings; zeroed, it is empty. */
struct text_list {
	const char **items;
	size_t count, room;
};
void text_list_add(struct text_pool *, struct text_list *, const char *item);

/* Whether `text` ends with `end`, in any letter case. */
bool text_ends_with(const char *text, const char *end);
/* A whole file, zero-terminated, and its size; NULL when it cannot be read (errno says why). */
char *text_of_file(struct text_pool *, const char *path, size_t *size);

#endif
