/* SPDX-License-Identifier: MIT */
/*
 * warp { … } statements.
 */
#include "looks.h"

#include "base/epsilon.h"

/* A vector this short has no direction; periods this short do not repeat. */

static double component(vec3 v, int axis)
{
	return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static struct warp repeat_warp(struct lowering *l, const struct node *kind)
{
	struct warp_repeat *w = ARENA_NEW(l->arena, struct warp_repeat);
	const vec3 width = lower_vector(l, kind, 0, "a vector");
	w->axis = -1;
	for (int i = 0; i < 3; i++) {
		if (component(width, i) == 0)
			continue;
		if (w->axis >= 0)
			diag_error(l->diag, kind->span, "warp can repeat along one axis only");
		w->axis = i;
	}
	if (w->axis < 0) {
		diag_error(l->diag, kind->span, "warp repeats along no axis: the vector is zero");
		w->axis = 0;
	}
	w->width = (float)component(width, w->axis);
	for (const struct node *item = kind->next; item; item = item->next)
		if (item->keyword == K_OFFSET)
			w->offset = lower_vector(l, item, 0, "a vector");
		else if (item->keyword == K_FLIP)
			w->flip = lower_vector(l, item, 0, "a vector");
		else
			diag_error(l->diag, item->word, "unexpected %s in warp repeat",
				keyword_name(item->keyword));
	return (struct warp){ warp_repeat, w };
}

/* Holes must not reach out of their cells. */
static void fit_axis(struct lowering *l, const struct node *kind, double *centre, double *period,
	double radius, double turbulence)
{
	if (*period <= 0)
		return;
	if (*period < EPSILON) {
		diag_warning(l->diag, kind->span, "black_hole: a repeat this small is ignored");
		return;
	}
	if (*centre < radius)
		*centre = radius;
	if (*period < *centre + radius + turbulence) {
		diag_warning(l->diag, kind->span, "black_hole: repeat increased to hold the hole");
		*period = *centre + radius + turbulence;
	}
}

static struct warp black_hole_warp(struct lowering *l, const struct node *kind)
{
	struct warp_black_hole *w = ARENA_NEW(l->arena, struct warp_black_hole);
	w->centre = lower_vector(l, kind, 0, "a centre");
	w->radius = lower_float(l, kind, 1, "a radius");
	w->strength = 1;
	w->falloff = 2;
	for (const struct node *item = kind->next; item; item = item->next)
		switch (item->keyword) {
		case K_STRENGTH:
			w->strength = lower_float(l, item, 0, "a number");
			break;
		case K_FALLOFF:
			w->falloff = lower_float(l, item, 0, "a number");
			break;
		case K_INVERSE:
			w->inverse = true;
			break;
		case K_TYPE:
			w->inert = lower_int(l, item, 0, "a number") != 0;
			break;
		case K_REPEAT:
			w->repeat = lower_vector(l, item, 0, "a vector");
			w->repeats = true;
			break;
		case K_TURBULENCE:
			w->turbulence = lower_vector(l, item, 0, "a vector");
			w->turbulent = true;
			break;
		default:
			diag_error(l->diag, item->word, "unexpected %s in warp black_hole",
				keyword_name(item->keyword));
		}
	if (w->repeats) {
		fit_axis(l, kind, &w->centre.x, &w->repeat.x, w->radius, w->turbulence.x);
		fit_axis(l, kind, &w->centre.y, &w->repeat.y, w->radius, w->turbulence.y);
		fit_axis(l, kind, &w->centre.z, &w->repeat.z, w->radius, w->turbulence.z);
	}
	return (struct warp){ warp_black_hole, w };
}

static struct warp turbulence_warp(struct lowering *l, const struct node *kind)
{
	struct turbulence *t = ARENA_NEW(l->arena, struct turbulence);
	*t = pattern_state_fresh.turbulence;
	t->amount = lower_vector(l, kind, 0, "a vector");
	for (const struct node *item = kind->next; item; item = item->next)
		switch (item->keyword) {
		case K_OCTAVES:
			t->octaves = lower_octaves(l, item);
			break;
		case K_OMEGA:
			t->omega = (float)lower_float(l, item, 0, "a number");
			break;
		case K_LAMBDA:
			t->lambda = (float)lower_float(l, item, 0, "a number");
			break;
		default:
			diag_error(l->diag, item->word, "unexpected %s in warp turbulence",
				keyword_name(item->keyword));
		}
	return (struct warp){ warp_turbulence, t };
}

static struct warp wrap_warp(
	struct lowering *l, const struct node *kind, vec3 (*apply)(const void *, vec3))
{
	struct warp_wrap *w = ARENA_NEW(l->arena, struct warp_wrap);
	w->orientation = vec(0, 0, 1);
	w->major_radius = 1;
	if (kind->keyword == K_PLANAR && kind->arg_count > 0) {
		w->orientation = lower_vector(l, kind, 0, "a vector");
		w->distance = lower_float(l, kind, 1, "a distance");
	}
	for (const struct node *item = kind->next; item; item = item->next)
		if (item->keyword == K_ORIENTATION)
			w->orientation = lower_vector(l, item, 0, "a vector");
		else if (item->keyword == K_DIST_EXP)
			w->exponent = lower_float(l, item, 0, "a number");
		else if (item->keyword == K_MAJOR_RADIUS)
			w->major_radius = lower_float(l, item, 0, "a number");
		else
			diag_error(l->diag, item->word, "unexpected %s in warp %s",
				keyword_name(item->keyword), keyword_name(kind->keyword));
	if (vec_length(w->orientation) < EPSILON)
		diag_error(l->diag, kind->span, "warp: the orientation is a zero vector");
	w->orientation = vec_normalize(w->orientation);
	return (struct warp){ apply, w };
}

const struct warp_step *lower_warp(
	struct lowering *l, const struct node *n, const struct warp_step *before)
{
	struct warp_step *step = ARENA_NEW(l->arena, struct warp_step);
	const struct node *kind = n->children;
	step->before = before;
	switch (kind ? kind->keyword : K_NONE) {
	case K_REPEAT:
		step->warp = repeat_warp(l, kind);
		break;
	case K_BLACK_HOLE:
		step->warp = black_hole_warp(l, kind);
		break;
	case K_TURBULENCE:
		step->warp = turbulence_warp(l, kind);
		break;
	case K_CYLINDRICAL:
		step->warp = wrap_warp(l, kind, warp_cylindrical);
		break;
	case K_SPHERICAL:
		step->warp = wrap_warp(l, kind, warp_spherical);
		break;
	case K_TOROIDAL:
		step->warp = wrap_warp(l, kind, warp_toroidal);
		break;
	case K_PLANAR:
		step->warp = wrap_warp(l, kind, warp_planar);
		break;
	case K_CUBIC:
		step->warp = (struct warp){ warp_cubic, NULL };
		break;
	default:
		diag_error(l->diag, n->span, "warp needs its kind: repeat, turbulence, …");
		return before;
	}
	return step;
}
