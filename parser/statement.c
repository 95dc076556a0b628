/* SPDX-License-Identifier: MIT */
/*
 * Statements whose node needs more than a word, arguments and children, and
 * those that change the state of the language.
 */
#include "base/transform.h"
#include "build.h"

#include <math.h>
#include <string.h>

/* -- Cameras ------------------------------------------------------------------------------ */

static bool is_camera_type(enum keyword k)
{
	return k == K_PERSPECTIVE || k == K_ORTHOGRAPHIC || k == K_FISHEYE ||
	       k == K_ULTRA_WIDE_ANGLE || k == K_OMNIMAX || k == K_PANORAMIC || k == K_SPHERICAL ||
	       k == K_CYLINDER || k == K_MESH_CAMERA;
}

static bool is_transformation(enum keyword k)
{
	return k == K_TRANSLATE || k == K_ROTATE || k == K_SCALE || k == K_MATRIX ||
	       k == K_TRANSFORM;
}

/* What some cameras allow must be said before: an angle without a value, two of them. */
static void check_angles(struct parser *p, struct node_list items)
{
	bool orthographic = false, spherical = false;
	for (const struct node *n = items.first; n; n = n->next) {
		orthographic |= n->keyword == K_ORTHOGRAPHIC;
		spherical |= n->keyword == K_SPHERICAL;
		if (n->keyword != K_ANGLE)
			continue;
		if (!n->arg_count && !orthographic)
			parser_error(p, n->span, "angle needs a number of degrees");
		else if (n->arg_count > 1 && !spherical)
			parser_error(p, n->span, "only a spherical camera has a second angle");
	}
}

/* Angles; and, from version 3.5, that the type stands first and a camera identifier takes
 * transformations only. */
void camera_check(struct parser *p, struct node_list items)
{
	check_angles(p, items);
	if (p->state->version < 350)
		return;
	bool reference = false, item = false;
	for (const struct node *n = items.first; n; n = n->next) {
		if (n->keyword == K_REFERENCE) {
			reference = true;
		} else if (reference && !is_transformation(n->keyword)) {
			parser_error(
				p, n->span, "only transformations may follow a camera identifier");
		} else if (!is_camera_type(n->keyword)) {
			item = true;
		} else if (item) {
			parser_error(p, n->span, "the type of a camera, %s, must come first",
				keyword_name(n->keyword));
		}
	}
}

/* -- Small shapes of nodes ---------------------------------------------------------------- */

struct node *node_matrix(struct parser *p, span whole, span word, size_t start)
{
	struct grammar *g = p->grammar;
	const size_t found = g->arg_count - start;
	double *values = ARENA_ARRAY(p->tree, 12, double);
	if (found != 12) {
		parser_error(p, word, "matrix needs 12 numbers, found %zu", found);
		note_sign_in(p, start);
	}
	for (size_t i = 0; i < found && i < 12; i++)
		values[i] = number_to_float(p, g->args[start + i].number, g->args[start + i].span);
	g->arg_count = start;
	transform mended;
	if (found == 12 && !transform_matrix(values, &mended))
		parser_error(p, whole, "the matrix is singular: it cannot be inverted");
	else if (found == 12 && memcmp(mended.m, values, sizeof mended.m) != 0)
		diag_warning(p->diag, whole,
			"a column of the matrix is zero: its diagonal entry is set to 1");
	return node_args(p, K_MATRIX, whole, word, args_push_array(p, values, 12, 1, whole));
}

struct node *magnet_node(
	struct parser *p, span whole, span word, double type, span at, struct node *kind)
{
	if (type != 1 && type != 2)
		parser_error(p, at, "a magnet pattern is of type 1 or 2");
	struct node *node = node_number(p, K_MAGNET, whole, word, number_float(type), at);
	node->children = kind;
	return node;
}

struct node *parametric_node(struct parser *p, span whole, span word,
	const struct function *const functions[3], const span at[3], size_t start,
	struct node_list items)
{
	struct grammar *g = p->grammar;
	const struct arg corners[2] = { g->args[start], g->args[start + 1] };
	g->arg_count = start;
	for (int i = 0; i < 3; i++)
		args_push_function(p, functions[i], at[i]);
	for (int i = 0; i < 2; i++)
		args_push_number(p, corners[i].number, corners[i].span);
	struct node *node = node_fit(p, K_PARAMETRIC, whole, word, start, "ppp22");
	node->children = items.first;
	return node;
}

