/* SPDX-License-Identifier: MIT */
/*
 * pavement { number_of_sides number_of_tiles pattern exterior interior form }
 *
 * The xz plane paved with pieces of 1 to 6 equal triangles, squares or hexagons.
 * The value rises towards the edges of a piece; the last three words choose how
 * it goes around corners. A piece is found through its lattice: the rows of the
 * table below hold two steps of it and the cells of the pieces of one period.
 */
#include "texture/patterns.h"
#include "noise/noise.h"

#define HALF_ROOT_3 0.86602540378443864676
#define ROOT_3	    1.7320508075688772935

enum { CELLS = 12 };

struct pavement_row {
	int8_t sides, tiles, pattern;
	int8_t u[2], w[2]; /* the lattice */
	int8_t pieces;
	int8_t cells[CELLS][2]; /* `tiles` of each piece */
};

/* clang-format off */
static const struct pavement_row rows[] = {
	{ 3, 1, 1, { -1, 1 }, { 1, 1 }, 2, { { 0, 0 }, { 1, 0 } } },
	{ 3, 2, 1, { -1, 1 }, { 1, 1 }, 1, { { -1, 0 }, { 0, 0 } } },
	{ 3, 3, 1, { 0, 2 }, { -3, 1 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 3, 4, 1, { -1, 1 }, { 3, 1 }, 1, { { -3, 0 }, { -2, 0 }, { -1, 0 }, { 0, 0 } } },
	{ 3, 4, 2, { -1, 1 }, { 3, 1 }, 1, { { 0, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 } } },
	{ 3, 4, 3, { -2, 2 }, { 2, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { -1, 0 }, { -2, 1 }, { -1, 1 }, { 0, 1 } } },
	{ 3, 5, 1, { 0, 2 }, { -5, 1 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 } } },
	{ 3, 5, 2, { 0, 2 }, { -5, 1 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { -1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 3, 5, 3, { 0, 2 }, { -5, 1 }, 2, { { -1, 0 }, { 0, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 2, 1 }, { 3, 1 } } },
	{ 3, 5, 4, { -3, 1 }, { 1, 3 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 1, 1 }, { 2, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 } } },
	{ 3, 6, 1, { 1, 1 }, { -5, 1 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0 } } },
	{ 3, 6, 2, { 1, 1 }, { -5, 1 }, 1, { { 0, -1 }, { 1, -1 }, { 2, -1 }, { 3, -1 }, { 4, -1 }, { 0, 0 } } },
	{ 3, 6, 3, { 0, 2 }, { -3, 1 }, 1, { { -2, -1 }, { -1, -1 }, { 0, -1 }, { 1, -1 }, { 2, -1 }, { 0, 0 } } },
	{ 3, 6, 4, { -2, 2 }, { 4, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 3, 1 }, { -1, 0 }, { -2, 1 }, { -1, 1 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 3, 6, 5, { -2, 2 }, { 4, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 1, 1 }, { 2, 1 }, { -2, 0 }, { -1, 0 }, { -3, 1 }, { -2, 1 }, { -1, 1 }, { 0, 1 } } },
	{ 3, 6, 6, { 0, 2 }, { 6, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { -4, 0 }, { -3, 0 }, { -2, 0 }, { -1, 0 }, { -1, 1 }, { 0, 1 } } },
	{ 3, 6, 7, { 4, 0 }, { 1, 3 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 2, 1 }, { 3, 1 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 } } },
	{ 3, 6, 8, { 4, 0 }, { 1, 3 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 } } },
	{ 3, 6, 9, { -2, 2 }, { 4, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { -3, 0 }, { -2, 0 }, { -1, 0 }, { -2, 1 }, { -1, 1 }, { 0, 1 } } },
	{ 3, 6, 10, { 1, 1 }, { -5, 1 }, 1, { { 2, -1 }, { 3, -1 }, { 4, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 } } },
	{ 3, 6, 11, { 0, 2 }, { -3, 1 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 3, 6, 12, { 0, 2 }, { -3, 1 }, 1, { { 0, -1 }, { 1, -1 }, { 2, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 } } },
	{ 4, 1, 1, { 0, 1 }, { 1, 0 }, 1, { { 0, 0 } } },
	{ 4, 2, 1, { 1, 0 }, { 0, 2 }, 1, { { 0, 0 }, { 0, 1 } } },
	{ 4, 3, 1, { 0, 1 }, { 3, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 } } },
	{ 4, 3, 2, { 0, 2 }, { 3, 0 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 }, { 2, 0 }, { 2, 1 } } },
	{ 4, 4, 1, { 0, 1 }, { 4, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 } } },
	{ 4, 4, 2, { 0, 2 }, { 4, 0 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 } } },
	{ 4, 4, 3, { 0, 2 }, { -2, 1 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } } },
	{ 4, 4, 4, { 0, 2 }, { 2, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } } },
	{ 4, 4, 5, { 2, 0 }, { -1, 2 }, 1, { { -1, 0 }, { 0, 0 }, { -2, 1 }, { -1, 1 } } },
	{ 4, 5, 1, { 0, 1 }, { 5, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 } } },
	{ 4, 5, 2, { 0, 2 }, { 5, 0 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 4, 1 } } },
	{ 4, 5, 3, { 2, 2 }, { -3, 2 }, 2, { { -2, 0 }, { -1, 0 }, { 0, 0 }, { -2, 1 }, { -1, 1 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 4, 5, 4, { -2, 1 }, { 1, 2 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 2, 1 } } },
	{ 4, 5, 5, { -2, 1 }, { 1, 2 }, 1, { { 1, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } } },
	{ 4, 5, 6, { -1, 1 }, { 5, 5 }, 2, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 5, 0 }, { 6, 0 }, { 7, 0 }, { 7, 1 }, { 7, 2 } } },
	{ 4, 5, 7, { -1, 1 }, { 5, 5 }, 2, { { -2, -2 }, { -1, -2 }, { -1, -1 }, { 0, -1 }, { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 3, 2 } } },
	{ 4, 5, 8, { -3, 1 }, { 1, 3 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 2, 1 }, { 1, 1 }, { 3, 1 }, { 1, 2 }, { 2, 2 }, { 3, 2 } } },
	{ 4, 5, 9, { -1, 1 }, { 2, 3 }, 1, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 } } },
	{ 4, 5, 10, { 2, 2 }, { -3, 2 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 1, 2 }, { 2, -1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 } } },
	{ 4, 5, 11, { 1, 2 }, { -4, 2 }, 2, { { -1, 0 }, { 0, 0 }, { -3, 1 }, { -2, 1 }, { -1, 1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 1, 1 } } },
	{ 4, 5, 12, { 2, 1 }, { -2, 4 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { 1, 2 }, { 0, 1 }, { 0, 2 }, { -1, 3 }, { 0, 3 }, { 1, 3 } } },
	{ 4, 6, 1, { 0, 1 }, { 6, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0 } } },
	{ 4, 6, 2, { 0, 2 }, { 6, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 0, 1 }, { 5, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } } },
	{ 4, 6, 3, { 0, 2 }, { 6, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 1, 1 }, { -1, 0 }, { -4, 1 }, { -3, 1 }, { -2, 1 }, { -1, 1 }, { 0, 1 } } },
	{ 4, 6, 4, { 0, 2 }, { 6, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 2, 1 }, { -1, 0 }, { -3, 1 }, { -2, 1 }, { -1, 1 }, { 0, 1 }, { 1, 1 } } },
	{ 4, 6, 5, { 1, 1 }, { -3, 3 }, 1, { { 1, -1 }, { 2, -1 }, { 3, -1 }, { 4, -1 }, { 0, 0 }, { 1, 0 } } },
	{ 4, 6, 6, { 0, 2 }, { 6, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 1, 1 }, { 4, 0 }, { 5, 0 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } } },
	{ 4, 6, 7, { 0, 2 }, { 6, 0 }, 2, { { -3, 0 }, { -2, 0 }, { -1, 0 }, { 0, 0 }, { -2, 1 }, { -1, 1 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 } } },
	{ 4, 6, 8, { 1, 1 }, { -3, 3 }, 1, { { 2, -1 }, { 3, -1 }, { 4, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 } } },
	{ 4, 6, 9, { 0, 2 }, { 3, 0 }, 1, { { -2, 0 }, { -1, 0 }, { 0, 0 }, { -3, 1 }, { -2, 1 }, { -1, 1 } } },
	{ 4, 6, 10, { 0, 2 }, { 3, 0 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 } } },
	{ 4, 6, 11, { 0, 3 }, { 4, 0 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 2, 1 }, { 3, 1 }, { 3, 2 } } },
	{ 4, 6, 12, { -1, 1 }, { 3, 3 }, 1, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 3, 1 }, { 3, 2 } } },
	{ 4, 6, 13, { 0, 3 }, { 4, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 1, 1 }, { 3, 1 }, { 0, 1 }, { 2, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 } } },
	{ 4, 6, 14, { 3, 0 }, { 0, 4 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { 1, 2 }, { 2, 2 }, { -1, 1 }, { 0, 1 }, { 0, 2 }, { -1, 3 }, { 0, 3 }, { 1, 3 } } },
	{ 4, 6, 15, { 1, 2 }, { -2, 2 }, 1, { { 2, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { 2, 1 } } },
	{ 4, 6, 16, { -2, 1 }, { 2, 2 }, 1, { { 0, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 } } },
	{ 4, 6, 17, { -1, 2 }, { 5, 2 }, 2, { { 1, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 1, 1 }, { 4, 0 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 }, { 4, 2 } } },
	{ 4, 6, 18, { -1, 2 }, { 5, 2 }, 2, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 0, 2 }, { 5, -1 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0 }, { 5, 1 } } },
	{ 4, 6, 19, { -1, 1 }, { 3, 3 }, 1, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 2, 3 } } },
	{ 4, 6, 20, { 1, 1 }, { -3, 3 }, 1, { { 3, -2 }, { 0, -1 }, { 1, -1 }, { 2, -1 }, { 3, -1 }, { 0, 0 } } },
	{ 4, 6, 21, { 1, 1 }, { -3, 3 }, 1, { { 0, -2 }, { 1, -2 }, { 2, -2 }, { 3, -2 }, { 0, -1 }, { 0, 0 } } },
	{ 4, 6, 22, { 0, 3 }, { 4, 0 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 3, 1 }, { -2, 1 }, { 1, 1 }, { -2, 2 }, { -1, 2 }, { 0, 2 }, { 1, 2 } } },
	{ 4, 6, 23, { 0, 3 }, { 4, 0 }, 2, { { 0, -1 }, { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 1, 2 }, { 2, -1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { 3, 2 } } },
	{ 4, 6, 24, { 2, 2 }, { -4, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 1, 2 }, { 0, 1 }, { -2, 2 }, { -1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 } } },
	{ 4, 6, 25, { 2, 0 }, { 0, 3 }, 1, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 3, 2 } } },
	{ 4, 6, 26, { 2, 0 }, { 0, 3 }, 1, { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, 2 }, { 2, 2 } } },
	{ 4, 6, 27, { 2, 0 }, { 0, 3 }, 1, { { 0, 0 }, { 1, 0 }, { -1, 1 }, { 0, 1 }, { 0, 2 }, { 1, 2 } } },
	{ 4, 6, 28, { -1, 1 }, { 3, 3 }, 1, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 3, 2 } } },
	{ 4, 6, 29, { 2, 2 }, { -4, 2 }, 2, { { 0, 0 }, { 1, 0 }, { 3, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { -2, 1 }, { -1, 1 }, { 0, 1 }, { -2, 2 }, { 0, 2 }, { 1, 2 } } },
	{ 4, 6, 30, { -3, 2 }, { 3, 2 }, 2, { { -2, -2 }, { -3, -1 }, { -2, -1 }, { -1, -1 }, { -1, 0 }, { 0, 0 }, { 1, -1 }, { 2, -1 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 3, 1 } } },
	{ 4, 6, 31, { -3, 2 }, { 3, 2 }, 2, { { 2, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 4, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 2, 2 } } },
	{ 4, 6, 32, { 2, 1 }, { -2, 2 }, 1, { { 0, 0 }, { -2, 1 }, { -1, 1 }, { 0, 1 }, { 1, 1 }, { -1, 2 } } },
	{ 4, 6, 33, { 3, 0 }, { 0, 4 }, 2, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 2 }, { 2, 2 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } } },
	{ 4, 6, 34, { -2, 2 }, { 3, 3 }, 2, { { 1, -1 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 1 }, { 4, 0 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 3, 2 } } },
	{ 4, 6, 35, { -2, 3 }, { 2, 3 }, 2, { { 0, -1 }, { 0, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 0, 2 }, { 3, -1 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { 3, 2 } } },
	{ 6, 1, 1, { 0, 1 }, { 1, -1 }, 1, { { 0, 0 } } },
	{ 6, 2, 1, { 0, 1 }, { 2, -1 }, 1, { { -1, 1 }, { 0, 0 } } },
	{ 6, 3, 1, { 2, -1 }, { 0, 3 }, 2, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { -1, -2 }, { -1, -1 }, { -1, 0 } } },
	{ 6, 3, 2, { 2, -2 }, { 2, 1 }, 2, { { -1, 0 }, { -1, 1 }, { 0, 0 }, { -1, -1 }, { 0, -2 }, { 0, -1 } } },
	{ 6, 3, 3, { 0, 1 }, { 3, -2 }, 1, { { -2, 1 }, { -1, 0 }, { 0, 0 } } },
	{ 6, 4, 1, { 2, -1 }, { 0, 4 }, 2, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { -1, -3 }, { -1, -2 }, { -1, -1 }, { -1, 0 } } },
	{ 6, 4, 2, { 0, 2 }, { 2, -2 }, 1, { { -1, 1 }, { 0, 0 }, { 0, 1 }, { 1, 0 } } },
	{ 6, 4, 3, { 0, 1 }, { 4, -2 }, 1, { { -3, 1 }, { -2, 1 }, { -1, 0 }, { 0, 0 } } },
	{ 6, 4, 4, { 1, 0 }, { 2, -4 }, 1, { { -1, 1 }, { -1, 2 }, { -1, 3 }, { 0, 0 } } },
	{ 6, 4, 5, { 2, 0 }, { 2, -4 }, 2, { { 0, -1 }, { 0, 0 }, { 1, -2 }, { 1, 0 }, { -1, 1 }, { -1, 3 }, { 0, 1 }, { 0, 2 } } },
	{ 6, 4, 6, { 2, 0 }, { 2, -4 }, 2, { { -1, 0 }, { 0, -2 }, { 0, -1 }, { 0, 0 }, { -1, 1 }, { -1, 2 }, { -1, 3 }, { 0, 1 } } },
	{ 6, 4, 7, { 0, 2 }, { 2, -2 }, 1, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, -1 } } },
	{ 6, 5, 1, { 2, -1 }, { 0, 5 }, 2, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 4 }, { -1, -4 }, { -1, -3 }, { -1, -2 }, { -1, -1 }, { -1, 0 } } },
	{ 6, 5, 2, { 1, 0 }, { 3, -5 }, 1, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, -1 } } },
	{ 6, 5, 3, { 2, -1 }, { 0, 5 }, 2, { { -1, 1 }, { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 }, { -1, -3 }, { -1, -2 }, { -1, -1 }, { -1, 0 }, { 0, -1 } } },
	{ 6, 5, 4, { 2, -1 }, { 0, 5 }, 2, { { -1, 1 }, { 0, -1 }, { 0, 0 }, { 0, 1 }, { 0, 2 }, { -1, -3 }, { -1, -2 }, { -1, -1 }, { -1, 0 }, { 0, -2 } } },
	{ 6, 5, 5, { 1, 0 }, { 3, -5 }, 1, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, -2 }, { 1, -1 } } },
	{ 6, 5, 6, { 2, -1 }, { 0, 5 }, 2, { { -1, 1 }, { -1, 2 }, { -1, 3 }, { 0, 0 }, { 0, 1 }, { -1, -1 }, { -1, 0 }, { 0, -3 }, { 0, -2 }, { 0, -1 } } },
	{ 6, 5, 7, { 2, -1 }, { 0, 5 }, 2, { { -1, -1 }, { -1, 0 }, { 0, -2 }, { 0, -1 }, { 0, 0 }, { -1, 1 }, { -1, 2 }, { -1, 3 }, { 0, 1 }, { 0, 2 } } },
	{ 6, 5, 8, { 3, -1 }, { 2, -4 }, 2, { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, -1 }, { 1, 1 }, { -2, 1 }, { -2, 3 }, { -1, 0 }, { -1, 1 }, { -1, 2 } } },
	{ 6, 5, 9, { 2, -2 }, { 2, 3 }, 2, { { 0, 0 }, { 1, -1 }, { 2, -1 }, { 3, -1 }, { 3, 0 }, { -1, -3 }, { -1, 0 }, { 0, -3 }, { 0, -2 }, { 0, -1 } } },
	{ 6, 5, 10, { 2, 0 }, { 2, -5 }, 2, { { -1, 1 }, { -1, 2 }, { 0, 0 }, { 1, 0 }, { 2, -1 }, { -3, 4 }, { -2, 3 }, { -1, 3 }, { 0, 1 }, { 0, 2 } } },
	{ 6, 5, 11, { 2, -2 }, { 2, 3 }, 2, { { -2, 0 }, { -1, 0 }, { -1, 1 }, { 0, -1 }, { 0, 0 }, { -1, 2 }, { -1, 3 }, { 0, 1 }, { 0, 2 }, { 1, 2 } } },
	{ 6, 5, 12, { 1, 1 }, { 2, -3 }, 1, { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 2, -1 }, { 2, 0 } } },
	{ 6, 5, 13, { 2, 1 }, { 2, -4 }, 2, { { -1, 1 }, { -1, 2 }, { 0, 0 }, { 0, 2 }, { 1, 0 }, { -2, 0 }, { -1, -2 }, { -1, 0 }, { 0, -2 }, { 0, -1 } } },
	{ 6, 5, 14, { 1, -1 }, { 2, 3 }, 1, { { -2, -2 }, { -2, -1 }, { -1, -1 }, { 0, -1 }, { 0, 0 } } },
	{ 6, 5, 15, { 1, -1 }, { 2, 3 }, 1, { { -2, -2 }, { -2, -1 }, { -2, 0 }, { -1, 0 }, { 0, 0 } } },
	{ 6, 5, 16, { 2, -2 }, { 2, 3 }, 2, { { -2, -1 }, { -2, 0 }, { -2, 1 }, { -1, 0 }, { 0, 0 }, { -1, 1 }, { 0, 1 }, { 1, 0 }, { 1, 1 }, { 1, 2 } } },
	{ 6, 5, 17, { 2, -3 }, { 2, 2 }, 2, { { 0, -2 }, { 0, -1 }, { 0, 0 }, { 1, -1 }, { 2, -2 }, { -3, 1 }, { -2, 0 }, { -1, -1 }, { -1, 0 }, { -1, 1 } } },
	{ 6, 5, 18, { 2, -2 }, { 2, 3 }, 2, { { -2, -1 }, { -2, 0 }, { -2, 1 }, { -1, 1 }, { 0, 0 }, { -3, -1 }, { -2, -2 }, { -1, -2 }, { -1, -1 }, { -1, 0 } } },
	{ 6, 5, 19, { 2, 1 }, { 2, -4 }, 2, { { -2, 0 }, { -2, 1 }, { -1, 1 }, { -1, 2 }, { 0, 0 }, { -1, 0 }, { 0, -2 }, { 0, -1 }, { 1, -1 }, { 1, 0 } } },
	{ 6, 5, 20, { 2, -1 }, { 0, 5 }, 2, { { -1, 1 }, { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 2 }, { -2, -2 }, { -2, -1 }, { -1, -1 }, { -1, 0 }, { 0, -1 } } },
	{ 6, 5, 21, { 1, -1 }, { 2, 3 }, 1, { { -2, -2 }, { -2, -1 }, { -1, -1 }, { -1, 0 }, { 0, 0 } } },
	{ 6, 5, 22, { 2, -2 }, { 2, 3 }, 2, { { -1, 1 }, { 0, -2 }, { 0, -1 }, { 0, 0 }, { 1, 0 }, { -2, -2 }, { -1, -2 }, { -1, -1 }, { -1, 0 }, { 0, -3 } } },
};
/* clang-format on */

