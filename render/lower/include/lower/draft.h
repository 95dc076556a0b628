/* SPDX-License-Identifier: MIT */
/*
 * Objects while their statement is read. The language transforms, inverts and
 * textures objects step by step, moving what is attached so far; a draft holds
 * that state and becomes final objects when the statement at the top level is
 * complete. A declared object is drafted once and copied for each use.
 */
#ifndef LAMBERT_LOWER_DRAFT_H
#define LAMBERT_LOWER_DRAFT_H

#include "lower/lower.h"
#include "geometry/shape.h"
#include "lower/road.h"

enum draft_kind {
	DRAFT_SHAPE, /* shape, self, place */
	DRAFT_MADE,  /* node, road, place: becomes the objects its road makes */
	DRAFT_CSG,   /* csg, children */
	DRAFT_LIGHT, /* light */
	DRAFT_GROUP, /* a light_group: csg, children */
};

/* An interior under construction; shared by the children of a CSG object. */
struct draft_interior {
	struct interior data;
	struct interior *finished; /* NULL: no leaf yet */
};

/* A texture under construction and its finished form. */
struct looks {
	struct texture_state *state;
	const struct texture *finished;
};

/* The box of an object as the language counts it, see extent.c. */
struct extent {
	box box;
	transform absorbed, rest; /* by the shape, and what came after */
	bool has_rest, inverted;
};

struct draft {
	enum draft_kind kind;
	const struct node *node;
	struct draft *next, *children;

	const struct shape_class *shape;
	shape_road *road;
	void *self;
	transform place;
	bool is_placed;

	enum csg_kind csg;
	bool is_difference; /* written as difference: for messages */
	bool split_union;   /* may be dissolved */

	struct light *light;
	struct draft *looks_like, *projected_through;
	bool global_lights; /* of a light_group */

	struct looks *texture, *interior_texture;
	struct draft_interior *interior;
	struct draft *clips, *bounds;
	bool bounds_are_clips; /* one list for both: transformed once */
	struct extent *extent; /* NULL unless the lowering keeps them */
	bool inverted, uv_mapping;
	bool hollow, hollow_set, double_illuminate;
	bool no_shadow, no_image, no_reflection;
};

/* An object statement, or a reference to one. NULL after an error. */
struct draft *draft_from_node(struct lowering *, const struct node *);
/* A copy but for lights and interiors: what rays enter and leave stays the same. */
struct draft *draft_twin(struct lowering *, const struct draft *);
/* The first object of a block (looks_like { … }) with the block's modifiers applied. */
struct draft *draft_from_block(struct lowering *, const struct node *);
bool node_is_object(const struct node *);

/* One transformation of a statement. */
struct step {
	transform t;
	bool is_scale; /* written as scale */
};
struct step lower_step(struct lowering *, const struct node *item);

/* Moves everything that is attached so far. */
void draft_transform(struct lowering *, struct draft *, const struct step *);
/* The same with each of a list. */
void drafts_transform(struct lowering *, struct draft *, const struct step *);

/* lower_modifiers.c: the items of an object statement that are not objects. */
void draft_modify(struct lowering *, struct draft *, const struct node *item);
void draft_invert(struct lowering *, struct draft *);
/* Whether it has no inside, or a part without one. */
bool draft_is_patch(const struct draft *);
/* Whether the item is a flag word of the draft's shape. */
bool draft_takes_flag(const struct draft *, const struct node *item);

/* extent.c: gives the draft its extent, if the lowering keeps them; its shape or children are there. */
void extent_begin(struct lowering *, struct draft *);
/* Of drafts that have one: moved, turned inside out, clipped once more, at the end of their modifiers. */
void extent_move(struct lowering *, struct draft *, const transform *);
void extent_invert(struct lowering *, struct draft *);
void extent_clip(struct lowering *, struct draft *);
void extent_cut(struct draft *);

/* lower_light.c */
void light_defaults(struct light *);
void lower_light_items(struct lowering *, const struct node *, struct draft *);
void light_transform(struct light *, const transform *);
void light_finish(struct light *);

/* lower_atmosphere.c */
struct draft_interior *lower_interior(
	struct lowering *, const struct node *, const struct draft_interior *start);

/* finish_object.c: adds what a complete top-level draft stands for to the scene. */
void draft_emit(struct lowering *, struct draft *, const struct language_state *);

/* The statements of the top level (lower_camera.c, lower_atmosphere.c, lower_settings.c). */
void lower_camera(struct lowering *, const struct node *);
void lower_default_camera(struct lowering *, const struct defaults *);
void lower_fog(struct lowering *, const struct node *);
void lower_sky_sphere(struct lowering *, const struct node *);
void lower_background(struct lowering *, const struct node *);
void lower_global_settings(struct lowering *, const struct node *);
/* One item of global_settings; old scenes have some at the top level. */
void lower_setting(struct lowering *, const struct node *item);
/* Before the first statement: the defaults. */
void settings_begin(struct lowering *);

#endif
