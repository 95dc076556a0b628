/* SPDX-License-Identifier: MIT */
/*
 * From a sample position on the picture to its colour. One worker per thread.
 */
#ifndef LAMBERT_INTEGRATE_TRACE_H
#define LAMBERT_INTEGRATE_TRACE_H

#include "worker/worker.h"

struct worker *worker_create(const struct scene *, unsigned width, unsigned height);
void worker_destroy(struct worker *);

/* The colour at (x, y) in pixel units: integers are pixel centres, x from the left, y from the top.
 * r, g, b in the working space, unclamped; transmit is 1 - alpha; filter is 0. The place names its
 * random numbers. */
colour trace_sample(struct worker *, double x, double y, struct sample_place);

#endif