struct node *old_finish_node(
	struct parser *p, enum keyword keyword, span whole, span word, double value, span at)
{
	diag_warning(p->diag, word, "%s belongs in interior, not in finish", keyword_name(keyword));
	return node_number(p, keyword, whole, word, number_float(value), at);
}

struct node *old_colour(struct parser *p, struct colour_value colour, span where)
{
	diag_warning(p->diag, where, "a colour among the modifiers of an object is obsolete%s",
		p->state->version >= 150 ? " and ignored" : "");
	return colour_node(p, colour_full(p, colour, where), where);
}

struct node *old_named_colour(struct parser *p, struct number_value colour, span where)
{
	return old_colour(p, (struct colour_value){ colour.number, NULL, true }, where);
}

/* A float alone is the distance, as in the oldest scenes; anything else is the colour. */
struct node *fog_number(struct parser *p, struct colour_value value, span where)
{
	if (value.number.terms > 1 || value.parts)
		return colour_node(p, colour_full(p, colour_bare(p, value, where), where), where);
	diag_warning(
		p->diag, where, "the distance of a fog is written distance %g", value.number.v[0]);
	return node_number(p, K_DISTANCE, where, where, value.number, where);
}

void rainbow_check(struct parser *p, const struct node *rainbow)
{
	for (const struct node *n = rainbow->children; n; n = n->next) {
		if (n->keyword == K_REFERENCE)
			return;
		const double *v = n->keyword == K_DIRECTION ? n->args[0].number.v : NULL;
		if (v && (v[0] != 0 || v[1] != 0 || v[2] != 0))
			return;
	}
	parser_error(p, rainbow->word, "rainbow needs a direction");
}

/* -- State of the language ---------------------------------------------------------------- */

/* Whether a texture is neither layered nor made of a pattern. */
static bool is_plain_texture(const struct node *texture)
{
	if (texture->keyword == K_LAYERS)
		return false;
	for (const struct node *n = texture->children; n; n = n->next) {
		const enum keyword k = n->keyword;
		if (k == K_REFERENCE
				? n->ref->keyword != K_PIGMENT && n->ref->keyword != K_NORMAL &&
					  n->ref->keyword != K_FINISH && !is_plain_texture(n->ref)
				: k != K_PIGMENT && k != K_NORMAL && k != K_FINISH &&
					  k != K_NO_BUMP_SCALE && !is_transformation(k))
			return false;
	}
	return true;
}

void default_add(struct parser *p, struct node *node)
{
	if (node->keyword == K_TEXTURE && !is_plain_texture(node))
		parser_error(p, node->span,
			"the default texture can be neither layered nor made of a pattern");
	struct defaults *defaults = ARENA_NEW(p->arena, struct defaults);
	defaults->previous = p->state->defaults;
	defaults->node = node;
	p->keeps_tree |= p->tree != p->arena;
	parser_change_state(p)->defaults = defaults;
}

void set_gamma(struct parser *p, float gamma, span where)
{
	if (p->state->assumed_gamma != 0)
		diag_warning(p->diag, where, "assumed_gamma was already set; this one is ignored");
	else if (gamma == 0 || !isfinite(gamma) || (gamma < 0 && gamma != -1))
		parser_error(p, where, "assumed_gamma must be greater than 0");
	else
		parser_change_state(p)->assumed_gamma = gamma;
}

void set_noise(struct parser *p, double value, span where)
{
	const int generator = number_truncate(value);
	if (generator < 1 || generator > 3)
		parser_error(p, where, "noise_generator is 1, 2 or 3");
	else
		parser_change_state(p)->noise_generator = generator;
}

void set_charset(struct parser *p, const struct node *word)
{
	p->charset = word->keyword == K_UTF8  ? CHARSET_UTF8
		     : word->keyword == K_SYS ? CHARSET_SYS
					      : CHARSET_ASCII;
}
