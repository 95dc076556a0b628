/* SPDX-License-Identifier: MIT */
/*
 * marble, wood, spiral1, spiral2: unbounded ramps that a triangle wave folds. Each uses
 * the item's turbulence in its own way; marble and wood instead of moving the point,
 * the spirals besides.
 */
#include "texture/patterns.h"

#include "base/elementary.h"
#include "noise/noise.h"

#include <math.h>

/* What turbulence adds to the ramp: its x amount times scalar turbulence. */
static double ramp_turbulence(const struct pattern *pattern, vec3 q)
{
	const struct turbulence *t = pattern->turbulence;
	if (!t || t->amount.x == 0)
		return 0;
	return t->amount.x * noise_turbulence_scalar(
				     q, t->octaves, t->omega, t->lambda, pattern->noise_generator);
}

static double marble_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	return q.x + ramp_turbulence(pattern, q);
}

static const float marble_values[] = { 0, 0.9f, 0.9f };
static const colour marble_colours[] = { { 0.9f, 0.8f, 0.8f, 0, 0 }, { 0.9f, 0.08f, 0.08f, 0, 0 },
	{ 0, 0, 0, 0, 0 } };
static const struct default_map marble_map = { 3, marble_values, marble_colours };
const struct pattern_class pattern_marble = {
	.name = "marble",
	.sets_triangle_wave = true,
	.own_turbulence = true,
	.value = marble_value,
	.map = &marble_map,
};

static double wood_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct turbulence *t = pattern->turbulence;
	double x = q.x, y = q.y;
	if (t && (t->amount.x != 0 || t->amount.y != 0)) {
		const vec3 v = noise_turbulence(q, t->octaves, (double)t->omega, (double)t->lambda);
		x += cycloid((q.x + v.x) * t->amount.x);
		y += cycloid((q.y + v.y) * t->amount.y);
	}
	return sqrt(x * x + y * y);
}

static const float wood_values[] = { 0.6f, 0.6f };
static const colour wood_colours[] = { { 0.666f, 0.312f, 0.2f, 0, 0 },
	{ 0.4f, 0.1333f, 0.066f, 0, 0 } };
static const struct default_map wood_map = { 2, wood_values, wood_colours };
const struct pattern_class pattern_wood = {
	.name = "wood",
	.sets_triangle_wave = true,
	.own_turbulence = true,
	.value = wood_value,
	.map = &wood_map,
};

struct spiral {
	double arms; /* truncated to a 16-bit integer */
};

static void spiral_build(void *self)
{
	struct spiral *spiral = self;
	const double arms = fabs(spiral->arms) < 1e9 ? spiral->arms : 0;
	spiral->arms = (int16_t)(uint16_t)(uint32_t)(int32_t)arms;
}

static double spiral_ramp(const struct pattern *pattern, vec3 q)
{
	const struct spiral *spiral = pattern->self;
	const double r = sqrt(q.x * q.x + q.y * q.y);
	double angle = 0;
	if (r > 0)
		angle = q.x >= 0 ? M_PI / 2 + elementary_asin(q.y / r)
				 : 3 * M_PI / 2 - elementary_asin(q.y / r);
	return q.z + r + spiral->arms * angle / (2 * M_PI) + ramp_turbulence(pattern, q);
}

static double spiral1_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	return spiral_ramp(pattern, q);
}

static double spiral2_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	return triangle(sqrt(q.x * q.x + q.y * q.y)) + triangle(spiral_ramp(pattern, q));
}

static const struct pattern_param spiral_params[] = {
	{ NULL, PATTERN_DOUBLE, offsetof(struct spiral, arms) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_spiral1 = {
	.name = "spiral1",
	.size = sizeof(struct spiral),
	.params = spiral_params,
	.build = spiral_build,
	.sets_triangle_wave = true,
	.value = spiral1_value,
};
const struct pattern_class pattern_spiral2 = {
	.name = "spiral2",
	.size = sizeof(struct spiral),
	.params = spiral_params,
	.build = spiral_build,
	.sets_triangle_wave = true,
	.value = spiral2_value,
};
