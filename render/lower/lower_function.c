/* SPDX-License-Identifier: MIT */
/*
 * User-defined functions to register code.
 *
 * Scenes are tuned on the reference's arithmetic, so its habits are kept:
 * division by a constant is multiplication by its reciprocal, small constant
 * powers are products, and neighbouring constants of a chain of operators are
 * merged, even where that is not quite algebra (see merge_chain).
 */
#include "lower/lower_function.h"

#include "function/ridged.h"
#include "looks.h"

#include <assert.h>
#include <stdlib.h>

struct code {
	struct lowering *lowering;
	const struct function *function;
	struct instruction *items;
	size_t count, room;
	double constants[PROGRAM_REGISTERS_MAX];
	unsigned constant_count;
	const struct program *calls[PROGRAM_CALLS_MAX];
	unsigned call_count;
	unsigned next, highest; /* temporaries: the next free one, as if constants took no room */
	bool failed;
};

/* Operands are numbered: variables first, then CONSTANT_BASE + k, then TEMPORARY_BASE + k; the
 * numbers become registers when the counts are known. */
enum { CONSTANT_BASE = 0x4000, TEMPORARY_BASE = 0x8000 };

static void fail(struct code *c, span where, const char *message)
{
	if (!c->failed)
		diag_error(c->lowering->diag, where, "%s", message);
	c->failed = true;
}

static size_t emit(struct code *c, enum opcode op, unsigned to, unsigned a, unsigned b)
{
	if (c->count == c->room) {
		c->room = c->room ? 2 * c->room : 64;
		c->items = memory_grow(c->items, c->room, sizeof *c->items);
	}
	c->items[c->count] = (struct instruction){
		.op = (uint8_t)op, .to = (uint16_t)to, .a = (uint16_t)a, .b = (uint16_t)b
	};
	return c->count++;
}

static unsigned constant(struct code *c, double v, span where)
{
	for (unsigned i = 0; i < c->constant_count; i++) {
		if (c->constants[i] == v && signbit(c->constants[i]) == signbit(v))
			return CONSTANT_BASE + i;
	}
	if (c->constant_count == PROGRAM_REGISTERS_MAX) {
		fail(c, where, "the function has too many constants");
		return CONSTANT_BASE;
	}
	c->constants[c->constant_count] = v;
	return CONSTANT_BASE + c->constant_count++;
}

static unsigned temporary(struct code *c, span where)
{
	if (c->next >= PROGRAM_REGISTERS_MAX) {
		fail(c, where, "the function is too complex");
		return TEMPORARY_BASE;
	}
	const unsigned t = c->next++;
	if (c->next > c->highest)
		c->highest = c->next;
	return TEMPORARY_BASE + t;
}

static unsigned compile(struct code *, const struct expr *);

/* Evaluates into a temporary of the caller's choice. */
static void compile_to(struct code *c, const struct expr *e, unsigned to)
{
	const unsigned mark = c->next;
	const unsigned from = compile(c, e);
	c->next = mark;
	if (from != to)
		emit(c, OP_MOVE, to, from, 0);
}

/* ---- chains of operators of one level ---- */

enum { CHAIN_MAX = 200 };

/* One operand of a chain a0 op1 a1 op2 a2 …, attached by `op`. */
struct link {
	enum expr_kind op;
	const struct expr *operand; /* NULL: the constant */
	double constant;
	bool has_variable;
};

static int level_of(enum expr_kind kind)
{
	switch (kind) {
	case EXPR_OR:
		return 1;
	case EXPR_AND:
		return 2;
	case EXPR_LESS:
	case EXPR_LESS_EQUAL:
	case EXPR_EQUAL:
	case EXPR_NOT_EQUAL:
	case EXPR_GREATER_EQUAL:
	case EXPR_GREATER:
		return 3;
	case EXPR_ADD:
	case EXPR_SUBTRACT:
		return 4;
	case EXPR_MULTIPLY:
	case EXPR_DIVIDE:
		return 5;
	default:
		return 0;
	}
}

