/* SPDX-License-Identifier: MIT */
/*
 * Random numbers by name. A number is a function of the frame, the pixel, the
 * sample of that pixel and a dimension: what the number is for. Nothing counts
 * draws. So a number depends neither on threads nor on the order of work, and a
 * feature that draws leaves the draws of all others as they are.
 *
 * In each dimension the samples of one pixel are stratified: their first 2^k
 * numbers fall one into each of 2^k equal parts of [0, 1), or of every such
 * division of the unit square (Owen-scrambled Sobol points). Different pixels,
 * frames and dimensions are independent of each other.
 */
#ifndef LAMBERT_SAMPLE_SAMPLE_H
#define LAMBERT_SAMPLE_SAMPLE_H

#include "base/random.h"

/* A pixel, counted from the top left of the whole picture, and one of its samples, from 0. */
struct sample_place {
	int32_t x, y;
	uint32_t index;
};

/* One sample of one pixel of one frame. */
struct sample_id {
	uint64_t pixel; /* hash of frame and pixel */
	uint32_t index;
};

static inline struct sample_id sample_at(uint32_t frame, struct sample_place place)
{
	const uint64_t pixel = (uint64_t)(uint32_t)place.x << 32 | (uint32_t)place.y;
	return (struct sample_id){ random_mix(frame * 0x9e3779b97f4a7c15u, pixel), place.index };
}

/* What random numbers are for. */
enum sample_purpose { SAMPLE_GRAIN, SAMPLE_AREA_LIGHT };

/* The vertex of the ray tree that camera rays end at; no small number leads from it to 0. */
#define SAMPLE_CAMERA_VERTEX 0x2545f491u
/* The vertex that ray `number` from a vertex leads to. A vertex is hashed when it names something. */
static inline uint32_t sample_vertex(uint32_t vertex, uint32_t number)
{
	return (vertex + number + 1) * 0x9e3779b1u;
}

/* The dimension of a purpose at a vertex of the ray tree. */
static inline uint64_t sample_dimension(uint32_t vertex, enum sample_purpose purpose)
{
	return (uint64_t)vertex << 32 | purpose;
}
/* One of several under it: of a light, a layer, a point of a grid. */
static inline uint64_t sample_subdimension(uint64_t dimension, uint32_t number)
{
	return random_mix(dimension, number);
}

/* In [0, 1). */
static inline double sample_unit(uint32_t bits)
{
	return bits * 0x1p-32;
}
/* Uniform in [0, 1). */
double sample_1d(struct sample_id, uint64_t dimension);
/* Uniform in the unit square. */
struct sample_pair {
	double u, v;
};
struct sample_pair sample_2d(struct sample_id, uint64_t dimension);

/* Many pairs at a time, for points of a grid: members are copies of one pair under shifts of their
 * own. Each by itself is as good as the pair, and the members are independent of each other. */
struct sample_family {
	uint64_t seed;
	uint32_t u, v;
};
struct sample_family sample_family(struct sample_id, uint64_t dimension);
static inline struct sample_pair sample_member(const struct sample_family *f, uint32_t number)
{
	const uint64_t shift = random_mix(f->seed, number);
	return (struct sample_pair){ sample_unit(f->u ^ (uint32_t)shift),
		sample_unit(f->v ^ (uint32_t)(shift >> 32)) };
}

#endif
