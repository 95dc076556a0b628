/* SPDX-License-Identifier: MIT */
/*
 * Bodies of user-defined functions: the tree of the expression, its names
 * resolved to parameters and loop variables.
 *
 * x and u are one variable, y and v too: the last parameter called by either
 * name. A list without them leaves them 0.
 */
#include "build.h"
#include "expand.h"

#include "grammar.tab.h"

#include <string.h>

enum { INTERNAL_FUNCTIONS = 79, FUNCTION_CALLS_MAX = 1000000 };

/* The function being read. */
struct function_scope {
	struct function_scope *outer;
	const char **names; /* parameters, then loop variables in scope */
	unsigned parameter_count, name_count, capacity, variable_count;
	unsigned *indices; /* variable of each name */
	size_t calls;
	bool listed;
};

/* Parameters of internal(n) beyond x, y, z. */
static const unsigned char internal_parameters[INTERNAL_FUNCTIONS] = {
	5, 5, 5, 5, 2, 2, 5, 4, 2, 1,  /* 0 */
	4, 1, 1, 1, 1, 6, 6, 3, 1, 4,  /* 10 */
	3, 6, 1, 1, 10, 7, 7, 1, 1, 6, /* 20 */
	1, 3, 4, 3, 6, 1, 1, 4, 1, 6,  /* 30 */
	5, 1, 1, 1, 4, 1, 3, 0, 1, 1,  /* 40 */
	7, 5, 6, 1, 1, 1, 3, 0, 6, 6,  /* 50 */
	4, 1, 5, 4, 6, 1, 4, 7, 2, 0,  /* 60 */
	2, 3, 1, 1, 2, 6, 0, 0, 1,     /* 70 */
};

/* -- Scopes ------------------------------------------------------------------------------- */

static void add_name(struct parser *p, struct function_scope *s, const char *name, unsigned index)
{
	if (s->name_count == s->capacity) {
		const unsigned capacity = s->capacity ? 2 * s->capacity : 8;
		const char **names = ARENA_ARRAY(p->arena, capacity, const char *);
		unsigned *indices = ARENA_ARRAY(p->arena, capacity, unsigned);
		if (s->name_count) {
			memcpy(names, s->names, s->name_count * sizeof *names);
			memcpy(indices, s->indices, s->name_count * sizeof *indices);
		}
		s->names = names;
		s->indices = indices;
		s->capacity = capacity;
	}
	s->names[s->name_count] = name;
	s->indices[s->name_count++] = index;
}

void function_begin(struct parser *p, size_t start, bool listed)
{
	static const char *const xyz[] = { "x", "y", "z" };
	struct grammar *g = p->grammar;
	struct function_scope *s = ARENA_NEW(p->arena, struct function_scope);
	const size_t count = listed ? g->arg_count - start : 3;
	s->outer = g->scope;
	s->listed = listed;
	for (size_t i = 0; i < count; i++)
		add_name(p, s, listed ? g->args[start + i].string : xyz[i], (unsigned)i);
	if (count > FUNCTION_PARAMETERS_MAX)
		parser_error(p, g->args[start].span, "a function has at most %d parameters",
			FUNCTION_PARAMETERS_MAX);
	g->arg_count = start;
	s->parameter_count = s->variable_count = (unsigned)count;
	g->scope = s;
	expand_push_names(p, s->names, s->name_count);
}

static struct function *close(struct parser *p, enum function_kind kind, span where)
{
	struct function_scope *s = p->grammar->scope;
	struct function *f = ARENA_NEW(p->arena, struct function);
	expand_pop_names(p);
	p->grammar->scope = s->outer;
	f->kind = kind;
	f->span = where;
	f->parameter_count = s->parameter_count;
	f->variable_count = s->variable_count;
	f->calls = s->calls;
	if (s->outer)
		s->outer->calls += s->calls;
	if (s->listed && kind != FUNCTION_EXPRESSION && kind != FUNCTION_INTERNAL)
		parser_error(p, where, "this kind of function takes no list of parameters");
	return f;
}

static enum function_kind kind_of(const struct node *node)
{
	switch (node->keyword) {
	case K_PIGMENT:
		return FUNCTION_PIGMENT;
	case K_TRANSFORM:
		return FUNCTION_TRANSFORM;
	default:
		return FUNCTION_PATTERN;
	}
}

/* Some patterns need a surface, or more than a number. */
static void check_pattern(struct parser *p, const struct node *block)
{
	const struct node *pattern = block->children;
	switch (pattern->keyword) {
	case K_AOI:
	case K_AVERAGE:
	case K_FACETS:
	case K_SLOPE:
	case K_SQUARE:
	case K_TRIANGULAR:
		parser_error(p, pattern->word, "the pattern %s cannot be a function",
			keyword_name(pattern->keyword));
		break;
	default:
		break;
	}
}