struct pavement {
	double sides, tiles, pattern, exterior, interior, form; /* as written */
	const struct pavement_row *row;
	int outer, inner, shape; /* of exterior, interior, form */
};

/* The language keeps these numbers in a byte. */
static int byte_of(double v)
{
	return (int)((uint64_t)(int64_t)v & 255);
}

static const struct pavement_row *find_row(const struct pavement *p)
{
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (rows[i].sides == byte_of(p->sides) && rows[i].tiles == byte_of(p->tiles) &&
			rows[i].pattern == byte_of(p->pattern))
			return &rows[i];
	return NULL;
}

static const char *pavement_complaint(const void *self)
{
	const struct pavement *p = self;
	const double all[] = { p->sides, p->tiles, p->pattern, p->exterior, p->interior, p->form };
	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		if (!(fabs(all[i]) < 1e9))
			return "the numbers of a pavement are small";
	const int sides = byte_of(p->sides), tiles = byte_of(p->tiles);
	if (sides != 3 && sides != 4 && sides != 6)
		return "a pavement is of tiles with 3, 4 or 6 sides";
	if (tiles < 1 || tiles > (sides == 6 ? 5 : 6))
		return sides == 6
			       ? "a pavement of hexagons has 1 to 5 tiles in a piece"
			       : "a pavement of triangles or squares has 1 to 6 tiles in a piece";
	return find_row(p) ? NULL : "there is no such pattern of a pavement with these tiles";
}

