/* SPDX-License-Identifier: MIT */
/*
 * Identifiers: the typed token of what a name holds, subscripts of arrays, the
 * test whether something is declared.
 */
#include "expand.h"

#include "grammar.tab.h"

/* -- Subscripts --------------------------------------------------------------------------- */

static bool read_subscript(struct parser *p, double *value)
{
	struct gate gate;
	gate_open(p, &gate, false);
	const bool ok = parse_float(p, value) && expect(p, ']', "']' behind the subscript");
	gate_close(p);
	return ok;
}

bool identifier_index(
	struct parser *p, double f, size_t size, const char *name, span where, size_t *index)
{
	if (f < -EPSILON) {
		parser_error(p, where, "negative subscript %g of array '%s'", f, name);
		return false;
	}
	if (!(f + EPSILON < (double)size)) {
		parser_error(p, where,
			"subscript %g of array '%s' is out of range: its elements are 0 to %zu", f,
			name, size - 1);
		return false;
	}
	*index = (size_t)(f + EPSILON);
	return true;
}

struct value *identifier_element(
	struct parser *p, struct value *array, const char *name, span *where)
{
	const struct array *a = array->array;
	size_t at = 0;
	for (unsigned d = 0; d < a->dimensions; d++) {
		const struct raw_token *raw = raw_peek(p);
		const span bracket = raw_span(p);
		double subscript;
		size_t index;
		if (!raw || raw->kind != '[') {
			parser_error(p, bracket, "array '%s' needs %u subscripts, found %u", name,
				a->dimensions, d);
			return NULL;
		}
		raw_take(p);
		if (!read_subscript(p, &subscript) ||
			!identifier_index(p, subscript, a->size[d], name, bracket, &index))
			return NULL;
		at = at * a->size[d] + index;
		const struct frame *f = top_frame(p->expand);
		*where = span_join(*where, raw_span_at(p, &f->tokens[f->position - 1]));
	}
	return &a->elements[at];
}

/* -- Tokens ------------------------------------------------------------------------------- */

int value_terminal(const struct value *value)
{
	switch (value->kind) {
	case VALUE_NONE:
		return T_UNDECLARED;
	case VALUE_NUMBER:
		return value->number.terms == 1 ? T_NUMBER : T_VECTOR;
	case VALUE_COLOUR:
		return T_COLOUR;
	case VALUE_STRING:
		return T_STRING;
	case VALUE_ARRAY:
		return T_ARRAY;
	case VALUE_NODE:
	case VALUE_FUNCTION:
		return value->token;
	case VALUE_SPLINE:
		return T_SPLINE;
	case VALUE_MACRO:
		return T_MACRO;
	case VALUE_FILE:
		return T_FILE;
	}
	return 0;
}

/* The value goes with the token. */
static int value_token(const struct value *value, struct token_value *v)
{
	switch (value->kind) {
	case VALUE_NUMBER:
	case VALUE_COLOUR:
		v->number = value->number;
		break;
	case VALUE_STRING:
		v->string = v->raw = value->string;
		break;
	case VALUE_NODE:
		v->node = value->node;
		break;
	case VALUE_FUNCTION:
		v->function = value->function;
		break;
	case VALUE_SPLINE:
		v->spline = value->spline;
		break;
	default:
		break;
	}
	return value_terminal(value);
}

static void warn_deprecated(struct parser *p, struct symbol *symbol, span where)
{
	diag_warning(p->diag, where, "%s",
		symbol->deprecation ? symbol->deprecation
				    : arena_printf(p->arena, "'%s' is deprecated", symbol->text));
	if (symbol->deprecated_once)
		symbol->deprecated = false;
}

int identifier_token(struct parser *p, uint32_t name, span *where, struct token_value *v)
{
	struct symbols *symbols = &p->expand->symbols;
	struct symbol *symbol = symbol_find(symbols, name);
	if (symbol->deprecated)
		warn_deprecated(p, symbol, *where);
	struct value *slot = symbol->slot;
	v->symbol = symbol;
	const struct raw_token *raw;
	if (slot->kind == VALUE_ARRAY)
		symbol->kept = true; /* the token refers to it */
	while (slot->kind == VALUE_ARRAY && (raw = raw_peek(p)) && raw->kind == '[') {
		slot = identifier_element(p, slot, v->name, where);
		if (!slot)
			return 0;
		if (slot->kind == VALUE_NONE) {
			parser_error(p, *where, "element of array '%s' that was never assigned",
				v->name);
			return 0;
		}
		v->symbol = symbol_of_element(symbols, symbol, slot);
	}
	return p->failed ? 0 : value_token(slot, v);
}

/* -- defined ------------------------------------------------------------------------------ */

static bool is_constant(unsigned kind)
{
	return kind == RAW_INTEGER || kind == RAW_NUMBER || kind == RAW_NUMBER_TEXT ||
	       kind == RAW_STRING;
}

/* Takes what stands before the closing parenthesis. */
static void skip_subscripts(struct parser *p)
{
	const struct raw_token *raw;
	for (int open = 0; (raw = raw_peek(p)) && (open || raw->kind != ')'); raw_take(p))
		open += (raw->kind == '(') - (raw->kind == ')');
}

/* N or N[i]: whether it has a value, or is just getting its first one. */
static bool read_defined(struct parser *p, bool *defined)
{
	const struct raw_token *raw = raw_peek(p);
	if (raw && is_constant(raw->kind)) {
		const char *what = raw_describe(p, raw);
		diag_warning(p->diag, raw_take(p), "%s is never a declared identifier", what);
		*defined = false;
		return true;
	}
	if (raw && raw->kind == RAW_KEYWORD) {
		raw_take(p);
		*defined = false;
		return true;
	}
	uint32_t name;
	span where;
	if (!raw_name(p, "an identifier", &name, &where))
		return false;
	if (name_is_lost(p, name)) {
		skip_subscripts(p);
		*defined = true;
		return true;
	}
	const struct symbol *symbol = symbol_find(&p->expand->symbols, name);
	struct value *slot = symbol ? symbol->slot : NULL;
	while (slot && slot->kind == VALUE_ARRAY && (raw = raw_peek(p)) && raw->kind == '[') {
		slot = identifier_element(p, slot, symbol->text, &where);
		if (!slot)
			return false;
	}
	*defined = slot && (slot->kind != VALUE_NONE ||
				   ((symbol->entered || symbol->awaited) && slot == symbol->slot));
	return true;
}

bool identifier_defined(struct parser *p, bool *defined)
{
	struct gate gate;
	gate_open(p, &gate, false);
	const bool ok = expect(p, '(', "'('") && read_defined(p, defined) &&
			expect(p, ')', "')' behind the identifier");
	gate_close(p);
	return ok;
}
