/* SPDX-License-Identifier: MIT */
/*
 * Lobes: the ways a surface sends light on. A lobe is one layer of a texture at
 * one point. brdf_eval and brdf_reflect answer light from a direction, whoever
 * sends it; a lobe that is a mirror, too, takes `mirror` of the light from its
 * mirror_direction (specular.h).
 */
#ifndef LAMBERT_SURFACE_BRDF_H
#define LAMBERT_SURFACE_BRDF_H

#include "base/elementary.h"
#include "surface/interaction.h"

struct lobe {
	const struct finish *finish;
	vec3 normal;	  /* shading normal, unit */
	rgb pigment;	  /* its colour */
	float own;	  /* share of its own colour: 1 - what comes through */
	rgb weight;	  /* what the layers above let through of its light */
	rgb mirror;	  /* what it reflects of light from the mirror direction; not weighted */
	float importance; /* of that light, for adc_bailout */
	uint32_t number;  /* among all lobes of the interaction */
};

/* Whether light from somewhere matters: the lobe is more than a mirror. */
static inline bool lobe_scatters(const struct lobe *lobe)
{
	const struct finish *f = lobe->finish;
	return f->diffuse != 0 || f->diffuse_back != 0 || f->phong != 0 || f->specular != 0;
}
static inline bool lobe_is_mirror(const struct lobe *lobe)
{
	return !rgb_is_zero(lobe->mirror);
}

/* How light may arrive at a lobe. */
enum brdf_light {
	BRDF_HIGHLIGHTS = 1, /* it makes them */
	BRDF_BOTH_SIDES = 2, /* it does not matter which side it is on */
};
/* What a lobe sends to the viewer of light of strength 1. */
struct brdf_value {
	double diffuse, highlight;
	double cosine;	/* of normal and light */
	bool has_grain; /* crand */
};
/* Phong's and Blinn's highlights. */
double brdf_highlight(const struct interaction *, const struct lobe *, const vec3 *direction);

/* False: nothing. `direction` leads to the light, `how` has bits of enum brdf_light. */
static inline bool brdf_eval(const struct interaction *it, const struct lobe *lobe,
	const vec3 *direction, unsigned how, struct brdf_value *out)
{
	const struct finish *f = lobe->finish;
	const double cosine = vec_dot(lobe->normal, *direction);
	const bool behind = !(how & BRDF_BOTH_SIDES) && cosine < NEARLY_ZERO;
	const double k = behind ? f->diffuse_back : f->diffuse;
	if (behind && k == 0)
		return false;

	const bool shines = !behind && (how & BRDF_HIGHLIGHTS) && (f->phong > 0 || f->specular > 0);
	out->cosine = cosine;
	out->diffuse = k > 0 ? k * (f->brilliance == 1 ? fabs(cosine)
						       : power_of(fabs(cosine), f->brilliance))
			     : 0;
	out->highlight = shines ? brdf_highlight(it, lobe, direction) : 0;
	out->has_grain = k > 0 && f->crand > 0;
	return out->diffuse != 0 || out->highlight != 0 || out->has_grain;
}

/* Colour shift of metallic highlights and reflections: 1 + metallic (1 - Fr)(pigment - 1). */
rgb metallic_factor(float metallic, rgb pigment, double cosine);
/* Iridescence: factors for light from `direction`. */
rgb irid_factor(
	const struct worker *, const struct interaction *, const struct lobe *, vec3 direction);

/* crand: the random share of each light's light that is missing, by lobe. */
double brdf_grain(
	const struct worker *, const struct interaction *, const struct lobe *, uint32_t light);

/* The light sent to the viewer of `arriving`. `light` numbers the light, for random numbers. */
static inline rgb brdf_reflect(const struct worker *w, const struct interaction *it,
	const struct lobe *lobe, const vec3 *direction, const struct brdf_value *value,
	rgb arriving, uint32_t light)
{
	const struct finish *f = lobe->finish;
	double diffuse = value->diffuse * lobe->own;
	if (value->has_grain)
		diffuse -= brdf_grain(w, it, lobe, light);
	rgb sum = rgb_scale(rgb_mul(lobe->pigment, arriving), diffuse);
	if (value->highlight != 0) {
		if (f->metallic > 0)
			arriving = rgb_mul(arriving,
				metallic_factor(f->metallic, lobe->pigment, value->cosine));
		sum = rgb_add(sum, rgb_scale(arriving, value->highlight));
	}
	if (f->irid > 0)
		sum = rgb_mul(sum, irid_factor(w, it, lobe, *direction));
	return sum;
}

#endif
