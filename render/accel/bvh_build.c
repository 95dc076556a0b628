/* SPDX-License-Identifier: MIT */
/*
 * Building the hierarchy, in three steps.
 *
 * 1. A binary tree from the top down, split where the surface area heuristic
 *    is least among 16 bins per axis (Wald 2007, "On fast construction of
 *    SAH-based bounding volume hierarchies"). A subtree of n items owns 2n - 1
 *    nodes at a place known beforehand, so subtrees are built in parallel and
 *    land in the same places in any order.
 * 2. From the bottom up, the cheapest way to cut each subtree into at most
 *    1 to 8 wide nodes and leaves (Ylitie, Karras and Laine 2017, "Efficient
 *    incoherent ray traversal on GPUs through compressed wide BVHs", 3.1).
 * 3. The wide nodes are written out in depth-first order.
 */
#include "bvh.h"

#include "base/arena.h"
#include "base/parallel.h"

#include <stdlib.h>
#include <string.h>

enum {
	BINS = 16,
	JOB_ITEMS = 4096, /* subtrees up to this size are built by one thread */
	DEPTH_SAH = 56,	  /* deeper ranges are halved, so that depth stays bounded */
	GROUP_MAX = BVH_WIDTH,
};
/* What testing a group of slots costs, in visits of a node. */
#define GROUP_COST 1.0f

struct bounds {
	float lo[3], hi[3];
};

struct item {
	struct bounds bounds;
	uint32_t index;
	bool groups;
};

/* The left child follows its parent. */
struct binary {
	struct bounds bounds;
	uint32_t right; /* 0: a single item */
	uint32_t first, count;
	bool groups;		/* all items may share a leaf */
	uint8_t cut[BVH_WIDTH]; /* see struct cost */
};

struct builder {
	struct item *items;
	struct binary *tree;
	struct job *jobs;
	size_t job_count, job_room;
	struct bvh bvh;
	size_t slot_room;
	uint32_t latest_leaf; /* as a child */
};

struct job {
	uint32_t at, first, count, depth;
};

/* ---- boxes ---- */

static float round_down(double v)
{
	const float f = (float)v;
	return (double)f > v ? nextafterf(f, -INFINITY) : f;
}

static float round_up(double v)
{
	const float f = (float)v;
	return (double)f < v ? nextafterf(f, INFINITY) : f;
}

static struct bounds bounds_outwards(box b)
{
	return (struct bounds){
		{ round_down(b.lo.x), round_down(b.lo.y), round_down(b.lo.z) },
		{ round_up(b.hi.x), round_up(b.hi.y), round_up(b.hi.z) },
	};
}

static const struct bounds bounds_nothing = {
	{ INFINITY, INFINITY, INFINITY },
	{ -INFINITY, -INFINITY, -INFINITY },
};

static inline void bounds_add(struct bounds *to, const struct bounds *b)
{
	for (int k = 0; k < 3; k++) {
		to->lo[k] = to->lo[k] < b->lo[k] ? to->lo[k] : b->lo[k];
		to->hi[k] = to->hi[k] > b->hi[k] ? to->hi[k] : b->hi[k];
	}
}

/* Half the surface. */
static float bounds_area(const struct bounds *b)
{
	const float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
	return x * y + y * z + z * x;
}

/* Twice the centre of an item. */
static inline float item_centre(const struct item *item, int axis)
{
	return item->bounds.lo[axis] + item->bounds.hi[axis];
}

/* ---- step 1: the binary tree ---- */

struct bin {
	struct bounds bounds;
	uint32_t count;
};

struct split {
	int axis;
	float start, scale; /* centre to bin number */
	int bin;	    /* last one on the left */
	float cost;
};

static inline int bin_of(float centre, float start, float scale)
{
	const int bin = (int)((centre - start) * scale);
	return bin < 0 ? 0 : bin < BINS ? bin : BINS - 1;
}

