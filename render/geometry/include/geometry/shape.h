/* SPDX-License-Identifier: MIT */
/*
 * What a primitive must offer: one file with one struct shape_class, and one
 * line in language/shapes.def, which says what it takes.
 *
 * A shape works in its own space. Rays given to it have unnormalised directions
 * so that the ray parameter is that of the world ray; a shape that wants a unit
 * direction normalises and divides its roots. It reports crossings; the caller
 * decides which of them matter.
 */
#ifndef LAMBERT_GEOMETRY_SHAPE_H
#define LAMBERT_GEOMETRY_SHAPE_H

#include "base/arena.h"
#include "geometry/object.h"
#include "language/shape_word.h"

#include <string.h>

/* Where the instance keeps a parameter, in the order of its row in shapes.def; items have no field. */
struct field {
	enum parameter_type type; /* FLOAT stands for OPTIONAL, VECTOR for PAIR too */
	size_t offset;
};
struct field_array {
	const double *values; /* alive until build returns */
	size_t count;	      /* numbers, not elements */
};
#define FIELD(instance, member)                                                                    \
	{                                                                                          \
		_Generic(((struct instance *)NULL)->member, double                                 \
			 : PARAMETER_FLOAT, vec3                                                   \
			 : PARAMETER_VECTOR, bool                                                  \
			 : PARAMETER_FLAG, struct field_array                                      \
			 : PARAMETER_ARRAY),                                                       \
			offsetof(struct instance, member)                                          \
	}
#define FIELD_END                                                                                  \
	{                                                                                          \
		PARAMETER_END, 0                                                                   \
	}

/* What `build` may say. The message functions of lowering stand behind the pointers. */
struct shape_build {
	struct arena *arena; /* for what the instance owns */
	void *user;
	void (*error)(void *user, const char *message);
	void (*warning)(void *user, const char *message);
	bool dropped; /* set by build: nothing to render ("degenerate triangle") */
};

/* The points with normal . p <= distance; the normal is unit. */
struct half_space {
	vec3 normal;
	double distance;
};
enum { SHAPE_HALF_SPACES = 8 };

struct shape_class {
	const char *name;	    /* the word of the scene language */
	size_t size;		    /* of the instance */
	const struct field *fields; /* NULL: lowering makes the instance itself (csg, glyph) */
	bool is_patch;		    /* has no inside */
	bool is_compound;	    /* children are objects and hits already name their leaf */
	bool reaches_out;	    /* its inside goes on beyond its bounds (disc) */
	bool is_convex;		    /* holds every segment between two of its points */
	bool moves_extent;	    /* transformations move its extent instead of making it anew */
	bool keeps_normal_inverted; /* `inverse` does not negate the raw normal (plane, quadric) */

	/* Checks the parameters and derives what tracing needs. NULL: nothing to do. */
	void (*build)(void *self, struct shape_build *);
	/* Takes a transformation into the instance's own parameters if that is exact; false: the
	 * object keeps it as its place. NULL: never. */
	bool (*absorb)(void *self, const transform *);
	/* Takes in each transformation as it comes, for shapes to which one written as `scale` means
	 * something else. NULL: all of them at the end, by absorb or as place. */
	void (*step)(void *self, const transform *, bool is_scale);
	/* Turns the instance inside out by itself (plane); NULL: the object's flag does it. */
	void (*invert)(void *self);
	/* In shape space; box_everything() when unbounded. */
	box (*bounds)(const void *self);
	/* The box that min_extent and max_extent tell of, with what `place` (NULL: nothing) moves.
	 * NULL: the box of the bounds' moved corners. */
	box (*extent)(const void *self, const transform *place);
	/* The part of a box that the inside may reach, for the extent of intersections. NULL: what
	 * is also in the extent. */
	box (*extent_within)(const void *self, box);
	/* A sphere around it that is much tighter than its box, in shape space; rays that miss it are
	 * not even asked about. NULL or false: none. */
	bool (*enclosing_sphere)(const void *self, vec3 *centre, double *radius);
	/* The first crossing with tmin <= t < tmax. NULL: found through `hits`. */
	bool (*nearest)(const void *self, const ray *, double tmin, double tmax, struct hit *);
	/* Every crossing with tmin < t < tmax. */
	void (*hits)(const void *self, const ray *, double tmin, double tmax, struct hits *);
	/* For convex shapes with an inside: where the ray is inside, as near as `inside` can tell;
	 * false if it misses. */
	bool (*chord)(const void *self, const ray *, struct chord *);
	/* Whether chord may be asked of this instance. NULL: always. */
	bool (*has_chord)(const void *self);
	/* For shapes with an unbounded inside: half-spaces that hold the inside and what is hit, at most
	 * SHAPE_HALF_SPACES; their count. */
	size_t (*half_spaces)(const void *self, struct half_space *);
	/* Whether a point of the surface counts is the language's choice, shape by shape. NULL for
	 * patches. */
	bool (*inside)(const void *self, vec3 p);
	/* Outward, any length. */
	vec3 (*normal)(const void *self, const struct hit *, vec3 p);
	/* NULL: world x and y. `absorbed`: the transformation the instance has taken in since it
	 * was written, or NULL; only a shape that absorbs more than moving needs it. */
	void (*uv)(const void *self, const struct hit *, vec3 p, const transform *absorbed,
		double uv[2]);
};

/* The box of a box's corners in their place (NULL: where they are). */
static inline box box_placed(box b, const transform *place)
{
	return place && !box_is_empty(b) ? transform_box(place, b) : b;
}

/* The neighbours of t among the doubles. */
static inline double double_after(double t)
{
	uint64_t bits;
	memcpy(&bits, &t, sizeof bits);
	bits = t > 0 ? bits + 1 : t < 0 ? bits - 1 : 1;
	memcpy(&t, &bits, sizeof t);
	return t;
}
static inline double double_before(double t)
{
	return -double_after(-t);
}

/* The class of a scene-language word, or NULL. */
const struct shape_class *shape_find(const char *word);

/* CSG, for lowering. Children in scene order; inside tests of patches are false. */
enum csg_kind { CSG_UNION, CSG_MERGE, CSG_INTERSECTION };
struct csg {
	enum csg_kind kind;
	size_t count, unseen;		      /* of a union or merge: then come some more … */
	const struct object *const *children; /* … whose inside counts, but not their surface */
};
extern const struct shape_class shape_csg;

#endif
