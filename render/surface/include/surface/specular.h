/* SPDX-License-Identifier: MIT */
/*
 * Mirrors and refraction: how much, and which way.
 */
#ifndef LAMBERT_SURFACE_SPECULAR_H
#define LAMBERT_SURFACE_SPECULAR_H

#include "surface/brdf.h"

/* Share of light reflected by a surface of relative index `eta`. */
double fresnel_reflectance(double eta, double cosine);
/* How much of each colour the lobe reflects; sets the weight of the reflected ray. */
rgb reflectivity(const struct interaction *, const struct lobe *, float *weight);
/* Mirrors the ray at the bumpy normal, kept above the smooth surface. */
vec3 mirror_direction(vec3 v, vec3 normal, vec3 geometric);
/* The direction after refraction with index ratio eta; false: total internal reflection. */
bool refract_direction(vec3 v, vec3 normal, double eta, vec3 *out);

#endif
