/* SPDX-License-Identifier: MIT */
/*
 * #declare, #local and #undef.
 */
#include "expand.h"

#include "grammar.tab.h"

#include <string.h>

/* What is written to. */
struct target {
	struct symbol *symbol;
	struct value *slot;  /* NULL: the value is lost, see find_element */
	struct array *array; /* the slot is an element of it; NULL: no element */
	bool is_new;
	bool kept; /* the symbol was already */
	span where;
};

/* The `deprecated once "text"` before a name. */
struct mark {
	bool deprecated, once;
	const char *text;
};

static void read_deprecation(struct parser *p, struct mark *mark)
{
	if (!raw_accept_keyword(p, K_DEPRECATED))
		return;
	mark->deprecated = true;
	mark->once = raw_accept_keyword(p, K_ONCE);
	const char *text = raw_string(p, true);
	mark->text = text ? arena_string(p->arena, text, strlen(text)) : NULL;
}

/* Whether a subscript follows in this text: looking beyond the end of a macro would leave it, and its
 * symbols, in the middle of a directive that is about one of them. */
static bool is_subscripted(struct parser *p)
{
	const struct frame *f = top_frame(p->expand);
	const bool is_over = f->is_macro && f->position == f->end;
	const struct raw_token *raw = is_over ? NULL : raw_peek(p);
	return raw && raw->kind == '[';
}

/* Goes down to an element. A #local cannot reach an element of an array of an outer table, unless
 * that has no elements yet: the value is read and lost. */
static bool find_element(struct parser *p, bool local, struct target *t)
{
	while (t->slot && t->slot->kind == VALUE_ARRAY && is_subscripted(p)) {
		t->array = t->slot->array;
		t->slot = identifier_element(p, t->slot, t->symbol->text, &t->where);
		if (!t->slot)
			return false;
	}
	if (t->array && local && t->symbol->table != p->expand->symbols.table &&
		t->array->kind != VALUE_NONE)
		t->slot = NULL;
	return true;
}

static bool find_target(struct parser *p, bool local, struct target *t)
{
	struct symbols *s = &p->expand->symbols;
	uint32_t name;
	if (!raw_name(p, "an identifier to declare", &name, &t->where))
		return false;
	t->symbol = symbol_find(s, name);
	const bool element = is_subscripted(p);
	if (element && name_is_lost(p, name)) {
		parser_error_undeclared(p, t->where, s->names->list[name].text, is_declared, NULL);
		return false;
	}
	if (element && (!t->symbol || t->symbol->slot->kind != VALUE_ARRAY)) {
		parser_error(p, t->where, "'%s' is not an array", s->names->list[name].text);
		return false;
	}
	if (!t->symbol || (local && !element && t->symbol->table != s->table)) {
		t->symbol = symbol_create(s, name, local ? s->table : SYMBOL_GLOBAL);
		t->is_new = t->symbol->entered = true;
	}
	t->slot = t->symbol->slot;
	t->kept = t->symbol->kept;
	t->symbol->kept = true; /* the table may go before the value is complete */
	if (t->slot->kind == VALUE_MACRO) {
		parser_error(p, t->where, "'%s' is a macro: #undef it first", t->symbol->text);
		return false;
	}
	return !element || find_element(p, local, t);
}

static bool assign(struct parser *p, const struct target *t, const struct value *v)
{
	if (!t->slot)
		return true;
	const bool function = v->kind == VALUE_FUNCTION;
	if (t->slot->kind == VALUE_FUNCTION) {
		parser_error(p, t->where, "the function '%s' cannot be redeclared: #undef it first",
			t->symbol->text);
		return false;
	}
	if (function && !t->is_new && t->slot->kind != VALUE_NONE) {
		parser_error(p, t->where, "'%s' is declared and cannot become a function",
			t->symbol->text);
		return false;
	}
	if (t->array && !array_accepts(t->array, v)) {
		parser_error(p, t->where,
			"all elements of array '%s' have one type, which is not that of this value",
			t->symbol->text);
		return false;
	}
	*t->slot = *v;
	if (!t->array)
		t->symbol->entered = false;
	return true;
}