static void pavement_build(void *self)
{
	struct pavement *p = self;
	p->row = find_row(p);
	p->outer = byte_of(p->exterior) % 3;
	p->inner = byte_of(p->interior) % 3;
	p->shape = byte_of(p->form) % (p->row->sides == 4 ? 4 : 3);
}

/* ---- pieces ---- */

/* A piece of the whole plane: which of the period's, and which step of the lattice. */
struct piece {
	int number;
	int64_t a, b;
};

static bool same_piece(const struct piece *p, const struct piece *q)
{
	return p->number == q->number && p->a == q->a && p->b == q->b;
}

/* The piece a cell belongs to: the cell of the table that a step of the lattice takes to it. */
static struct piece piece_at(const struct pavement_row *row, int64_t i, int64_t j)
{
	const int64_t det = row->u[0] * row->w[1] - row->u[1] * row->w[0];
	const int count = row->pieces * row->tiles;
	for (int c = 0; c < count; c++) {
		const int64_t x = i - row->cells[c][0], y = j - row->cells[c][1];
		const int64_t a = x * row->w[1] - y * row->w[0];
		const int64_t b = y * row->u[0] - x * row->u[1];
		if (a % det == 0 && b % det == 0)
			return (struct piece){ c / row->tiles, a / det, b / det };
	}
	return (struct piece){ 0, 0, 0 }; /* the cells of a row leave no gap */
}

