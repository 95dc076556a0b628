/* SPDX-License-Identifier: MIT */
/*
 * A hash table from node to draft: open addressing, grown at half load.
 */
#include "render/lower/draft_cache.h"

struct draft_cache {
	size_t size, count; /* size is a power of two */
	struct entry {
		const struct node *node;
		struct draft *draft;
	} * entries;
};

static size_t slot_of(const struct draft_cache *c, const struct node *n)
{
	size_t slot = ((uintptr_t)n >> 4) * 0x9E3779B97F4A7C15u >> 20;
	for (slot &= c->size - 1; c->entries[slot].node && c->entries[slot].node != n;)
		slot = (slot + 1) & (c->size - 1);
	return slot;
}

struct draft *draft_cache_find(struct lowering *l, const struct node *n)
{
	const struct draft_cache *c = l->drafts;
	return c ? c->entries[slot_of(c, n)].draft : NULL;
}

static struct draft_cache *cache_create(struct lowering *l, size_t size)
{
	struct draft_cache *c = ARENA_NEW(l->arena, struct draft_cache);
	c->size = size;
	c->entries = ARENA_ARRAY(l->arena, size, struct entry);
	return c;
}

void draft_cache_add(struct lowering *l, const struct node *n, struct draft *d)
{
	if (!l->drafts)
		l->drafts = cache_create(l, 64);
	if (2 * (l->drafts->count + 1) > l->drafts->size) {
		const struct draft_cache *old = l->drafts;
		l->drafts = cache_create(l, 2 * old->size);
		for (size_t i = 0; i < old->size; i++) {
			if (old->entries[i].node)
				draft_cache_add(l, old->entries[i].node, old->entries[i].draft);
		}
	}
	struct draft_cache *c = l->drafts;
	c->entries[slot_of(c, n)] = (struct entry){ n, d };
	c->count++;
}
