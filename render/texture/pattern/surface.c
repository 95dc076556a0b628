/* SPDX-License-Identifier: MIT */
/*
 * slope, aoi, pigment_pattern: patterns that look at the surface, or at the colour of
 * a pigment. Where there is no surface the first two are 0.
 */
#include "texture/patterns.h"

#include "base/elementary.h"
#include "base/epsilon.h"

#include <math.h>

static double aoi_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)q;
	if (!surface)
		return 0;
	const double c =
		vec_dot(vec_normalize(surface->current), vec_normalize(surface->direction));
	return elementary_acos(c < -1 ? -1 : c > 1 ? 1 : c) / M_PI;
}
const struct pattern_class pattern_aoi = { .name = "aoi", .value = aoi_value };

/* Into 0 to 1; exactly 1 stays just below. */
static double wrapped(double v)
{
	if (v - 1 >= 0 && v - 1 < EPSILON)
		return v - EPSILON;
	v = fmod(v, 1);
	return v < 0 ? v + 1 : v;
}

static double ranged(double v, double low, double range)
{
	return range != 0 ? (v - low) / range : v;
}

static double slope_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	const struct slope *s = pattern->self;
	if (!surface)
		return 0;
	const vec3 direction =
		s->is_point ? vec_normalize(vec_sub(s->direction, surface->point)) : s->direction;
	const double c = vec_dot(surface->current, direction);
	double a = (elementary_asin(c < -1 ? -1 : c > 1 ? 1 : c) * 2 / M_PI + 1) / 2;
	a = ranged(a, s->slope_low, s->slope_range);
	if (!s->has_altitude)
		return wrapped(a);
	const double b = ranged(vec_dot(q, s->altitude), s->altitude_low, s->altitude_range);
	return wrapped(s->slope_weight * a + s->altitude_weight * b);
}
const struct pattern_class pattern_slope = {
	.name = "slope", .size = sizeof(struct slope), .value = slope_value
};

static double pigment_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	const struct pigment_pattern *self = pattern->self;
	colour c;
	if (!pigment_colour(self->pigment, q, surface, &c))
		return 0;
	return (double)rgb_luminance(colour_rgb(c));
}
const struct pattern_class pattern_pigment_pattern = {
	.name = "pigment_pattern",
	.size = sizeof(struct pigment_pattern),
	.value = pigment_value,
};
