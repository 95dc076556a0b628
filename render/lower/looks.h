/* SPDX-License-Identifier: MIT */
/*
 * Pigments, normals and textures while their statements are read. Each is a state
 * that starts as a copy of another one (the default, or an identifier) and is
 * changed by the items of its block; once read it never changes again, so states are
 * shared freely. Building makes the render form of a state, once.
 *
 * All of it lives in the scene's arena.
 */
#ifndef LAMBERT_LOWER_LOOKS_H
#define LAMBERT_LOWER_LOOKS_H

#include "lower/lower.h"
#include "texture/pattern.h"
#include "texture/map.h"
#include "texture/normal.h"
#include "texture/pigment.h"
#include "texture/texture_map.h"

/* ---- memory of what has been lowered: lower_texture.c ---- */

/* The state made of a declared node, or NULL. */
void *looks_find(struct lowering *, const void *key);
void looks_remember(struct lowering *, const void *key, void *state);

/* What a pigment, normal or patterned texture is made of.
 * REFUSED: reported as not supported; what follows in the block is not looked at. */
enum look_form { FORM_NONE, FORM_PLAIN, FORM_PATTERN, FORM_AVERAGE, FORM_UV, FORM_REFUSED };

/* ---- patterns: lower_pattern.c, lower_warp.c ---- */

/* Transformations and warps of an item, newest first; neighbouring transformations are merged. */
struct warp_step {
	const struct warp_step *before;
	const transform *place; /* NULL: a warp */
	struct warp warp;
};

struct pattern_state {
	const struct pattern_class *class; /* NULL: none, or `average` */
	const void *self;		   /* its parameters as written */
	span word;			   /* where it is named */
	const struct warp_step *steps;
	struct turbulence turbulence;
	bool has_turbulence;
	enum wave wave;
	float frequency, phase, exponent;
	int noise_generator; /* 0: the scene's */
};

extern const struct pattern_state pattern_state_fresh;
/* An item that is no word of its block's own: a modifier that all share, or what names the pattern;
 * then true. */
bool pattern_state_item(struct lowering *, struct pattern_state *, const struct node *item,
	const char *block, enum look_form *form);
void pattern_state_move(struct lowering *, struct pattern_state *, const transform *);
const struct warp_step *lower_warp(
	struct lowering *, const struct node *, const struct warp_step *before);
void pattern_build(struct lowering *, const struct pattern_state *, struct pattern *out);

/* ---- maps: lower_map.c ---- */

struct map_state {
	size_t count;
	bool is_list;
	float *values;
	colour *colours;	    /* of a colour map or list */
	const void **items;	    /* pigment, normal or texture states */
	struct slope_entry *slopes; /* of a slope map */
};

/* Reads one entry or list item that is a statement of its own kind. */
typedef const void *map_entry_reader(struct lowering *, const struct node *);

/* A map statement, or a reference to one. `entry` reads the bodies; NULL: colours or slopes. */
const struct map_state *lower_map(
	struct lowering *, const struct node *, map_entry_reader *entry, bool is_average);
/* A list behind an integer pattern: items of keyword `word`, then `filler` for missing ones. */
const struct map_state *lower_list(struct lowering *, const struct node *pattern, unsigned count,
	enum keyword word, map_entry_reader *entry, const void *filler);
/* A list of colours; missing ones are the pattern's own. */
const struct map_state *lower_colour_list(
	struct lowering *, const struct node *pattern, const struct pattern_class *);
/* The pattern's own map. */
const struct map_state *default_map_state(struct lowering *, const struct pattern_class *);
struct map map_build(struct lowering *, const struct map_state *);
float map_total(const struct map_state *);
const struct node *map_node(const struct node *);

/* ---- pigments: lower_pigment.c ---- */

struct pigment_state {
	enum look_form form;
	colour colour;
	colour quick;
	bool has_quick;
	struct pattern_state pattern;
	const struct map_state *map;	    /* colours or pigment states; NULL: the pattern's own */
	const struct pigment_state *mapped; /* FORM_UV */
	const struct node *node;	    /* for messages */
	const struct pigment *built;
};

/* The state of a declared pigment; reads it once. */
const struct pigment_state *pigment_declared(struct lowering *, const struct node *);
/* A block with the items of a pigment, beginning with a copy of `start`. */
const struct pigment_state *pigment_read(
	struct lowering *, const struct node *block, const struct pigment_state *start);
const struct pigment_state *pigment_moved(
	struct lowering *, const struct pigment_state *, const transform *);
/* Filter becomes transmit, as layers of old scenes want. */
const struct pigment_state *pigment_unfiltered(struct lowering *, const struct pigment_state *);
const struct pigment *pigment_build(struct lowering *, const struct pigment_state *);

/* ---- normals: lower_normal.c ---- */

struct normal_state {
	enum look_form form;
	struct pattern_state pattern;
	float amount, accuracy;
	bool keeps_length;
	const struct map_state *map;	/* normal states, or NULL */
	const struct map_state *slopes; /* or NULL */
	const struct normal_state *mapped;
	const struct node *node;
	const struct normal *built;
};

const struct normal_state *normal_declared(struct lowering *, const struct node *);
/* `start` may be NULL. */
const struct normal_state *normal_read(
	struct lowering *, const struct node *block, const struct normal_state *start);
const struct normal_state *normal_moved(
	struct lowering *, const struct normal_state *, const transform *);
const struct normal_state *normal_unscaled(struct lowering *, const struct normal_state *);
/* NULL when the quality leaves normals out. */
const struct normal *normal_build(struct lowering *, const struct normal_state *);

/* ---- finishes: lower_finish.c ---- */

struct finish_state {
	struct finish finish;
	const struct node *subsurface; /* NULL: none */
};

extern const struct finish_state finish_state_fresh;
const struct finish_state *finish_declared(struct lowering *, const struct node *);
const struct finish_state *finish_read(
	struct lowering *, const struct node *block, const struct finish_state *start);
/* The scene's copy; equal ones in a row share one. */
const struct finish *finish_build(struct lowering *, const struct finish_state *);

/* ---- textures: lower_texture.c, lower_patterned.c ---- */

struct layer_state {
	const struct pigment_state *pigment;
	const struct normal_state *normal; /* or NULL */
	const struct finish_state *finish;
};

/* A texture with a pattern of its own. */
struct patterned_state {
	enum look_form form; /* pattern, average or uv */
	bool keeps_length;
	struct pattern_state pattern;
	const struct map_state *map; /* texture specs */
	const struct texture_spec *mapped;
	const struct node *node;
};

struct texture_spec {
	size_t count;			  /* 0: patterned */
	const struct layer_state *layers; /* bottom first */
	const struct patterned_state *patterned;
	/* built already: as it is, and moved by `last_place`; without and with uv */
	const struct texture *built[2], *built_moved[2];
	transform last_place[2];
};

const struct texture_spec *default_spec(struct lowering *, const struct language_state *);
const struct texture_spec *texture_declared(struct lowering *, const struct node *);
const struct texture_spec *texture_read(
	struct lowering *, const struct node *block, const struct texture_spec *start);
const struct texture *texture_build(struct lowering *, const struct texture_spec *, bool uv);
const struct texture_spec *patterned_read(struct lowering *, const struct node *block);
/* tiles { texture … tile2 texture … } */
const struct texture_spec *tiles_read(struct lowering *, const struct node *);
void patterned_build(struct lowering *, const struct patterned_state *, struct texture *);
/* Puts a texture over what is there (NULL: nothing). */
const struct texture_spec *texture_layer(struct lowering *, const struct texture_spec *below,
	const struct texture_spec *above, const struct node *item);

#endif
