/* SPDX-License-Identifier: MIT */
/*
 * The AST as JSON, one object per node, indented. Declared values are printed
 * where they are used, the first time; later uses name the place only.
 */
#include "base/json.h"
#include "base/pointer_map.h"
#include "parser/ast.h"
#include "parser/parser.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct printer {
	struct diag *diag;
	FILE *out;
	struct pointer_map
		seen; /* nodes behind references and functions that were printed already */
};

static bool first_time(struct printer *j, const void *what)
{
	if (pointer_map_find(&j->seen, what))
		return false;
	pointer_map_add(&j->seen, what, j);
	return true;
}

static void indent(const struct printer *j, unsigned depth)
{
	enum { DEEPEST = 40 }; /* deeper levels are not moved further in */
	fprintf(j->out, "\n%*s", 2 * (int)(depth < DEEPEST ? depth : DEEPEST), "");
}

/* -- Scalars ------------------------------------------------------------------------------ */

/* JSON knows no infinity and no NaN: they are strings. */
static void print_double(const struct printer *j, double v)
{
	if (isfinite(v))
		fprintf(j->out, "%.17g", v == 0 ? 0 : v);
	else
		fprintf(j->out, isnan(v) ? "\"nan\"" : v > 0 ? "\"inf\"" : "\"-inf\"");
}

static void print_place(const struct printer *j, span where)
{
	const struct place place = diag_place(j->diag, where);
	fputs(", \"at\": ", j->out);
	if (!place.file) {
		fputs("null", j->out);
		return;
	}
	const size_t room = strlen(place.file) + 32;
	char *text = memory_alloc(room, 1);
	snprintf(text, room, "%s:%u:%u", place.file, place.line, place.column);
	json_print_string(j->out, text);
	free(text);
}

static void print_number(const struct printer *j, const struct number *n)
{
	if (n->terms == 1) {
		print_double(j, n->v[0]);
		return;
	}
	for (unsigned i = 0; i < n->terms; i++) {
		fputs(i ? ", " : "[", j->out);
		print_double(j, n->v[i]);
	}
	fputc(']', j->out);
}

/* -- Functions ---------------------------------------------------------------------------- */

static const char *operator_name(const struct expr *e)
{
	static const char *const names[] = {
		[EXPR_NEGATE] = "negate",
		[EXPR_ADD] = "+",
		[EXPR_SUBTRACT] = "-",
		[EXPR_MULTIPLY] = "*",
		[EXPR_DIVIDE] = "/",
		[EXPR_LESS] = "<",
		[EXPR_LESS_EQUAL] = "<=",
		[EXPR_EQUAL] = "=",
		[EXPR_NOT_EQUAL] = "!=",
		[EXPR_GREATER_EQUAL] = ">=",
		[EXPR_GREATER] = ">",
		[EXPR_AND] = "&",
		[EXPR_OR] = "|",
		[EXPR_FUNCTION] = "call",
		[EXPR_SUM] = "sum",
		[EXPR_PROD] = "prod",
	};
	return e->kind == EXPR_CALL ? keyword_name(e->builtin) : names[e->kind];
}

static void print_function(struct printer *j, const struct function *f, unsigned depth);

/* What stands between the operator and its operands. */
static void print_detail(struct printer *j, const struct expr *e, unsigned depth)
{
	if (e->kind == EXPR_FUNCTION) {
		fputs(", ", j->out);
		print_function(j, e->function, depth);
		if (e->component)
			fprintf(j->out, ", {\"component\": %u}", e->component);
	} else if (e->kind == EXPR_SUM || e->kind == EXPR_PROD) {
		fprintf(j->out, ", {\"p\": %u}", e->index);
	}
}

/* ["+", a, b]; parameters as {"p": index}. */
static void print_expr(struct printer *j, const struct expr *e, unsigned depth)
{
	if (e->kind == EXPR_CONSTANT) {
		print_double(j, e->constant);
		return;
	}
	if (e->kind == EXPR_PARAMETER) {
		fprintf(j->out, "{\"p\": %u}", e->index);
		return;
	}
	fputc('[', j->out);
	json_print_string(j->out, operator_name(e));
	print_detail(j, e, depth);
	for (uint32_t i = 0; i < e->operand_count; i++) {
		fputs(", ", j->out);
		print_expr(j, e->operands[i], depth);
	}
	fputc(']', j->out);
}