/* Takes a semicolon if it is next, without running a directive on the way. */
static bool accept_semicolon(struct parser *p)
{
	p->expand->gate->operand = true;
	return accept(p, ';');
}

/* The semicolon behind the value, which an expression needs. */
static bool read_semicolon(struct parser *p, bool expression, span where)
{
	const bool found = accept_semicolon(p);
	if (p->failed)
		return false;
	if (found && expression)
		accept_semicolon(p);
	if (found || !expression || p->state->version < 310)
		return !p->failed;
	if (p->state->version < 350) {
		diag_warning(p->diag, where, "a declared expression should end with ';'");
		return true;
	}
	struct token_value next;
	span at;
	const int token = expand_next(p, &next, &at);
	const span gap = raw_gap_before(p, at);
	if (token == T_UNDECLARED && gap.offset == at.offset) { /* on the same line: color Red */
		parser_error_undeclared(p, at, next.name, is_declared, NULL);
		return false;
	}
	parser_error(p, gap, "expected ';' behind the declared expression, found %s",
		token_describe(p, token, &next));
	if (token == T_NUMBER || token == T_SUM)
		note_row(p, at);
	else if (!note_bracket(p, token, at))
		note_operator(p, token, at);
	if (token == ',')
		parser_note(p, at, "the decimal point is '.', and vectors are written <a, b, c>");
	if (diag_place(p->diag, where).line != diag_place(p->diag, gap).line)
		parser_note(p, where, "the declaration begins here");
	return false;
}

/* The name of a function or spline could have been the beginning of a call: it counts as one. */
static bool is_expression(const struct value *v, const struct gate *g)
{
	return v->kind == VALUE_NUMBER || v->kind == VALUE_COLOUR || g->first == T_FUNCTION ||
	       g->first == T_VECTOR_FUNCTION || g->first == T_SPLINE;
}

/* Reads the value and what ends it. */
static bool read_value(struct parser *p, struct target *t, span where)
{
	struct gate gate;
	struct value v = { .kind = VALUE_NONE };
	gate_open(p, &gate, true);
	bool ok = parse_declared(p, &v) && !p->failed;
	if (ok) {
		/* A lone identifier, or an array that may hold others: the copy is independent. */
		if (v.kind == VALUE_ARRAY &&
			((gate.delivered == 1 && gate.slot) || v.array->kind == VALUE_ARRAY))
			v = value_copy(p, &v);
		ok = assign(p, t, &v) && read_semicolon(p, is_expression(&v, &gate), where);
	}
	gate_close(p);
	return ok;
}

bool declare_run(struct parser *p, bool local, span where)
{
	struct mark mark = { 0 };
	struct target t = { 0 };
	read_deprecation(p, &mark);
	if (!find_target(p, local, &t))
		return false;
	if (t.is_new && mark.deprecated) {
		t.symbol->deprecated = true;
		t.symbol->deprecated_once = mark.once;
		t.symbol->deprecation = mark.text;
	}
	if (!raw_accept(p, '=')) {
		parser_error(p, raw_span(p), "expected '=' behind '%s', found %s", t.symbol->text,
			raw_describe(p, raw_peek(p)));
		return false;
	}
	/* The old value stays readable: #declare A = A + 1; */
	if (!read_value(p, &t, where))
		return false;
	symbol_let_go(&p->expand->symbols, t.symbol, t.kept);
	return true;
}

bool undef_run(struct parser *p, span where)
{
	(void)where;
	struct symbols *s = &p->expand->symbols;
	uint32_t name;
	struct target t = { 0 };
	if (!raw_name(p, "an identifier", &name, &t.where))
		return false;
	t.symbol = symbol_find(s, name);
	if (!t.symbol) {
		if (!name_is_lost(p, name))
			diag_warning(p->diag, t.where, "#undef of '%s', which is not declared",
				s->names->list[name].text);
		return true;
	}
	t.slot = t.symbol->slot;
	if (!find_element(p, false, &t))
		return false;
	if (t.array)
		t.slot->kind = VALUE_NONE;
	else
		symbol_remove(s, t.symbol);
	return true;
}
