/* SPDX-License-Identifier: MIT */
/*
 * The primitives that are a list of numbers: what each wants, so that a
 * missing radius is called a missing radius; and the polynomials with their
 * long lists of coefficients.
 */
#include "build.h"

#include <math.h>
#include <string.h>

/* One line each: the letters of node_fit for the leading arguments, then what the rest is. */
struct shape_form {
	enum keyword keyword;
	const char *letters;
	unsigned tail; /* numbers per element of the list behind them, 0: none */
	size_t fixed;  /* elements the list must have, 0: as many as the last float says */
	const char *names[8];
};

/* clang-format off */
static const struct shape_form forms[] = {
	{ K_SPHERE,          "vf",      0, 0, { "a centre", "a radius" } },
	{ K_BOX,             "vv",      0, 0, { "a corner", "a second corner" } },
	{ K_CYLINDER,        "vvf",     0, 0, { "a base point", "a cap point", "a radius" } },
	{ K_CONE,            "vfvf",    0, 0, { "a base point", "a base radius", "a cap point", "a cap radius" } },
	{ K_TORUS,           "ff",      0, 0, { "a major radius", "a minor radius" } },
	{ K_PLANE,           "vf",      0, 0, { "a normal", "a distance" } },
	{ K_DISC,            "vvff?",   0, 0, { "a centre", "a normal", "a radius", "a hole radius" } },
	{ K_TRIANGLE,        "vvv",     0, 0, { "a first corner", "a second corner", "a third corner" } },
	{ K_SMOOTH_TRIANGLE, "vvvvvv",  0, 0, { "a first corner", "a first normal", "a second corner",
		"a second normal", "a third corner", "a third normal" } },
	{ K_QUADRIC,         "vvvf",    0, 0, { "square terms", "mixed terms", "linear terms", "a constant term" } },
	{ K_SUPERELLIPSOID,  "2",       0, 0, { "exponents" } },
	{ K_OVUS,            "ff",      0, 0, { "a bottom radius", "a top radius" } },
	{ K_TEXT,            "ssfv",    0, 0, { "a font", "a text", "a thickness", "an offset" } },
	{ K_POLYGON,         "f",       3, 0, { "a number of points" } },
	{ K_LATHE,           "f",       2, 0, { "a number of points" } },
	{ K_PRISM,           "fff",     2, 0, { "a base height", "a top height", "a number of points" } },
	{ K_SOR,             "f",       2, 0, { "a number of points" } },
	{ K_SPHERE_SWEEP,    "f",       4, 0, { "a number of spheres" } },
	{ K_BICUBIC_PATCH,   "",        3, 16, { NULL } },
};
/* clang-format on */

static const struct shape_form *form_of(enum keyword keyword)
{
	for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
		if (forms[i].keyword == keyword)
			return &forms[i];
	return NULL;
}

struct body body_add(struct body body, struct node *item)
{
	body.items = list_add(body.items, item);
	return body;
}

void body_comma(struct parser *p, struct body body, span where)
{
	if (args_height(p) == body.start && !body.items.first)
		parser_error(p, where, "unexpected ',' before the first value");
}

struct body body_string(struct parser *p, struct body body, const char *text, span where)
{
	body.has_bare_font |= args_height(p) == body.start;
	args_push_string(p, text, where);
	return body;
}

/* How many leading arguments there must be. */
static size_t leading(const struct shape_form *form)
{
	size_t n = 0;
	for (const char *c = form->letters; *c; c++)
		n += *c != '?' && c[1] != '?';
	return n;
}

/* Writes one element of a list: a vector, or for sphere_sweep a centre and a radius. */
static void list_element(struct parser *p, const struct arg *args, unsigned stride, double out[5])
{
	if (stride == 4) {
		number_to_vector(p, args[0].number, 3, args[0].span, out);
		out[3] = number_to_float(p, args[1].number, args[1].span);
	} else {
		number_to_vector(p, args[0].number, stride, args[0].span, out);
	}
}

/* Replaces the arguments from `start` by one array. */
static void gather(struct parser *p, const struct shape_form *form, size_t start, span word)
{
	struct grammar *g = p->grammar;
	const size_t per = form->tail == 4 ? 2 : 1;
	const size_t found = (g->arg_count - start) / per;
	const double wanted =
		form->fixed ? (double)form->fixed : floor(g->args[start - 1].number.v[0]);
	if (!(wanted >= 1))
		parser_error(p, g->args[start - 1].span, "%s needs 1 point or more, not %g",
			keyword_name(form->keyword), wanted);
	if ((double)found != wanted || (g->arg_count - start) % per) {
		parser_error(p, word, "%s needs %g points, found %zu", keyword_name(form->keyword),
			wanted, found);
		note_sign_in(p, start);
		g->arg_count = start;
		return;
	}
	double *values = ARENA_ARRAY(p->tree, found * form->tail, double);
	for (size_t i = 0; i < found; i++) {
		double element[5];
		list_element(p, &g->args[start + i * per], form->tail, element);
		for (unsigned k = 0; k < form->tail; k++)
			values[i * form->tail + k] = element[k];
	}
	const span where = found ? g->args[start].span : word;
	g->arg_count = start;
	args_push_array(p, values, found * form->tail, form->tail, where);
}