const struct function *function_end(
	struct parser *p, const struct expr *body, span where, struct node *node, int internal)
{
	if (node) {
		struct function *f = close(p, kind_of(node), where);
		f->node = node;
		if (f->kind == FUNCTION_PATTERN)
			check_pattern(p, node);
		return f;
	}
	if (body) {
		struct function *f = close(p, FUNCTION_EXPRESSION, where);
		f->body = body;
		return f;
	}
	struct function *f = close(p, FUNCTION_INTERNAL, where);
	f->internal = internal;
	if (internal < 0 || internal >= INTERNAL_FUNCTIONS || internal == 77)
		parser_error(p, where, "there is no internal function %d", internal);
	else
		f->parameter_count = f->variable_count = 3u + internal_parameters[internal];
	return f;
}

const struct function *function_from_spline(
	struct parser *p, const struct spline *spline, span where)
{
	struct function *f = close(p, FUNCTION_SPLINE, where);
	f->spline = spline;
	f->parameter_count = f->variable_count = 1;
	return f;
}

unsigned function_terms(const struct function *f)
{
	switch (f->kind) {
	case FUNCTION_PIGMENT:
		return 5;
	case FUNCTION_TRANSFORM:
		return 3;
	case FUNCTION_SPLINE:
		return f->spline->terms;
	default:
		return 1;
	}
}

/* Whoever walks an expression may do so by recursion: it is never deeper than this. */
enum { EXPR_DEPTH_MAX = 4000 };

/* -- Nodes -------------------------------------------------------------------------------- */

static struct expr *make(struct parser *p, enum expr_kind kind, span where)
{
	struct expr *e = ARENA_NEW(p->arena, struct expr);
	e->kind = kind;
	e->span = where;
	return e;
}

static void set_operands(
	struct parser *p, struct expr *e, const struct expr *const *operands, size_t count)
{
	e->operand_count = (uint32_t)count;
	e->operands = arena_copy(p->arena, operands, count * sizeof *operands);
	for (size_t i = 0; i < count; i++)
		if (e->depth <= operands[i]->depth)
			e->depth = operands[i]->depth + 1;
	if (e->depth == EXPR_DEPTH_MAX + 1)
		parser_error(p, e->span, "the expression has more than %d levels", EXPR_DEPTH_MAX);
}

static const struct expr *expr_constant(struct parser *p, double value, span where)
{
	struct expr *e = make(p, EXPR_CONSTANT, where);
	e->constant = value;
	e->literal = true;
	return e;
}

const struct expr *expr_number(struct parser *p, struct number_value n, span where)
{
	if (n.keyword != K_NONE && n.keyword != K_PI && n.keyword != K_CLOCK)
		parser_error(
			p, where, "'%s' cannot be used in a function", keyword_name(n.keyword));
	return expr_constant(p, n.number.v[0], where);
}

static const struct expr *parameter(struct parser *p, unsigned index, span where)
{
	struct expr *e = make(p, EXPR_PARAMETER, where);
	e->index = (uint16_t)index;
	return e;
}

static bool same_variable(const char *a, const char *b)
{
	if (strcmp(a, b) == 0)
		return true;
	if (a[1] || b[1])
		return false;
	return (a[0] == 'x' && b[0] == 'u') || (a[0] == 'u' && b[0] == 'x') ||
	       (a[0] == 'y' && b[0] == 'v') || (a[0] == 'v' && b[0] == 'y');
}

/* The innermost variable of that name. */
static bool find_name(const struct function_scope *s, const char *name, unsigned *index)
{
	for (unsigned i = s->name_count; i-- > 0;)
		if (same_variable(s->names[i], name)) {
			*index = s->indices[i];
			return true;
		}
	return false;
}

/* Whether a name could stand in the body of a function: a parameter, a float, something to call. */
static bool fits_in_function(const void *context, const struct name *name)
{
	(void)context;
	if (name->hidden || !name->binding)
		return name->hidden;
	const int token = value_terminal(name->binding->slot);
	return token == T_NUMBER || token == T_FUNCTION || token == T_VECTOR_FUNCTION ||
	       token == T_MACRO;
}

const struct expr *expr_name(struct parser *p, const char *name, span where)
{
	unsigned index;
	if (find_name(p->grammar->scope, name, &index))
		return parameter(p, index, where);
	parser_error_undeclared(p, where, name, fits_in_function, NULL);
	return expr_constant(p, 0, where);
}

const struct expr *expr_axis(struct parser *p, enum keyword word, span where)
{
	unsigned index;
	if (find_name(p->grammar->scope, keyword_name(word), &index))
		return parameter(p, index, where);
	struct expr *e = make(p, EXPR_CONSTANT, where); /* not a literal: a variable that is 0 */
	return e;
}

