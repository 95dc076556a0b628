/* SPDX-License-Identifier: MIT */
/*
 * The short way for numbers. Most expressions of a scene are sums of literals,
 * variables, array elements, vectors and calls of simple functions; this reads
 * them straight from the raw tokens by recursive descent, several times as fast
 * as the grammar can.
 *
 * It is only a short cut: every value comes from the same functions that the
 * grammar's actions call. Where it meets anything else — a macro, a directive, a
 * string, the end of the text, something that wants a message — it gives up
 * without having moved, and the grammar reads the same tokens again and does
 * whatever is due. So nothing here reports: reports are only noted (p->trial).
 *
 * The rules mirror those of grammar.y, from `full` down to `operand`. Commas,
 * which the language lets one leave out, must be there.
 */
#include "quick.h"

#include "build.h"

#include "grammar.tab.h"

enum { NO_KIND = 0 }; /* behind the last token of the text; no raw kind */

unsigned quick_next(const struct quick *q)
{
	return q->at < q->end ? q->at->kind : NO_KIND;
}

bool quick_skip(struct quick *q, unsigned kind)
{
	if (quick_next(q) != kind)
		return false;
	q->at++;
	return true;
}

/* -- Identifiers -------------------------------------------------------------------------- */

static struct value *read_element(struct quick *q, const struct array *a, const char *name)
{
	size_t at = 0;
	for (unsigned d = 0; d < a->dimensions; d++) {
		struct number n;
		size_t index;
		if (!quick_skip(q, '[') || !quick_read_sum(q, &n) || n.terms != 1 ||
			!quick_skip(q, ']') ||
			!identifier_index(q->p, n.v[0], a->size[d], name, NO_SPAN, &index))
			return NULL;
		at = at * a->size[d] + index;
	}
	return &a->elements[at];
}

struct value *quick_read_variable(struct quick *q, const struct symbol **found)
{
	const struct name *name = &q->p->expand->names.list[q->at->payload];
	const struct symbol *symbol = name->binding;
	if (name->hidden || !symbol || symbol->deprecated)
		return NULL;
	struct value *slot = symbol->slot;
	q->at++;
	while (slot && slot->kind == VALUE_ARRAY && quick_next(q) == '[')
		slot = read_element(q, slot->array, symbol->text);
	*found = symbol;
	return slot;
}

/* sum, sum … ) becomes arguments; false: gives up. */
static bool read_sums(struct quick *q)
{
	struct number n;
	do {
		if (!quick_read_sum(q, &n))
			return false;
		args_push_number(q->p, n, NO_SPAN);
	} while (quick_skip(q, ','));
	return quick_skip(q, ')');
}

/* ( sum, sum … ) behind the name of a function that has been called before: the first call is the
 * one that may need a message. */
static bool read_call(struct quick *q, const struct value *v, const char *name, struct number *n)
{
	const size_t start = args_height(q->p);
	if (!pointer_map_find(&q->p->called, v->function) || !quick_skip(q, '(') || !read_sums(q))
		return false;
	*n = builtin_call(q->p, (struct callee){ v->function, name }, start, NO_SPAN);
	return true;
}

static bool read_identifier(struct quick *q, struct number *n)
{
	const struct symbol *symbol;
	const struct value *slot = quick_read_variable(q, &symbol);
	if (slot && slot->kind == VALUE_FUNCTION)
		return read_call(q, slot, symbol->text, n);
	if (!slot || (slot->kind != VALUE_NUMBER && slot->kind != VALUE_COLOUR))
		return false;
	*n = slot->number;
	n->leftover = false;
	return true;
}

/* -- Words -------------------------------------------------------------------------------- */

/* The streams of rand() go back if the attempt fails. */
static bool note_draw(struct quick *q, const struct number *n)
{
	if (n->terms != 1 || q->draw_count == QUICK_DRAWS)
		return false;
	const int stream = number_truncate(n->v[0]);
	if (stream < 0 || (size_t)stream >= q->p->seed_count)
		return false;
	q->draws[q->draw_count++] = (struct draw){ (size_t)stream, q->p->seeds[stream] };
	return true;
}