/* ---- squares ---- */

/* Of a corner of the cell: the distances of the point from it, whether its edges are closed. */
struct corner {
	double dx, dz;
	bool is_convex, is_concave;
};

static double round_corner(const struct pavement *p, double dx, double dz)
{
	switch (p->shape) {
	case 0:
		return fmax(fmax(2 * dx - 1, 2 * dz - 1), fmin(1 - 2 * dx, 1 - 2 * dz));
	case 1:
		return fmin(1, fabs(2 * (dx + dz) - 1));
	default:
		return fmin(1, fabs(2 * sqrt(dx * dx + dz * dz) - 1));
	}
}

static double square_inner(const struct pavement *p, const struct corner *c)
{
	switch (p->inner) {
	case 0:
		return fmin(1 - 2 * c->dx, 1 - 2 * c->dz);
	case 1:
		return 1 - 2 * (c->dx + c->dz);
	default:
		return 1 - 2 * sqrt(c->dx * c->dx + c->dz * c->dz);
	}
}

static double square_outer(const struct pavement *p, const struct corner *c)
{
	if (p->outer == 1)
		return fmin(1, 2 - 2 * (c->dx + c->dz));
	if (p->outer == 2 && c->dx <= 0.5 && c->dz <= 0.5)
		return fmin(
			1, 2 * sqrt((0.5 - c->dx) * (0.5 - c->dx) + (0.5 - c->dz) * (0.5 - c->dz)));
	return 0;
}

