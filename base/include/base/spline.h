/* SPDX-License-Identifier: MIT */
/*
 * Curves through points of 1 to 5 components.
 */
#ifndef LAMBERT_BASE_SPLINE_H
#define LAMBERT_BASE_SPLINE_H

#include "base/arena.h"

enum spline_type { SPLINE_LINEAR, SPLINE_QUADRATIC, SPLINE_CUBIC, SPLINE_NATURAL };

struct spline {
	enum spline_type type;
	unsigned terms;
	size_t count;
	const double *keys; /* sorted */
	const double (*values)[5];
	const double (
		*curvature)[5];	  /* second derivatives at the keys, needed while it is natural */
	struct spline_room *room; /* of the parser: where the entries are */
};

/* All components at `at`; those beyond `terms` are 0. A natural spline needs its curvature. */
void spline_value(const struct spline *, double at, double result[5]);
/* The second derivatives of a natural spline with these entries. */
const double (*spline_curvature(struct arena *, const struct spline *))[5];
/* A copy that needs nothing of the original, with its curvature if it is natural. */
struct spline *spline_copy(struct arena *, const struct spline *);

#endif