static bool has_variable(const struct expr *e)
{
	if (e->kind == EXPR_PARAMETER)
		return true;
	for (uint32_t i = 0; i < e->operand_count; i++) {
		if (has_variable(e->operands[i]))
			return true;
	}
	return false;
}

static enum opcode opcode_of(enum expr_kind kind)
{
	switch (kind) {
	case EXPR_ADD:
		return OP_ADD;
	case EXPR_SUBTRACT:
		return OP_SUBTRACT;
	case EXPR_MULTIPLY:
		return OP_MULTIPLY;
	case EXPR_DIVIDE:
		return OP_DIVIDE;
	case EXPR_LESS:
		return OP_LESS;
	case EXPR_LESS_EQUAL:
		return OP_LESS_EQUAL;
	case EXPR_EQUAL:
		return OP_EQUAL;
	case EXPR_NOT_EQUAL:
		return OP_NOT_EQUAL;
	case EXPR_GREATER_EQUAL:
		return OP_GREATER_EQUAL;
	case EXPR_GREATER:
		return OP_GREATER;
	case EXPR_AND:
		return OP_AND;
	default:
		return OP_OR;
	}
}

static double apply(enum expr_kind kind, double a, double b)
{
	switch (kind) {
	case EXPR_ADD:
		return a + b;
	case EXPR_SUBTRACT:
		return a - b;
	case EXPR_MULTIPLY:
		return a * b;
	case EXPR_DIVIDE:
		return a / b;
	case EXPR_LESS:
		return a < b;
	case EXPR_LESS_EQUAL:
		return a <= b;
	case EXPR_EQUAL:
		return a == b;
	case EXPR_NOT_EQUAL:
		return a != b;
	case EXPR_GREATER_EQUAL:
		return a >= b;
	case EXPR_GREATER:
		return a > b;
	case EXPR_AND:
		return a != 0 && b != 0;
	default:
		return a != 0 || b != 0;
	}
}

static bool merged_constant(struct code *, const struct expr *, double *);

/* Whether e is attached to its left neighbour in a chain of that level. */
static bool continues_chain(const struct expr *e, int level)
{
	return level_of(e->operands[0]->kind) == level && !e->operands[0]->grouped;
}

/* The links of the chain that e is the last step of. Returns their number. A chain hangs to the left
 * and may be as long as the text, so it is followed without recursion and before anything else looks
 * into it. */
static size_t collect_chain(struct code *c, const struct expr *e, struct link *links)
{
	const int level = level_of(e->kind);
	size_t count = 2;
	for (const struct expr *step = e; continues_chain(step, level); step = step->operands[0])
		count++;
	if (count > CHAIN_MAX) {
		fail(c, e->span, "the function has too long a chain of operators");
		links[0] = (struct link){ .operand = e->operands[1] };
		return 1;
	}
	for (size_t i = count - 1; i > 0; i--) {
		links[i] = (struct link){ .op = e->kind, .operand = e->operands[1] };
		if (i > 1)
			e = e->operands[0];
	}
	links[0] = (struct link){ .operand = e->operands[0] };
	return count;
}

/* Merges neighbouring constants, left to right, the way the reference does. A merged pair stays
 * attached by the first one's operator: x - 2*3 + 1 becomes x - 7. */
static size_t merge_chain(struct code *c, struct link *links, size_t count)
{
	const bool product = count > 1 && level_of(links[1].op) == 5;
	bool variable_before = false;
	size_t kept = 0;
	for (size_t i = 0; i < count; i++) {
		struct link link = links[i];
		const struct expr *e = link.operand;
		link.has_variable = has_variable(e);
		variable_before |= link.has_variable;
		if (merged_constant(c, e, &link.constant))
			link.operand = NULL;
		if (link.op == EXPR_SUBTRACT && e->literal) {
			link.op = EXPR_ADD;
			link.constant = -link.constant;
		}
		if (kept && !link.operand && !links[kept - 1].operand &&
			!(product && variable_before))
			links[kept - 1].constant =
				apply(link.op, links[kept - 1].constant, link.constant);
		else
			links[kept++] = link;
	}
	return kept;
}