static double square_pavement(const struct pavement *p, double x, double z)
{
	const int64_t i = floor_index(x), j = floor_index(z);
	const double fx = x - (double)i, fz = z - (double)j;
	const struct piece own = piece_at(p->row, i, j);
	bool other[3][3]; /* the neighbours belong to another piece */
	for (int a = 0; a < 3; a++)
		for (int b = 0; b < 3; b++) {
			const struct piece piece = piece_at(p->row, i + a - 1, j + b - 1);
			other[a][b] = !same_piece(&own, &piece);
		}
	struct corner corners[4]; /* the opposite of k is 3 - k */
	for (int k = 0; k < 4; k++) {
		const int a = k & 1 ? 2 : 0, b = k & 2 ? 2 : 0;
		const bool side = other[a][1], end = other[1][b];
		corners[k] = (struct corner){ a ? 1 - fx : fx, b ? 1 - fz : fz, side && end,
			!side && !end && other[a][b] };
	}
	for (int k = 0; k < 4 && p->shape != 3; k++)
		if (corners[k].is_concave && corners[3 - k].is_convex)
			return round_corner(p, corners[k].dx, corners[k].dz);
	const double edges[4] = { other[0][1] ? fx : 1, other[2][1] ? 1 - fx : 1,
		other[1][0] ? fz : 1, other[1][2] ? 1 - fz : 1 };
	double v = 0;
	for (int k = 0; k < 4; k++)
		v = fmax(v, 1 - 2 * edges[k]);
	for (int k = 0; k < 4; k++) {
		if (corners[k].is_concave)
			v = fmax(v, square_inner(p, &corners[k]));
		if (corners[k].is_convex)
			v = fmax(v, square_outer(p, &corners[k]));
	}
	return v;
}