/* Strings stand in the first two places of a text, and nowhere else. */
static void check_kinds(struct parser *p, const struct shape_form *form, size_t start)
{
	const struct grammar *g = p->grammar;
	const enum keyword keyword = form->keyword;
	const size_t letters = strlen(form->letters);
	for (size_t i = start; i < g->arg_count; i++) {
		const struct arg *arg = &g->args[i];
		const bool wants = keyword == K_TEXT && i - start < 2;
		if (arg->kind == ARG_STRING && !wants)
			parser_error(p, arg->span, "%s needs %s, found a string",
				keyword_name(keyword),
				i - start < letters && form->names[i - start]
					? form->names[i - start]
					: "a number");
		else if (arg->kind != ARG_STRING && wants && i != start)
			parser_error(p, arg->span, "text needs a string here");
		else if (arg->kind == ARG_NUMBER && arg->number.terms != 1 && i - start < letters &&
			 form->letters[i - start] == 'f') {
			parser_error(p, arg->span, "%s needs %s, which is a float, found a %s",
				keyword_name(keyword), form->names[i - start],
				arg->number.terms == 5 ? "colour" : "vector");
			note_sign(p, span_join(g->args[start].span, arg->span));
		}
	}
}

/* The items that only some primitives have, with these. */
static const struct {
	enum keyword item, shapes[12];
} special_items[] = {
	{ K_STURM, { K_BLOB, K_CUBIC, K_LATHE, K_OVUS, K_POLY, K_POLYNOMIAL, K_PRISM, K_QUARTIC,
			   K_SOR, K_TORUS } },
	{ K_HIERARCHY, { K_BLOB, K_HEIGHT_FIELD, K_MESH, K_MESH2 } },
	{ K_SPLIT_UNION, { K_UNION, K_MERGE } },
	{ K_CUTAWAY_TEXTURES, { K_INTERSECTION, K_DIFFERENCE } },
	{ K_OPEN, { K_CYLINDER, K_CONE, K_ISOSURFACE, K_PRISM, K_SOR } },
	{ K_LINEAR_SPLINE, { K_LATHE, K_PRISM, K_SPHERE_SWEEP } },
	{ K_QUADRATIC_SPLINE, { K_LATHE, K_PRISM } },
	{ K_CUBIC_SPLINE, { K_LATHE, K_PRISM, K_SPHERE_SWEEP } },
	{ K_BEZIER_SPLINE, { K_LATHE, K_PRISM } },
	{ K_B_SPLINE, { K_SPHERE_SWEEP } },
	{ K_LINEAR_SWEEP, { K_PRISM } },
	{ K_CONIC_SWEEP, { K_PRISM } },
	{ K_SMOOTH, { K_HEIGHT_FIELD } },
	{ K_WATER_LEVEL, { K_HEIGHT_FIELD } },
	{ K_TOLERANCE, { K_SPHERE_SWEEP } },
	{ K_TYPE, { K_BICUBIC_PATCH } },
	{ K_FLATNESS, { K_BICUBIC_PATCH } },
	{ K_U_STEPS, { K_BICUBIC_PATCH } },
	{ K_V_STEPS, { K_BICUBIC_PATCH } },
	{ K_ACCURACY, { K_BICUBIC_PATCH, K_ISOSURFACE, K_PARAMETRIC } },
	{ K_UV_VECTORS, { K_BICUBIC_PATCH, K_MESH2 } },
};

static bool item_applies(enum keyword item, enum keyword shape)
{
	for (size_t i = 0; i < sizeof special_items / sizeof *special_items; i++) {
		if (special_items[i].item != item)
			continue;
		for (const enum keyword *s = special_items[i].shapes; *s != K_NONE; s++)
			if (*s == shape)
				return true;
		return false;
	}
	return true;
}

void shape_check_items(struct parser *p, const struct node *shape)
{
	if (shape->keyword == K_OBJECT)
		return; /* depends on what was copied */
	for (const struct node *n = shape->children; n; n = n->next)
		if (!item_applies(n->keyword, shape->keyword))
			parser_error(p, n->span, "%s does not apply to %s",
				keyword_name(n->keyword), keyword_name(shape->keyword));
}

/* A colour identifier behind the numbers is an obsolete colour of the object. */
static void take_old_colour(
	struct parser *p, const struct shape_form *form, struct body *body, size_t least)
{
	struct grammar *g = p->grammar;
	if (form->tail || g->arg_count - body->start <= least)
		return;
	const struct arg *last = &g->args[g->arg_count - 1];
	if (last->kind != ARG_NUMBER || last->number.terms != 5)
		return;
	struct node *colour =
		old_colour(p, (struct colour_value){ last->number, NULL, true }, last->span);
	g->arg_count--;
	body->items = list_join(list_one(colour), body->items);
}

