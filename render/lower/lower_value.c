/* SPDX-License-Identifier: MIT */
/*
 * The arguments of nodes as numbers, vectors, colours and transformations, with
 * the promotions of the language: a float where a vector is wanted stands for
 * every component, a 2-vector gets z = 0.
 */
#include "lower/lower.h"

#include <limits.h>

static const struct number zero = { .terms = 1 };

static const struct number *number_at(
	struct lowering *l, const struct node *n, uint32_t index, const char *what)
{
	if (index < n->arg_count && n->args[index].kind == ARG_NUMBER)
		return &n->args[index].number;
	diag_error(l->diag, n->word, "%s needs %s", keyword_name(n->keyword), what);
	return &zero;
}

double lower_float(struct lowering *l, const struct node *n, uint32_t index, const char *what)
{
	const struct number *v = number_at(l, n, index, what);
	if (v->terms != 1)
		diag_error(l->diag, n->args[index].span,
			"%s: %s must be a float, this is a vector of %d components",
			keyword_name(n->keyword), what, v->terms);
	return v->v[0];
}

int lower_int(struct lowering *l, const struct node *n, uint32_t index, const char *what)
{
	const double v = lower_float(l, n, index, what);
	return v >= INT_MAX ? INT_MAX : v <= INT_MIN ? INT_MIN : v == v ? (int)v : 0;
}

int lower_octaves(struct lowering *l, const struct node *n)
{
	const int octaves = lower_int(l, n, 0, "a number");
	return octaves < 1 ? 1 : octaves > 10 ? 10 : octaves;
}

vec3 lower_vector(struct lowering *l, const struct node *n, uint32_t index, const char *what)
{
	const struct number *v = number_at(l, n, index, what);
	if (v->terms == 1 && !v->leftover)
		return vec(v->v[0], v->v[0], v->v[0]);
	if (v->terms == 2)
		return vec(v->v[0], v->v[1], 0);
	if (v->terms > 3)
		diag_error(l->diag, n->args[index].span,
			"%s: %s must be a vector of 3 components, this has %d",
			keyword_name(n->keyword), what, v->terms);
	return vec(v->v[0], v->v[1], v->v[2]);
}

colour lower_colour(struct lowering *l, const struct node *n, uint32_t index)
{
	const struct number *v = number_at(l, n, index, "a colour");
	return (colour){ (float)v->v[0], (float)v->v[1], (float)v->v[2], (float)v->v[3],
		(float)v->v[4] };
}

rgb lower_rgb(struct lowering *l, const struct node *n, uint32_t index, const char *what)
{
	const struct number *v = number_at(l, n, index, what);
	if (v->terms == 1)
		return rgb_grey((float)v->v[0]);
	return (rgb){ (float)v->v[0], (float)v->v[1], (float)v->v[2] };
}

bool lower_switch(struct lowering *l, const struct node *n, bool absent)
{
	return n->arg_count ? lower_float(l, n, 0, "a switch") > 0 : absent;
}

const struct node *node_resolve(const struct node *n)
{
	while (n && n->keyword == K_REFERENCE)
		n = n->ref;
	return n;
}

bool node_is_transform(const struct node *n)
{
	switch (node_resolve(n)->keyword) {
	case K_TRANSLATE:
	case K_ROTATE:
	case K_SCALE:
	case K_MATRIX:
	case K_TRANSFORM:
		return true;
	default:
		return false;
	}
}

static transform lower_scale(struct lowering *l, const struct node *n)
{
	vec3 by = lower_vector(l, n, 0, "a vector");
	if (by.x == 0 || by.y == 0 || by.z == 0)
		diag_warning(l->diag, n->span, "scale by 0 changed to scale by 1");
	by.x = by.x == 0 ? 1 : by.x;
	by.y = by.y == 0 ? 1 : by.y;
	by.z = by.z == 0 ? 1 : by.z;
	return transform_scale(by);
}

static transform lower_matrix(struct lowering *l, const struct node *n)
{
	transform t = transform_identity();
	if (!n->arg_count || n->args[0].kind != ARG_ARRAY || n->args[0].array.count != 12) {
		diag_error(l->diag, n->span, "matrix needs 12 numbers");
		return t;
	}
	if (!transform_matrix(n->args[0].array.values, &t)) {
		diag_error(l->diag, n->span, "the matrix is singular: it cannot be inverted");
		return transform_identity();
	}
	return t;
}

/* transform { items }: left to right; `inverse` anywhere inverts the whole. */
static transform lower_transform_block(struct lowering *l, const struct node *n)
{
	transform t = transform_identity();
	bool inverse = false;
	for (const struct node *item = n->children; item; item = item->next) {
		if (item->keyword == K_INVERSE) {
			inverse = true;
			continue;
		}
		const transform step = lower_transform(l, item);
		t = transform_compose(&t, &step);
	}
	return inverse ? transform_invert(&t) : t;
}

transform lower_transform(struct lowering *l, const struct node *item)
{
	const struct node *n = node_resolve(item);
	switch (n->keyword) {
	case K_TRANSLATE:
		return transform_translate(lower_vector(l, n, 0, "a vector"));
	case K_ROTATE:
		return transform_rotate(lower_vector(l, n, 0, "a vector"));
	case K_SCALE:
		return lower_scale(l, n);
	case K_MATRIX:
		return lower_matrix(l, n);
	case K_TRANSFORM:
		return lower_transform_block(l, n);
	default:
		diag_error(l->diag, item->span, "a transformation is expected here, this is %s",
			keyword_name(n->keyword));
		return transform_identity();
	}
}

void lower_unsupported(struct lowering *l, const struct node *n, const char *what)
{
	diag_unsupported(l->diag, n->word, what);
}
