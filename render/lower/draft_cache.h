/* SPDX-License-Identifier: MIT */
/*
 * Declared objects that have been drafted already, by their node.
 */
#ifndef LAMBERT_RENDER_LOWER_DRAFT_CACHE_H
#define LAMBERT_RENDER_LOWER_DRAFT_CACHE_H

#include "render/lower/draft.h"

struct draft *draft_cache_find(struct lowering *, const struct node *);
void draft_cache_add(struct lowering *, const struct node *, struct draft *);

#endif
