/* SPDX-License-Identifier: MIT */
/*
 * Layers are gone through from the top. Each shows its own light tinted by those
 * above it, until hardly anything comes through; a viewer does not look at the
 * rest. Shadows take the tints of all layers.
 */
#include "surface/layers.h"

#include "base/elementary.h"
#include "medium/interior.h"
#include "surface/specular.h"
#include "texture/texture.h"

/* The perturbed normal of a layer. */
static vec3 layer_normal(const struct worker *w, const struct texture_part *part,
	const struct layer *layer, struct surface *s)
{
	if (!layer->normal || w->scene->settings.quality < 8)
		return s->geometric;
	if (part->frame)
		return texture_part_normal(part, layer, s);
	return normal_perturb(layer->normal, s->geometric, part->p, s);
}

/* Share of its own colour a layer shows. */
static float own_share(colour c, int version)
{
	if (version >= 370)
		return colour_opacity(c);
	return 1 - (c.filter * rgb_max(colour_rgb(c)) + c.transmit);
}

static rgb energy_left(rgb reflected)
{
	return (rgb){ fminf(1, 1 - reflected.r), fminf(1, 1 - reflected.g),
		fminf(1, 1 - reflected.b) };
}

/* Sets what the lobe reflects like a mirror, seen through what is above it; returns its share. */
static rgb set_mirror(
	const struct worker *w, const struct interaction *it, float clear, struct lobe *lobe)
{
	const struct finish *f = lobe->finish;
	lobe->mirror = rgb_grey(0);
	if (rgb_is_zero(f->reflection_max) && rgb_is_zero(f->reflection_min))
		return lobe->mirror;
	float weight;
	const rgb amount = reflectivity(it, lobe, &weight);
	if (w->scene->settings.quality >= 8) {
		lobe->mirror = amount;
		lobe->importance = clear * weight;
	}
	return amount;
}

/* The lobe of a layer below others that let `out` through, and what that leaves for the next. */
static void layer_open(const struct worker *w, struct interaction *it,
	const struct texture_part *part, const struct layer *layer, struct lobe *lobe,
	struct layers *out)
{
	const struct settings *settings = &w->scene->settings;
	colour c = { 1, 1, 1, 0, 1 };
	lobe->finish = layer->finish;
	lobe->normal = layer_normal(w, part, layer, &it->surface);
	const bool found = pigment_colour(layer->pigment, part->p, &it->surface, &c);
	lobe->pigment = colour_rgb(c);
	lobe->own = own_share(c, settings->version);
	lobe->weight = out->tint;
	if (settings->quality >= 2) {
		const rgb reflected = set_mirror(w, it, out->clear, lobe);
		if (found && layer->finish->conserve_energy)
			out->tint = rgb_mul(out->tint, energy_left(reflected));
	}
	if (found) {
		out->tint = rgb_mul(out->tint, colour_tint(c));
		out->tinted = true;
	}
	const float clear = fabsf(rgb_luminance(out->tint));
	out->clear = clear < 1 ? clear : 1;
}

void layers_open(struct worker *w, struct interaction *it, const struct texture_part *part,
	uint32_t numbered, struct layers *out)
{
	const struct texture *texture = part->texture;
	struct lobe *lobes = texture->layer_count <= LOBES_FEW
				     ? out->few
				     : ARENA_ARRAY(w->scratch, texture->layer_count, struct lobe);
	size_t count = 0;
	out->tint = rgb_grey(1);
	out->clear = 1;
	out->tinted = false;
	it->surface.current = it->surface.geometric;
	while (count < texture->layer_count && out->clear > w->scene->settings.adc_bailout) {
		lobes[count].number = numbered + (uint32_t)count;
		layer_open(w, it, part, &texture->layers[count], &lobes[count], out);
		count++;
	}
	out->lobes = lobes;
	out->count = count;
}

/* The share of light a part lets through. */
static rgb part_tint(const struct worker *w, struct interaction *it,
	const struct texture_part *part, double caustics)
{
	struct surface *s = &it->surface;
	rgb tint = rgb_grey(1);
	s->current = s->geometric;
	for (size_t i = 0; i < part->texture->layer_count; i++) {
		const struct layer *layer = &part->texture->layers[i];
		const vec3 normal = layer_normal(w, part, layer, s);
		colour c;
		if (pigment_colour(layer->pigment, part->p, s, &c))
			tint = rgb_mul(tint, colour_tint(c));
		if (caustics != 0)
			tint = rgb_scale(tint,
				1 + elementary_pow(fabs(vec_dot(normal, s->direction)), caustics));
	}
	return tint;
}

rgb layers_tint(struct worker *w, struct interaction *it)
{
	const double caustics = object_interior(it->object)->caustics;
	if (it->parts == &it->whole)
		return part_tint(w, it, &it->whole, caustics);
	rgb tint = rgb_grey(0);
	for (size_t i = 0; i < it->part_count; i++) {
		const struct texture_part *part = &it->parts[i];
		tint = rgb_add(tint, rgb_scale(part_tint(w, it, part, caustics), part->weight));
	}
	return tint;
}
