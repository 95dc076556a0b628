/* SPDX-License-Identifier: MIT */
/*
 * The rules of the language for the layers of a plain texture: what each shows
 * through those above it, where the rest is not looked at, what light passes.
 */
#ifndef LAMBERT_SURFACE_LAYERS_H
#define LAMBERT_SURFACE_LAYERS_H

#include "surface/brdf.h"

enum { LOBES_FEW = 2 };

/* A plain texture at a point, as a viewer sees it. */
struct layers {
	const struct lobe *lobes; /* top first, without the hidden ones */
	size_t count;
	rgb tint; /* of what comes through all layers */
	float clear;
	bool tinted;		    /* some layer had a colour here */
	struct lobe few[LOBES_FEW]; /* room for the usual number */
};

/* The lobes of a part. `numbered` of the interaction's lobes are in the parts before it. */
void layers_open(struct worker *, struct interaction *, const struct texture_part *,
	uint32_t numbered, struct layers *);
/* The share of light that passes all parts of an interaction, for shadows. */
rgb layers_tint(struct worker *, struct interaction *);

#endif
