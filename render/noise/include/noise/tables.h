/* SPDX-License-Identifier: MIT */
/*
 * The fixed tables of the language, the same in every scene: written by
 * generate_tables.c, which says how each comes about.
 */
#ifndef LAMBERT_NOISE_TABLES_H
#define LAMBERT_NOISE_TABLES_H

#include <stdint.h>

/* A permutation of 0 to 4095 that hashes lattice cells and sample positions; its low bytes. */
extern const uint16_t hash_table[4096];
extern const uint8_t hash_low[4096];
/* -1/2 to 1/2, by hash. */
extern const float jitter_table[256];
/* -1 to 1: what noise is made of, by the low byte of the hash of a corner. */
extern const double noise_reals[267];
/* Unit vectors, and their order: for the third kind of noise. */
extern const double noise_gradients[2048][3];
extern const uint16_t noise_permutation[2048];
/* 0 to 1, by hash of a cell plus 0, 1, 2. */
extern const double cell_uniforms[4098];

#endif