/* Whether e is a constant once its own chain is merged; groups and calls never are. */
static bool merged_constant(struct code *c, const struct expr *e, double *value)
{
	if (e->grouped)
		return false;
	if (e->kind == EXPR_CONSTANT) {
		*value = e->constant;
		return true;
	}
	if (e->kind == EXPR_NEGATE) {
		if (e->operands[0]->kind != EXPR_CONSTANT || e->operands[0]->grouped)
			return false;
		*value = -e->operands[0]->constant;
		return true;
	}
	if (!level_of(e->kind) || has_variable(e))
		return false;
	struct link links[CHAIN_MAX];
	const size_t count = merge_chain(c, links, collect_chain(c, e, links));
	if (count != 1 || links[0].operand)
		return false;
	*value = links[0].constant;
	return true;
}

static unsigned link_operand(struct code *c, const struct link *link, span where)
{
	return link->operand ? compile(c, link->operand) : constant(c, link->constant, where);
}

static unsigned compile_chain(struct code *c, const struct expr *e)
{
	struct link links[CHAIN_MAX];
	const size_t count = merge_chain(c, links, collect_chain(c, e, links));
	const unsigned to = temporary(c, e->span);
	const unsigned mark = c->next;
	unsigned left = link_operand(c, &links[0], e->span);
	for (size_t i = 1; i < count; i++) {
		struct link *link = &links[i];
		if (link->op == EXPR_DIVIDE && !link->operand) {
			if (link->constant == 0)
				fail(c, e->span, "division by zero in a function");
			link->op = EXPR_MULTIPLY;
			link->constant = 1 / link->constant;
		}
		const unsigned right = link_operand(c, link, e->span);
		emit(c, opcode_of(link->op), to, left, right);
		left = to;
		c->next = mark;
	}
	if (left != to)
		emit(c, OP_MOVE, to, left, 0);
	c->next = mark;
	return to;
}

/* ---- calls ---- */

static int opcode_of_builtin(enum keyword k)
{
	switch (k) {
	case K_SIN:
		return OP_SIN;
	case K_COS:
		return OP_COS;
	case K_TAN:
		return OP_TAN;
	case K_ASIN:
		return OP_ASIN;
	case K_ACOS:
		return OP_ACOS;
	case K_ATAN:
		return OP_ATAN;
	case K_SINH:
		return OP_SINH;
	case K_COSH:
		return OP_COSH;
	case K_TANH:
		return OP_TANH;
	case K_ASINH:
		return OP_ASINH;
	case K_ACOSH:
		return OP_ACOSH;
	case K_ATANH:
		return OP_ATANH;
	case K_ABS:
		return OP_ABS;
	case K_INT:
		return OP_INT;
	case K_FLOOR:
		return OP_FLOOR;
	case K_CEIL:
		return OP_CEIL;
	case K_SQRT:
		return OP_SQRT;
	case K_EXP:
		return OP_EXP;
	case K_LN:
		return OP_LN;
	case K_LOG:
		return OP_LOG;
	case K_ATAN2:
		return OP_ATAN2;
	case K_POW:
		return OP_POW;
	case K_MOD:
		return OP_MOD;
	case K_DIV:
		return OP_DIV;
	case K_MIN:
		return OP_MIN;
	case K_MAX:
		return OP_MAX;
	default:
		return -1;
	}
}

