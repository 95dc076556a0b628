/* SPDX-License-Identifier: MIT */
/* What cones share. */
#ifndef LAMBERT_LIGHT_CONE_H
#define LAMBERT_LIGHT_CONE_H

/* 0 below lo, 1 from hi on, smooth in between. */
static inline double smooth_step(double lo, double hi, double x)
{
	if (x < lo)
		return 0;
	if (x >= hi)
		return 1;
	const double z = (x - lo) / (hi - lo);
	return (3 - 2 * z) * z * z;
}

#endif
