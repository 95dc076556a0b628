/* SPDX-License-Identifier: MIT */
/*
 * brick: 0 in the mortar, 1 in the bricks. Every second row is moved by half a brick.
 */
#include "texture/patterns.h"

#include "base/epsilon.h"

struct brick {
	vec3 size;
	float mortar; /* as written */
};

static void brick_build(void *self)
{
	struct brick *brick = self;
	brick->mortar = (float)((double)brick->mortar - 2 * EPSILON);
}

static double fraction(double v)
{
	const double f = v - trunc(v);
	return f < 0 ? f + 1 : f;
}

static double brick_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct brick *brick = pattern->self;
	const vec3 size = brick->size;
	const double mortar = (double)brick->mortar;
	const double x = q.x + EPSILON + mortar, y = q.y + EPSILON + mortar,
		     z = q.z + EPSILON + mortar;
	if (fraction(y / size.y) <= mortar / size.y)
		return 0;
	const bool odd = fraction(y / (2 * size.y)) > 0.5;
	if (fraction(x / size.x + (odd ? 0.5 : 0)) <= mortar / size.x)
		return 0;
	return fraction(z / size.z + (odd ? 0 : 0.5)) <= mortar / size.z ? 0 : 1;
}

static const struct pattern_param params[] = {
	{ "brick_size", PATTERN_VECTOR, offsetof(struct brick, size) },
	{ "mortar", PATTERN_FLOAT, offsetof(struct brick, mortar) },
	{ NULL, PATTERN_END, 0 },
};
static const float values[] = { 0, 1 };
static const colour colours[] = { { 0.5f, 0.5f, 0.5f, 0, 0 }, { 0.6f, 0.15f, 0.15f, 0, 0 } };
static const struct default_map map = { 2, values, colours };
const struct pattern_class pattern_brick = {
	.name = "brick",
	.size = sizeof(struct brick),
	.params = params,
	.defaults = &(const struct brick){ { 8, 3, 4.5 }, 0.5f },
	.list_count = 2,
	.keeps_parameters = true,
	.sets_frequency_0 = true,
	.build = brick_build,
	.value = brick_value,
	.map = &map,
};