static void split_best_of_axis(const struct bin bins[BINS], int axis, struct split *best)
{
	float right_cost[BINS];
	struct bounds sum = bounds_nothing;
	uint32_t count = 0;
	for (int i = BINS - 1; i > 0; i--) {
		bounds_add(&sum, &bins[i].bounds);
		count += bins[i].count;
		right_cost[i] = count ? bounds_area(&sum) * (float)count : INFINITY;
	}
	sum = bounds_nothing;
	count = 0;
	for (int i = 0; i < BINS - 1; i++) {
		bounds_add(&sum, &bins[i].bounds);
		count += bins[i].count;
		if (!count)
			continue;
		const float cost = bounds_area(&sum) * (float)count + right_cost[i + 1];
		if (cost < best->cost) {
			best->axis = axis;
			best->bin = i;
			best->cost = cost;
		}
	}
}

static struct split find_split(const struct item *items, uint32_t count)
{
	float lo[3] = { INFINITY, INFINITY, INFINITY };
	float hi[3] = { -INFINITY, -INFINITY, -INFINITY };
	for (uint32_t i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			const float c = item_centre(&items[i], k);
			lo[k] = c < lo[k] ? c : lo[k];
			hi[k] = c > hi[k] ? c : hi[k];
		}
	}
	float scale[3];
	for (int k = 0; k < 3; k++) {
		scale[k] = (float)BINS * 0.9999f / (hi[k] - lo[k]);
		if (!isfinite(scale[k]))
			scale[k] = 0;
	}

	struct bin bins[3][BINS];
	for (int i = 0; i < 3 * BINS; i++)
		bins[i / BINS][i % BINS] = (struct bin){ bounds_nothing, 0 };
	for (uint32_t i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			struct bin *bin =
				&bins[k][bin_of(item_centre(&items[i], k), lo[k], scale[k])];
			bounds_add(&bin->bounds, &items[i].bounds);
			bin->count++;
		}
	}
	struct split best = { .axis = -1, .cost = INFINITY };
	for (int k = 0; k < 3; k++)
		split_best_of_axis(bins[k], k, &best);
	if (best.axis >= 0) {
		best.start = lo[best.axis];
		best.scale = scale[best.axis];
	}
	return best;
}

/* Brings the items of the left side to the front and returns their number. */
static uint32_t partition(struct item *items, uint32_t count, const struct split *s)
{
	uint32_t left = 0, right = count;
	for (;;) {
		while (left < right &&
			bin_of(item_centre(&items[left], s->axis), s->start, s->scale) <= s->bin)
			left++;
		while (left < right && bin_of(item_centre(&items[right - 1], s->axis), s->start,
					       s->scale) > s->bin)
			right--;
		if (left >= right)
			return left;
		const struct item other = items[left];
		items[left] = items[right - 1];
		items[right - 1] = other;
	}
}

/* How many items go to the left. Items with one centre in common are halved as they stand. */
static uint32_t divide(struct item *items, uint32_t count, uint32_t depth)
{
	if (count == 2)
		return 1;
	if (depth < DEPTH_SAH) {
		const struct split s = find_split(items, count);
		if (s.axis >= 0)
			return partition(items, count, &s);
	}
	return count / 2;
}

static void push_job(struct builder *b, struct job job)
{
	if (b->job_count == b->job_room) {
		b->job_room = b->job_room ? 2 * b->job_room : 64;
		b->jobs = memory_grow(b->jobs, b->job_room, sizeof *b->jobs);
	}
	b->jobs[b->job_count++] = job;
}

/* Splits ranges of more than `small` items and leaves the others as jobs. */
static void grow(struct builder *b, struct job j, uint32_t small)
{
	struct binary *node = &b->tree[j.at];
	*node = (struct binary){ .first = j.first, .count = j.count };
	if (j.count == 1) {
		const struct item *item = &b->items[j.first];
		node->bounds = item->bounds;
		node->groups = item->groups;
		return;
	}
	const uint32_t left = divide(b->items + j.first, j.count, j.depth);
	node->right = j.at + 2 * left;
	const struct job children[2] = {
		{ j.at + 1, j.first, left, j.depth + 1 },
		{ node->right, j.first + left, j.count - left, j.depth + 1 },
	};
	for (int i = 0; i < 2; i++) {
		if (children[i].count > small || small == 0)
			grow(b, children[i], small);
		else
			push_job(b, children[i]);
	}
}