/* ---- triangles and hexagons ---- */

/* A triangle of a grid with unit edges: its centre is at x = (k + 1) / 2, its row begins at j times the
 * height; it points upwards if k + j is even. */
struct triangle {
	int64_t k, j;
};

/* A vertex of the grid: half units along x, and the row that begins at it. */
struct vertex {
	int64_t half, row;
};

/* A corner or the opposite edge of a triangle is named by the same number: 0 is the apex and the base,
 * 1 and 2 are left and right. */
struct side {
	double distance; /* of the point from the edge */
	bool is_closed;
};

static bool points_up(struct triangle t)
{
	return ((t.k + t.j) & 1) == 0;
}

static struct triangle triangle_at(double x, double z)
{
	const int64_t j = floor_index(z / HALF_ROOT_3), odd = j & 1;
	const double t = z / HALF_ROOT_3 - (double)j;
	const double u = x - (odd ? 0.5 : 0) - t / 2;
	const int64_t m = floor_index(u);
	return (struct triangle){ 2 * m + odd + (u - (double)m + t < 1 ? 0 : 1), j };
}

static struct triangle neighbour(struct triangle t, int side)
{
	const int up = points_up(t) ? 1 : -1;
	return side == 0   ? (struct triangle){ t.k, t.j - up }
	       : side == 1 ? (struct triangle){ t.k + up, t.j }
			   : (struct triangle){ t.k - up, t.j };
}

