/* SPDX-License-Identifier: MIT */
/*
 * From a sample position on the picture to its colour. One worker per thread.
 */
#ifndef LAMBERT_SHADING_TRACE_H
#define LAMBERT_SHADING_TRACE_H

#include "sample/sample.h"
#include "scene/scene.h"

/* Counters, one set per worker, added up by index at the end. */
struct trace_stats {
	uint64_t camera_rays, reflected_rays, refracted_rays, transmitted_rays, shadow_rays;
	uint64_t max_level;
};

struct worker;
struct worker *worker_create(const struct scene *, unsigned width, unsigned height);
void worker_destroy(struct worker *);
const struct trace_stats *worker_stats(const struct worker *);

/* The colour at (x, y) in pixel units: integers are pixel centres, x from the left, y from the top.
 * r, g, b in the working space, unclamped; transmit is 1 - alpha; filter is 0. The place names its
 * random numbers. */
colour trace_sample(struct worker *, double x, double y, struct sample_place);

#endif
