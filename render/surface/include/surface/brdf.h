/* SPDX-License-Identifier: MIT */
/*
 * Lobes: the ways a surface sends light on. A lobe is one layer of a texture at
 * one point. brdf_eval and brdf_reflect answer light from a direction, whoever
 * sends it; a lobe that is a mirror, too, takes `mirror` of the light from its
 * mirror_direction (specular.h).
 */
#ifndef LAMBERT_SURFACE_BRDF_H
#define LAMBERT_SURFACE_BRDF_H

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
/* False: nothing. `direction` leads to the light, `how` has bits of enum brdf_light. */
bool brdf_eval(const struct interaction *, const struct lobe *, const vec3 *direction, unsigned how,
	struct brdf_value *);
/* The light sent to the viewer of `arriving`. `light` numbers the light, for random numbers. */
rgb brdf_reflect(const struct worker *, const struct interaction *, const struct lobe *,
	const vec3 *direction, const struct brdf_value *, rgb arriving, uint32_t light);

/* Colour shift of metallic highlights and reflections: 1 + metallic (1 - Fr)(pigment - 1). */
rgb metallic_factor(float metallic, rgb pigment, double cosine);
/* Iridescence: factors for light from `direction`. */
rgb irid_factor(
	const struct worker *, const struct interaction *, const struct lobe *, vec3 direction);

#endif
