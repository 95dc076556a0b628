/* SPDX-License-Identifier: MIT */
/*
 * Memory by lifetime. An arena hands out memory that is freed all at once:
 * when the arena is destroyed, or reset for the next round.
 *
 * Allocation never returns NULL: when the system has no memory left the program
 * says so and ends with status 1. Sizes are multiplied with an overflow check in
 * one place, arena.c.
 */
#ifndef LAMBERT_BASE_ARENA_H
#define LAMBERT_BASE_ARENA_H

#include <stddef.h>

struct arena;

/* A new, empty arena; `block` is the usual size of a block in bytes, 0 for the default. */
struct arena *arena_create(size_t block);
/* Frees everything that came from the arena. NULL is allowed. */
void arena_destroy(struct arena *);
/* Forgets everything that came from the arena but keeps its first block for reuse. */
void arena_reset(struct arena *);

/* What has come from an arena so far. */
struct arena_mark {
	struct block *block, *next;
	size_t used, handed_out;
};
struct arena_mark arena_mark(const struct arena *);
/* Forgets what came from the arena behind the mark, which no reset may precede. */
void arena_rewind(struct arena *, struct arena_mark);

/* Zeroed memory, aligned to 64 bytes when size >= 64, else to 16. */
void *arena_alloc(struct arena *, size_t size);
/* Zeroed memory, aligned to 8 bytes only: for the many small parts of a large tree. */
void *arena_pack(struct arena *, size_t size);
/* Zeroed memory for `count` elements of `size` bytes. */
void *arena_array(struct arena *, size_t count, size_t size);
/* A copy of `size` bytes. */
void *arena_copy(struct arena *, const void *bytes, size_t size);
/* A zero-terminated copy of the first `length` bytes of `text`. */
char *arena_string(struct arena *, const char *text, size_t length);
/* printf into the arena. */
char *arena_printf(struct arena *, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Bytes handed out since creation or the last reset. */
size_t arena_used(const struct arena *);

#define ARENA_NEW(arena, type)		((type *)arena_alloc((arena), sizeof(type)))
#define ARENA_ARRAY(arena, count, type) ((type *)arena_array((arena), (count), sizeof(type)))

/* malloc, realloc that end the program with a plain message when memory is exhausted. */
void *memory_alloc(size_t count, size_t size);
void *memory_grow(void *old, size_t count, size_t size);
/* The same, zeroed. */
void *memory_zeroed(size_t count, size_t size);

#endif
