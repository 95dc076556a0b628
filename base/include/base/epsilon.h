/* SPDX-License-Identifier: MIT */
#ifndef LAMBERT_BASE_EPSILON_H
#define LAMBERT_BASE_EPSILON_H

/* Numbers of a scene that differ by less are equal: the one tolerance of comparisons in the language, and
 * of the patterns at the edges of their cells. */
#define EPSILON 1e-10

#endif
