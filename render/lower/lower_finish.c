/* SPDX-License-Identifier: MIT */
/*
 * finish { … }. Every number is single precision.
 */
#include "looks.h"

#include "base/elementary.h"

#include <string.h>

const struct finish_state finish_state_fresh = {
	.finish = {
		.ambient = { 0.1f, 0.1f, 0.1f },
		.diffuse = 0.6f,
		.diffuse_unscaled = 0.6f,
		.brilliance = 1,
		.phong_size = 40,
		.specular_power = 1 / 0.05f,
		.reflection_falloff = 1,
		.reflection_exponent = 1,
		.refraction = 1,
	},
};

/* What `albedo` asks for once the whole block has been read. */
struct albedo {
	bool diffuse, phong, specular;
};

const struct finish_state *finish_declared(struct lowering *l, const struct node *n)
{
	const struct finish_state *state = looks_find(l, n);
	if (!state) {
		struct arena *const before = lowering_keep(l);
		state = finish_read(l, n, default_spec(l, n->state)->layers->finish);
		l->states = before;
		looks_remember(l, n, (void *)(uintptr_t)state);
	}
	return state;
}

static float number(struct lowering *l, const struct node *item)
{
	return (float)lower_float(l, item, 0, "a number");
}

static float optional_number(struct lowering *l, const struct node *item, float absent)
{
	return item->arg_count > 0 ? number(l, item) : absent;
}

static void read_roughness(struct lowering *l, struct finish *f, const struct node *item)
{
	const float roughness = number(l, item);
	if (roughness == 0)
		diag_warning(l->diag, item->span, "roughness 0: the highlight covers everything");
	f->specular_power = roughness == 0 ? 0 : 1 / roughness;
}

static void read_fresnel(struct lowering *l, struct finish *f, const struct node *item)
{
	const int on = item->arg_count > 0 ? lower_int(l, item, 0, "a switch") : 1;
	if (on != 0 && on != 1)
		diag_error(l->diag, item->span, "fresnel is 0 or 1");
	f->fresnel = on != 0;
}

/* `reflection C` also resets the falloff; in braces what is not mentioned stays. */
static void read_reflection(struct lowering *l, struct finish *f, const struct node *item)
{
	const bool pair = item->arg_count > 1;
	f->reflection_min = lower_rgb(l, item, 0, "a colour");
	f->reflection_max = pair ? lower_rgb(l, item, 1, "a colour") : f->reflection_min;
	if (!item->children && !pair) {
		f->reflection_falloff = 1;
		f->fresnel = false;
	}
	for (const struct node *sub = item->children; sub; sub = sub->next)
		switch (sub->keyword) {
		case K_FRESNEL:
			read_fresnel(l, f, sub);
			break;
		case K_FALLOFF:
			f->reflection_falloff = number(l, sub);
			break;
		case K_EXPONENT:
			f->reflection_exponent = 1 / number(l, sub);
			break;
		case K_METALLIC:
			f->reflection_metallic = optional_number(l, sub, 1);
			break;
		default:
			diag_error(l->diag, sub->word, "unexpected %s in reflection",
				keyword_name(sub->keyword));
		}
	if (!pair && node_child(item, K_FRESNEL) && f->fresnel)
		f->reflection_min = rgb_grey(0);
}

static void read_irid(struct lowering *l, struct finish *f, const struct node *item)
{
	f->irid = number(l, item);
	for (const struct node *sub = item->children; sub; sub = sub->next)
		if (sub->keyword == K_THICKNESS)
			f->irid_thickness = number(l, sub);
		else if (sub->keyword == K_TURBULENCE)
			f->irid_turbulence = (float)lower_vector(l, sub, 0, "a vector").x;
		else
			diag_error(l->diag, sub->word, "unexpected %s in irid",
				keyword_name(sub->keyword));
}

