/* SPDX-License-Identifier: MIT */
/*
 * Real roots of polynomials in a bounded interval.
 *
 * Coefficients stand lowest power first. Between two neighbouring roots of its
 * derivative a polynomial is monotonic, so the signs at these points decide
 * where its roots are; a bracketed Newton iteration then finds each to the last
 * place that the evaluation supports. No tolerance enters: the answer does not
 * depend on the scale of x or of the coefficients.
 */
#ifndef LAMBERT_GEOMETRY_SHAPE_POLYNOMIAL_H
#define LAMBERT_GEOMETRY_SHAPE_POLYNOMIAL_H

#include <stdbool.h>

#define POLYNOMIAL_MAX_DEGREE 40

double polynomial_value(const double *c, unsigned degree, double x);

/* The points of [lo, hi] where the sign changes, ascending, at most `degree`; zero counts as
 * positive. A root of even multiplicity is not among them, or twice when rounding splits it. */
unsigned polynomial_crossings(
	const double *c, unsigned degree, double lo, double hi, double *roots);
/* The first of them. */
bool polynomial_first_crossing(
	const double *c, unsigned degree, double lo, double hi, double *root);

#endif
