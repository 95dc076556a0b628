/* SPDX-License-Identifier: MIT */
/*
 * The entries of the grammar: each starts a run with its start token. Runs
 * nest, since a directive inside a statement reads its own expressions.
 */
#include "build.h"
#include "quick.h"

#include "grammar.tab.h"

#include <string.h>

/* False: an error was reported. */
static bool start_run(struct parser *p, struct run *run, int start)
{
	struct grammar *g = grammar_state(p);
	if (p->failed)
		return false;
	if (g->nested == NESTED_PARSES) {
		parser_error(p, NO_SPAN, "expressions and declarations are nested too deeply");
		return false;
	}
	run->start = start;
	run->start_token = start;
	run->last = NULL;
	run->base = g->opening_top;
	run->depth = 0;
	run->closed = false;
	run->braces = 0;
	run->word = run->word_before = K_NONE;
	run->next = NEXT_NONE;
	run->items = start == T_START_SCENE ? ITEMS_OBJECTS : ITEMS_NONE;
	run->accepted = false;
	const size_t height = g->arg_count;
	/* A value read within a function body does not see the body's parameters. */
	struct function_scope *scope = g->scope;
	struct arena *const tree = p->tree;
	g->scope = NULL;
	p->tree = start == T_START_SCENE && p->options->statements ? p->options->passing : p->arena;
	g->nested++;
	const int failed = grammar_parse(p, run);
	g->nested--;
	p->tree = tree;
	g->scope = scope;
	g->arg_count = height;
	g->opening_top = run->base;
	return !failed && run->accepted && !p->failed;
}

static bool to_float(struct parser *p, const struct run *run, double *value)
{
	*value = number_to_float(p, run->value.number, run->where);
	return !p->failed;
}

bool parse_float(struct parser *p, double *value)
{
	struct run run;
	return quick_float(p, QUICK_SUM, value) ||
	       (expand_settle(p) && quick_float(p, QUICK_SUM, value)) ||
	       (start_run(p, &run, T_START_FLOAT) && to_float(p, &run, value));
}

bool parse_condition(struct parser *p, double *value)
{
	struct run run;
	return quick_float(p, QUICK_FULL, value) ||
	       (expand_settle(p) && quick_float(p, QUICK_FULL, value)) ||
	       (start_run(p, &run, T_START_CONDITION) && to_float(p, &run, value));
}

bool parse_number_any(struct parser *p, struct number *value)
{
	struct run run;
	if (quick_number(p, value) || (expand_settle(p) && quick_number(p, value)))
		return true;
	if (!start_run(p, &run, T_START_NUMBER))
		return false;
	*value = run.value.number;
	return true;
}

bool parse_string(struct parser *p, const char **text, bool file_name)
{
	struct run run;
	if (!start_run(p, &run, T_START_STRING))
		return false;
	*text = file_name ? run.text.raw : run.text.text;
	return true;
}

static void remember_references(struct parser *p, const struct value *value)
{
	if (p->levels_read == 0)
		return;
	if (value->kind == VALUE_FUNCTION)
		pointer_map_add(&p->reference_levels, value->function, (void *)p->levels_read);
	if (value->kind == VALUE_NODE && !pointer_map_find(&p->reference_levels, value->node)) {
		pointer_map_add(&p->reference_levels, value->node, (void *)p->levels_read);
		pointer_map_add(&p->reference_parts, value->node, (void *)p->parts_read);
	}
	for (size_t i = 0; value->kind == VALUE_ARRAY && i < value->array->count; i++)
		remember_references(p, &value->array->elements[i]);
}

/* A value cannot begin with the vector t. */
static bool begins_with_t(struct parser *p)
{
	const struct expand *x = p->expand;
	span where;
	if (has_read_ahead(x)) {
		const struct unread *next = &x->unread[x->unread_count - 1];
		if (next->token != KW_T)
			return false;
		where = next->where;
	} else {
		const struct raw_token *next = raw_peek(p);
		if (!next || next->kind != RAW_KEYWORD || next->payload != (uint32_t)K_T)
			return false;
		where = raw_span(p);
	}
	parser_error(p, where, "a value cannot begin with t: write +t");
	return true;
}

bool parse_declared(struct parser *p, struct value *value)
{
	struct run run;
	if (begins_with_t(p))
		return false;
	if (quick_value(p, value) || (expand_settle(p) && quick_value(p, value)))
		return true;
	const uintptr_t around = p->levels_read, parts_around = p->parts_read;
	p->levels_read = p->parts_read = 0;
	const bool fine = start_run(p, &run, T_START_DECLARED);
	if (fine) {
		*value = run.value;
		remember_references(p, value);
	}
	p->levels_read = around;
	p->parts_read = parts_around;
	return fine;
}

bool parse_defaults(struct parser *p)
{
	struct run run;
	return start_run(p, &run, T_START_DEFAULTS);
}

bool parse_statements(struct parser *p, const struct node **statements)
{
	struct run run;
	bool good = true;
	while (!start_run(p, &run, T_START_SCENE)) {
		good = false;
		if (!expand_recover(p))
			return false;
	}
	*statements = run.list.first;
	return good;
}