static struct vertex corner_of(struct triangle t, int corner)
{
	const bool up = points_up(t);
	return corner == 0	     ? (struct vertex){ t.k + 1, t.j + up }
	       : (corner == 1) == up ? (struct vertex){ t.k, t.j + !up }
				     : (struct vertex){ t.k + 2, t.j + !up };
}

/* A hexagon is the six triangles around its centre, which is a corner of each. */
static struct piece piece_of_triangle(const struct pavement_row *row, struct triangle t)
{
	if (row->sides == 3)
		return piece_at(row, t.k, t.j);
	for (int c = 0; c < 3; c++) {
		const struct vertex v = corner_of(t, c);
		const int64_t a = (v.half + 1) / 3;
		if (3 * a == v.half + 1 && ((v.row - 1 - a) & 1) == 0)
			return piece_at(row, a, (v.row - 1 - a) / 2);
	}
	return (struct piece){ 0, 0, 0 }; /* every triangle has one */
}

/* How many of the six triangles around a vertex belong to the piece. */
static int count_around(const struct pavement_row *row, struct vertex v, const struct piece *own)
{
	int count = 0;
	for (int i = 0; i < 6; i++) {
		const struct triangle t = { v.half - i % 3, v.row - i / 3 };
		const struct piece piece = piece_of_triangle(row, t);
		count += same_piece(own, &piece);
	}
	return count;
}

/* Corner 0, 1, 2 of a triangle turned upwards, its left corner at the origin. */
static const double corners_x[3] = { 0.5, 0, 1 }, corners_z[3] = { HALF_ROOT_3, 0, 0 };

/* How far along the edge from one corner to another the point is. */
static double along(double x, double z, int from, int to)
{
	return (x - corners_x[from]) * (corners_x[to] - corners_x[from]) +
	       (z - corners_z[from]) * (corners_z[to] - corners_z[from]);
}

static double distance_from(double x, double z, int corner)
{
	const double dx = x - corners_x[corner], dz = z - corners_z[corner];
	return sqrt(dx * dx + dz * dz);
}

static double triangle_inner(
	const struct pavement *p, double x, double z, int corner, double opposite, double v)
{
	const double a = along(x, z, corner, (corner + 1) % 3),
		     b = along(x, z, corner, (corner + 2) % 3);
	if (p->inner == 0)
		return fmax(v, 1 - 2 * ROOT_3 * (HALF_ROOT_3 - opposite));
	if (p->inner == 2)
		return fmax(v, 1 - 3 * distance_from(x, z, corner));
	return a < 0.5 && b < 0.5 ? fmax(v, fmin(1 - 3 * a, 1 - 3 * b)) : v;
}

