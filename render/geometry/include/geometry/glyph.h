/* SPDX-License-Identifier: MIT */
/*
 * One letter of a text: the region inside closed outlines of lines and quadratic
 * curves, from z = 0 to z = thickness. Made by lowering from a font.
 */
#ifndef LAMBERT_GEOMETRY_GLYPH_H
#define LAMBERT_GEOMETRY_GLYPH_H

#include "geometry/shape.h"

/* From (x[0], y[0]) to (x[2], y[2]); of a curve, point 1 is the control point. */
struct glyph_segment {
	double x[3], y[3];
	bool is_curve;
};

struct glyph {
	const struct glyph_segment *segments;
	size_t count;
	double thickness;
	double overhang; /* how far the letter reaches to the left of where it stands; for the extent */
	box outline;	 /* x and y of all points; z between 0 and thickness */
};

extern const struct shape_class shape_glyph;

/* Sets `outline` from the rest. */
void glyph_finish(struct glyph *);

#endif
