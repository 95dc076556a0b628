/* SPDX-License-Identifier: MIT */
/*
 * From AST to render scene: the only place that knows both. Every remaining
 * error of the scene is found here, with its span.
 */
#ifndef LAMBERT_LOWER_LOWER_H
#define LAMBERT_LOWER_LOWER_H

#include "base/diag.h"
#include "base/pointer_map.h"
#include "parser/ast.h"
#include "parser/parser.h"
#include "scene/scene.h"
#include "texture/texture.h"

/* What the command line decides about a scene. */
struct lower_options {
	unsigned width, height;
	int quality;
	uint32_t frame;
	bool output_alpha;
	int working_version;		   /* Version option, hundredths; 0: none given */
	const struct parse_options *files; /* for fonts and images */
};

enum { FINISHES_KEPT = 8 };

/* The members of a compound whose statement is still being read. */
struct begun_compound {
	span word;		    /* its keyword */
	struct draft *first, **end; /* end NULL: there is none */
	bool has_nodes;		    /* some draft refers to its node */
};

struct lowering {
	struct scene *scene;
	struct arena *arena;	/* the scene's: what the scene is made of */
	struct scene *rendered; /* the scene of the picture; another one when for_questions */
	/* Drafts and the states of looks: of the present statement, forgotten at its end; of what is
	 * declared, which later statements use again. */
	struct arena *statement_states, *declared_states;
	struct arena *states; /* where they are made now: one of the two */
	struct diag *diag;
	const struct lower_options *options;
	struct pointer_map
		looks; /* states of pigments, normals, textures, maps made already, by node */
	struct wave_sources *wave_sources; /* of all ripples and waves: filled in at the end */
	double wave_count;		   /* number_of_waves */
	int **generators; /* where the noise generator is to be put that holds at the end */
	size_t generator_count, generator_room;
	bool for_questions; /* of the language about objects: keeps extents, and any ray sees all */
	struct begun_compound begun;
	bool given_up;			       /* after too many errors */
	bool has_uv_mapping;		       /* some texture met so far has it, within itself */
	struct pointer_map drafts;	       /* declared objects drafted already, by node */
	struct pointer_map functions;	       /* compiled already, by struct function */
	unsigned cameras;		       /* met so far */
	const struct texture *default_texture; /* finished, for objects without one */
	const struct defaults *default_of;     /* the #default it was made of */
	struct interior *plain_interior[2];    /* of opaque objects: solid, hollow */
	const transform *latest_place;	       /* that an object was given */
	const struct finish *finishes[FINISHES_KEPT]; /* the latest ones built */
	unsigned finish_next;
	const struct shape_class *shapes[KEYWORD_COUNT]; /* found already */

	span camera_word; /* of the last camera */
	span photons;	  /* the global setting; no place: there is none */
	bool has_photons; /* an object met so far is a target, or a file has them */
	bool has_radiosity;
};

/* Begins to lower a text to a scene that is still empty. */
void lowering_init(struct lowering *, const struct lower_options *, struct diag *, struct scene *);
/* Lowers statements of the top level, in their order; may be called again with the next ones. */
void lower_statements(struct lowering *, const struct node *first);
/* Lowers the next members of a union or merge of the top level whose word stands there, and which is
 * one of the next statements. False if their nodes are still needed then. */
bool lower_members(struct lowering *, span word, const struct node *first);
/* Behind the last statement: what only the end of the text decides. False after an error in any. */
bool lower_end(struct lowering *, const struct language_state *final);
/* Frees what lowering keeps beside the scene. */
void lowering_release(struct lowering *);

/* ---- helpers of the lower_ files ---- */

/* Brings what depends on the end of the text in line with a state of the language. */
void lowering_settle(struct lowering *, const struct language_state *);
/* At the end of the text, in a scene without errors: warns of what leaves the picture black. */
void lower_warn_of_darkness(struct lowering *);
/* At the end of the text: refuses photons if any would be shot. */
void lower_photons_end(struct lowering *);
/* The noise generator of the end of the text will be put there. */
void lower_late_generator(struct lowering *, int *generator);
/* At the end of a statement: its drafts and states are not needed any more. */
void lowering_forget(struct lowering *);
/* States made from now on are those of something declared. Returns what to set `states` to when that
 * is read. */
struct arena *lowering_keep(struct lowering *);

/* The number argument `index` of a node as a float, vector, colour; reports what is wrong. */
double lower_float(struct lowering *, const struct node *, uint32_t index, const char *what);
/* A float argument without its fraction, as near as an int can be; not a number counts as 0. */
int lower_int(struct lowering *, const struct node *, uint32_t index, const char *what);
/* octaves N: 1 to 10. */
int lower_octaves(struct lowering *, const struct node *);
vec3 lower_vector(struct lowering *, const struct node *, uint32_t index, const char *what);
colour lower_colour(struct lowering *, const struct node *, uint32_t index);
rgb lower_rgb(struct lowering *, const struct node *, uint32_t index, const char *what);
/* An optional switch: absent means on; on if > 0. */
bool lower_switch(struct lowering *, const struct node *, bool absent);
/* The transformation of K_TRANSLATE, K_ROTATE, K_SCALE, K_MATRIX, K_TRANSFORM nodes. */
transform lower_transform(struct lowering *, const struct node *);
bool node_is_transform(const struct node *);
/* Follows references to the declared value. */
const struct node *node_resolve(const struct node *);
void lower_unsupported(struct lowering *, const struct node *, const char *what);

/* ---- lower_texture.c: textures and what they are made of ---- */

/* A texture under construction on an object: layers that transformations still move. */
struct texture_state;
/* The default texture in force in `state`. */
struct texture_state *texture_state_default(struct lowering *, const struct language_state *);
struct texture_state *texture_state_copy(struct lowering *, const struct texture_state *);
/* Applies a K_TEXTURE (adds layers), K_PIGMENT, K_NORMAL, K_FINISH (modify the top layer) item, or
 * a reference to one, to *state, which is NULL while the object has no texture yet. */
void texture_state_add(struct lowering *, struct texture_state **state, const struct node *item);
void texture_state_transform(struct lowering *, struct texture_state *, const transform *);
/* The finished texture. Equal states may share one. */
const struct texture *texture_state_finish(struct lowering *, struct texture_state *, bool uv);
/* Obsolete finish items that belong to the interior (ior, caustics); false if none. */
bool texture_state_interior(const struct texture_state *, double *ior, double *caustics);

/* A pigment on its own, for sky_sphere; transformed by `place` when not NULL. */
const struct pigment *lower_pigment(struct lowering *, const struct node *, const transform *place);

/* The object of a block (an object and transformations), for tests of what is inside it; NULL after an
 * error. */
const struct object *lower_inside_object(struct lowering *, const struct node *block);

#endif
