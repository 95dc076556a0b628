/* SPDX-License-Identifier: MIT */
/*
 * quilted: cushions in unit cells, their profile a cubic with two controls.
 */
#include "texture/patterns.h"

struct quilted {
	float control0, control1;
};

/* From the centre of the cell, which is one lower at negative integers. */
static double from_centre(double v)
{
	const double cell = v >= 0 ? floor(v) : -floor(-v) - 1;
	return v - cell - 0.5;
}

static double profile(const struct quilted *quilted, double t)
{
	return 1.154700538 * (t * t * t + 3 * t * (1 - t) * (1 - t) * (double)quilted->control0 +
				     3 * t * t * (1 - t) * (double)quilted->control1);
}

static double quilted_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const vec3 d = { from_centre(q.x), from_centre(q.y), from_centre(q.z) };
	return (fabs(d.x) + fabs(d.y) + fabs(d.z)) * profile(pattern->self, vec_length(d)) / 3;
}

static vec3 quilted_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)surface;
	const vec3 d = { from_centre(q.x), from_centre(q.y), from_centre(q.z) };
	return vec_mad(n, amount * profile(pattern->self, vec_length(d)), d);
}

static const struct pattern_param params[] = {
	{ "control0", PATTERN_FLOAT, offsetof(struct quilted, control0) },
	{ "control1", PATTERN_FLOAT, offsetof(struct quilted, control1) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_quilted = {
	.name = "quilted",
	.size = sizeof(struct quilted),
	.params = params,
	.defaults = &(const struct quilted){ 1, 1 },
	.sets_frequency_0 = true,
	.value = quilted_value,
	.perturb = quilted_perturb,
};
