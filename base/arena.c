/* SPDX-License-Identifier: MIT */
/*
 * Arenas: a list of blocks, filled from the front. Large requests get a block
 * of their own. Memory is zero when it is handed out.
 *
 * Blocks grow with the arena. Where much memory is wanted the system is asked
 * for huge pages: getting small ones, half a million of them to the gigabyte,
 * takes longer than filling them.
 */
#include "base/arena.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum {
	DEFAULT_BLOCK = 64 * 1024,
	HUGE_PAGE = 2 << 20,
	MAPPED_BLOCK = 4 << 20, /* blocks of this size and above come from the system */
	GROWTH = 8,		/* a block holds this share of the arena */
	BIG_ALIGNMENT = 64,
	SMALL_ALIGNMENT = 16,
	PACKED_ALIGNMENT = 8,
};

struct block {
	struct block *next;
	size_t size; /* bytes that follow the header */
	size_t used;
	size_t dirty; /* memory behind this is zero */
	bool mapped;
	char padding[BIG_ALIGNMENT - 2 * sizeof(void *) - 3 * sizeof(size_t)];
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

void *memory_zeroed(size_t count, size_t size)
{
	void *memory = calloc(count ? count : 1, size ? size : 1);
	if (!memory)
		out_of_memory(checked_product(count, size));
	return memory;
}

/* Only advice: whether it is taken does not matter to anybody. */
static void want_huge_pages(void *memory, size_t size)
{
	const uintptr_t start = ((uintptr_t)memory + HUGE_PAGE - 1) & ~(uintptr_t)(HUGE_PAGE - 1);
	const uintptr_t end = ((uintptr_t)memory + size) & ~(uintptr_t)(HUGE_PAGE - 1);
	if (end > start)
		(void)madvise((void *)start, end - start, MADV_HUGEPAGE);
}

void *memory_grow(void *old, size_t count, size_t size)
{
	const size_t bytes = checked_product(count, size);
	void *memory = realloc(old, bytes ? bytes : 1);
	if (!memory)
		out_of_memory(bytes);
	if (bytes >= MAPPED_BLOCK)
		want_huge_pages(memory, bytes);
	return memory;
}

/* Zeroed memory of the system that begins with a huge page. */
static void *map(size_t size)
{
	char *memory = mmap(
		NULL, size + HUGE_PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	if (memory == MAP_FAILED)
		return NULL;
	const size_t before = -(uintptr_t)memory & (HUGE_PAGE - 1);
	if (before)
		munmap(memory, before);
	munmap(memory + before + size, HUGE_PAGE - before);
	want_huge_pages(memory + before, size);
	return memory + before;
}

/* With room for `size` bytes. */
static struct block *block_create(size_t size)
{
	if (size > SIZE_MAX / 2)
		out_of_memory(size);
	size_t whole = sizeof(struct block) + size;
	const bool mapped = whole >= MAPPED_BLOCK;
	const size_t unit = mapped ? HUGE_PAGE : BIG_ALIGNMENT;
	whole = (whole + unit - 1) & ~(unit - 1);
	struct block *b = mapped ? map(whole) : aligned_alloc(BIG_ALIGNMENT, whole);
	if (!b)
		out_of_memory(size);
	b->next = NULL;
	b->size = whole - sizeof *b;
	b->used = 0;
	b->dirty = mapped ? 0 : b->size;
	b->mapped = mapped;
	return b;
}

static void block_destroy(struct block *b)
{
	if (b->mapped)
		munmap(b, sizeof *b + b->size);
	else
		free(b);
}

/* The size of the next block: in proportion to what is there. */
static size_t next_block(const struct arena *a)
{
	size_t size = a->block_size;
	while (size < MAPPED_BLOCK && size < a->handed_out / GROWTH)
		size *= 2;
	return size;
}

struct arena *arena_create(size_t block)
{
	struct arena *a = memory_alloc(1, sizeof *a);
	a->block_size = block ? block : DEFAULT_BLOCK;
	a->blocks = NULL;
	a->handed_out = 0;
	return a;
}

/* Frees the blocks of a list up to one that stays; NULL: all. */
static struct block *blocks_free_until(struct block *b, const struct block *stays)
{
	while (b != stays) {
		struct block *next = b->next;
		block_destroy(b);
		b = next;
	}
	return b;
}

void arena_destroy(struct arena *a)
{
	if (!a)
		return;
	blocks_free_until(a->blocks, NULL);
	free(a);
}

void arena_reset(struct arena *a)
{
	a->handed_out = 0;
	if (!a->blocks)
		return;
	a->blocks->next = blocks_free_until(a->blocks->next, NULL);
	a->blocks->used = 0;
}

struct arena_mark arena_mark(const struct arena *a)
{
	struct block *b = a->blocks;
	return (struct arena_mark){ b, b ? b->next : NULL, b ? b->used : 0, a->handed_out };
}

void arena_rewind(struct arena *a, struct arena_mark mark)
{
	a->blocks = blocks_free_until(a->blocks, mark.block);
	a->handed_out = mark.handed_out;
	if (!mark.block)
		return;
	mark.block->next = blocks_free_until(mark.block->next, mark.next);
	mark.block->used = mark.used;
}

static void *take(struct arena *a, size_t size, size_t alignment)
{
	struct block *b = a->blocks;
	size_t start = b ? (b->used + alignment - 1) & ~(alignment - 1) : 0;

	if (!b || start > b->size || size > b->size - start) {
		const size_t usual = next_block(a);
		const bool alone = size > usual / 4;
		struct block *fresh = block_create(alone ? size : usual);
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
	char *memory = (char *)(b + 1) + start;
	if (start < b->dirty)
		memset(memory, 0, b->dirty - start < size ? b->dirty - start : size);
	if (b->dirty < b->used)
		b->dirty = b->used;
	return memory;
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
