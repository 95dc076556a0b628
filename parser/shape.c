/* SPDX-License-Identifier: MIT */
/*
 * The primitives that are a list of values, checked against their rows of
 * shapes.def, so that a missing radius is called a missing radius; and the
 * polynomials with their long lists of coefficients.
 */
#include "build.h"
#include "language/shape_word.h"

#include <math.h>

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

/* What one statement may be, from the row of its word. */
struct shape_form {
	enum keyword keyword;
	const struct parameter *arguments;
	const char *letters;
	size_t count, least;	       /* leading arguments it may and must have */
	const struct parameter *array; /* the list behind them; NULL: none */
};

static struct shape_form form_of(enum keyword keyword)
{
	const struct shape_word *word = shape_word_of(keyword);
	struct shape_form form = { keyword, word->parameters, word->letters, 0, 0, NULL };
	const struct parameter *p = word->parameters;
	for (; p->type != PARAMETER_END && p->type < PARAMETER_ARRAY; p++) {
		form.count++;
		form.least += p->type != PARAMETER_OPTIONAL;
	}
	if (p->type == PARAMETER_ARRAY)
		form.array = p;
	return form;
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
	const unsigned stride = form->array->stride;
	const size_t per = stride == 4 ? 2 : 1;
	const size_t found = (g->arg_count - start) / per;
	const double wanted = form->array->count ? (double)form->array->count
						 : floor(g->args[start - 1].number.v[0]);
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
	double *values = ARENA_ARRAY(p->tree, found * stride, double);
	for (size_t i = 0; i < found; i++) {
		double element[5];
		list_element(p, &g->args[start + i * per], stride, element);
		for (unsigned k = 0; k < stride; k++)
			values[i * stride + k] = element[k];
	}
	const span where = found ? g->args[start].span : word;
	g->arg_count = start;
	args_push_array(p, values, found * stride, stride, where);
}

static bool takes_string(const struct parameter *p)
{
	return p && (p->type == PARAMETER_FONT || p->type == PARAMETER_STRING);
}

static const char *kind_name(const struct arg *arg)
{
	return arg->number.terms == 5 ? "colour" : "vector";
}

/* Refuses an argument of another kind than its parameter (NULL: beyond the last) is of. */
static void check_kind(struct parser *p, const struct shape_form *form,
	const struct parameter *parameter, const struct arg *arg, span from)
{
	const char *word = keyword_name(form->keyword);
	if (arg->kind == ARG_STRING && !takes_string(parameter)) {
		parser_error(p, arg->span, "%s needs %s, found a string", word,
			parameter ? parameter->name : "a number");
	} else if (arg->kind != ARG_STRING && parameter && parameter->type == PARAMETER_STRING) {
		parser_error(p, arg->span, "%s needs a string here", word);
	} else if (arg->kind == ARG_NUMBER && arg->number.terms != 1 && parameter &&
		   (parameter->type == PARAMETER_FLOAT || parameter->type == PARAMETER_OPTIONAL)) {
		parser_error(p, arg->span, "%s needs %s, which is a float, found a %s", word,
			parameter->name, kind_name(arg));
		note_sign(p, span_join(from, arg->span));
	}
}

static void check_kinds(struct parser *p, const struct shape_form *form, size_t start)
{
	const struct grammar *g = p->grammar;
	for (size_t i = start; i < g->arg_count; i++)
		check_kind(p, form, i - start < form->count ? &form->arguments[i - start] : NULL,
			&g->args[i], g->args[start].span);
}

void shape_check_items(struct parser *p, const struct node *shape)
{
	const struct shape_word *word = shape_word_of(shape->keyword);
	if (!word || word->keyword == K_OBJECT)
		return; /* depends on what was copied */
	for (const struct node *n = shape->children; n; n = n->next)
		if (!shape_word_takes(word, n->keyword))
			parser_error(p, n->span, "%s does not apply to %s",
				keyword_name(n->keyword), keyword_name(shape->keyword));
}

/* A colour identifier behind the numbers is an obsolete colour of the object. */
static void take_old_colour(struct parser *p, const struct shape_form *form, struct body *body)
{
	struct grammar *g = p->grammar;
	if (form->array || g->arg_count - body->start <= form->least)
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
	const struct shape_form form = form_of(keyword);
	take_old_colour(p, &form, &body);
	const size_t found = g->arg_count - body.start;
	struct node *node = NULL;
	check_kinds(p, &form, body.start);
	if (body.has_bare_font && form.arguments->type == PARAMETER_FONT)
		parser_error(p, g->args[body.start].span,
			"%s needs the word ttf before the name of a font file",
			keyword_name(keyword));
	if (found < form.least) {
		parser_error(
			p, word, "%s needs %s", keyword_name(keyword), form.arguments[found].name);
		note_sign_in(p, body.start);
		node = node_args(p, keyword, whole, word, body.start);
	} else if (form.array) {
		for (size_t i = 0; i < form.least; i++) {
			struct arg *arg = &g->args[body.start + i];
			arg->number = number_float(number_to_float(p, arg->number, arg->span));
		}
		gather(p, &form, body.start + form.least, word);
		node = node_args(p, keyword, whole, word, body.start);
	} else {
		if (form.count > form.least &&
			found > form.count) { /* the last optional one counts */
			g->args[body.start + form.least] = g->args[g->arg_count - 1];
			g->arg_count = body.start + form.count;
		}
		node = node_fit(p, keyword, whole, word, body.start, form.letters);
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
