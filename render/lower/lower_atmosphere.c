/* SPDX-License-Identifier: MIT */
/*
 * What fills the space between objects and within them: fog, sky_sphere,
 * background and interiors.
 */
#include "lower/draft.h"

#include "base/epsilon.h"

/* Below this a length counts as nothing. */

/* ---- fog ---- */

static const struct fog fog_defaults = {
	.up = { 0, 1, 0 },
	.turb_depth = 0.5,
	.octaves = 6,
	.omega = 0.5f,
	.lambda = 2,
};

static void fog_type(struct lowering *l, const struct node *item, struct fog *f)
{
	const int type = lower_int(l, item, 0, "1 or 2");
	if (type != 1 && type != 2)
		diag_warning(
			l->diag, item->span, "fog_type %d is unknown: constant fog is used", type);
	f->ground = type == 2;
}

static void fog_transform(struct lowering *l, const struct node *item, struct fog *f)
{
	const struct node *n = node_resolve(item);
	if (n->keyword == K_SCALE) { /* a zero is kept here */
		f->up = vec_mul(f->up, lower_vector(l, n, 0, "a vector"));
	} else if (n->keyword == K_TRANSLATE) {
		diag_warning(l->diag, n->span, "translate has no effect on fog");
	} else {
		const transform t = lower_transform(l, item);
		f->up = transform_direction(&t, f->up);
	}
}

static void fog_items(struct lowering *l, const struct node *n, struct fog *f);

static void fog_item(struct lowering *l, const struct node *item, struct fog *f)
{
	switch (item->keyword) {
	case K_REFERENCE:
		fog_items(l, node_resolve(item), f);
		break;
	case K_COLOUR_VALUE:
		f->colour = lower_colour(l, item, 0);
		break;
	case K_DISTANCE:
		f->distance = lower_float(l, item, 0, "a distance");
		break;
	case K_FOG_TYPE:
		fog_type(l, item, f);
		break;
	case K_FOG_OFFSET:
		f->offset = lower_float(l, item, 0, "a height");
		break;
	case K_FOG_ALT:
		f->altitude = lower_float(l, item, 0, "a height");
		break;
	case K_UP:
		f->up = lower_vector(l, item, 0, "a vector");
		break;
	case K_TURBULENCE:
		f->turbulence = lower_vector(l, item, 0, "a vector");
		f->turbulent = true;
		break;
	case K_TURB_DEPTH:
		f->turb_depth = lower_float(l, item, 0, "a depth");
		break;
	case K_OCTAVES:
		f->octaves = lower_octaves(l, item);
		break;
	case K_OMEGA:
		f->omega = (float)lower_float(l, item, 0, "a number");
		break;
	case K_LAMBDA:
		f->lambda = (float)lower_float(l, item, 0, "a number");
		break;
	default:
		lower_unsupported(l, item, keyword_name(item->keyword));
	}
}

static void fog_items(struct lowering *l, const struct node *n, struct fog *f)
{
	for (const struct node *item = n->children; item; item = item->next) {
		if (node_is_transform(item))
			fog_transform(l, item, f);
		else
			fog_item(l, item, f);
	}
}

void lower_fog(struct lowering *l, const struct node *n)
{
	struct fog *f = arena_copy(l->arena, &fog_defaults, sizeof fog_defaults);
	fog_items(l, n, f);
	f->up = vec_normalize(f->up);
	if (fabs(f->distance) <= EPSILON)
		return;
	struct scene *s = l->scene;
	const struct fog **fogs = ARENA_ARRAY(l->arena, s->fog_count + 1, const struct fog *);
	for (size_t i = 0; i < s->fog_count; i++)
		fogs[i + 1] = s->fogs[i];
	fogs[0] = f; /* the one declared last acts first */
	s->fogs = fogs;
	s->fog_count++;
}

/* ---- sky_sphere ---- */

enum { SKY_PIGMENTS_MAX = 256 };

struct sky_items {
	size_t count;
	const struct node *pigments[SKY_PIGMENTS_MAX];
	transform places[SKY_PIGMENTS_MAX]; /* transformations that follow each */
	rgb emission;
};

static void sky_transform(struct sky_items *sky, const transform *t)
{
	for (size_t i = 0; i < sky->count; i++)
		sky->places[i] = transform_compose(&sky->places[i], t);
}

