/* SPDX-License-Identifier: MIT */
/*
 * One ray goes on through a plain texture, bent by the top layer's normal and
 * tinted by all layers, or is totally reflected.
 */
#include "surface/transmission.h"

#include "base/elementary.h"
#include "medium/interior.h"
#include "surface/brdf.h"
#include "surface/specular.h"

void transmission_find(const struct worker *w, const struct interaction *it,
	const struct layers *layers, struct transmission *out)
{
	const struct settings *settings = &w->scene->settings;
	const struct interior_stack *inside = it->interiors;
	out->present = settings->quality >= 6 && layers->clear > settings->adc_bailout;
	if (!out->present)
		return;

	const struct lobe *top = &layers->lobes[0];
	const struct interior *interior = object_interior(it->object);
	const vec3 v = it->surface.direction;
	const double eta = interior_stack_ratio(inside, interior);
	out->straight = fabs(eta - 1) < NEARLY_ZERO;
	out->total = false;
	out->direction = v;
	if (!out->straight && !refract_direction(v, top->normal, eta, &out->direction)) {
		out->total = true;
		out->direction = mirror_direction(v, top->normal, it->surface.geometric);
	}

	rgb factor = rgb_grey(top->finish->refraction);
	if (out->total && top->finish->irid > 0)
		factor = rgb_mul(factor, irid_factor(w, it, top, out->direction));
	if (interior_stack_has(inside, interior))
		factor = rgb_mul(factor, interior_fading(interior, it->depth));
	out->weight = rgb_max_abs(layers->tint);
	out->transmit = out->total ? 0 : rgb_luminance(factor);
	if (!out->total && layers->tinted) {
		out->transmit *= layers->clear;
		factor = rgb_mul(factor, layers->tint);
	}
	out->factor = factor;
}
