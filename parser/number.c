/* SPDX-License-Identifier: MIT */
/*
 * Arithmetic on values of one to five terms.
 *
 * A float meets a vector by being copied to every component, a shorter vector
 * by zeros. Comparisons have a tolerance. A value whose component was selected
 * (`V.y`) is a float, but where a vector is wanted the other components are
 * still those of V: `leftover`.
 */
#include "build.h"

#include "grammar.tab.h"

#include <math.h>

struct number number_float(double value)
{
	return (struct number){ .terms = 1, .v = { value } };
}

struct number number_vector(double x, double y, double z)
{
	return (struct number){ .terms = 3, .v = { x, y, z } };
}

struct number number_axis(enum keyword word)
{
	switch (word) {
	case K_X:
		return number_vector(1, 0, 0);
	case K_Y:
		return number_vector(0, 1, 0);
	case K_Z:
		return number_vector(0, 0, 1);
	case K_U:
		return (struct number){ .terms = 2, .v = { 1 } };
	case K_V:
		return (struct number){ .terms = 2, .v = { 0, 1 } };
	default:
		return (struct number){ .terms = 4, .v = { 0, 0, 0, 1 } };
	}
}

struct number number_plain(struct number n)
{
	if (!n.leftover)
		return n;
	return number_float(n.v[0]);
}

int number_truncate(double value)
{
	if (!(value > -2147483649.0 && value < 2147483648.0))
		return -2147483647 - 1;
	return (int)value;
}

struct number number_negate(struct number n)
{
	for (unsigned i = 0; i < n.terms; i++)
		n.v[i] = -n.v[i];
	return n;
}

struct number number_not(struct number n)
{
	for (unsigned i = 0; i < n.terms; i++)
		n.v[i] = fabs(n.v[i]) > EPSILON ? 0 : 1;
	return n;
}

bool number_is_true(struct parser *p, struct number n, span where)
{
	return fabs(number_to_float(p, n, where)) > EPSILON;
}

/* -- Binary operators --------------------------------------------------------------------- */

/* The same number of terms on both sides. */
static void promote(struct number *n, unsigned terms)
{
	if (n->terms == terms)
		return;
	for (unsigned i = n->terms; i < terms; i++)
		n->v[i] = n->terms == 1 ? n->v[0] : 0;
	n->terms = (uint8_t)terms;
	n->leftover = false;
}

static bool is_arithmetic(int op)
{
	return op == '+' || op == '-' || op == '*' || op == '/';
}

static double compute(int op, double a, double b, bool *zero)
{
	switch (op) {
	case '+':
		return a + b;
	case '-':
		return a - b;
	case '*':
		return a * b;
	case '/':
		if (b != 0)
			return a / b;
		*zero = true;
		return INFINITY;
	case '<':
		return a < b;
	case '>':
		return a > b;
	case '=':
		return !(fabs(a - b) > EPSILON);
	case T_NE:
		return fabs(a - b) > EPSILON;
	case T_LE:
		return a <= b || !(fabs(a - b) > EPSILON); /* so NaN is, too */
	case T_GE:
		return a >= b || !(fabs(a - b) > EPSILON);
	case '&':
		return fabs(a) > EPSILON && fabs(b) > EPSILON;
	default:
		return fabs(a) > EPSILON || fabs(b) > EPSILON;
	}
}

struct number number_binary(struct parser *p, int op, struct number a, struct number b, span where)
{
	bool zero = false;
	if (a.terms != b.terms) {
		const unsigned terms = a.terms > b.terms ? a.terms : b.terms;
		promote(&a, terms);
		if (b.leftover && !is_arithmetic(op))
			b.terms = (uint8_t)terms; /* relations do not promote their right side */
		else
			promote(&b, terms);
	}
	for (unsigned i = 0; i < a.terms; i++)
		a.v[i] = compute(op, a.v[i], b.v[i], &zero);
	if (zero)
		parser_warning(p, where, "division by zero; the result is infinite");
	return a;
}

/* -- Components --------------------------------------------------------------------------- */

unsigned component_index(enum keyword component)
{
	switch (component) {
	case K_X:
	case K_U:
	case K_RED:
		return 0;
	case K_Y:
	case K_V:
	case K_GREEN:
		return 1;
	case K_Z:
	case K_BLUE:
		return 2;
	case K_T:
	case K_FILTER:
		return 3;
	case K_TRANSMIT:
		return 4;
	default:
		return COMPONENT_GRAY;
	}
}

struct number number_select(struct parser *p, struct number n, enum keyword component, span where)
{
	const unsigned i = component_index(component);
	const bool is_float = n.terms == 1;
	const unsigned needed = i == COMPONENT_GRAY ? 3 : i + 1;
	if (is_float && i == 0) {
		for (unsigned k = 1; k < 5; k++)
			n.v[k] = n.v[0];
		n.leftover = true;
		return n;
	}
	if (needed > n.terms) {
		if (is_float)
			parser_error(p, where, "a float has no component %s: it is no vector",
				keyword_name(component));
		else
			parser_error(p, where, "a vector of %u components has no component %s",
				n.terms, keyword_name(component));
		return number_float(0);
	}
	n.v[0] = i == COMPONENT_GRAY ? 0.297 * n.v[0] + 0.589 * n.v[1] + 0.114 * n.v[2] : n.v[i];
	for (unsigned k = n.terms; k < 5; k++)
		n.v[k] = 0;
	n.terms = 1;
	n.leftover = true;
	return n;
}

struct number number_literal(struct parser *p, size_t start, span where)
{
	struct grammar *g = p->grammar;
	const size_t count = g->arg_count - start;
	struct number n = { .terms = (uint8_t)(count < 5 ? count : 5) };
	if (count < 2 || count > 5) {
		parser_error(p, where, "a vector has 2 to 5 components, found %zu", count);
		note_sign(p, where);
	}
	for (unsigned i = 0; i < n.terms; i++)
		n.v[i] = number_to_float(p, g->args[start + i].number, g->args[start + i].span);
	g->arg_count = start;
	return n;
}

/* -- What a place wants ------------------------------------------------------------------- */

double number_to_float(struct parser *p, struct number n, span where)
{
	if (n.terms != 1)
		parser_error(p, where, "a float is wanted here, not a %s",
			n.terms == 5 ? "colour" : "vector");
	return n.v[0];
}

struct number number_check(struct parser *p, struct number n, unsigned terms, span where)
{
	if (n.terms > terms)
		parser_error(p, where, "a vector of %u components is wanted here, not %s", terms,
			n.terms == 5   ? "a colour"
			: n.terms == 4 ? "one of 4"
				       : "one of 3");
	return n;
}

void number_to_vector(struct parser *p, struct number n, unsigned terms, span where, double out[5])
{
	number_check(p, n, terms, where);
	for (unsigned i = 0; i < 5; i++)
		out[i] = i < n.terms || n.leftover ? n.v[i] : n.terms == 1 ? n.v[0] : 0;
}