static void run_job(void *user, size_t index, unsigned thread)
{
	(void)thread;
	struct builder *b = user;
	grow(b, b->jobs[index], 0);
}

static void build_binary(struct builder *b, uint32_t count, unsigned threads)
{
	const struct job whole = { 0, 0, count, 0 };
	const uint32_t small = count / 64 > JOB_ITEMS ? count / 64 : JOB_ITEMS;
	if (count <= small || threads <= 1) {
		grow(b, whole, 0);
		return;
	}
	grow(b, whole, small);
	parallel_for(b->job_count, threads, run_job, b);
}

/* ---- step 2: the cheapest cuts ---- */

/*
 * Entry i - 1 is the least cost of a subtree cut into at most i roots. `cut` of the node tells
 * how: [0] whether one root is a leaf; [i - 1] the roots given to the left child, or 0 when one
 * root less is as good.
 */
struct cost {
	float of[BVH_WIDTH];
};

static bool can_be_leaf(const struct binary *n)
{
	return n->count == 1 || (n->groups && n->count <= GROUP_MAX);
}

static struct cost find_cuts(struct builder *b, uint32_t at)
{
	struct binary *n = &b->tree[at];
	const float area = bounds_area(&n->bounds);
	struct cost cost;
	if (!n->right) {
		n->cut[0] = 1;
		for (int i = 0; i < BVH_WIDTH; i++)
			cost.of[i] = area * GROUP_COST;
		return cost;
	}
	const struct cost left = find_cuts(b, at + 1), right = find_cuts(b, n->right);
	const struct binary *l = &b->tree[at + 1], *r = &b->tree[n->right];
	n->bounds = l->bounds;
	bounds_add(&n->bounds, &r->bounds);
	n->groups = l->groups && r->groups;
	const float own = bounds_area(&n->bounds);

	for (int i = 1; i < BVH_WIDTH; i++) {
		cost.of[i] = INFINITY;
		for (int k = 0; k < i; k++) {
			const float c = left.of[k] + right.of[i - 1 - k];
			if (c < cost.of[i]) {
				cost.of[i] = c;
				n->cut[i] = (uint8_t)(k + 1);
			}
		}
	}
	cost.of[0] = own + cost.of[BVH_WIDTH - 1];
	if (can_be_leaf(n) && own * GROUP_COST < cost.of[0]) {
		cost.of[0] = own * GROUP_COST;
		n->cut[0] = 1;
	}
	for (int i = 1; i < BVH_WIDTH; i++) {
		if (cost.of[i - 1] <= cost.of[i]) {
			cost.of[i] = cost.of[i - 1];
			n->cut[i] = 0;
		}
	}
	return cost;
}

/* ---- step 3: wide nodes ---- */

/* The roots when the subtree is cut into at most `room`; returns their number. */
static size_t collect(const struct builder *b, uint32_t at, int room, uint32_t *out)
{
	const struct binary *n = &b->tree[at];
	while (room > 1 && (!n->right || n->cut[room - 1] == 0))
		room--;
	if (room == 1) {
		out[0] = at;
		return 1;
	}
	const int left = n->cut[room - 1];
	const size_t count = collect(b, at + 1, left, out);
	return count + collect(b, n->right, room - left, out + count);
}

/* The children of a wide node: at least two where the binary node has two. */
static size_t collect_children(const struct builder *b, uint32_t at, uint32_t out[BVH_WIDTH])
{
	const struct binary *n = &b->tree[at];
	int room = BVH_WIDTH;
	while (room > 2 && n->cut[room - 1] == 0)
		room--;
	const int left = n->cut[room - 1] ? n->cut[room - 1] : 1;
	const size_t count = collect(b, at + 1, left, out);
	return count + collect(b, n->right, room - left, out + count);
}

