/* SPDX-License-Identifier: MIT */
/*
 * The top level of a scene: each statement to the file that knows it.
 */
#include "lower/lower.h"

#include "lower/draft.h"

#include <stdlib.h>

/* With this many errors the rest is likely to repeat them. */
enum { ERRORS_MAX = 20 };

static void lower_object_statement(struct lowering *l, const struct node *n)
{
	struct draft *d = draft_from_node(l, n);
	if (d)
		draft_emit(l, d, n->state);
}

static void camera_statement(struct lowering *l, const struct node *n)
{
	if (l->cameras++)
		diag_warning(l->diag, n->word, "a second camera: the last one is used");
	l->camera_word = n->word;
	lower_camera(l, n);
}

static void statement(struct lowering *l, const struct node *n)
{
	switch (n->keyword) {
	case K_CAMERA:
		camera_statement(l, n);
		break;
	case K_GLOBAL_SETTINGS:
		lower_global_settings(l, n);
		break;
	case K_MAX_TRACE_LEVEL:
		diag_warning(l->diag, n->word, "%s belongs in global_settings",
			keyword_name(n->keyword));
		lower_setting(l, n);
		break;
	case K_MAX_INTERSECTIONS:
		lower_setting(l, n);
		break;
	case K_BACKGROUND:
		lower_background(l, n);
		break;
	case K_FOG:
		if (l->options->quality >= 9)
			lower_fog(l, n);
		break;
	case K_SKY_SPHERE:
		lower_sky_sphere(l, n);
		break;
	default:
		if (node_is_object(n))
			lower_object_statement(l, n);
		else
			lower_unsupported(l, n, keyword_name(n->keyword));
	}
}

void lowering_init(struct lowering *l, const struct lower_options *options, struct diag *diag,
	struct scene *scene)
{
	*l = (struct lowering){
		.scene = scene,
		.arena = scene->arena,
		.rendered = scene,
		.diag = diag,
		.options = options,
		.statement_states = arena_create(0),
		.declared_states = arena_create(0),
		.wave_count = 10,
	};
	l->states = l->statement_states;
	settings_begin(l);
}

void lowering_forget(struct lowering *l)
{
	l->begun = (struct begun_compound){ .first = NULL };
	arena_reset(l->statement_states);
}

struct arena *lowering_keep(struct lowering *l)
{
	struct arena *const before = l->states;
	l->states = l->declared_states;
	return before;
}

void lowering_release(struct lowering *l)
{
	arena_destroy(l->statement_states);
	arena_destroy(l->declared_states);
	free(l->generators);
	pointer_map_release(&l->drafts);
	pointer_map_release(&l->functions);
	pointer_map_release(&l->looks);
}

void lower_statements(struct lowering *l, const struct node *first)
{
	for (const struct node *n = first; n && !l->given_up; n = n->next) {
		statement(l, n);
		lowering_forget(l);
		l->given_up = diag_mistakes(l->diag) >= ERRORS_MAX;
		if (l->given_up)
			diag_note(l->diag, n->span, "too many errors: stopped here");
	}
}

bool lower_members(struct lowering *l, span word, const struct node *first)
{
	if (!l->given_up)
		draft_members(l, word, first);
	return !l->begun.has_nodes;
}

bool lower_end(struct lowering *l, const struct language_state *final)
{
	if (l->given_up)
		return false;
	if (!l->cameras)
		lower_default_camera(l, final->defaults);
	lowering_settle(l, final);
	lower_photons_end(l);
	if (!l->scene->object_count && !diag_errors(l->diag)) /* else they may have been refused */
		diag_warning(l->diag, NO_SPAN, "the scene has no objects");
	if (final->assumed_gamma == 0)
		diag_warning(l->diag, NO_SPAN, "the scene has no assumed_gamma: %s",
			l->scene->settings.working.transfer == TRANSFER_NONE
				? "colours are left as they are, as before version 3.7"
				: "1.0 is taken");
	if (!diag_errors(l->diag))
		lower_warn_of_darkness(l);
	return diag_errors(l->diag) == 0;
}