/* Returns false for words that are not highlights or diffuse light. */
static bool read_light_item(
	struct lowering *l, struct finish *f, struct albedo *albedo, const struct node *item)
{
	const bool scaled = node_child(item, K_ALBEDO) != NULL;
	switch (item->keyword) {
	case K_DIFFUSE:
		f->diffuse = number(l, item);
		f->diffuse_back =
			item->arg_count > 1 ? (float)lower_float(l, item, 1, "a number") : 0;
		if (f->diffuse_back != 0)
			diag_warning(l->diag, item->span,
				"light from behind a surface is an experimental feature");
		albedo->diffuse = scaled;
		return true;
	case K_BRILLIANCE:
		f->brilliance = number(l, item);
		return true;
	case K_PHONG:
		f->phong = number(l, item);
		albedo->phong = scaled;
		return true;
	case K_PHONG_SIZE:
		f->phong_size = number(l, item);
		return true;
	case K_SPECULAR:
		f->specular = number(l, item);
		albedo->specular = scaled;
		return true;
	case K_ROUGHNESS:
		read_roughness(l, f, item);
		return true;
	case K_METALLIC:
		f->metallic = optional_number(l, item, 1);
		return true;
	default:
		return false;
	}
}

/* Items that became properties of the interior; the parser has warned of them. */
static bool read_obsolete(struct lowering *l, struct finish *f, const struct node *item)
{
	switch (item->keyword) {
	case K_IOR:
		f->ior = number(l, item);
		break;
	case K_CAUSTICS:
		f->caustics = number(l, item);
		break;
	case K_REFRACTION:
		f->refraction = number(l, item);
		break;
	default:
		return false;
	}
	return true;
}

static void read_item(
	struct lowering *l, struct finish_state *s, struct albedo *albedo, const struct node *item)
{
	struct finish *f = &s->finish;
	if (read_light_item(l, f, albedo, item) || read_obsolete(l, f, item))
		return;
	switch (item->keyword) {
	case K_REFERENCE: {
		const struct node *declared = node_resolve(item);
		if (declared && declared->keyword == K_FINISH)
			*s = *finish_declared(l, declared);
		else
			diag_error(l->diag, item->span, "%s is not a finish", item->name);
		break;
	}
	case K_AMBIENT:
		f->ambient = lower_rgb(l, item, 0, "a colour");
		break;
	case K_EMISSION:
		f->emission = lower_rgb(l, item, 0, "a colour");
		break;
	case K_CRAND:
		f->crand = number(l, item);
		break;
	case K_CONSERVE_ENERGY:
		f->conserve_energy = true;
		break;
	case K_REFLECTION:
		read_reflection(l, f, item);
		break;
	case K_REFLECTION_EXPONENT:
		f->reflection_exponent = 1 / number(l, item);
		break;
	case K_IRID:
		read_irid(l, f, item);
		break;
	case K_SUBSURFACE:
		s->subsurface = item;
		break;
	default:
		diag_error(l->diag, item->word, "unexpected %s in finish",
			keyword_name(item->keyword));
	}
}

/* The share of all light that comes back, instead of its brightest part. */
static void apply_albedo(struct finish *f, const struct albedo *albedo)
{
	f->diffuse_unscaled = f->diffuse;
	if (albedo->diffuse) {
		f->diffuse *= (f->brilliance + 1) / 2;
		f->diffuse_back *= (f->brilliance + 1) / 2;
	}
	if (albedo->phong)
		f->phong *= (f->phong_size + 1) / 2;
	if (albedo->specular) {
		const double power = (double)f->specular_power;
		f->specular = (float)((double)f->specular * (power + 2) /
				      (4 * (2 - elementary_pow(2, -power / 2))));
	}
}

const struct finish_state *finish_read(
	struct lowering *l, const struct node *block, const struct finish_state *start)
{
	struct finish_state *s = arena_copy(l->states, start, sizeof *start);
	struct albedo albedo = { false, false, false };
	for (const struct node *item = block->children; item; item = item->next)
		read_item(l, s, &albedo, item);
	apply_albedo(&s->finish, &albedo);
	return s;
}

/* Most textures have one of a few finishes. */
const struct finish *finish_build(struct lowering *l, const struct finish_state *s)
{
	for (unsigned i = 0; i < FINISHES_KEPT; i++) {
		const struct finish *known = l->finishes[i];
		if (known && memcmp(known, &s->finish, sizeof s->finish) == 0)
			return known;
	}
	struct finish *finish = arena_pack(l->arena, sizeof *finish);
	memcpy(finish, &s->finish, sizeof *finish);
	l->finishes[l->finish_next++ % FINISHES_KEPT] = finish;
	return finish;
}