/* base to the power k, 2 to 8, by the reference's products. */
static void emit_power(struct code *c, unsigned to, unsigned base, int k, span where)
{
	const unsigned square = temporary(c, where), work = temporary(c, where);
	emit(c, OP_MULTIPLY, square, base, base);
	switch (k) {
	case 2:
		emit(c, OP_MOVE, to, square, 0);
		break;
	case 3:
		emit(c, OP_MULTIPLY, to, square, base);
		break;
	case 4:
	case 8:
		emit(c, OP_MULTIPLY, to, square, square);
		if (k == 8)
			emit(c, OP_MULTIPLY, to, to, to);
		break;
	case 5:
		emit(c, OP_MULTIPLY, work, square, square);
		emit(c, OP_MULTIPLY, to, work, base);
		break;
	case 6:
		emit(c, OP_MULTIPLY, work, square, square);
		emit(c, OP_MULTIPLY, to, work, square);
		break;
	default:
		emit(c, OP_MULTIPLY, work, square, square);
		emit(c, OP_MULTIPLY, work, work, base);
		emit(c, OP_MULTIPLY, to, work, square);
		break;
	}
}

/* pow(e, k) with a small constant k; false: an ordinary power. */
static bool compile_power(struct code *c, const struct expr *e, unsigned to)
{
	double exponent;
	if (!merged_constant(c, e->operands[1], &exponent) || exponent != floor(exponent))
		return false;
	if (exponent == 0) {
		diag_warning(c->lowering->diag, e->span, "a zero power is always 1");
		emit(c, OP_MOVE, to, constant(c, 1, e->span), 0);
		return true;
	}
	if (exponent < 2 || exponent > 8)
		return false;
	emit_power(c, to, compile(c, e->operands[0]), (int)exponent, e->span);
	return true;
}

/* select(a, negative, [zero,] positive): only the branch taken is computed. */
static void compile_select(struct code *c, const struct expr *e, unsigned to)
{
	const unsigned a = compile(c, e->operands[0]);
	const size_t negative = emit(c, OP_JUMP_NEGATIVE, 0, a, 0);
	const bool has_zero = e->operand_count == 4;
	const size_t zero = has_zero ? emit(c, OP_JUMP_ZERO, 0, a, 0) : 0;
	compile_to(c, e->operands[e->operand_count - 1], to);
	const size_t end_positive = emit(c, OP_JUMP, 0, 0, 0);
	c->items[negative].to = (uint16_t)c->count;
	compile_to(c, e->operands[1], to);
	if (has_zero) {
		const size_t end_negative = emit(c, OP_JUMP, 0, 0, 0);
		c->items[zero].to = (uint16_t)c->count;
		compile_to(c, e->operands[2], to);
		c->items[end_negative].to = (uint16_t)c->count;
	}
	c->items[end_positive].to = (uint16_t)c->count;
}

/* One-argument functions of degrees and radians are products. */
static double angle_factor(enum keyword k)
{
	return k == K_DEGREES ? 180 / M_PI : M_PI / 180;
}

static void compile_builtin(struct code *c, const struct expr *e, unsigned to)
{
	if (e->builtin == K_SELECT) {
		compile_select(c, e, to);
		return;
	}
	if (e->builtin == K_DEGREES || e->builtin == K_RADIANS) {
		const unsigned a = compile(c, e->operands[0]);
		emit(c, OP_MULTIPLY, to, a, constant(c, angle_factor(e->builtin), e->span));
		return;
	}
	if (e->builtin == K_POW && compile_power(c, e, to))
		return;
	const int op = opcode_of_builtin(e->builtin);
	if (op < 0) {
		fail(c, e->span, "this function cannot be used in a function body");
		return;
	}
	unsigned left = compile(c, e->operands[0]);
	if (e->operand_count == 1)
		emit(c, (enum opcode)op, to, left, 0);
	for (uint32_t i = 1; i < e->operand_count; i++) {
		const unsigned mark = c->next;
		emit(c, (enum opcode)op, to, left, compile(c, e->operands[i]));
		c->next = mark;
		left = to;
	}
}

/* A call in the picture may be the one that fills the table of f_ridged_mf. */
static void expect_ridged(struct code *c, const struct expr *call, struct ridged_table *table)
{
	double h, lacunarity;
	const bool known = merged_constant(c, call->operands[3], &h) &&
			   merged_constant(c, call->operands[4], &lacunarity);
	if (!c->lowering->for_questions)
		ridged_expect(table, known ? &h : NULL, known ? &lacunarity : NULL);
}

