/* SPDX-License-Identifier: MIT */
/*
 * function { expression }: the value of a user-defined function of the point.
 */
#include "texture/patterns.h"

#include "function/program.h"

#include <math.h>

static double function_pattern_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	const struct function_pattern *f = pattern->self;
	(void)surface;
	const double point[3] = { q.x, q.y, q.z };
	const double v = program_value(f->program, point);
	return v > 1 ? fmod(v, 1) : v;
}

const struct pattern_class pattern_function = {
	.name = "function",
	.size = sizeof(struct function_pattern),
	.value = function_pattern_value,
};
