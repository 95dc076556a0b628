/* SPDX-License-Identifier: MIT */
/*
 * The normal is taken into the space of the pattern, perturbed there, and taken
 * back. Any pattern makes bumps: the differences of its value towards the corners
 * of a small tetrahedron tilt the normal.
 */
#include "texture/normal.h"

#include "texture/pigment.h"

static const vec3 corners[4] = {
	{ 0.942809041, -0.333333333, 0 },
	{ -0.471404521, -0.333333333, 0.816496581 },
	{ -0.471404521, -0.333333333, -0.816496581 },
	{ 0, 1, 0 },
};

static vec3 perturb(const struct normal *, vec3 n, vec3 p, struct surface *);

/* A Hermite cubic between two entries; slopes are per step from entry to entry. */
static double slope_height(const struct normal *normal, double v)
{
	const struct blend b = map_lookup(&normal->map, v);
	const struct slope_entry *low = &normal->slopes[b.low], *high = &normal->slopes[b.high];
	if (b.low == b.high)
		return low->height;
	const double t = b.share, rise = low->height - high->height;
	return t * t * t * (low->slope + high->slope + 2 * rise) -
	       t * t * (2 * low->slope + high->slope + 3 * rise) + t * low->slope + low->height;
}

static vec3 bump(const struct normal *normal, vec3 q, vec3 n, struct surface *surface)
{
	const double scale = -5 * normal->amount * 0.02 / normal->accuracy;
	for (int i = 0; i < 4; i++) {
		const vec3 at = vec_mad(q, normal->accuracy, corners[i]);
		double height = pattern_value(&normal->pattern, at, surface);
		if (normal->slopes)
			height = slope_height(normal, height);
		n = vec_mad(n, height * scale, corners[i]);
	}
	return n;
}

static vec3 from_normals(const struct normal *normal, vec3 q, vec3 n, struct surface *surface)
{
	const double v = pattern_value(&normal->pattern, q, surface);
	const struct blend b = map_lookup(&normal->map, v);
	const vec3 low = perturb(normal->normals[b.low], n, q, surface);
	if (b.low == b.high)
		return low;
	const vec3 high = perturb(normal->normals[b.high], n, q, surface);
	return vec_add(vec_scale(low, 1 - b.share), vec_scale(high, b.share));
}

static vec3 average(const struct normal *normal, vec3 q, vec3 n, struct surface *surface)
{
	vec3 sum = { 0, 0, 0 };
	for (size_t i = 0; i < normal->map.count; i++)
		sum = vec_mad(sum, (double)normal->map.values[i],
			perturb(normal->normals[i], n, q, surface));
	return vec_scale(sum, 1 / (double)normal->total_weight);
}

static vec3 perturb_inside(const struct normal *normal, vec3 q, vec3 n, struct surface *surface)
{
	const struct pattern *pattern = &normal->pattern;
	switch (normal->kind) {
	case NORMAL_VECTOR:
		return pattern->class->perturb(pattern, q, n, normal->amount, surface);
	case NORMAL_BUMP:
		return bump(normal, q, n, surface);
	case NORMAL_MAP:
		return from_normals(normal, q, n, surface);
	case NORMAL_AVERAGE:
		return average(normal, q, n, surface);
	case NORMAL_UV:
		break;
	}
	return n;
}

/* One item. Every result becomes the current normal that slope and aoi see. */
static vec3 perturb(const struct normal *normal, vec3 n, vec3 p, struct surface *surface)
{
	if (!normal)
		return n;
	if (normal->kind == NORMAL_UV) {
		n = vec_normalize(
			perturb(normal->normals[0], n, surface_uv_point(surface), surface));
		surface->current = n;
		return n;
	}
	const bool unit = !normal->keeps_length;
	const transform *frame = normal->pattern.frame;
	if (frame)
		n = transform_normal_back(frame, n);
	if (unit)
		n = vec_normalize(n);
	n = perturb_inside(normal, pattern_warp(&normal->pattern, p), n, surface);
	if (unit)
		n = vec_normalize(n);
	if (frame) {
		n = transform_normal(frame, n);
		if (unit)
			n = vec_normalize(n);
	}
	surface->current = n;
	return n;
}

vec3 normal_perturb(const struct normal *normal, vec3 n, vec3 p, struct surface *surface)
{
	return normal ? vec_normalize(perturb(normal, n, p, surface)) : n;
}