static bool read_float_function(struct quick *q, enum keyword word, struct number *n)
{
	q->at++;
	if (!quick_skip(q, '(') || !quick_read_full(q, n) || !quick_skip(q, ')') ||
		(word == K_RAND && !note_draw(q, n)))
		return false;
	*n = builtin_float(q->p, word, *n, NO_SPAN);
	return true;
}

static bool read_list_function(struct quick *q, enum keyword word, struct number *n)
{
	q->at++;
	if (!quick_skip(q, '('))
		return false;
	const size_t start = args_height(q->p);
	if (!read_sums(q))
		return false;
	*n = builtin_list(q->p, word, start, NO_SPAN);
	return true;
}

static bool read_constant(struct quick *q, enum keyword word, struct number *n)
{
	double value;
	if (!constant_value(q->p, word, &value))
		return false;
	q->at++;
	*n = number_float(value);
	return true;
}

static bool read_word(struct quick *q, struct number *n)
{
	const enum keyword word = (enum keyword)q->at->payload;
	switch (word) {
	case K_X:
	case K_Y:
	case K_Z:
	case K_U:
	case K_V:
	case K_T:
		q->at++;
		*n = number_axis(word);
		return true;
	case K_ABS:
	case K_ACOS:
	case K_ACOSH:
	case K_ASIN:
	case K_ASINH:
	case K_ATAN:
	case K_ATANH:
	case K_CEIL:
	case K_COS:
	case K_COSH:
	case K_DEGREES:
	case K_EXP:
	case K_FLOOR:
	case K_INT:
	case K_LN:
	case K_LOG:
	case K_RADIANS:
	case K_RAND:
	case K_SIN:
	case K_SINH:
	case K_SQRT:
	case K_TAN:
	case K_TANH:
		return read_float_function(q, word, n);
	case K_ATAN2:
	case K_DIV:
	case K_MOD:
	case K_POW:
	case K_MAX:
	case K_MIN:
	case K_SELECT:
	case K_BITWISE_AND:
	case K_BITWISE_OR:
	case K_BITWISE_XOR:
	case K_VDOT:
	case K_VLENGTH:
	case K_VCROSS:
	case K_VNORMALIZE:
	case K_VROTATE:
	case K_VAXIS_ROTATE:
		return read_list_function(q, word, n);
	case K_ASC:
	case K_STRCMP:
	case K_STRLEN:
		return quick_read_text_function(q, word, n);
	default:
		return read_constant(q, word, n);
	}
}

/* -- From operands to sums ---------------------------------------------------------------- */

/* < sum, sum … > */
static bool read_literal(struct quick *q, struct number *n)
{
	struct number vector = { .terms = 0 };
	q->at++;
	do {
		struct number term;
		if (vector.terms == 5 || !quick_read_sum(q, &term) || term.terms != 1)
			return false;
		vector.v[vector.terms++] = term.v[0];
	} while (quick_skip(q, ','));
	*n = vector;
	return vector.terms >= 2 && quick_skip(q, '>');
}

static bool read_group(struct quick *q, struct number *n)
{
	q->at++;
	return quick_read_full(q, n) && quick_skip(q, ')');
}

static bool read_operand(struct quick *q, struct number *n)
{
	switch (quick_next(q)) {
	case RAW_INTEGER:
		*n = number_float(q->at++->payload);
		return true;
	case RAW_NUMBER:
		*n = number_float(q->frame->source->numbers[q->at++->payload]);
		return true;
	case RAW_NAME:
		return read_identifier(q, n);
	case RAW_KEYWORD:
		return read_word(q, n);
	case '<':
		return read_literal(q, n);
	case '(':
		return read_group(q, n);
	default:
		return false;
	}
}

static bool is_selector(const struct raw_token *raw)
{
	if (raw->kind != RAW_KEYWORD)
		return false;
	switch ((enum keyword)raw->payload) {
	case K_X:
	case K_Y:
	case K_Z:
	case K_U:
	case K_V:
	case K_T:
	case K_RED:
	case K_GREEN:
	case K_BLUE:
	case K_FILTER:
	case K_TRANSMIT:
	case K_GRAY:
		return true;
	default:
		return false;
	}
}