static void sky_items(struct lowering *l, const struct node *n, struct sky_items *sky)
{
	for (const struct node *item = n->children; item; item = item->next) {
		const struct node *what = node_resolve(item);
		if (node_is_transform(item)) {
			const transform t = lower_transform(l, item);
			sky_transform(sky, &t);
		} else if (what->keyword == K_SKY_SPHERE) {
			sky_items(l, what, sky);
		} else if (what->keyword == K_EMISSION) {
			sky->emission = lower_rgb(l, what, 0, "a colour");
		} else if (what->keyword == K_PIGMENT && sky->count < SKY_PIGMENTS_MAX) {
			sky->places[sky->count] = transform_identity();
			sky->pigments[sky->count++] = item;
		} else {
			lower_unsupported(l, what, keyword_name(what->keyword));
		}
	}
}

void lower_sky_sphere(struct lowering *l, const struct node *n)
{
	if (l->scene->sky_sphere)
		diag_warning(l->diag, n->span, "a second sky_sphere: the last one is used");
	struct sky_items *items = ARENA_NEW(l->arena, struct sky_items);
	items->emission = rgb_grey(1);
	sky_items(l, n, items);
	if (!items->count)
		diag_error(l->diag, n->span, "sky_sphere needs a pigment");
	const struct pigment **pigments =
		ARENA_ARRAY(l->arena, items->count + 1, const struct pigment *);
	for (size_t i = 0; i < items->count; i++) {
		const bool moved = !transform_is_identity(&items->places[i]);
		pigments[i] =
			lower_pigment(l, items->pigments[i], moved ? &items->places[i] : NULL);
	}
	struct sky_sphere *sky = ARENA_NEW(l->arena, struct sky_sphere);
	sky->count = items->count;
	sky->pigments = pigments;
	sky->emission = items->emission;
	l->scene->sky_sphere = sky;
}

/* ---- background ---- */

void lower_background(struct lowering *l, const struct node *n)
{
	const struct node *value = node_child(n, K_COLOUR_VALUE);
	colour c = value ? lower_colour(l, value, 0) : (colour){ 0, 0, 0, 0, 0 };
	const int version = n->state->version_set ? n->state->version : 362;
	if (version < 370) {
		c.filter = 0;
		c.transmit = l->options->output_alpha ? 1 : 0;
	} else if (!l->options->output_alpha) {
		const float opacity = 1 - c.transmit;
		c = (colour){ c.r * opacity, c.g * opacity, c.b * opacity, 0, 0 };
	}
	l->scene->background = c;
	l->scene->has_background = true;
}

/* ---- interior ---- */

static void interior_item(struct lowering *l, const struct node *item, struct draft_interior *i)
{
	switch (item->keyword) {
	case K_IOR:
		i->data.ior = lower_float(l, item, 0, "an index");
		break;
	case K_CAUSTICS:
		i->data.caustics = 45 * lower_float(l, item, 0, "a strength");
		break;
	case K_FADE_DISTANCE:
		i->data.fade_distance = lower_float(l, item, 0, "a distance");
		break;
	case K_FADE_POWER:
		i->data.fade_power = lower_float(l, item, 0, "a power");
		break;
	case K_FADE_COLOR:
		i->data.fade_colour = lower_rgb(l, item, 0, "a colour");
		break;
	case K_DISPERSION:
		i->data.dispersion = lower_float(l, item, 0, "a ratio");
		if (fabs(i->data.dispersion - 1) > EPSILON && i->data.dispersion != 0)
			lower_unsupported(l, item, "dispersion");
		break;
	case K_DISPERSION_SAMPLES:
		i->data.dispersion_samples = lower_int(l, item, 0, "a number");
		break;
	case K_REFRACTION:
		diag_warning(l->diag, item->word, "refraction has no effect: ior is enough");
		break;
	default:
		lower_unsupported(l, item, keyword_name(item->keyword));
	}
}

struct draft_interior *lower_interior(
	struct lowering *l, const struct node *n, const struct draft_interior *start)
{
	struct draft_interior *i = ARENA_NEW(l->states, struct draft_interior);
	if (start)
		*i = *start;
	else
		i->data = (struct interior){ .ior = 1, .dispersion = 1, .dispersion_samples = 7 };
	i->finished = NULL;
	for (const struct node *item = n ? n->children : NULL; item; item = item->next) {
		const struct node *what = node_resolve(item);
		if (what->keyword == K_INTERIOR)
			i = lower_interior(l, what, i);
		else
			interior_item(l, what, i);
	}
	if (i->data.ior == 0) /* unspecified: that of the surroundings */
		i->data.ior = i->data.dispersion = 1;
	return i;
}
