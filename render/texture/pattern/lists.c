/* SPDX-License-Identifier: MIT */
/*
 * checker, square, hexagon, triangular, cubic: the number of the cell's kind, which
 * chooses an item of a list.
 */
#include "texture/patterns.h"

#include "base/epsilon.h"
#include "noise/noise.h"

#define HALF_ROOT_3 0.86602540378443864676

static const float list_values[] = { 0, 1, 2 };
static const colour list_colours[] = { { 0, 0, 1, 0, 0 }, { 0, 1, 0, 0, 0 }, { 1, 0, 0, 0, 0 } };
static const struct default_map list_map = { 3, list_values, list_colours };

static double checker_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	return (double)((floor_index(q.x + EPSILON) + floor_index(q.y + EPSILON) +
				floor_index(q.z + EPSILON)) &
			1);
}
const struct pattern_class pattern_checker = {
	.name = "checker",
	.list_count = 2,
	.sets_frequency_0 = true,
	.value = checker_value,
	.map = &list_map,
};

static double square_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const int64_t i = floor_index(q.x) & 1, j = floor_index(q.z) & 1;
	return (double)(i ? 3 - j : j);
}
const struct pattern_class pattern_square = {
	.name = "square",
	.list_count = 4,
	.sets_frequency_0 = true,
	.value = square_value,
	.map = &default_map_primaries,
};

static double modulo(double v, double period)
{
	return v - period * floor(v / period);
}

/* The nearest centre of a hexagonal grid, by rounding three coordinates that add up to 0 and
 * correcting the one that was rounded most. */
static double hexagon_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double fa = q.x / 1.5, fb = (q.z / HALF_ROOT_3 - fa) / 2;
	double a = floor(fa + 0.5), b = floor(fb + 0.5);
	const double c = floor(-fa - fb + 0.5);
	const double da = fabs(a - fa), db = fabs(b - fb), dc = fabs(c + fa + fb);
	if (da > db && da > dc)
		a = -b - c;
	else if (db > dc)
		b = -a - c;
	return modulo(b - a, 3);
}
const struct pattern_class pattern_hexagon = {
	.name = "hexagon",
	.list_count = 3,
	.sets_frequency_0 = true,
	.value = hexagon_value,
	.map = &list_map,
};

/* Two rows of triangles, `t` the height within the row; a skewed coordinate tells the halves of
 * its cells apart. */
static double triangular_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double row = modulo(q.z, 2 * HALF_ROOT_3) / HALF_ROOT_3;
	if (row < 1) {
		const double u = q.x - row / 2, m = floor(u);
		return u - m + row < 1 ? modulo(-2 * m, 6) : modulo(3 + 2 * m, 6);
	}
	const double t = row - 1, u = q.x + 0.5 - t / 2, m = floor(u);
	return u - m + t < 1 ? modulo(4 - 2 * m, 6) : modulo(5 + 2 * m, 6);
}
const struct pattern_class pattern_triangular = {
	.name = "triangular",
	.list_count = 6,
	.sets_frequency_0 = true,
	.value = triangular_value,
	.map = &default_map_primaries,
};

/* The face of the cube around the origin that the point lies behind. */
static double cubic_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double x = fabs(q.x), y = fabs(q.y), z = fabs(q.z);
	if (q.x >= 0 && x >= y && x >= z)
		return 0;
	if (q.y >= 0 && y >= x && y >= z)
		return 1;
	if (q.z >= 0 && z >= x && z >= y)
		return 2;
	if (q.x < 0 && x >= y && x >= z)
		return 3;
	return q.y < 0 && y >= x && y >= z ? 4 : 5;
}
const struct pattern_class pattern_cubic = {
	.name = "cubic",
	.list_count = 6,
	.sets_frequency_0 = true,
	.value = cubic_value,
	.map = &default_map_primaries,
};

static double object_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct object_pattern *self = pattern->self;
	return object_inside(self->object, q) ? 1 : 0;
}
const struct pattern_class pattern_object = {
	.name = "object",
	.size = sizeof(struct object_pattern),
	.list_count = 2,
	.sets_frequency_0 = true,
	.value = object_value,
	.map = &list_map,
};