static size_t count_nodes(const struct builder *b, uint32_t at)
{
	size_t nodes = 1;
	if (b->tree[at].cut[0])
		return nodes;
	uint32_t children[BVH_WIDTH];
	const size_t count = collect_children(b, at, children);
	for (size_t i = 0; i < count; i++)
		if (!b->tree[children[i]].cut[0])
			nodes += count_nodes(b, children[i]);
	return nodes;
}

/* Makes the slots from `start` on exist; those skipped stay empty. */
static uint32_t *add_slots(struct builder *b, size_t start, size_t count)
{
	struct bvh *v = &b->bvh;
	if (start + count > b->slot_room) {
		b->slot_room = 2 * (start + count);
		v->slots = memory_grow(v->slots, b->slot_room, sizeof *v->slots);
	}
	for (size_t i = v->slot_count; i < start + count; i++)
		v->slots[i] = BVH_NOTHING;
	v->slot_count = start + count;
	return v->slots + start;
}

static uint32_t emit_leaf(struct builder *b, const struct binary *n)
{
	const size_t end = b->bvh.slot_count;
	if (!n->groups) {
		*add_slots(b, end, 1) = b->items[n->first].index;
		return b->latest_leaf = BVH_LEAF | (uint32_t)end;
	}
	const size_t start = (end + GROUP_MAX - 1) / GROUP_MAX * GROUP_MAX;
	uint32_t *slots = add_slots(b, start, GROUP_MAX);
	for (uint32_t i = 0; i < n->count; i++)
		slots[i] = b->items[n->first + i].index;
	return b->latest_leaf = BVH_LEAF | BVH_GROUP | (uint32_t)start;
}

static void set_child(struct bvh_node *node, size_t lane, const struct bounds *b, uint32_t child)
{
	for (int k = 0; k < 3; k++) {
		node->bound[k][lane] = b->lo[k];
		node->bound[3 + k][lane] = b->hi[k];
	}
	node->child[lane] = child;
}

static uint32_t emit(struct builder *b, uint32_t at, size_t depth)
{
	struct bvh *v = &b->bvh;
	const size_t index = v->node_count++;
	v->depth = depth > v->depth ? depth : v->depth;
	uint32_t children[BVH_WIDTH] = { at };
	/* only the root of the whole tree can be a leaf here */
	const size_t count = b->tree[at].cut[0] ? 1 : collect_children(b, at, children);
	for (size_t lane = 0; lane < count; lane++) {
		const struct binary *n = &b->tree[children[lane]];
		const uint32_t child =
			n->cut[0] ? emit_leaf(b, n) : emit(b, children[lane], depth + 1);
		set_child(&v->nodes[index], lane, &n->bounds, child);
	}
	for (size_t lane = count; lane < BVH_WIDTH; lane++)
		set_child(&v->nodes[index], lane, &bounds_nothing, b->latest_leaf);
	return (uint32_t)index;
}

struct bvh bvh_build(
	struct arena *arena, const box *boxes, const bool *groups, size_t count, unsigned threads)
{
	struct builder b = { .items = memory_alloc(count, sizeof *b.items),
		.tree = memory_alloc(2 * count, sizeof *b.tree) };
	for (size_t i = 0; i < count; i++)
		b.items[i] = (struct item){ bounds_outwards(boxes[i]), (uint32_t)i,
			groups && groups[i] };
	build_binary(&b, (uint32_t)count, threads);
	find_cuts(&b, 0);

	struct bvh *v = &b.bvh;
	v->nodes = ARENA_ARRAY(arena, count_nodes(&b, 0), struct bvh_node);
	emit(&b, 0, 1);
	uint32_t *slots = v->slots;
	v->slots = arena_copy(arena, slots, v->slot_count * sizeof *slots);
	free(slots);
	free(b.items);
	free(b.tree);
	free(b.jobs);
	return b.bvh;
}
