/* SPDX-License-Identifier: MIT */
/*
 * An interaction: what a ray met. It is made in one place, for whoever follows
 * rays, and knows no light: the lobes of a part (layers.h) say what the surface
 * does with light, transmission.h what it lets through.
 */
#ifndef LAMBERT_SURFACE_INTERACTION_H
#define LAMBERT_SURFACE_INTERACTION_H

#include "medium/interior_stack.h"
#include "texture/texture.h"
#include "worker/worker.h"

struct interaction {
	struct surface surface; /* point, the ray's direction, normals: what patterns see */
	const struct object *object;
	const struct interior_stack *interiors; /* the ray came through */
	double depth;				/* how far it came */
	uint32_t vertex;			/* of the ray tree: names random numbers */
	struct texture_part *parts;		/* plain textures, blended by weight */
	size_t part_count;
	struct texture_part whole; /* the only part of a plain texture; `parts` leads here */
};

/* Fills in what is at a hit of a ray that came through these interiors to this vertex. The parts are
 * there until the next interaction of the worker is made. */
void interaction_make(struct worker *, struct interaction *, const struct hit *, const ray *,
	const struct interior_stack *, uint32_t vertex);
/* Makes the parts last as long as the sample. */
void interaction_keep(struct worker *, struct interaction *);

struct surface_memory *surface_memory_create(void);
void surface_memory_destroy(struct surface_memory *);

#endif
