/* SPDX-License-Identifier: MIT */
/*
 * The fixed tables of the language: a permutation of 0 to 4095 that hashes
 * lattice cells for the noise functions and sample positions for the jitter of
 * antialiasing. Constants of the renderer, the same in every scene.
 */
#ifndef LAMBERT_RENDER_HASH_H
#define LAMBERT_RENDER_HASH_H

#include <stdint.h>

/* A permutation of 0 to 4095, index modulo 4096. */
extern const uint16_t hash_table[4096];

/* The displacement of the sample at (x, y), each component in [-1/2, 1/2). Pixel units: integers
 * are pixel centres, (0, 0) is the top left pixel of the whole picture. */
void hash_jitter(double x, double y, double out[2]);

#endif
