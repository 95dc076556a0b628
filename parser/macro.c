/* SPDX-License-Identifier: MIT */
/*
 * #macro and macro calls. The body is not copied: a call reads the tokens of the
 * definition in a frame of its own.
 */
#include "expand.h"
#include "quick.h"

#include "grammar.tab.h"

#include <string.h>

/* -- Definition --------------------------------------------------------------------------- */

static bool read_parameters(struct parser *p, struct macro *m)
{
	uint32_t ids[MAX_PARAMETERS];
	if (!raw_accept(p, '(')) {
		parser_error(p, raw_span(p), "expected '(' behind the name of the macro, found %s",
			raw_describe(p, raw_peek(p)));
		return false;
	}
	while (!raw_accept(p, ')')) {
		span where;
		if (m->parameter_count == MAX_PARAMETERS) {
			parser_error(p, raw_span(p), "too many parameters: %d are the limit",
				MAX_PARAMETERS);
			return false;
		}
		if (!raw_name(p, "a parameter or ')'", &ids[m->parameter_count], &where))
			return false;
		if (ids[m->parameter_count] == m->name) {
			parser_error(p, where, "a parameter cannot have the name of its macro");
			return false;
		}
		m->parameter_count++;
		raw_accept(p, ',');
	}
	m->parameters = arena_copy(p->arena, ids, m->parameter_count * sizeof ids[0]);
	return !p->failed;
}

/* Enters the macro in the global table, in place of one of the same name. */
static bool enter(struct parser *p, struct macro *m, span where)
{
	struct symbols *s = &p->expand->symbols;
	struct symbol *symbol = symbol_find(s, m->name);
	if (symbol && symbol->slot->kind != VALUE_MACRO && symbol->slot->kind != VALUE_NONE) {
		parser_error(
			p, where, "'%s' is declared as something else than a macro", symbol->text);
		return false;
	}
	if (!symbol)
		symbol = symbol_create(s, m->name, SYMBOL_GLOBAL);
	*symbol->slot = (struct value){ .kind = VALUE_MACRO, .macro = m };
	return true;
}

bool macro_define(struct parser *p, const struct directive *d, span opened)
{
	struct macro *m = ARENA_NEW(p->arena, struct macro);
	span where;
	if (p->state->version < 310) {
		parser_error(p, opened, "macros need #version 3.1 or later");
		return false;
	}
	if (!raw_name(p, "the name of the macro", &m->name, &where) || !read_parameters(p, m))
		return false;
	struct frame *f = top_frame(p->expand);
	m->source = f->source;
	m->start = f->position;
	m->end = d->end;
	if (d->end == NO_TOKEN) {
		f->position =
			f->end && f->tokens[f->end - 1].kind == RAW_ERROR ? f->end - 1 : f->end;
		return block_report_unclosed(p, opened);
	}
	f->position = d->end + 1;
	m->context = arena_printf(
		p->arena, "in macro %s called here", p->expand->names.list[m->name].text);
	return enter(p, m, where);
}

/* -- Call --------------------------------------------------------------------------------- */

static bool is_reference(const struct parser *p, const struct gate *g)
{
	return g->delivered == 1 && g->slot && g->first != T_FUNCTION &&
	       g->first != T_VECTOR_FUNCTION && g->table <= p->expand->symbols.table;
}

static bool read_argument(struct parser *p, struct argument *a)
{
	struct gate gate;
	gate_open(p, &gate, true);
	const bool ok = parse_declared(p, &a->value) && !p->failed;
	a->slot = ok && is_reference(p, &gate) ? gate.slot : NULL;
	a->symbol = gate.symbol;
	if (ok && !a->slot)
		a->value = value_copy(p, &a->value);
	gate_close(p);
	return ok;
}

static bool report_count(
	struct parser *p, const struct macro *m, span where, const char *what, unsigned found)
{
	parser_error(p, where, "macro '%s' takes %u argument%s, %s %u",
		p->expand->names.list[m->name].text, m->parameter_count,
		m->parameter_count == 1 ? "" : "s", what, found);
	parser_note(p, (span){ m->source->number, m->source->tokens[m->start - 1].offset, 1, 0 },
		"the macro is defined here");
	return false;
}

