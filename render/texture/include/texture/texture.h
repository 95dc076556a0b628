/* SPDX-License-Identifier: MIT */
/*
 * The looks of a surface: textures made of layers (pigment, normal, finish),
 * and textures chosen by a pattern. Built by lower/lower_texture.c, const
 * afterwards. The formulas are in the files of render/texture and
 * render/pattern; what light does with them is in render/surface.
 */
#ifndef LAMBERT_TEXTURE_TEXTURE_H
#define LAMBERT_TEXTURE_TEXTURE_H

#include "base/colour.h"
#include "base/transform.h"
#include "geometry/object.h"

#include <stdbool.h>

struct arena;
struct normal;

/* The point being shaded, for patterns that look at more than the evaluation point. `current` is
 * the current normal that `slope` and `aoi` see; normal_perturb updates it. Skies pass NULL. */
struct surface {
	vec3 point;	/* in the world */
	vec3 direction; /* of the arriving ray, unit */
	vec3 geometric; /* the shape's normal turned against the ray, unit */
	vec3 current;
	const struct hit *hit;
};

/* A pigment. The colour of a plain one is all there is to it. */
struct pigment {
	bool is_plain;
	bool is_opaque; /* no part of it lets light through */
	colour colour;
	const struct pigment_source *source; /* of the others: pigment.h */
};

bool pigment_evaluate(const struct pigment *, vec3 p, struct surface *, colour *out);

/* Colour of a pigment at evaluation point p; false: no colour there (outside a `once` image). */
static inline bool pigment_colour(
	const struct pigment *pigment, vec3 p, struct surface *surface, colour *out)
{
	if (!pigment->is_plain)
		return pigment_evaluate(pigment, p, surface, out);
	*out = pigment->colour;
	return true;
}
/* Whether no part of the pigment lets light through. */
static inline bool pigment_is_opaque(const struct pigment *pigment)
{
	return pigment->is_opaque;
}
/* The perturbed unit normal, starting from unit n. `normal` may be NULL: n itself. */
vec3 normal_perturb(const struct normal *, vec3 n, vec3 p, struct surface *);

struct finish {
	rgb ambient, emission;
	float diffuse, diffuse_back, brilliance;
	float diffuse_unscaled; /* before `albedo` */
	float phong, phong_size;
	float specular, specular_power; /* the exponent: 1 / roughness, 0 for roughness 0 */
	float metallic;
	float crand;
	float irid, irid_thickness, irid_turbulence;
	rgb reflection_max, reflection_min;
	float reflection_falloff, reflection_exponent /* stored inverted: 1/e */,
		reflection_metallic;
	bool fresnel, conserve_energy;
	float ior, caustics, refraction; /* obsolete items of finish; 0, 0 and 1 if not given */
};

struct layer {
	const struct pigment *pigment;
	const struct normal *normal; /* NULL: none */
	const struct finish *finish;
};

/* A plain texture has layers, top layer first; a patterned one is resolved to plain ones. */
struct texture {
	bool opaque;	    /* casts a full shadow; nothing behind it is ever seen */
	bool uses_uv;	    /* evaluate at (u, v, 0): object uv_mapping */
	size_t layer_count; /* 0: patterned */
	const struct layer *layers;
	const struct texture_map *map; /* of a patterned texture */
};

/* A plain texture that takes part in a shading point. */
struct texture_part {
	const struct texture *texture;
	float weight; /* the parts add up to 1 */
	vec3 p;	      /* where to evaluate it */
	const struct texture_frame
		*frame; /* enclosing patterned textures, for the normal; or NULL */
};
/* A list of them, which memory_grow lengthens. */
struct texture_parts {
	struct texture_part *items;
	size_t count, room;
};

/* Resolves maps, lists and averages at p and appends the parts. `scratch` holds the frames; it is
 * the worker's, reset after every sample. */
void texture_resolve(const struct texture *, vec3 p, struct surface *, struct texture_parts *parts,
	struct arena *scratch);
/* The perturbed normal of one layer of a part. */
vec3 texture_part_normal(const struct texture_part *, const struct layer *, struct surface *);

#endif
