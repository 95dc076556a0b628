/* SPDX-License-Identifier: MIT */
/*
 * Strings by lifetime; see text.h. Blocks form a list and are freed together.
 */
#include "text.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

struct text_block {
	struct text_block *next;
	_Alignas(16) char bytes[];
};

void text_pool_finish(struct text_pool *pool)
{
	for (struct text_block *b = pool->blocks, *next; b; b = next) {
		next = b->next;
		free(b);
	}
	pool->blocks = NULL;
}

void *text_alloc(struct text_pool *pool, size_t size)
{
	struct text_block *b = calloc(1, sizeof *b + size);
	if (!b) {
		fputs("lambert: error: out of memory\n", stderr);
		exit(1);
	}
	b->next = pool->blocks;
	pool->blocks = b;
	return b->bytes;
}

char *text_copy(struct text_pool *pool, const char *text, size_t length)
{
	char *copy = text_alloc(pool, length + 1);
	memcpy(copy, text, length);
	return copy;
}

char *text_vprintf(struct text_pool *pool, const char *format, va_list args)
{
	va_list again;
	va_copy(again, args);
	const int n = vsnprintf(NULL, 0, format, again);
	va_end(again);
	char *text = text_alloc(pool, (size_t)n + 1);
	vsnprintf(text, (size_t)n + 1, format, args);
	return text;
}

char *text_printf(struct text_pool *pool, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	char *text = text_vprintf(pool, format, args);
	va_end(args);
	return text;
}

void text_show(FILE *file, const char *text)
{
	for (const unsigned char *s = (const unsigned char *)text; *s; s++) {
		/* U+0080 to U+009F are two bytes */
		const bool wide = s[0] == 0xC2 && s[1] >= 0x80 && s[1] < 0xA0;
		const bool control = (*s < ' ' && *s != '\n' && *s != '\t') || *s == 127 || wide;
		if (!control) {
			fputc(*s, file);
			continue;
		}
		s += wide;
		fprintf(file, "\\x%02x", *s);
	}
}

void text_list_add(struct text_pool *pool, struct text_list *list, const char *item)
{
	if (list->count == list->room) {
		const size_t room = list->room ? 2 * list->room : 8;
		const char **items = text_alloc(pool, room * sizeof *items);
		if (list->count)
			memcpy(items, list->items, list->count * sizeof *items);
		list->items = items;
		list->room = room;
	}
	list->items[list->count++] = item;
}

bool text_ends_with(const char *text, const char *end)
{
	const size_t n = strlen(text), m = strlen(end);
	return n >= m && strcasecmp(text + n - m, end) == 0;
}

char *text_of_file(struct text_pool *pool, const char *path, size_t *size)
{
	FILE *file = fopen(path, "rb");
	struct stat s;
	if (!file)
		return NULL;
	if (fstat(fileno(file), &s) != 0 || S_ISDIR(s.st_mode)) {
		fclose(file);
		errno = EISDIR;
		return NULL;
	}
	char *text = text_alloc(pool, (size_t)s.st_size + 1);
	const size_t n = fread(text, 1, (size_t)s.st_size, file);
	fclose(file);
	text[n] = 0;
	*size = n;
	return text;
}