static double triangle_outer(const struct pavement *p, double x, double z, int corner,
	const struct side sides[3], double v)
{
	const int l = (corner + 1) % 3, r = (corner + 2) % 3;
	const double third = HALF_ROOT_3 / 3;
	if (p->outer == 2 && along(x, z, corner, l) <= 0.5 && along(x, z, corner, r) <= 0.5) {
		const double dx = x - 0.5, dz = z - third;
		return fmin(1, 2 * ROOT_3 * sqrt(dx * dx + dz * dz));
	}
	if (p->outer == 1 && sides[l].distance <= third && sides[r].distance <= third)
		return fmin(1, 2 * ROOT_3 * fabs(sides[corner].distance - third));
	return v;
}

/* Where a piece is one edge wide at a corner, `form` rounds it. False: not there. */
static bool triangle_form(const struct pavement *p, double x, double z, int corner,
	const struct side sides[3], double *v)
{
	const int l = (corner + 1) % 3, r = (corner + 2) % 3;
	const int end = sides[r].is_closed ? r : l; /* the open edge is opposite the other corner */
	if (along(x, z, corner, l) >= 0.5 || along(x, z, corner, r) >= 0.5)
		return false;
	*v = p->shape == 1 ? fmin(1, 4 * (0.5 - along(x, z, corner, end)))
			   : fmin(1, fmax(0, 2 * ROOT_3 * (distance_from(x, z, end) - 1 / ROOT_3)));
	return true;
}

static double triangle_pavement(const struct pavement *p, double x, double z)
{
	const struct triangle t = triangle_at(x, z);
	const struct piece own = piece_of_triangle(p->row, t);
	x -= (double)t.k / 2;
	z -= (double)t.j * HALF_ROOT_3;
	if (!points_up(t)) {
		x = 1 - x;
		z = HALF_ROOT_3 - z;
	}
	struct side sides[3] = { { z, false }, { HALF_ROOT_3 * (1 - x) - z / 2, false },
		{ HALF_ROOT_3 * x - z / 2, false } };
	double v = 0;
	for (int e = 0; e < 3; e++) {
		const struct piece beyond = piece_of_triangle(p->row, neighbour(t, e));
		sides[e].is_closed = !same_piece(&own, &beyond);
		if (sides[e].is_closed)
			v = fmax(v, 1 - 2 * ROOT_3 * sides[e].distance);
	}
	for (int c = 0; c < 3; c++) {
		const bool l = sides[(c + 1) % 3].is_closed, r = sides[(c + 2) % 3].is_closed;
		const int around = count_around(p->row, corner_of(t, c), &own);
		if (p->shape > 0 && l != r && around == 2 && triangle_form(p, x, z, c, sides, &v))
			return v;
	}
	for (int c = 0; c < 3; c++) {
		const bool l = sides[(c + 1) % 3].is_closed, r = sides[(c + 2) % 3].is_closed;
		if (!l && !r && count_around(p->row, corner_of(t, c), &own) < 6)
			v = triangle_inner(p, x, z, c, sides[c].distance, v);
	}
	for (int c = 0; c < 3; c++) {
		if (sides[(c + 1) % 3].is_closed && sides[(c + 2) % 3].is_closed)
			v = triangle_outer(p, x, z, c, sides, v);
	}
	return v;
}

static double pavement_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	const struct pavement *p = pattern->self;
	(void)surface;
	return p->row->sides == 4 ? square_pavement(p, q.x, q.z) : triangle_pavement(p, q.x, q.z);
}

static const struct pattern_param params[] = {
	{ "number_of_sides", PATTERN_DOUBLE, offsetof(struct pavement, sides) },
	{ "number_of_tiles", PATTERN_DOUBLE, offsetof(struct pavement, tiles) },
	{ "pattern", PATTERN_DOUBLE, offsetof(struct pavement, pattern) },
	{ "exterior", PATTERN_DOUBLE, offsetof(struct pavement, exterior) },
	{ "interior", PATTERN_DOUBLE, offsetof(struct pavement, interior) },
	{ "form", PATTERN_X, offsetof(struct pavement, form) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_pavement = {
	.name = "pavement",
	.size = sizeof(struct pavement),
	.params = params,
	.defaults = &(const struct pavement){ .sides = 3, .tiles = 1, .pattern = 1 },
	.complaint = pavement_complaint,
	.build = pavement_build,
	.value = pavement_value,
};
