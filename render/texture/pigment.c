/* SPDX-License-Identifier: MIT */
/*
 * The colour of a pigment at a point: the pattern's value looked up in a map of
 * colours or pigments. Colours are single precision at every step.
 */
#include "texture/pigment.h"

static float mix(float a, float b, double share)
{
	return (float)((double)a + share * (double)(b - a));
}

static colour colour_mix(colour a, colour b, double share)
{
	return (colour){ mix(a.r, b.r, share), mix(a.g, b.g, share), mix(a.b, b.b, share),
		mix(a.filter, b.filter, share), mix(a.transmit, b.transmit, share) };
}

static colour from_colours(const struct pigment_source *s, double v)
{
	if (s->map.is_list) {
		const size_t i = (size_t)(v >= 0 && v < (double)s->map.count ? v : 0);
		if ((double)i == v)
			return s->colours[i];
	}
	const struct blend b = map_lookup(&s->map, v);
	if (b.low == b.high)
		return s->colours[b.low];
	return colour_mix(s->colours[b.low], s->colours[b.high], b.share);
}

/* A pigment without colour at this place takes part as clear white. */
static bool from_pigments(
	const struct pigment_source *s, double v, vec3 q, struct surface *surface, colour *out)
{
	const struct blend b = map_lookup(&s->map, v);
	if (b.low == b.high)
		return pigment_colour(s->pigments[b.low], q, surface, out);
	colour low, high;
	const bool found_low = pigment_colour(s->pigments[b.low], q, surface, &low);
	const bool found_high = pigment_colour(s->pigments[b.high], q, surface, &high);
	*out = colour_mix(low, high, b.share);
	return found_low || found_high;
}

static bool average(const struct pigment_source *s, vec3 q, struct surface *surface, colour *out)
{
	colour sum = { 0, 0, 0, 0, 0 }, c;
	bool found = false;
	for (size_t i = 0; i < s->map.count; i++) {
		const float w = s->map.values[i];
		found |= pigment_colour(s->pigments[i], q, surface, &c);
		sum = (colour){ sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b,
			sum.filter + w * c.filter, sum.transmit + w * c.transmit };
	}
	const float total = s->total_weight;
	*out = (colour){ sum.r / total, sum.g / total, sum.b / total, sum.filter / total,
		sum.transmit / total };
	return found;
}

vec3 surface_uv_point(const struct surface *surface)
{
	double uv[2] = { 0, 0 };
	if (surface && surface->hit)
		object_uv(surface->hit, surface->point, uv);
	return vec(uv[0], uv[1], 0);
}

bool pigment_evaluate(const struct pigment *pigment, vec3 p, struct surface *surface, colour *out)
{
	const struct pigment_source *s = pigment->source;
	if (s->kind == PIGMENT_UV)
		return pigment_colour(s->pigments[0], surface_uv_point(surface), surface, out);
	const vec3 q = pattern_warp(&s->pattern, p);
	if (s->kind == PIGMENT_AVERAGE)
		return average(s, q, surface, out);
	const double v = pattern_value(&s->pattern, q, surface);
	if (s->kind == PIGMENT_PIGMENTS)
		return from_pigments(s, v, q, surface, out);
	*out = from_colours(s, v);
	return true;
}