static void compile_call(struct code *c, const struct expr *e, unsigned to)
{
	const struct program *callee = lower_function(c->lowering, e->function);
	if (!callee || c->call_count == PROGRAM_CALLS_MAX) {
		fail(c, e->span, "the function cannot be called here");
		return;
	}
	if (callee->world.ridged)
		expect_ridged(c, e, callee->world.ridged);
	const unsigned first = c->next;
	for (uint32_t i = 0; i < e->operand_count; i++)
		temporary(c, e->span);
	for (uint32_t i = 0; i < e->operand_count; i++)
		compile_to(c, e->operands[i], TEMPORARY_BASE + first + i);
	const size_t at = emit(c, OP_CALL, to, TEMPORARY_BASE + first, e->component);
	c->items[at].extra = (uint8_t)c->call_count;
	c->calls[c->call_count++] = callee;
}

/* sum and prod: the variable runs from operand 0 while it is not above operand 1. */
static void compile_loop(struct code *c, const struct expr *e, unsigned to)
{
	const bool sum = e->kind == EXPR_SUM;
	const unsigned total = temporary(c, e->span), end = temporary(c, e->span);
	const unsigned one = constant(c, 1, e->span);
	emit(c, OP_MOVE, total, constant(c, sum ? 0 : 1, e->span), 0);
	compile_to(c, e->operands[0], e->index);
	compile_to(c, e->operands[1], end);
	const size_t top = emit(c, OP_JUMP_ABOVE, 0, e->index, end);
	const unsigned mark = c->next;
	const unsigned value = compile(c, e->operands[2]);
	c->next = mark;
	emit(c, sum ? OP_ADD : OP_MULTIPLY, total, total, value);
	emit(c, OP_ADD, e->index, e->index, one);
	emit(c, OP_JUMP, (unsigned)top, 0, 0);
	c->items[top].to = (uint16_t)c->count;
	emit(c, OP_MOVE, to, total, 0);
}

static unsigned compile(struct code *c, const struct expr *e)
{
	if (e->kind == EXPR_CONSTANT)
		return constant(c, e->constant, e->span);
	if (e->kind == EXPR_PARAMETER)
		return e->index;
	if (level_of(e->kind))
		return compile_chain(c, e);
	const unsigned to = temporary(c, e->span);
	const unsigned mark = c->next;
	if (e->kind == EXPR_NEGATE)
		emit(c, OP_NEGATE, to, compile(c, e->operands[0]), 0);
	else if (e->kind == EXPR_CALL)
		compile_builtin(c, e, to);
	else if (e->kind == EXPR_FUNCTION)
		compile_call(c, e, to);
	else
		compile_loop(c, e, to);
	c->next = mark;
	return to;
}

/* ---- whole functions ---- */

static uint16_t register_of(const struct code *c, uint16_t operand)
{
	const unsigned variables = c->function->variable_count;
	if (operand >= TEMPORARY_BASE)
		return (uint16_t)(variables + c->constant_count + (operand - TEMPORARY_BASE));
	if (operand >= CONSTANT_BASE)
		return (uint16_t)(variables + (operand - CONSTANT_BASE));
	return operand;
}

static bool is_jump(unsigned op)
{
	return op >= OP_JUMP && op <= OP_JUMP_ABOVE;
}

static void place_registers(struct code *c)
{
	for (size_t i = 0; i < c->count; i++) {
		struct instruction *in = &c->items[i];
		if (!is_jump(in->op))
			in->to = register_of(c, in->to);
		in->a = register_of(c, in->a);
		if (in->op != OP_CALL)
			in->b = register_of(c, in->b);
	}
}