struct node *shape_node(
	struct parser *p, enum keyword keyword, span whole, span word, struct body body)
{
	struct grammar *g = p->grammar;
	const struct shape_form *form = form_of(keyword);
	const size_t least = leading(form);
	take_old_colour(p, form, &body, least);
	const size_t found = g->arg_count - body.start;
	struct node *node = NULL;
	check_kinds(p, form, body.start);
	if (keyword == K_TEXT && body.has_bare_font)
		parser_error(p, g->args[body.start].span,
			"text needs the word ttf before the name of a font file");
	if (found < least) {
		parser_error(p, word, "%s needs %s", keyword_name(keyword), form->names[found]);
		note_sign_in(p, body.start);
		g->arg_count = body.start + found;
		node = node_args(p, keyword, whole, word, body.start);
	} else if (form->tail) {
		for (size_t i = 0; i < least; i++) {
			struct arg *arg = &g->args[body.start + i];
			arg->number = number_float(number_to_float(p, arg->number, arg->span));
		}
		gather(p, form, body.start + least, word);
		node = node_args(p, keyword, whole, word, body.start);
	} else {
		if (keyword == K_DISC && found > 4) { /* the last hole radius counts */
			g->args[body.start + 3] = g->args[g->arg_count - 1];
			g->arg_count = body.start + 4;
		}
		node = node_fit(p, keyword, whole, word, body.start, form->letters);
	}
	node->children = body.items.first;
	return node;
}

/* The coefficients of all terms of a lower order than `order`. */
static size_t coefficients_below(size_t order)
{
	return order * (order + 1) * (order + 2) / 6;
}

/* 0 after an error. */
static size_t take_order(struct parser *p, enum keyword keyword, struct arg *arg)
{
	const double said = number_to_float(p, arg->number, arg->span);
	arg->number = number_float(said);
	if (said >= 2 && said < 36)
		return (size_t)said;
	parser_error(p, arg->span, "the order of a %s is 2 to 35", keyword_name(keyword));
	return 0;
}

struct node *shape_coefficients(struct parser *p, enum keyword keyword, span whole, span word,
	size_t start, span at, struct node_list items)
{
	struct grammar *g = p->grammar;
	size_t order = keyword == K_CUBIC ? 3 : 4, first = start;
	if (keyword == K_POLY) {
		order = take_order(p, keyword, &g->args[start]);
		first++;
	}
	const size_t wanted = coefficients_below(order + 1);
	const size_t found = g->arg_count - first;
	if (order && found != wanted) {
		parser_error(p, at, "%s needs %zu coefficients, found %zu", keyword_name(keyword),
			wanted, found);
		note_sign_in(p, first);
	}
	double *values = ARENA_ARRAY(p->tree, found + 1, double);
	for (size_t i = 0; i < found; i++)
		values[i] = number_to_float(p, g->args[first + i].number, g->args[first + i].span);
	g->arg_count = first;
	args_push_array(p, values, found, 1, at);
	struct node *node = node_args(p, keyword, whole, word, start);
	node->children = items.first;
	return node;
}

/* The place of the coefficient of x^i y^j z^k among all of them; SIZE_MAX after an error. */
static size_t place_of_term(struct parser *p, const struct node *term, size_t order)
{
	size_t left = order, place = 0;
	for (size_t n = 0; n < 3; n++) {
		const double power = floor(term->args[n].number.v[0]);
		if (!(power >= 0 && power <= (double)left)) {
			parser_error(p, term->args[n].span,
				"exponents are 0 or more, and their sum is the order, %zu, at most",
				order);
			return SIZE_MAX;
		}
		left -= (size_t)power;
		/* terms with a higher power of x, then of y, then of z stand before it */
		place += n == 0 ? coefficients_below(left) : n == 1 ? left * (left + 1) / 2 : left;
	}
	return place;
}

struct node *shape_terms(struct parser *p, span whole, span word, size_t start,
	struct node_list terms, struct node_list items)
{
	const size_t order = take_order(p, K_POLYNOMIAL, &p->grammar->args[start]);
	const size_t count = coefficients_below(order + 1);
	double *values = ARENA_ARRAY(p->tree, count, double);
	for (const struct node *term = terms.first; order && term; term = term->next) {
		const size_t place = place_of_term(p, term, order);
		if (place != SIZE_MAX)
			values[place] = term->args[3].number.v[0];
	}
	p->grammar->arg_count = start + 1;
	args_push_array(p, values, count, 1, word);
	struct node *node = node_args(p, K_POLYNOMIAL, whole, word, start);
	node->children = items.first;
	return node;
}
