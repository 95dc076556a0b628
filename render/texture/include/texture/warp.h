/* SPDX-License-Identifier: MIT */
/*
 * Warps: steps that move a point on its way into a pattern.
 */
#ifndef LAMBERT_TEXTURE_WARP_H
#define LAMBERT_TEXTURE_WARP_H

#include "base/transform.h"

struct turbulence {
	vec3 amount;
	int octaves; /* 1 to 10 */
	float omega, lambda;
};

/* One step. */
struct warp {
	vec3 (*apply)(const void *self, vec3 p);
	const void *self;
};

/* The instances, each with the function that applies it. */

vec3 warp_transform(const void *transform, vec3 p); /* into the transformed space */
vec3 warp_turbulence(const void *turbulence, vec3 p);

struct warp_repeat {
	int axis; /* 0 to 2 */
	float width;
	vec3 offset, flip; /* flip: the components that are not 0 change sign in odd cells */
};
vec3 warp_repeat(const void *, vec3 p);

struct warp_black_hole {
	vec3 centre, repeat, turbulence;
	double radius, strength, falloff;
	bool inverse, repeats, turbulent, inert; /* inert: of a type that does nothing */
};
vec3 warp_black_hole(const void *, vec3 p);

/* Shared by the warps that wrap the pattern around something. */
struct warp_wrap {
	vec3 orientation; /* unit */
	double exponent, major_radius, distance;
};
vec3 warp_cylindrical(const void *, vec3 p);
vec3 warp_spherical(const void *, vec3 p);
vec3 warp_toroidal(const void *, vec3 p);
vec3 warp_planar(const void *, vec3 p);
vec3 warp_cubic(const void *, vec3 p);

#endif