static bool read_component(struct quick *q, struct number *n)
{
	if (!read_operand(q, n))
		return false;
	if (!quick_skip(q, '.'))
		return true;
	if (q->at == q->end || !is_selector(q->at))
		return false;
	*n = number_select(q->p, *n, (enum keyword)q->at++->payload, NO_SPAN);
	return true;
}

static bool read_signed(struct quick *q, struct number *n)
{
	const unsigned sign = quick_next(q);
	if (sign != '-' && sign != '+' && sign != '!')
		return read_component(q, n);
	q->at++;
	if (!quick_go_down(q))
		return false;
	const bool ok = read_signed(q, n);
	quick_go_up(q);
	if (ok && sign == '-')
		*n = number_negate(*n);
	else if (ok && sign == '!')
		*n = number_not(*n);
	return ok;
}

/* a = a op b; the commonest, floats, at once. */
static void combine(struct quick *q, int op, struct number *a, const struct number *b)
{
	const bool floats = a->terms == 1 && b->terms == 1;
	if (floats && op == '+')
		a->v[0] += b->v[0];
	else if (floats && op == '-')
		a->v[0] -= b->v[0];
	else if (floats && op == '*')
		a->v[0] *= b->v[0];
	else
		*a = number_binary(q->p, op, *a, *b, NO_SPAN);
}

typedef bool reader(struct quick *, struct number *);
/* The grammar's operator for a raw token of one rank, 0: none. */
typedef int rank(unsigned kind);

/* Operands with operators of one rank between them, from the left. */
static inline bool read_chain(struct quick *q, struct number *n, reader *operand, rank *operator_of)
{
	if (!operand(q, n))
		return false;
	for (int op; (op = operator_of(quick_next(q))) != 0;) {
		struct number b;
		q->at++;
		if (!operand(q, &b))
			return false;
		combine(q, op, n, &b);
	}
	return true;
}

static inline int product_operator(unsigned kind)
{
	return kind == '*' || kind == '/' ? (int)kind : 0;
}

static bool read_product(struct quick *q, struct number *n)
{
	return read_chain(q, n, read_signed, product_operator);
}

static inline int sum_operator(unsigned kind)
{
	return kind == '+' || kind == '-' ? (int)kind : 0;
}

static bool sum_of_products(struct quick *q, struct number *n)
{
	return read_chain(q, n, read_product, sum_operator);
}

/* What stands behind most sums, and is no part of any. */
static inline bool ends_plainly(unsigned kind)
{
	return kind == ',' || kind == '>' || kind == ')' || kind == ';' || kind == ']' ||
	       kind == '}';
}

/* A literal alone, the commonest of all sums. */
static bool read_plain(struct quick *q, struct number *n)
{
	const struct raw_token *raw = q->at;
	if (q->end - raw < 2)
		return false;
	if (!ends_plainly(raw[1].kind))
		return false;
	if (raw->kind == RAW_INTEGER)
		*n = number_float(raw->payload);
	else if (raw->kind == RAW_NUMBER)
		*n = number_float(q->frame->source->numbers[raw->payload]);
	else
		return false;
	q->at++;
	return true;
}

/* The same for a vector of literals: n may be written to in vain. */
static bool read_plain_vector(struct quick *q, struct number *n)
{
	const struct raw_token *const first = q->at;
	if (quick_next(q) != '<')
		return false;
	*n = (struct number){ .terms = 0 };
	do {
		struct number term;
		q->at++;
		const bool negative = quick_skip(q, '-');
		if (!read_plain(q, &term))
			break;
		n->v[n->terms++] = negative ? -term.v[0] : term.v[0];
	} while (n->terms < 5 && quick_next(q) == ',');
	if (n->terms > 1 && quick_skip(q, '>') && ends_plainly(quick_next(q)))
		return true;
	q->at = first;
	return false;
}

bool quick_read_sum(struct quick *q, struct number *n)
{
	if (read_plain(q, n) || read_plain_vector(q, n))
		return true;
	if (!quick_go_down(q))
		return false;
	const bool ok = sum_of_products(q, n);
	quick_go_up(q);
	return ok;
}

/* -- Full expressions --------------------------------------------------------------------- */