static void print_node(struct printer *j, const struct node *node, unsigned depth);

static void print_function(struct printer *j, const struct function *f, unsigned depth)
{
	static const char *const kinds[] = { "expression", "internal", "pattern", "pigment",
		"transform", "spline" };
	fprintf(j->out, "{\"function\": \"%s\"", kinds[f->kind]);
	print_place(j, f->span);
	if (!first_time(j, f)) {
		fputc('}', j->out);
		return;
	}
	fprintf(j->out, ", \"parameters\": %u", f->parameter_count);
	if (f->kind == FUNCTION_EXPRESSION) {
		fputs(", \"body\": ", j->out);
		print_expr(j, f->body, depth);
	} else if (f->kind == FUNCTION_INTERNAL) {
		fprintf(j->out, ", \"number\": %d", f->internal);
	} else if (f->node) {
		fputs(", \"node\": ", j->out);
		print_node(j, f->node, depth + 1);
	}
	fputc('}', j->out);
}

/* -- Nodes -------------------------------------------------------------------------------- */

static void print_array(const struct printer *j, const struct arg *arg, unsigned depth)
{
	const unsigned stride = arg->array.stride;
	fputc('[', j->out);
	for (size_t i = 0; i < arg->array.count; i += stride) {
		if (i)
			fputc(',', j->out);
		if (i % (stride * (stride > 1 ? 4 : 10)) == 0)
			indent(j, depth + 1);
		else
			fputc(' ', j->out);
		for (unsigned k = 0; k < stride && i + k < arg->array.count; k++) {
			if (stride > 1)
				fputs(k ? ", " : "[", j->out);
			print_double(j, arg->array.values[i + k]);
		}
		if (stride > 1)
			fputc(']', j->out);
	}
	fputc(']', j->out);
}

static void print_args(struct printer *j, const struct node *node, unsigned depth)
{
	fputs(", \"args\": [", j->out);
	for (uint32_t i = 0; i < node->arg_count; i++) {
		const struct arg *arg = &node->args[i];
		if (i)
			fputs(", ", j->out);
		switch (arg->kind) {
		case ARG_NUMBER:
			print_number(j, &arg->number);
			break;
		case ARG_STRING:
			json_print_string(j->out, arg->string);
			break;
		case ARG_ARRAY:
			print_array(j, arg, depth);
			break;
		case ARG_FUNCTION:
			print_function(j, arg->function, depth);
			break;
		}
	}
	fputc(']', j->out);
}

static void print_nodes(struct printer *j, const struct node *list, unsigned depth)
{
	fputc('[', j->out);
	for (const struct node *n = list; n; n = n->next) {
		indent(j, depth + 1);
		print_node(j, n, depth + 1);
		if (n->next)
			fputc(',', j->out);
	}
	if (list)
		indent(j, depth);
	fputc(']', j->out);
}

static void print_node(struct printer *j, const struct node *node, unsigned depth)
{
	fprintf(j->out, "{\"%s\": ", node->keyword == K_REFERENCE ? "reference" : "node");
	json_print_string(j->out, node->keyword == K_REFERENCE ? (node->name ? node->name : "")
							       : keyword_name(node->keyword));
	print_place(j, node->span);
	if (node->arg_count)
		print_args(j, node, depth);
	if (node->children) {
		fputs(", \"children\": ", j->out);
		print_nodes(j, node->children, depth);
	}
	if (node->ref && first_time(j, node->ref)) {
		fputs(", \"value\": ", j->out);
		print_node(j, node->ref, depth + 1);
	} else if (node->ref) {
		fputs(", \"declared\": {\"node\": ", j->out);
		json_print_string(j->out, keyword_name(node->ref->keyword));
		print_place(j, node->ref->span);
		fputc('}', j->out);
	}
	fputc('}', j->out);
}

void ast_print_json(const struct ast *ast, struct diag *diag, FILE *out)
{
	struct printer j = { .diag = diag, .out = out };
	fprintf(out, "{\"version\": %d, \"statements\": ", ast->final.version);
	print_nodes(&j, ast->statements, 0);
	fputs("}\n", out);
	pointer_map_release(&j.seen);
}
