/* SPDX-License-Identifier: MIT */
/*
 * An 8-wide bounding volume hierarchy over boxes. It knows boxes and numbers,
 * not objects: who builds one keeps its items in the slots the tree names, and
 * walks it with bvh_walk.h.
 */
#ifndef LAMBERT_ACCEL_BVH_H
#define LAMBERT_ACCEL_BVH_H

#include "base/arena.h"
#include "base/vec3.h"

#include <stddef.h>
#include <stdint.h>

enum { BVH_WIDTH = 8 };

/* Child bounds in lanes, rounded outwards: low x, y, z, then high x, y, z. Lanes without a child
 * hold an empty box and a leaf that stands elsewhere, too: only a ray from beyond the reach of single
 * precision, which meets all boxes, comes there. */
struct bvh_node {
	_Alignas(64) float bound[6][BVH_WIDTH];
	uint32_t child[BVH_WIDTH];
};

/* A child is the number of a node, or a leaf: one slot, or with BVH_GROUP eight slots from a
 * multiple of eight, some of them empty. */
#define BVH_LEAF      0x80000000u
#define BVH_GROUP     0x40000000u
#define BVH_SLOT_MASK 0x3fffffffu
/* A slot of a group without an item. */
#define BVH_NOTHING UINT32_MAX

/* No path from the root is longer than this many nodes; a walk writes eight entries at a time. */
enum { BVH_DEPTH_MAX = 96, BVH_STACK = BVH_DEPTH_MAX * (BVH_WIDTH - 1) + BVH_WIDTH };

/* What the tree is built over: a box in single precision, rounded outwards. Items that group may
 * share a leaf, the others get one each. */
struct bvh_item {
	float lo[3], hi[3];
	uint32_t index : 31, groups : 1;
};
struct bvh_item bvh_item(box, uint32_t index, bool groups);

struct bvh {
	struct bvh_node *nodes; /* node 0 is the root */
	size_t node_count, depth;
	/* The index of the item in each slot, or BVH_NOTHING; who builds the tree frees them. */
	uint32_t *slots;
	size_t slot_count;
};

/* The tree over 1 to 2^26 items, whose boxes are finite, with its nodes in the arena; puts the items
 * into another order. The result is the same for any number of threads. */
struct bvh bvh_build(struct arena *, struct bvh_item *items, size_t count, unsigned threads);

#endif