static inline int relation_operator(unsigned kind)
{
	switch (kind) {
	case '<':
	case '>':
	case '=':
		return (int)kind;
	case RAW_LE:
		return T_LE;
	case RAW_GE:
		return T_GE;
	case RAW_NE:
		return T_NE;
	default:
		return 0;
	}
}

static bool read_relation(struct quick *q, struct number *n)
{
	return read_chain(q, n, quick_read_sum, relation_operator);
}

static inline int logic_operator(unsigned kind)
{
	return kind == '&' || kind == '|' ? (int)kind : 0;
}

static bool read_logic(struct quick *q, struct number *n)
{
	return read_chain(q, n, read_relation, logic_operator);
}

bool quick_read_full(struct quick *q, struct number *n)
{
	if (!read_logic(q, n))
		return false;
	if (!quick_skip(q, '?')) {
		*n = number_plain(*n);
		return true;
	}
	struct number yes, no;
	if (n->terms != 1 || !quick_read_full(q, &yes) || !quick_skip(q, ':') ||
		!quick_read_full(q, &no))
		return false;
	*n = number_is_true(q->p, *n, NO_SPAN) ? yes : no;
	return true;
}

/* -- Attempts ----------------------------------------------------------------------------- */

bool quick_begin(struct quick *q, struct parser *p)
{
	struct expand *x = p->expand;
	if (p->failed || p->options->no_short_ways || has_read_ahead(x) ||
		p->state->version < QUICK_VERSION)
		return false;
	const struct frame *f = &x->frames[x->frame_count - 1];
	q->p = p;
	q->frame = f;
	q->at = f->tokens + f->position;
	q->end = f->tokens + f->end;
	q->depth = 0;
	q->object = NULL;
	q->arg_count = args_height(p);
	q->draw_count = 0;
	p->trial = true;
	p->refused = false;
	return true;
}

/* Puts the streams back to where they were after the first `kept` draws. */
static void undo_draws(struct quick *q, unsigned kept)
{
	while (q->draw_count > kept) {
		const struct draw *d = &q->draws[--q->draw_count];
		q->p->seeds[d->stream] = d->state;
	}
}

bool quick_finish(struct quick *q, bool good)
{
	struct parser *p = q->p;
	struct expand *x = p->expand;
	p->trial = false;
	if (!good || p->refused) {
		p->grammar->arg_count = q->arg_count;
		undo_draws(q, 0);
		return false;
	}
	struct frame *f = &x->frames[x->frame_count - 1];
	const uint32_t position = (uint32_t)(q->at - f->tokens);
	x->work += position - f->position;
	p->token_count += position - f->position;
	if (symbols_are_old(&x->symbols, p->token_count))
		symbols_recycle(&x->symbols, p->token_count);
	f->position = position;
	x->gate->operand = true;
	x->gate->dot = false;
	x->gate->delivered += 2; /* not one identifier alone */
	x->before = *x->gate;
	return true;
}

/* The raw token behind the attempt, also if that reaches to the end of a macro; NO_KIND: none. */
static unsigned kind_behind(const struct quick *q)
{
	const struct expand *x = q->p->expand;
	const struct frame *f = q->frame;
	if (q->at < q->end)
		return q->at->kind;
	if (x->unread_count) /* could belong in between */
		return NO_KIND;
	while (f->is_macro) {
		f--;
		if (f->position < f->end)
			return f->tokens[f->position].kind;
	}
	return NO_KIND;
}

/* A closing bracket, comma or semicolon ends any expression. */
static bool at_close(const struct quick *q)
{
	const unsigned kind = kind_behind(q);
	return kind == ',' || kind == ')' || kind == ';' || kind == ']';
}

static bool begins_with_t(const struct quick *q)
{
	return quick_next(q) == RAW_KEYWORD && q->at->payload == (uint32_t)K_T;
}

/* A value that is declared or an argument cannot begin with t. */
static bool closed_sum(struct parser *p, struct number *n, bool value)
{
	struct quick q;
	if (!quick_begin(&q, p))
		return false;
	const bool ok = !(value && begins_with_t(&q)) && quick_read_sum(&q, n) && at_close(&q);
	if (!quick_finish(&q, ok))
		return false;
	*n = number_plain(*n);
	return true;
}

bool quick_number(struct parser *p, struct number *n)
{
	return closed_sum(p, n, false);
}

