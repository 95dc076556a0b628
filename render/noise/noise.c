/* SPDX-License-Identifier: MIT */
/*
 * Lattice noise. Each corner of the unit cell around a point holds a random
 * linear function of the offset from that corner; the eight are blended with
 * s(f) = f^2 (3 - 2f) along each axis. Corners find their four coefficients at a
 * random place in one table of reals, the other components of vector noise four
 * places further on.
 *
 * The four coefficients of a corner (of 1, dx, dy, dz) are four lanes. Weights and
 * offsets of an axis depend only on the side of the cell along that axis, so the
 * corners are summed along z, then y, then x, each with two factors a side. Lanes are
 * added at the very end in a fixed order: every instruction set gives the same bits.
 */
#include "noise/noise.h"

/* Negative coordinates this close to a lattice plane belong to the cell above it. */
#define LATTICE_EPSILON 1e-10
/* Integers stay exact and conversions defined; nothing repeats below 4096 anyway. */
#define LATTICE_LIMIT 1e15

typedef double lanes __attribute__((vector_size(32), aligned(32)));
typedef double loose_lanes __attribute__((vector_size(32), aligned(8), may_alias));

struct cell {
	const double *start[8]; /* coefficients of each corner; z changes fastest, then y */
	lanes x[2], y[2], z[2]; /* factors of the two sides along each axis */
};

/* Splits a coordinate into lattice index and offset. */
static inline double split(double x, unsigned *index)
{
	x = x > -LATTICE_LIMIT ? x : -LATTICE_LIMIT;
	x = x < LATTICE_LIMIT ? x : LATTICE_LIMIT;
	const int64_t i = (int64_t)(x < 0 ? x - (1 - LATTICE_EPSILON) : x);
	*index = (unsigned)(i + 10000) & 0xfff;
	return x - (double)i;
}

static inline double smooth(double f)
{
	return f * f * (3 - 2 * f);
}

static inline void cell_find(vec3 p, struct cell *cell)
{
	unsigned x, y, z;
	const double fx = split(p.x, &x), fy = split(p.y, &y), fz = split(p.z, &z);
	const unsigned y1 = (y + 1) & 0xfff, z1 = (z + 1) & 0xfff;
	const unsigned h0 = hash_table[x], h1 = hash_table[(x + 1) & 0xfff];
	const unsigned h[4] = { hash_table[h0 ^ y], hash_table[h0 ^ y1], hash_table[h1 ^ y],
		hash_table[h1 ^ y1] };
	const double sx = smooth(fx), sy = smooth(fy), sz = smooth(fz);
	cell->x[0] = (1 - sx) * (lanes){ 0.5, fx, 1, 1 };
	cell->x[1] = sx * (lanes){ 0.5, fx - 1, 1, 1 };
	cell->y[0] = (1 - sy) * (lanes){ 1, 1, fy, 1 };
	cell->y[1] = sy * (lanes){ 1, 1, fy - 1, 1 };
	cell->z[0] = (1 - sz) * (lanes){ 1, 1, 1, fz };
	cell->z[1] = sz * (lanes){ 1, 1, 1, fz - 1 };
	for (int i = 0; i < 4; i++) {
		cell->start[2 * i] = noise_reals + hash_low[h[i] ^ z];
		cell->start[2 * i + 1] = noise_reals + hash_low[h[i] ^ z1];
	}
}

/* The coefficients of one corner. */
static inline const loose_lanes *corner(const struct cell *cell, int i, int offset)
{
	return (const loose_lanes *)(cell->start[i] + offset);
}

/* The blend of the component whose coefficients begin `offset` places on. */
static inline double cell_blend(const struct cell *cell, int offset)
{
	const lanes z00 =
		cell->z[0] * *corner(cell, 0, offset) + cell->z[1] * *corner(cell, 1, offset);
	const lanes z01 =
		cell->z[0] * *corner(cell, 2, offset) + cell->z[1] * *corner(cell, 3, offset);
	const lanes z10 =
		cell->z[0] * *corner(cell, 4, offset) + cell->z[1] * *corner(cell, 5, offset);
	const lanes z11 =
		cell->z[0] * *corner(cell, 6, offset) + cell->z[1] * *corner(cell, 7, offset);
	const lanes y0 = cell->y[0] * z00 + cell->y[1] * z01;
	const lanes y1 = cell->y[0] * z10 + cell->y[1] * z11;
	const lanes sum = cell->x[0] * y0 + cell->x[1] * y1;
	return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

vec3 noise_vector(vec3 p)
{
	struct cell cell;
	cell_find(p, &cell);
	return vec(cell_blend(&cell, 0), cell_blend(&cell, 4), cell_blend(&cell, 8));
}

/* Far from the origin keeps every coordinate positive; the fraction hides lattice planes at
 * integers. */
#define GRADIENT_SHIFT 10000000.023157213

static inline double gradient_split(double x, unsigned index[2])
{
	x = x > -LATTICE_LIMIT ? x : -LATTICE_LIMIT;
	x = x < LATTICE_LIMIT ? x : LATTICE_LIMIT;
	const double t = x + GRADIENT_SHIFT, i = floor(t);
	index[0] = (unsigned)(int64_t)i & 0x7ff;
	index[1] = (index[0] + 1) & 0x7ff;
	return t - i;
}

/* Generator 3: gradients at the corners, interpolated. */
static double gradient_noise(vec3 p)
{
	unsigned x[2], y[2], z[2];
	const double rx = gradient_split(p.x, x), ry = gradient_split(p.y, y),
		     rz = gradient_split(p.z, z);
	const double sx = smooth(rx), sy = smooth(ry), sz = smooth(rz);
	double along_z[2];
	for (int c = 0; c < 2; c++) {
		double along_y[2];
		for (int b = 0; b < 2; b++) {
			double value[2];
			for (int a = 0; a < 2; a++) {
				const unsigned xy =
					noise_permutation[(noise_permutation[x[a]] + y[b]) & 0x7ff];
				const double *g = noise_gradients[(xy + z[c]) & 0x7ff];
				value[a] = g[0] * (rx - a) + g[1] * (ry - b) + g[2] * (rz - c);
			}
			along_y[b] = value[0] + sx * (value[1] - value[0]);
		}
		along_z[c] = along_y[0] + sy * (along_y[1] - along_y[0]);
	}
	const double q = along_z[0] + sz * (along_z[1] - along_z[0]);
	return clamp01(0.5 * (1.59 * q + 0.985));
}

double noise_scalar(vec3 p, int generator)
{
	if (generator == 3)
		return gradient_noise(p);
	struct cell cell;
	cell_find(p, &cell);
	const double raw = cell_blend(&cell, 0);
	return generator == 2 ? clamp01((raw + 1.05242) * 0.48985582) : clamp01(raw + 0.5);
}
