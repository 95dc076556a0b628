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

/* What few drafts have. */
struct draft_extras {
	struct draft *children;
	shape_road *road; /* of DRAFT_MADE */
	struct light *light;
	struct draft *looks_like, *projected_through;
	struct looks *interior_texture;
	struct draft_interior *interior;
	struct draft *clips, *bounds;
	struct extent *extent; /* NULL unless the lowering keeps them */
};

/* A large union has millions: what is not needed by most stands in the extras. */
struct draft {
	struct draft *next;
	const struct node *node;

	/* The object a shape will be, and the shape's data, which stand behind it. */
	struct object *object;
	const struct shape_class *shape;
	void *self;
	const transform *place; /* never written to, since drafts share it; NULL: not moved */

	struct looks *texture;
	const struct draft_extras *extras; /* to be written through draft_extras */

	enum draft_kind kind : 8;
	enum csg_kind csg : 8;
	bool is_difference : 1;	   /* written as difference: for messages */
	bool split_union : 1;	   /* may be dissolved */
	bool global_lights : 1;	   /* of a light_group */
	bool bounds_are_clips : 1; /* one list for both: transformed once */
	bool inverted : 1, uv_mapping : 1;
	bool hollow : 1, hollow_set : 1, double_illuminate : 1;
	bool no_shadow : 1, no_image : 1, no_reflection : 1;
};

/* The draft's own extras, made when first written to. */
struct draft_extras *draft_extras(struct lowering *, struct draft *);
/* Where it has been moved to: at first the identity. */
transform draft_place(const struct draft *);

/* An object statement, or a reference to one. NULL after an error. */
struct draft *draft_from_node(struct lowering *, const struct node *);
/* A copy but for lights and interiors: what rays enter and leave stays the same. */
struct draft *draft_twin(struct lowering *, const struct draft *);
/* The first object of a block (looks_like { … }) with the block's modifiers applied. */
struct draft *draft_from_block(struct lowering *, const struct node *);
bool node_is_object(const struct node *);

/* One transformation of a statement, and where it brought the latest draft: mostly the others of a
 * union come from the same place. */
struct step {
	transform t;
	bool is_scale; /* written as scale */
	const transform *from, *to;
};
struct step lower_step(struct lowering *, const struct node *item);

/* Drafts more members of a compound whose statement has not come yet. */
void draft_members(struct lowering *, span word, const struct node *first);

/* Moves everything that is attached so far. */
void draft_transform(struct lowering *, struct draft *, struct step *);
/* The same with each of a list. */
void drafts_transform(struct lowering *, struct draft *, struct step *);

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
