/* SPDX-License-Identifier: MIT */
/*
 * Building the hierarchy, in three steps.
 *
 * 1. A binary tree from the top down, split where the surface area heuristic
 *    is least among 16 bins per axis (Wald 2007, "On fast construction of
 *    SAH-based bounding volume hierarchies"). A subtree of n items owns n - 1
 *    inner nodes at a place known beforehand, so subtrees are built in parallel
 *    and land in the same places in any order. An inner node is eight bytes: the
 *    rest follows from where it is, and boxes are made where they are needed.
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

/* An inner node: how many items its left child has, and how to cut it, see struct cost. */
struct inner {
	uint32_t left;
	uint8_t cut[BVH_WIDTH / 2]; /* four bits each */
};

/* A subtree: its items, and where its inner nodes begin if it has more than one item. */
struct range {
	uint32_t at, first, count;
};

struct builder {
	struct bvh_item *items;
	struct inner *tree;
	struct job *jobs;
	size_t job_count, job_room;
	struct bvh bvh;
	size_t slot_room;
	uint32_t latest_leaf; /* as a child */
};

struct job {
	struct range range;
	uint32_t depth;
};

/* The parent's own node comes before those of the left child, then those of the right one. */
static struct range left_of(struct range r, uint32_t left)
{
	return (struct range){ r.at + 1, r.first, left };
}

static struct range right_of(struct range r, uint32_t left)
{
	return (struct range){ r.at + left, r.first + left, r.count - left };
}

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

