/* SPDX-License-Identifier: MIT */
/*
 * Arenas: a list of blocks, filled from the front. Large requests get a block
 * of their own. Memory is zeroed when it is handed out.
 */
#include "base/arena.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	DEFAULT_BLOCK = 64 * 1024,
	BIG_ALIGNMENT = 64,
	SMALL_ALIGNMENT = 16,
	PACKED_ALIGNMENT = 8,
};

struct block {
	struct block *next;
	size_t size; /* bytes that follow the header */
	size_t used;
	char padding[BIG_ALIGNMENT - sizeof(void *) - 2 * sizeof(size_t)];
};

struct arena {
	struct block *blocks; /* the one being filled comes first */
	size_t block_size;
	size_t handed_out;
};

static _Noreturn void out_of_memory(size_t size)
{
	fprintf(stderr, "lambert: out of memory (%zu bytes wanted)\n", size);
	exit(1);
}

static size_t checked_product(size_t count, size_t size)
{
	if (size != 0 && count > SIZE_MAX / size)
		out_of_memory(SIZE_MAX);
	return count * size;
}

void *memory_alloc(size_t count, size_t size)
{
	const size_t bytes = checked_product(count, size);
	void *memory = malloc(bytes ? bytes : 1);
	if (!memory)
		out_of_memory(bytes);
	return memory;
}

void *memory_grow(void *old, size_t count, size_t size)
{
	const size_t bytes = checked_product(count, size);
	void *memory = realloc(old, bytes ? bytes : 1);
	if (!memory)
		out_of_memory(bytes);
	return memory;
}

static struct block *block_create(size_t size)
{
	if (size > SIZE_MAX / 2)
		out_of_memory(size);
	size = (size + BIG_ALIGNMENT - 1) & ~(size_t)(BIG_ALIGNMENT - 1);
	struct block *b = aligned_alloc(BIG_ALIGNMENT, sizeof *b + size);
	if (!b)
		out_of_memory(size);
	b->next = NULL;
	b->size = size;
	b->used = 0;
	return b;
}

struct arena *arena_create(size_t block)
{
	struct arena *a = memory_alloc(1, sizeof *a);
	a->block_size = block ? block : DEFAULT_BLOCK;
	a->blocks = NULL;
	a->handed_out = 0;
	return a;
}

static void blocks_free(struct block *b)
{
	while (b) {
		struct block *next = b->next;
		free(b);
		b = next;
	}
}

void arena_destroy(struct arena *a)
{
	if (!a)
		return;
	blocks_free(a->blocks);
	free(a);
}

void arena_reset(struct arena *a)
{
	a->handed_out = 0;
	if (!a->blocks)
		return;
	blocks_free(a->blocks->next);
	a->blocks->next = NULL;
	a->blocks->used = 0;
}

static void *take(struct arena *a, size_t size, size_t alignment)
{
	struct block *b = a->blocks;
	size_t start = b ? (b->used + alignment - 1) & ~(alignment - 1) : 0;

	if (!b || start > b->size || size > b->size - start) {
		const bool alone = size > a->block_size / 4;
		struct block *fresh = block_create(alone ? size : a->block_size);
		if (alone && b) { /* keep filling the current block afterwards */
			fresh->next = b->next;
			b->next = fresh;
		} else {
			fresh->next = b;
			a->blocks = fresh;
		}
		b = fresh;
		start = 0;
	}
	b->used = start + size;
	a->handed_out += size;
	return memset((char *)(b + 1) + start, 0, size);
}

void *arena_alloc(struct arena *a, size_t size)
{
	return take(a, size, size >= BIG_ALIGNMENT ? BIG_ALIGNMENT : SMALL_ALIGNMENT);
}

void *arena_pack(struct arena *a, size_t size)
{
	return take(a, size, PACKED_ALIGNMENT);
}

void *arena_array(struct arena *a, size_t count, size_t size)
{
	return arena_alloc(a, checked_product(count, size));
}

void *arena_copy(struct arena *a, const void *bytes, size_t size)
{
	void *copy = arena_alloc(a, size);
	if (size)
		memcpy(copy, bytes, size);
	return copy;
}

char *arena_string(struct arena *a, const char *text, size_t length)
{
	char *copy = arena_alloc(a, length + 1);
	if (length)
		memcpy(copy, text, length);
	return copy;
}

char *arena_printf(struct arena *a, const char *format, ...)
{
	va_list args, again;
	va_start(args, format);
	va_copy(again, args);
	const int length = vsnprintf(NULL, 0, format, args);
	va_end(args);
	char *text = arena_alloc(a, (size_t)(length < 0 ? 0 : length) + 1);
	if (length > 0)
		vsnprintf(text, (size_t)length + 1, format, again);
	va_end(again);
	return text;
}

size_t arena_used(const struct arena *a)
{
	return a->handed_out;
}
