/* SPDX-License-Identifier: MIT */
/*
 * What comparisons see of samples; see contrast.h.
 */
#include "contrast.h"

#include "base/arena.h"

#include <math.h>
#include <stdlib.h>

/* Exponents this near to one are one, as in the reference. */
#define EXPONENT_ONE 0.01

/* Linear light to the power of 1 / gamma. */
void contrast_init(
	struct contrast *c, const struct antialias *settings, const struct working_space *working)
{
	const double gamma = settings->gamma;
	c->threshold = settings->threshold;
	if (!(gamma > 0))
		return;
	const bool power = working->transfer == TRANSFER_POWER;
	const double exponent = (power ? (double)working->gamma : 1) / gamma;
	c->decodes_srgb = working->transfer == TRANSFER_SRGB;
	c->encodes = c->decodes_srgb || fabs(1 - exponent) > EXPONENT_ONE;
	if (c->decodes_srgb)
		power_curve_init(&c->srgb, 2.4f);
	if (c->encodes)
		power_curve_init(&c->gamma, (float)exponent);
}

static float srgb_decode(const struct contrast *c, float x)
{
	return x < 0.04045f ? x / 12.92f : power_curve_at(&c->srgb, (x + 0.055f) / 1.055f);
}

static float encode(const struct contrast *c, float x)
{
	if (c->decodes_srgb)
		x = srgb_decode(c, x);
	return power_curve_at(&c->gamma, x < 0 ? 0 : x); /* NaN stays, and compares as equal */
}

struct sample contrast_sample(const struct contrast *c, colour seen)
{
	struct sample out = { .colour = seen, .code = { seen.r, seen.g, seen.b } };
	if (c->encodes) {
		for (int k = 0; k < 3; k++)
			out.code[k] = encode(c, out.code[k]);
	}
	return out;
}

/* NaN counts as equal. */
bool contrast_differs(const struct contrast *c, const struct sample *a, const struct sample *b)
{
	const float distance = fabsf(a->code[0] - b->code[0]) + fabsf(a->code[1] - b->code[1]) +
			       fabsf(a->code[2] - b->code[2]) +
			       fabsf(a->colour.transmit - b->colour.transmit);
	return (double)distance >= c->threshold;
}

void contrast_row(const struct contrast *c, const struct sampler *s, int32_t x, int32_t y,
	double shift, size_t count, struct sample *out)
{
	enum { TOGETHER = 64 };
	colour seen[TOGETHER];
	for (size_t done = 0; done < count; done += TOGETHER) {
		const size_t n = count - done < TOGETHER ? count - done : TOGETHER;
		sampler_row(s, x + (int32_t)done, y, shift, n, seen);
		for (size_t i = 0; i < n; i++)
			out[done + i] = contrast_sample(c, seen[i]);
	}
}

struct sample *sample_room_for(struct sample_room *room, struct block b)
{
	const size_t count = (size_t)(1 + b.right - b.left) * (1 + b.bottom - b.top);
	if (count > room->count) {
		free(room->samples);
		room->samples = memory_alloc(count, sizeof *room->samples);
		room->count = count;
	}
	return room->samples;
}