struct bvh_item bvh_item(box b, uint32_t index, bool groups)
{
	return (struct bvh_item){
		.lo = { round_down(b.lo.x), round_down(b.lo.y), round_down(b.lo.z) },
		.hi = { round_up(b.hi.x), round_up(b.hi.y), round_up(b.hi.z) },
		.index = index & 0x7fffffffu,
		.groups = groups,
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

static inline void bounds_add_item(struct bounds *to, const struct bvh_item *item)
{
	for (int k = 0; k < 3; k++) {
		to->lo[k] = to->lo[k] < item->lo[k] ? to->lo[k] : item->lo[k];
		to->hi[k] = to->hi[k] > item->hi[k] ? to->hi[k] : item->hi[k];
	}
}

static struct bounds bounds_of(const struct bvh_item *items, uint32_t count)
{
	struct bounds b = bounds_nothing;
	for (uint32_t i = 0; i < count; i++)
		bounds_add_item(&b, &items[i]);
	return b;
}

/* Half the surface. */
static float bounds_area(const struct bounds *b)
{
	const float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
	return x * y + y * z + z * x;
}

/* Twice the centre of an item. */
static inline float item_centre(const struct bvh_item *item, int axis)
{
	return item->lo[axis] + item->hi[axis];
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

static struct split find_split(const struct bvh_item *items, uint32_t count)
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
			bounds_add_item(&bin->bounds, &items[i]);
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
static uint32_t partition(struct bvh_item *items, uint32_t count, const struct split *s)
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
		const struct bvh_item other = items[left];
		items[left] = items[right - 1];
		items[right - 1] = other;
	}
}

/* How many items go to the left. Items with one centre in common are halved as they stand. */
static uint32_t divide(struct bvh_item *items, uint32_t count, uint32_t depth)
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
	const struct range r = j.range;
	if (r.count == 1)
		return;
	const uint32_t left = divide(b->items + r.first, r.count, j.depth);
	b->tree[r.at] = (struct inner){ .left = left };
	const struct job children[2] = {
		{ left_of(r, left), j.depth + 1 },
		{ right_of(r, left), j.depth + 1 },
	};
	for (int i = 0; i < 2; i++) {
		if (children[i].range.count > small || small == 0)
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
	const struct job whole = { { 0, 0, count }, 0 };
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
 * Entry i - 1 is the least cost of a subtree cut into at most i roots. The cuts of the node tell
 * how: 0 whether one root is a leaf; i - 1 the roots given to the left child, or 0 when one root
 * less is as good.
 */
struct cost {
	float of[BVH_WIDTH];
	struct bounds bounds; /* of the subtree */
	bool groups;	      /* all items may share a leaf */
};

static unsigned cut_of(const struct inner *n, int i)
{
	const unsigned pair = n->cut[i / 2];
	return i % 2 ? pair >> 4 : pair & 15u;
}

static void set_cut(struct inner *n, int i, unsigned cut)
{
	const unsigned pair = n->cut[i / 2];
	n->cut[i / 2] = (uint8_t)(i % 2 ? (pair & 15u) | cut << 4 : (pair & ~15u) | cut);
}

static bool is_leaf(const struct builder *b, struct range r)
{
	return r.count == 1 || cut_of(&b->tree[r.at], 0);
}

static struct cost cost_of_item(const struct bvh_item *item)
{
	struct cost cost = { .bounds = bounds_of(item, 1), .groups = item->groups };
	const float area = bounds_area(&cost.bounds);
	for (int i = 0; i < BVH_WIDTH; i++)
		cost.of[i] = area * GROUP_COST;
	return cost;
}

static struct cost find_cuts(struct builder *b, struct range r)
{
	if (r.count == 1)
		return cost_of_item(&b->items[r.first]);
	struct inner *n = &b->tree[r.at];
	const struct cost left = find_cuts(b, left_of(r, n->left));
	const struct cost right = find_cuts(b, right_of(r, n->left));
	struct cost cost = { .bounds = left.bounds, .groups = left.groups && right.groups };
	bounds_add(&cost.bounds, &right.bounds);
	const float own = bounds_area(&cost.bounds);

	for (int i = 1; i < BVH_WIDTH; i++) {
		cost.of[i] = INFINITY;
		for (int k = 0; k < i; k++) {
			const float c = left.of[k] + right.of[i - 1 - k];
			if (c < cost.of[i]) {
				cost.of[i] = c;
				set_cut(n, i, (unsigned)k + 1);
			}
		}
	}
	cost.of[0] = own + cost.of[BVH_WIDTH - 1];
	if (cost.groups && r.count <= GROUP_MAX && own * GROUP_COST < cost.of[0]) {
		cost.of[0] = own * GROUP_COST;
		set_cut(n, 0, 1);
	}
	for (int i = 1; i < BVH_WIDTH; i++) {
		if (cost.of[i - 1] <= cost.of[i]) {
			cost.of[i] = cost.of[i - 1];
			set_cut(n, i, 0);
		}
	}
	return cost;
}

/* ---- step 3: wide nodes ---- */

/* The roots when the subtree is cut into at most `room`; returns their number. */
static size_t collect(const struct builder *b, struct range r, int room, struct range *out)
{
	const struct inner *n = &b->tree[r.at];
	while (room > 1 && (r.count == 1 || cut_of(n, room - 1) == 0))
		room--;
	if (room == 1) {
		out[0] = r;
		return 1;
	}
	const int left = (int)cut_of(n, room - 1);
	const size_t count = collect(b, left_of(r, n->left), left, out);
	return count + collect(b, right_of(r, n->left), room - left, out + count);
}

/* The children of a wide node: at least two, as the binary node has. */
static size_t collect_children(const struct builder *b, struct range r, struct range out[BVH_WIDTH])
{
	const struct inner *n = &b->tree[r.at];
	int room = BVH_WIDTH;
	while (room > 2 && cut_of(n, room - 1) == 0)
		room--;
	const unsigned cut = cut_of(n, room - 1);
	const int left = cut ? (int)cut : 1;
	const size_t count = collect(b, left_of(r, n->left), left, out);
	return count + collect(b, right_of(r, n->left), room - left, out + count);
}

static size_t count_nodes(const struct builder *b, struct range r)
{
	size_t nodes = 1;
	if (is_leaf(b, r))
		return nodes;
	struct range children[BVH_WIDTH];
	const size_t count = collect_children(b, r, children);
	for (size_t i = 0; i < count; i++)
		if (!is_leaf(b, children[i]))
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

static uint32_t emit_leaf(struct builder *b, struct range r)
{
	const size_t end = b->bvh.slot_count;
	const struct bvh_item *items = b->items + r.first;
	if (!items->groups) {
		*add_slots(b, end, 1) = items->index;
		return b->latest_leaf = BVH_LEAF | (uint32_t)end;
	}
	const size_t start = (end + GROUP_MAX - 1) / GROUP_MAX * GROUP_MAX;
	uint32_t *slots = add_slots(b, start, GROUP_MAX);
	for (uint32_t i = 0; i < r.count; i++)
		slots[i] = items[i].index;
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

/* A subtree as a child of a wide node, and its box. */
struct child {
	struct bounds bounds;
	uint32_t number;
};

static struct child emit(struct builder *b, struct range r, size_t depth);

static struct child emit_child(struct builder *b, struct range r, size_t depth)
{
	if (!is_leaf(b, r))
		return emit(b, r, depth);
	return (struct child){ bounds_of(b->items + r.first, r.count), emit_leaf(b, r) };
}

static struct child emit(struct builder *b, struct range r, size_t depth)
{
	struct bvh *v = &b->bvh;
	struct child self = { bounds_nothing, (uint32_t)v->node_count++ };
	struct bvh_node *node = &v->nodes[self.number];
	v->depth = depth > v->depth ? depth : v->depth;
	struct range children[BVH_WIDTH] = { r };
	/* only the root of the whole tree can be a leaf here */
	const size_t count = is_leaf(b, r) ? 1 : collect_children(b, r, children);
	for (size_t lane = 0; lane < count; lane++) {
		const struct child child = emit_child(b, children[lane], depth + 1);
		set_child(node, lane, &child.bounds, child.number);
		bounds_add(&self.bounds, &child.bounds);
	}
	for (size_t lane = count; lane < BVH_WIDTH; lane++)
		set_child(node, lane, &bounds_nothing, b->latest_leaf);
	return self;
}

struct bvh bvh_build(struct arena *arena, struct bvh_item *items, size_t count, unsigned threads)
{
	struct builder b = { .items = items, .tree = memory_alloc(count, sizeof *b.tree) };
	const struct range whole = { 0, 0, (uint32_t)count };
	build_binary(&b, (uint32_t)count, threads);
	find_cuts(&b, whole);
	b.bvh.nodes = ARENA_ARRAY(arena, count_nodes(&b, whole), struct bvh_node);
	emit(&b, whole, 1);
	free(b.tree);
	free(b.jobs);
	return b.bvh;
}
