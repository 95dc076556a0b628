/* SPDX-License-Identifier: MIT */
/*
 * Interned words: a hash table with linear probing over an array of names.
 */
#include "names.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static uint32_t hash_word(const char *text, size_t length)
{
	uint32_t hash = 2166136261u; /* FNV-1a */
	for (size_t i = 0; i < length; i++)
		hash = (hash ^ (unsigned char)text[i]) * 16777619u;
	return hash ^ hash >> 15;
}

static void place(struct names *n, uint32_t id)
{
	uint32_t at = n->list[id].hash & (n->bucket_count - 1);
	while (n->buckets[at])
		at = (at + 1) & (n->bucket_count - 1);
	n->buckets[at] = id + 1;
}

static void widen(struct names *n)
{
	n->bucket_count *= 2;
	free(n->buckets);
	n->buckets = memory_alloc(n->bucket_count, sizeof *n->buckets);
	memset(n->buckets, 0, n->bucket_count * sizeof *n->buckets);
	for (uint32_t id = 0; id < n->count; id++)
		place(n, id);
}

uint32_t names_intern(struct names *n, const char *text, size_t length)
{
	const uint32_t hash = hash_word(text, length);
	uint32_t at = hash & (n->bucket_count - 1);
	for (; n->buckets[at]; at = (at + 1) & (n->bucket_count - 1)) {
		const struct name *known = &n->list[n->buckets[at] - 1];
		if (known->hash == hash && known->length == length &&
			!memcmp(known->text, text, length))
			return n->buckets[at] - 1;
	}
	if (n->count == n->room) {
		n->room = n->room ? 2 * n->room : 1024;
		n->list = memory_grow(n->list, n->room, sizeof *n->list);
	}
	const uint32_t id = n->count++;
	n->list[id] = (struct name){
		.text = arena_string(n->arena, text, length),
		.length = (uint32_t)length,
		.hash = hash,
	};
	if (2 * n->count > n->bucket_count)
		widen(n);
	else
		n->buckets[at] = id + 1;
	return id;
}

static void reserve(struct names *n, const char *word, enum keyword keyword)
{
	const uint32_t id = names_intern(n, word, strlen(word));
	n->list[id].keyword = keyword;
}

void names_init(struct names *n, struct arena *arena)
{
	*n = (struct names){ .arena = arena, .bucket_count = 2048 };
	n->buckets = memory_alloc(n->bucket_count, sizeof *n->buckets);
	memset(n->buckets, 0, n->bucket_count * sizeof *n->buckets);
#define KEYWORD(word, WORD) reserve(n, #word, K_##WORD);
#define SYNONYM(word, WORD) reserve(n, #word, K_##WORD);
#include "language/keywords.def"
#undef KEYWORD
#undef SYNONYM
}

void names_finish(struct names *n)
{
	free(n->list);
	free(n->buckets);
	*n = (struct names){ 0 };
}

enum { WORD_MAX = 64 }; /* longer words get no suggestion */

static unsigned smaller(unsigned a, unsigned b)
{
	return a < b ? a : b;
}

/* Letters to insert, remove, replace or swap with the neighbour; case counts half. */
static unsigned distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
	unsigned rows[3][WORD_MAX + 1];
	for (size_t j = 0; j <= b_length; j++)
		rows[0][j] = 2 * (unsigned)j;
	for (size_t i = 1; i <= a_length; i++) {
		unsigned *now = rows[i % 3];
		const unsigned *above = rows[(i + 2) % 3], *above2 = rows[(i + 1) % 3];
		now[0] = 2 * (unsigned)i;
		for (size_t j = 1; j <= b_length; j++) {
			const char x = a[i - 1], y = b[j - 1];
			const unsigned change = x == y ? 0 : (x ^ y) == 32 ? 1 : 2;
			unsigned best = smaller(above[j] + 2, now[j - 1] + 2);
			best = smaller(best, above[j - 1] + change);
			if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y)
				best = smaller(best, above2[j - 2] + 2);
			now[j] = best;
		}
	}
	return rows[a_length % 3][b_length];
}

static bool is_other_case(char a, char b)
{
	return (a ^ b) == 32 && ((a >= 'A' && a <= 'Z') || (a >= 'a' && a <= 'z'));
}

static bool differs_in_case(const char *a, const char *b)
{
	const char *const start = a;
	bool differs = false;
	for (; *a && (*a == *b || is_other_case(*a, *b)); a++, b++)
		differs |= *a != *b;
	return differs && a > start && !*a && !*b;
}

const char *names_in_other_case(
	const struct names *n, const char *word, name_test *test, const void *context)
{
	for (uint32_t id = 0; id < n->count; id++)
		if (differs_in_case(n->list[id].text, word) && test(context, &n->list[id]))
			return n->list[id].text;
	return NULL;
}

bool names_is_nearer(const char *word, const char *known, unsigned *least)
{
	const size_t length = strlen(word), known_length = strlen(known);
	if ((length < 2 && !differs_in_case(word, known)) || length > WORD_MAX ||
		known_length > WORD_MAX || known_length + 3 < length || known_length > length + 3 ||
		!strcmp(known, word))
		return false;
	const unsigned most = length < 4 ? 2 : length < 8 ? 4 : 6;
	const unsigned d = distance(word, length, known, known_length);
	if (d > most || d >= *least)
		return false;
	*least = d;
	return true;
}

const char *names_nearest(
	const struct names *n, const char *word, name_test *test, const void *context)
{
	const char *nearest = NULL;
	unsigned least = UINT_MAX;
	for (uint32_t id = 0; id < n->count; id++) {
		const struct name *known = &n->list[id];
		if (test(context, known) && names_is_nearer(word, known->text, &least))
			nearest = known->text;
	}
	return nearest;
}