bool quick_value(struct parser *p, struct value *value)
{
	struct number n;
	if (!closed_sum(p, &n, true))
		return false;
	*value = value_number(n);
	return true;
}

bool quick_float(struct parser *p, enum quick_level level, double *value)
{
	struct quick q;
	struct number n;
	if (!quick_begin(&q, p))
		return false;
	const bool ok = level == QUICK_FULL ? quick_read_full(&q, &n) : quick_read_sum(&q, &n);
	if (!quick_finish(&q, ok && n.terms == 1 && at_close(&q)))
		return false;
	*value = n.v[0];
	return true;
}

bool quick_ends_sum(const struct quick *q)
{
	const struct name *name;
	switch (quick_next(q)) {
	case NO_KIND:
	case RAW_ERROR:
	case RAW_DIRECTIVE:
	case '+':
	case '-':
	case '*':
	case '/':
	case '.':
		return false;
	case RAW_NAME:
		name = &q->p->expand->names.list[q->at->payload];
		return name->hidden || !name->binding || name->binding->slot->kind != VALUE_MACRO;
	default:
		return true;
	}
}

static bool may_begin(const struct quick *q, enum quick_place place)
{
	switch (quick_next(q)) {
	case RAW_INTEGER:
	case RAW_NUMBER:
	case RAW_NAME:
	case RAW_KEYWORD:
		return true;
	case '(':
		return place == NEXT_ANY;
	case '<':
	case '+':
	case '-':
	case '!':
		return place != NEXT_AFTER_SUM;
	default:
		return false;
	}
}

bool quick_sum(struct parser *p, enum quick_place place, struct number *n, span *where)
{
	struct quick q;
	if (!quick_begin(&q, p))
		return false;
	const struct raw_token *first = q.at;
	const bool ok = may_begin(&q, place) && quick_read_sum(&q, n) && quick_ends_sum(&q);
	/* One word may be more than its value: a colour, the place of a vector, an axis. */
	const bool plain = ok && (n->terms == 1 || q.at - first > 1);
	if (!quick_finish(&q, plain))
		return false;
	*where = raw_span_at(p, q.at - 1);
	where->length += where->offset - first->offset;
	where->offset = first->offset;
	return true;
}

static bool may_be_referred_to(const struct value *v)
{
	return v && (v->kind == VALUE_NUMBER || v->kind == VALUE_COLOUR ||
			    v->kind == VALUE_STRING || v->kind == VALUE_ARRAY);
}

/* A variable or element alone is passed by reference. */
static bool read_reference(struct quick *q, struct argument *a)
{
	const struct raw_token *first = q->at;
	const unsigned draws = q->draw_count;
	if (quick_next(q) != RAW_NAME)
		return false;
	a->slot = quick_read_variable(q, &a->symbol);
	if (may_be_referred_to(a->slot) && at_close(q)) {
		a->value = *a->slot;
		return true;
	}
	q->at = first;
	undo_draws(q, draws);
	return false;
}

static bool read_argument(struct quick *q, struct argument *a)
{
	struct number n;
	const char *text;
	if (read_reference(q, a))
		return true;
	if (quick_next(q) == RAW_STRING) {
		a->slot = NULL;
		if (!quick_read_text(q, &text) || !at_close(q))
			return false;
		a->value = value_string(text);
		return true;
	}
	if (begins_with_t(q) || !quick_read_sum(q, &n) || !at_close(q))
		return false;
	a->slot = NULL;
	a->value = value_number(number_plain(n));
	return true;
}

bool quick_argument(struct parser *p, struct argument *a)
{
	struct quick q;
	return quick_begin(&q, p) && quick_finish(&q, read_argument(&q, a));
}

static bool read_arguments(struct quick *q, struct argument *arguments, unsigned count)
{
	bool fine = quick_skip(q, '(');
	for (unsigned i = 0; fine && i < count; i++)
		fine = (!i || quick_skip(q, ',')) && read_argument(q, &arguments[i]);
	return fine && quick_skip(q, ')');
}

bool quick_arguments(struct parser *p, struct argument *arguments, unsigned count)
{
	struct quick q;
	return quick_begin(&q, p) && quick_finish(&q, read_arguments(&q, arguments, count));
}
