/* SPDX-License-Identifier: MIT */
/*
 * Kinds of lights. To add one, write a file beside spotlight.c and add its line
 * to lights.def.
 */
#ifndef LAMBERT_LIGHT_LIGHT_H
#define LAMBERT_LIGHT_LIGHT_H

#include "scene/scene.h"

struct light_class {
	const char *name; /* the word of the language */
	bool is_parallel; /* its light has one direction */
	bool casts_shadows, makes_highlights;
	/* Cones have a radius and a falloff: the defaults, in degrees if they are angles. */
	bool has_cone, has_angles;
	double radius, falloff;
	/* The share of light inside the cone, at p, for a light `distance` away in `direction`. NULL
	 * without a cone. */
	double (*cone)(const struct light *, const vec3 *p, const vec3 *direction, double distance);
};

/* The class of a word, or NULL. */
const struct light_class *light_find(const char *word);

/* The unit direction from p towards the light, seen as standing at `centre`, and the distance as
 * the light counts it (negative behind a parallel light). */
double light_direction(const struct light *, vec3 centre, vec3 p, vec3 *direction);
/* Whether cone or distance take anything of the light. */
static inline bool light_attenuates(const struct light *light)
{
	return light->kind->cone || light->fade_power > 0;
}
/* What they leave of it. */
double light_attenuation(
	const struct light *, const vec3 *p, const vec3 *direction, double distance);

#endif
