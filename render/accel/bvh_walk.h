/* SPDX-License-Identifier: MIT */
/*
 * Walking the hierarchy with a ray: eight boxes at a time, in single
 * precision, made so that no box the exact ray meets is ever missed (after
 * Ize 2013, "Robust BVH ray traversal", with the slack put where it is free):
 *
 * - the origin is replaced by one rounded up against low bounds and by one
 *   rounded down against high bounds, which can only widen a box;
 * - the reciprocal direction against far bounds is a little too long, which
 *   outweighs the rounding of the two operations that follow.
 *
 * For files compiled once per instruction set. The leaf function is a
 * constant at every call, so that the compiler merges it into the loop.
 */
#ifndef LAMBERT_ACCEL_BVH_WALK_H
#define LAMBERT_ACCEL_BVH_WALK_H

#include "base/simd.h"
#include "bvh.h"

#include <string.h>

/* Rounding of a subtraction, a multiplication and the reciprocal, on both sides, is below 8 ulp. */
#define SLAB_SLACK 1e-6
/* Smaller components of a direction move a ray by less than 1e-19 within any scene. */
#define DIRECTION_TINY 1e-30

struct bvh_ray {
	int near_row[3], far_row[3]; /* of bvh_node.bound */
	float near_origin[3], far_origin[3];
	float near_inverse[3], far_inverse[3];
	float tmin, tmax; /* rounded outwards */
};

/* A leaf at `child` (BVH_LEAF set). True ends the walk. May lower the ray's tmax. */
typedef bool bvh_leaf(void *user, uint32_t child, struct bvh_ray *);

/* Not below `t`, whatever its distance was computed with. */
static inline float bvh_limit(double t)
{
	return (float)(t * (1 + 2 * SLAB_SLACK));
}

static inline void bvh_ray_axis(struct bvh_ray *b, int k, double origin, double direction)
{
	const float o = (float)origin;
	const float widen = fabsf(o) * 2.4e-7f + 1e-18f;
	const bool forward = direction >= 0;
	double d = direction;
	if (fabs(d) < DIRECTION_TINY)
		d = forward ? DIRECTION_TINY : -DIRECTION_TINY;
	const double inverse = 1 / d;
	b->near_row[k] = forward ? k : 3 + k;
	b->far_row[k] = forward ? 3 + k : k;
	b->near_origin[k] = forward ? o + widen : o - widen;
	b->far_origin[k] = forward ? o - widen : o + widen;
	b->near_inverse[k] = (float)inverse;
	b->far_inverse[k] = (float)(inverse * (1 + SLAB_SLACK));
}

static inline void bvh_ray_set(struct bvh_ray *b, const ray *r, double tmin, double tmax)
{
	bvh_ray_axis(b, 0, r->origin.x, r->direction.x);
	bvh_ray_axis(b, 1, r->origin.y, r->direction.y);
	bvh_ray_axis(b, 2, r->origin.z, r->direction.z);
	b->tmin = (float)(tmin * (1 - 2 * SLAB_SLACK));
	b->tmax = bvh_limit(tmax);
}

struct bvh_lanes {
	float8 near_origin[3], far_origin[3];
	float8 near_inverse[3], far_inverse[3];
	float8 tmin;
	size_t near_at[3], far_at[3]; /* offsets in a node */
};

__attribute__((always_inline)) static inline struct bvh_lanes bvh_lanes_of(const struct bvh_ray *b)
{
	struct bvh_lanes l;
	for (int k = 0; k < 3; k++) {
		l.near_origin[k] = float8_all(b->near_origin[k]);
		l.far_origin[k] = float8_all(b->far_origin[k]);
		l.near_inverse[k] = float8_all(b->near_inverse[k]);
		l.far_inverse[k] = float8_all(b->far_inverse[k]);
		l.near_at[k] = (size_t)b->near_row[k] * BVH_WIDTH;
		l.far_at[k] = (size_t)b->far_row[k] * BVH_WIDTH;
	}
	l.tmin = float8_all(b->tmin);
	return l;
}

/* The children met, as bits; `entry` receives where. */
__attribute__((always_inline)) static inline unsigned bvh_test(
	const struct bvh_node *node, const struct bvh_lanes *l, float tmax, float8 *entry)
{
	const float *bound = node->bound[0];
	float8 in = l->tmin, out = float8_all(tmax);
	for (int k = 0; k < 3; k++) {
		const float8 near = float8_load(bound + l->near_at[k]);
		const float8 far = float8_load(bound + l->far_at[k]);
		in = float8_max(
			float8_mul(float8_sub(near, l->near_origin[k]), l->near_inverse[k]), in);
		out = float8_min(
			float8_mul(float8_sub(far, l->far_origin[k]), l->far_inverse[k]), out);
	}
	*entry = in;
	return float8_le(in, out);
}

/* What is still to be visited: where the ray enters it, as the bits of a float >= 0, and the child.
 * Greater numbers are farther. */
static inline uint64_t bvh_visit(float entry, uint32_t child)
{
	uint32_t bits;
	memcpy(&bits, &entry, sizeof bits);
	return (uint64_t)bits << 32 | child;
}

/* Puts the children of `mask` on the stack, the nearest on top. */
__attribute__((always_inline)) static inline uint64_t *bvh_push(
	uint64_t *top, const struct bvh_node *node, unsigned mask, const float *entry)
{
	uint64_t *const base = top;
	const int first = __builtin_ctz(mask);
	mask &= mask - 1;
	const int second = __builtin_ctz(mask);
	mask &= mask - 1;
	const uint64_t a = bvh_visit(entry[first], node->child[first]);
	const uint64_t c = bvh_visit(entry[second], node->child[second]);
	top[0] = a > c ? a : c;
	top[1] = a > c ? c : a;
	top += 2;
	while (mask) {
		const int lane = __builtin_ctz(mask);
		const uint64_t visit = bvh_visit(entry[lane], node->child[lane]);
		uint64_t *at = top++;
		for (; at > base && at[-1] < visit; at--)
			at[0] = at[-1];
		*at = visit;
		mask &= mask - 1;
	}
	return top;
}

/* Gives `leaf` every leaf whose box the ray meets between tmin and tmax, nearer boxes first. True
 * when it has ended the walk. */
__attribute__((always_inline)) static inline bool bvh_walk(
	const struct bvh_node *nodes, struct bvh_ray *b, bvh_leaf *leaf, void *user)
{
	const struct bvh_lanes lanes = bvh_lanes_of(b);
	uint64_t stack[BVH_STACK], *top = stack;
	_Alignas(32) float entry[BVH_WIDTH];
	uint32_t child = 0;
	for (;;) {
		if (!(child & BVH_LEAF)) {
			const struct bvh_node *node = &nodes[child];
			float8 in;
			const unsigned mask = bvh_test(node, &lanes, b->tmax, &in);
			if (mask && (mask & (mask - 1)) == 0) {
				child = node->child[__builtin_ctz(mask)];
				continue;
			}
			if (mask) {
				float8_store(entry, in);
				top = bvh_push(top, node, mask, entry);
				child = (uint32_t) * --top;
				continue;
			}
		} else if (leaf(user, child, b)) {
			return true;
		}
		const uint64_t end = bvh_visit(b->tmax, UINT32_MAX);
		do {
			if (top == stack)
				return false;
			top--;
		} while (*top > end);
		child = (uint32_t)*top;
	}
}

#endif