static bool read_arguments(struct parser *p, const struct macro *m, struct argument *arguments)
{
	if (quick_arguments(p, arguments, m->parameter_count))
		return true;
	if (!expect(p, '(', "'(' behind the name of a macro"))
		return false;
	for (unsigned i = 0; i < m->parameter_count; i++) {
		struct token_value v;
		span where;
		if (quick_argument(p, &arguments[i])) {
			accept(p, ',');
			continue;
		}
		const int token = expand_next(p, &v, &where);
		if (p->failed)
			return false;
		if (token == ')')
			return report_count(p, m, where, "found", i);
		expand_unread(p, token, &v, where);
		if (!read_argument(p, &arguments[i]))
			return false;
		accept(p, ',');
	}
	if (accept(p, ')'))
		return true;
	struct token_value v;
	span where;
	const int token = expand_next(p, &v, &where);
	if (p->failed)
		return false;
	if (v.keyword != K_NONE || token == 0) {
		parser_error(p, raw_gap_before(p, where),
			"expected ')' behind the arguments of macro '%s', found %s",
			p->expand->names.list[m->name].text, token_describe(p, token, &v));
		return false;
	}
	report_count(p, m, where, "found more than", m->parameter_count);
	note_operator(p, token, where);
	return false;
}

/* A variable may be gone before the call: its macro ended among the arguments, or one of them undefined
 * it. Its value stays. */
static bool is_by_reference(const struct argument *a)
{
	return a->slot && a->symbol->table;
}

static void bind_parameters(
	struct parser *p, const struct macro *m, const struct argument *arguments)
{
	struct symbols *s = &p->expand->symbols;
	for (unsigned i = 0; i < m->parameter_count; i++) {
		struct symbol *symbol = symbol_create(s, m->parameters[i], s->table);
		symbol->value = arguments[i].value;
		if (is_by_reference(&arguments[i]))
			symbol->slot = arguments[i].slot;
	}
}

/* Loops call from one place over and over: one site serves them all. */
static uint32_t site_of_call(struct parser *p, struct macro *m, span call)
{
	const span last = m->last_call;
	if (!m->last_site || last.source != call.source || last.offset != call.offset ||
		last.site != call.site) {
		m->last_site = diag_add_site(p->diag, call, m->context);
		m->last_call = call;
		p->expand->site_count++;
	}
	return m->last_site;
}

/* The body is read next. */
static bool enter_body(
	struct parser *p, struct macro *m, const struct argument *arguments, span call)
{
	struct expand *x = p->expand;
	if (!symbols_push(&x->symbols)) {
		parser_error(p, call,
			"macros and include files are nested too deeply: %d are the limit (does "
			"macro '%s' call itself without end?)",
			SYMBOL_TABLES, x->names.list[m->name].text);
		return false;
	}
	bind_parameters(p, m, arguments);
	const unsigned blocks = x->block_count;
	struct frame *f = &x->frames[x->frame_count++];
	*f = (struct frame){
		.source = m->source,
		.tokens = m->source->tokens,
		.position = m->start,
		.end = m->end,
		.site = site_of_call(p, m, call),
		.is_macro = true,
		.blocks = blocks,
		.call = call,
	};
	return block_push(p, BLOCK_MACRO, NULL, call) != NULL;
}

/* Macros that call each other may come to more calls than anybody waits for. */
static bool is_within_limit(struct parser *p, span call)
{
	const double most = p->options->max_loop_tokens;
	if (most == 0 || (double)++p->expand->work <= most)
		return growth_permits(p, 0, call);
	parser_stop(p, call, "the macros of this scene do not seem to end (--loop-limit)");
	return false;
}

bool macro_call(struct parser *p, struct symbol *symbol, span call)
{
	if (!is_within_limit(p, call))
		return false;
	struct macro *m = symbol->slot->macro;
	struct argument arguments[MAX_PARAMETERS];
	struct gate gate;
	gate_open(p, &gate, false);
	const bool ok = read_arguments(p, m, arguments);
	gate_close(p);
	return ok && enter_body(p, m, arguments, call);
}
