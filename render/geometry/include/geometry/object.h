/* SPDX-License-Identifier: MIT */
/*
 * Objects: a shape in its place with its looks, and what a ray finds of it.
 * Built by lowering, const afterwards.
 *
 * A leaf object has a shape of its own surface (sphere, torus, mesh …). A
 * compound one (merge, intersection, difference, a union that must be kept) has
 * a CSG shape whose children are objects again. Transformations are pushed down
 * to the leaves, so a leaf's transform leads straight to the world.
 */
#ifndef LAMBERT_GEOMETRY_OBJECT_H
#define LAMBERT_GEOMETRY_OBJECT_H

#include "base/transform.h"
#include "base/vec3.h"

#include <stddef.h>
#include <stdint.h>

struct shape_class;
struct texture;
struct interior;
struct object;

/* Smallest accepted distance of any hit along a ray, in world units. */
#define T_MIN 1e-4
/* A surface must be this far from the lit point, and from the light, to shadow. */
#define T_SHADOW 1e-3
/* Depth of a ray that hits nothing. */
#define T_MISS 2e10

/* Kinds of rays, as bits of object.visible_to. */
enum ray_kind {
	RAY_CAMERA = 1,	       /* from the camera, possibly refracted since */
	RAY_REFLECTED = 2,     /* reflected at least once */
	RAY_SHADOW_OPAQUE = 4, /* set if the object blocks light completely */
	RAY_SHADOW_TINTED = 8, /* set if it casts a shadow but may let light through */
	RAY_SECONDARY =
		16, /* refracted or continued, never reflected: see no_image in kept unions */
	RAY_ALL = 31,
};

/* What few objects have. */
struct object_extras {
	const struct object *const *clips;     /* a hit counts only inside all of them */
	const struct object *const *bounds_by; /* kept bounded_by objects */
	uint32_t clip_count, bound_count;
	const transform *uv_place; /* what a shape with uv coordinates has absorbed, or NULL */
	const struct texture *interior_texture;
	const struct light *const
		*lights; /* of the light groups it is in; NULL-terminated, or NULL */
};

/* There may be millions: what is not needed by most stands in the extras. */
struct object {
	const struct shape_class *shape;
	const void *self;		    /* the shape's own data, in its own space */
	const transform *place;		    /* shape space to world; NULL: the same */
	const struct object_extras *extras; /* NULL: none */
	box bounds;	    /* world, after clipping and bounding; may be unbounded */
	uint32_t rank;	    /* wins exact ties by the lower rank */
	uint8_t visible_to; /* enum ray_kind bits */
	bool inverted;	    /* `inverse`: complement, normal negated */
	bool is_repeat; /* another object is the same to other rays: not counted twice around a point */
	bool hollow, double_illuminate;
	bool uv_mapping;
	bool has_chord;	    /* object_chord may be asked; set with the bounds */
	bool reaches_out;   /* its inside goes on beyond the bounds; set with them */
	bool normal_stays;  /* raw normal is not negated by `inverted` (quadric) */
	bool global_lights; /* lit by the scene's lights */
	const struct texture *texture;
	const struct interior *interior;
};

/* One crossing of a ray with a surface. */
struct hit {
	double t;		     /* parameter of the world ray */
	const struct object *object; /* the leaf that was hit */
	uint32_t part;		     /* for the shape: face, contour, triangle … */
	double u, v;		     /* for the shape: barycentrics, spline parameter … */
};

/* Where a ray is inside something convex: between t[0] and t[1], infinite where that does not end.
 * The finite ends are hits, with these parts. */
struct chord {
	double t[2];
	uint32_t part[2];
};
/* What is nearer to an end of a chord than this share of 1 + t is decided by its point alone: there
 * surfaces may coincide, and shapes have a skin. */
#define CHORD_SLACK 1e-9

/* A growing list of hits. Zero-initialise, or hits_init with a buffer of the caller, which spares
 * the allocation in all usual cases; release with hits_release. */
struct hits {
	struct hit *items;
	size_t count, room;
	bool borrowed; /* items is the caller's buffer */
};
/* Hits a caller on the render path should have room for on its stack. */
#define HITS_ROOM 16
void hits_init(struct hits *, struct hit *buffer, size_t room);
/* Appends a hit with the given parameter; object is filled in by object_hits. */
struct hit *hits_push(struct hits *, double t);
void hits_release(struct hits *);

/* Appends every crossing with tmin < t < tmax that survives clipping (unordered). */
void object_hits(const struct object *, const ray *, double tmin, double tmax, struct hits *);
/* The nearest crossing with tmin <= t < tmax, *found unchanged when there is none. Among equal t
 * of one object the crossing generated last wins. */
bool object_nearest(
	const struct object *, const ray *, double tmin, double tmax, struct hit *found);
/* Where the ray is inside the shape, inversion left aside; false if it misses. Only where has_chord
 * is set: the object is convex and not clipped. */
bool object_chord(const struct object *, const ray *, struct chord *);
/* Inversion and clips included. Always false for patches. */
bool object_inside(const struct object *, vec3 p);
/* The same, but clips end only what is endless: the inside of all else stays as it was. */
bool object_surrounds(const struct object *, vec3 p);
/* Whether the object has an inside at all. */
bool object_is_solid(const struct object *);
/* Raw outward normal in the world: unit, negated for inverted objects, not turned to the viewer.
 * `p` is the world point of the hit. */
vec3 object_normal(const struct hit *, vec3 p);
/* uv coordinates of a hit; shapes without their own give the world x and y. */
void object_uv(const struct hit *, vec3 p, double uv[2]);
/* The part of b that the objects leave of it, those that are inside out apart. Their own bounds
 * are set before. */
box box_cut(box b, const struct object *const *objects, size_t count);
/* Fills `bounds` from shape, place, clips and kept bounds, whose own bounds are set before (called
 * once by lowering, when all else is set). Empty, see box_is_empty, when nothing can be hit. */
void object_set_bounds(struct object *);

#endif
