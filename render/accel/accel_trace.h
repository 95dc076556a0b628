/* SPDX-License-Identifier: MIT */
/*
 * What accel.c builds and accel_trace.inc walks, which is compiled once per
 * instruction set; each copy offers the same three functions.
 */
#ifndef LAMBERT_ACCEL_ACCEL_TRACE_H
#define LAMBERT_ACCEL_ACCEL_TRACE_H

#include "accel/accel.h"
#include "bvh.h"

/* Spheres around the items of a leaf group. A ray that passes one by cannot hit its item; radii
 * are enlarged by what rounding can do, and are NaN in empty lanes. */
struct sphere_group {
	_Alignas(64) float x[BVH_WIDTH], y[BVH_WIDTH], z[BVH_WIDTH], radius[BVH_WIDTH];
};

/* Rounding in the test of a group, relative to the coordinates of centre and origin. The sum of all
 * errors of the test is below 20 half units in the last place. */
#define GROUP_SLACK 2e-6

struct accel_kernel {
	bool (*nearest)(const struct accel *, const ray *, double tmin, double tmax, uint32_t kinds,
		struct hit *found);
	const struct object *(*any)(const struct accel *, const ray *, double tmin, double tmax,
		uint32_t kinds, const struct object *guess);
	/* Objects whose box may hold p; the count, of which at most `room` are stored. */
	size_t (*around)(const struct accel *, vec3 p, const struct object **found, size_t room);
};

struct accel {
	struct arena *arena;
	const struct accel_kernel *kernel;
	uint32_t kinds; /* that anything is visible to */
	bool has_tree;
	struct bvh tree;
	const struct object **slots;	   /* NULL where a slot is empty */
	const struct sphere_group *groups; /* of slots 8 i to 8 i + 7 */
	const struct object **unbounded;   /* by rank */
	size_t unbounded_count;
	const struct object **outside; /* bounded, but points outside their bounds can be inside */
	const box *outside_reach; /* what their insides are within */
	size_t outside_count;
	size_t object_count;
};

extern const struct accel_kernel accel_kernel_plain, accel_kernel_baseline, accel_kernel_avx2,
	accel_kernel_avx512;

#endif