static bool compile_body(struct lowering *l, const struct function *f, struct program *p)
{
	struct code *c = memory_alloc(1, sizeof *c);
	*c = (struct code){ .lowering = l, .function = f };
	const unsigned result = compile(c, f->body);
	emit(c, OP_RETURN, 0, result, 0);
	p->registers = f->variable_count + c->constant_count + c->highest;
	if (p->registers > PROGRAM_REGISTERS_MAX || c->count > UINT16_MAX)
		fail(c, f->span, "the function is too complex");
	place_registers(c);
	p->first_constant = f->variable_count;
	p->constant_count = c->constant_count;
	p->constants = arena_copy(l->arena, c->constants, c->constant_count * sizeof(double));
	p->code = arena_copy(l->arena, c->items, c->count * sizeof *c->items);
	p->calls = arena_copy(l->arena, c->calls, c->call_count * sizeof *c->calls);
	const bool fine = !c->failed;
	free(c->items);
	free(c);
	return fine;
}

/* The pattern of function { pattern { … } }. */
static const struct pattern *pattern_of(struct lowering *l, const struct node *block)
{
	struct pattern_state s = pattern_state_fresh;
	enum look_form form = FORM_PATTERN;
	for (const struct node *item = block->children; item; item = item->next) {
		pattern_state_item(l, &s, item, "pattern", &form);
	}
	if (!s.class || form == FORM_REFUSED)
		return NULL;
	struct pattern *pattern = ARENA_NEW(l->arena, struct pattern);
	pattern_build(l, &s, pattern);
	return pattern;
}

static struct ridged_table *ridged_table_of(struct lowering *l, const struct function *f)
{
	struct pointer_map *tables = &l->rendered->ridged_tables;
	struct ridged_table *t = pointer_map_find(tables, f);
	if (!t) {
		t = ARENA_NEW(l->rendered->arena, struct ridged_table);
		pointer_map_add(tables, f, t);
	}
	return t;
}

static bool compile_internal(struct lowering *l, const struct function *f, struct program *p)
{
	p->internal = internal_find(f->internal);
	if (!p->internal) {
		diag_error(
			l->diag, f->span, "there is no built-in function number %d", f->internal);
		return false;
	}
	assert(f->parameter_count == 3 + p->internal->parameters);
	p->parameters = f->parameter_count;
	if (f->internal == INTERNAL_RIDGED_MF)
		p->world.ridged = ridged_table_of(l, f);
	return true;
}

static bool compile_kind(struct lowering *l, const struct function *f, struct program *p)
{
	p->parameters = 3;
	p->components = 1;
	lower_late_generator(l, &p->world.noise_generator);
	switch (f->kind) {
	case FUNCTION_EXPRESSION:
		p->kind = PROGRAM_CODE;
		p->parameters = f->parameter_count;
		return compile_body(l, f, p);
	case FUNCTION_INTERNAL:
		p->kind = PROGRAM_INTERNAL;
		return compile_internal(l, f, p);
	case FUNCTION_PATTERN:
		p->kind = PROGRAM_PATTERN;
		p->pattern = pattern_of(l, f->node);
		return p->pattern != NULL;
	case FUNCTION_PIGMENT:
		p->kind = PROGRAM_PIGMENT;
		p->components = 5;
		p->pigment = lower_pigment(l, f->node, NULL);
		return p->pigment != NULL;
	case FUNCTION_TRANSFORM:
		p->kind = PROGRAM_TRANSFORM;
		p->components = 3;
		p->place = lower_transform(l, f->node);
		return true;
	case FUNCTION_SPLINE:
		p->kind = PROGRAM_SPLINE;
		p->parameters = 1;
		p->components = f->spline->terms;
		p->spline = spline_copy(l->arena, f->spline);
		return true;
	}
	return false;
}

const struct program *lower_function(struct lowering *l, const struct function *f)
{
	struct program *p = pointer_map_find(&l->functions, f);
	if (p)
		return p;
	p = ARENA_NEW(l->arena, struct program);
	if (!compile_kind(l, f, p))
		return NULL;
	pointer_map_add(&l->functions, f, p);
	return p;
}