const struct expr *expr_unary(
	struct parser *p, enum expr_kind kind, const struct expr *operand, span where)
{
	if (kind != EXPR_NEGATE) { /* +a is a, but no longer a bare literal */
		struct expr *e = arena_copy(p->arena, operand, sizeof *e);
		e->literal = false;
		e->span = where;
		return e;
	}
	struct expr *e = make(p, EXPR_NEGATE, where);
	set_operands(p, e, &operand, 1);
	return e;
}

const struct expr *expr_binary(struct parser *p, enum expr_kind kind, const struct expr *a,
	const struct expr *b, span where)
{
	struct expr *e = make(p, kind, where);
	const struct expr *const operands[2] = { a, b };
	if (kind == EXPR_DIVIDE && b->kind == EXPR_CONSTANT && b->literal && b->constant == 0)
		parser_error(p, where, "division by the constant zero");
	set_operands(p, e, operands, 2);
	return e;
}

const struct expr *expr_group(struct parser *p, const struct expr *inner, span where)
{
	struct expr *e = arena_copy(p->arena, inner, sizeof *e);
	e->grouped = true;
	e->literal = false;
	e->span = where;
	return e;
}

/* -- Calls -------------------------------------------------------------------------------- */

struct expr_list *expr_list_add(struct parser *p, struct expr_list *list, const struct expr *e)
{
	if (!list)
		list = ARENA_NEW(p->arena, struct expr_list);
	if (list->count == list->capacity) {
		const size_t capacity = list->capacity ? 2 * list->capacity : 4;
		const struct expr **items = ARENA_ARRAY(p->arena, capacity, const struct expr *);
		if (list->count)
			memcpy(items, list->items, list->count * sizeof *items);
		list->items = items;
		list->capacity = capacity;
	}
	list->items[list->count++] = e;
	return list;
}

const struct expr *expr_builtin(
	struct parser *p, enum keyword word, const struct expr_list *list, span where)
{
	struct expr *e = make(p, EXPR_CALL, where);
	const bool folds = word == K_MAX || word == K_MIN; /* of one value only outside functions */
	if (!folds)
		builtin_fits(p, word, list->count, where);
	else
		arguments_fit(p, keyword_name(word), list->count, 2, SIZE_MAX, where);
	e->builtin = word;
	set_operands(p, e, list->items, list->count);
	return e;
}

/* A function made of two calls of one that is made alike, and so on, would never come to an end. */
static void count_calls(struct parser *p, const struct function *called, span where)
{
	struct function_scope *s = p->grammar->scope;
	s->calls += 1 + called->calls;
	if (s->calls > FUNCTION_CALLS_MAX)
		parser_error(p, where,
			"a function calls others more than %d times here, counting their calls of "
			"each other",
			FUNCTION_CALLS_MAX);
}

/* Number of a component of a call; `hf` is one more than those of vectors. */
static unsigned member_index(enum keyword word)
{
	if (word == K_NONE)
		return 0;
	return word == K_HF_GRAY_16 ? COMPONENT_GRAY + 1 : component_index(word);
}

enum keyword member_hf(struct parser *p, const char *name, span where)
{
	if (strcmp(name, "hf") != 0)
		parser_error(p, where, "'%s' is not a component", name);
	return K_HF_GRAY_16;
}

const struct expr *expr_call(struct parser *p, struct callee callee, const struct expr_list *list,
	enum keyword component, span where)
{
	const struct function *function = callee.function;
	struct expr *e = make(p, EXPR_FUNCTION, where);
	arguments_fit(p, callee.name, list->count, function->parameter_count,
		function->parameter_count, where);
	reference_count_levels(p, function, where);
	e->function = function;
	e->component = (uint8_t)member_index(component);
	if (component != K_NONE && e->component < 5 && e->component >= function_terms(function))
		parser_error(p, where, "the function has no component %s", keyword_name(component));
	set_operands(p, e, list->items, list->count);
	count_calls(p, function, where);
	return e;
}

/* -- Loops -------------------------------------------------------------------------------- */

void function_loop_begin(struct parser *p, const char *name, span where)
{
	struct function_scope *s = p->grammar->scope;
	if (s->variable_count >= 1000)
		parser_error(p, where, "too many loops in a function");
	add_name(p, s, name, s->variable_count++);
}

const struct expr *function_loop_end(struct parser *p, enum keyword word, const struct expr *from,
	const struct expr *to, const struct expr *body, span where)
{
	struct function_scope *s = p->grammar->scope;
	struct expr *e = make(p, word == K_SUM ? EXPR_SUM : EXPR_PROD, where);
	const struct expr *const operands[3] = { from, to, body };
	e->index = (uint16_t)s->indices[--s->name_count];
	set_operands(p, e, operands, 3);
	return e;
}
