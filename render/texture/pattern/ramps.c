/* SPDX-License-Identifier: MIT */
/*
 * gradient, planar, boxed, cylindrical, spherical, onion, leopard, radial: values
 * that follow from the coordinates alone.
 */
#include "texture/patterns.h"

#include "base/elementary.h"

#include <math.h>

struct gradient {
	vec3 axis;
};

/* A zero axis gives no number, which chooses the first map entry. */
static void gradient_build(void *self)
{
	struct gradient *gradient = self;
	gradient->axis = vec_scale(gradient->axis, 1 / vec_length(gradient->axis));
}

static double gradient_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct gradient *gradient = pattern->self;
	const double d = vec_dot(q, gradient->axis);
	return d > 1 ? fmod(d, 1) : d;
}

static const struct pattern_param gradient_params[] = {
	{ NULL, PATTERN_VECTOR, offsetof(struct gradient, axis) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_gradient = {
	.name = "gradient",
	.size = sizeof(struct gradient),
	.params = gradient_params,
	.build = gradient_build,
	.value = gradient_value,
};

/* 1 at the centre, 0 from distance 1 on. */
static double falling(double distance)
{
	return distance > 1 ? 0 : 1 - distance;
}

static double planar_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	return falling(fabs(q.y));
}
const struct pattern_class pattern_planar = { .name = "planar", .value = planar_value };

static double boxed_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double x = fabs(q.x), y = fabs(q.y), z = fabs(q.z), xy = x > y ? x : y;
	return falling(xy > z ? xy : z);
}
const struct pattern_class pattern_boxed = { .name = "boxed", .value = boxed_value };

static double cylindrical_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	return falling(sqrt(q.x * q.x + q.z * q.z));
}
const struct pattern_class pattern_cylindrical = { .name = "cylindrical",
	.value = cylindrical_value };

static double spherical_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	return falling(vec_length(q));
}
const struct pattern_class pattern_spherical = { .name = "spherical", .value = spherical_value };

static double onion_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double length = vec_length(q);
	return length < 1 ? length : fmod(length, 1);
}
const struct pattern_class pattern_onion = { .name = "onion", .value = onion_value };

static double leopard_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	const double v = (elementary_sin(q.x) + elementary_sin(q.y) + elementary_sin(q.z)) / 3;
	return v * v;
}
const struct pattern_class pattern_leopard = { .name = "leopard", .value = leopard_value };

/* Closer to the axis than this there is no angle. */
#define RADIAL_CORE 0.001

static double radial_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	if (fabs(q.x) < RADIAL_CORE && fabs(q.z) < RADIAL_CORE)
		return 0.25;
	return 0.25 + (elementary_atan2(q.x, q.z) + M_PI) / (2 * M_PI);
}

static const float radial_values[] = { 0, 0.333f, 0.666f, 1 };
static const colour radial_colours[] = { { 0, 1, 1, 0, 0 }, { 1, 1, 0, 0, 0 }, { 1, 0, 1, 0, 0 },
	{ 0, 1, 1, 0, 0 } };
static const struct default_map radial_map = { 4, radial_values, radial_colours };
const struct pattern_class pattern_radial = {
	.name = "radial", .value = radial_value, .map = &radial_map
};
