/* SPDX-License-Identifier: MIT */
/*
 * The register machine of user-defined functions. All arithmetic is double;
 * comparisons, NaN and out-of-range arguments behave as the language says:
 * nothing is an error while a function runs.
 */
#include "function/program.h"

#include "base/elementary.h"
#include "base/spline.h"
#include "texture/pattern.h"
#include "texture/texture.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Conversion to a 32-bit integer as the language defines it: toward zero, INT_MIN when it does not fit. */
static double truncated(double v)
{
	return v > -2147483649.0 && v < 2147483648.0 ? trunc(v) : INT_MIN;
}

/* What the language makes of comparisons with NaN: =, < and <= are false, the others true. */
static double binary(enum opcode op, double a, double b)
{
	switch (op) {
	case OP_LESS:
		return a < b;
	case OP_LESS_EQUAL:
		return a <= b;
	case OP_EQUAL:
		return a == b;
	case OP_NOT_EQUAL:
		return a != b;
	case OP_GREATER_EQUAL:
		return !(a < b);
	case OP_GREATER:
		return !(a <= b);
	case OP_AND:
		return a != 0 && b != 0;
	case OP_OR:
		return a != 0 || b != 0;
	case OP_ATAN2:
		return elementary_atan2(a, b);
	case OP_POW:
		return elementary_pow(a, b);
	case OP_MOD:
		return fmod(a, b);
	case OP_DIV:
		return truncated(a / b);
	case OP_MIN:
		return a < b ? a : b;
	case OP_MAX:
		return a < b ? b : a; /* the first operand unless the second is larger */
	default:
		return 0;
	}
}

static double unary(enum opcode op, double a)
{
	switch (op) {
	case OP_SIN:
		return elementary_sin(a);
	case OP_COS:
		return elementary_cos(a);
	case OP_TAN:
		return elementary_tan(a);
	case OP_ASIN:
		return elementary_asin(a);
	case OP_ACOS:
		return elementary_acos(a);
	case OP_ATAN:
		return elementary_atan(a);
	case OP_SINH:
		return elementary_sinh(a);
	case OP_COSH:
		return elementary_cosh(a);
	case OP_TANH:
		return elementary_tanh(a);
	case OP_ASINH:
		return elementary_asinh(a);
	case OP_ACOSH:
		return elementary_acosh(a);
	case OP_ATANH:
		return elementary_atanh(a);
	case OP_INT:
		return truncated(a);
	case OP_FLOOR:
		return floor(a);
	case OP_CEIL:
		return ceil(a);
	case OP_EXP:
		return elementary_exp(a);
	case OP_LN:
		return elementary_log(a);
	case OP_LOG:
		return elementary_log10(a);
	default:
		return 0;
	}
}

static double call(const struct program *p, const double *arguments, unsigned component)
{
	enum { GRAY = 5, HEIGHT = 6 };
	if (p->components == 1)
		return program_value(p, arguments);
	double c[5];
	program_components(p, arguments, c);
	if (component == GRAY)
		return 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2];
	if (component == HEIGHT)
		return 0.996093 * (c[0] + c[1] / 255);
	return c[component];
}

static double run(const struct program *p, const double *arguments)
{
	double r[PROGRAM_REGISTERS_MAX];
	memcpy(r, arguments, p->parameters * sizeof *r);
	memcpy(r + p->first_constant, p->constants, p->constant_count * sizeof *r);
	for (const struct instruction *i = p->code;; i++) {
		switch ((enum opcode)i->op) {
		case OP_ADD:
			r[i->to] = r[i->a] + r[i->b];
			break;
		case OP_SUBTRACT:
			r[i->to] = r[i->a] - r[i->b];
			break;
		case OP_MULTIPLY:
			r[i->to] = r[i->a] * r[i->b];
			break;
		case OP_DIVIDE:
			r[i->to] = r[i->a] / r[i->b];
			break;
		case OP_NEGATE:
			r[i->to] = -r[i->a];
			break;
		case OP_MOVE:
			r[i->to] = r[i->a];
			break;
		case OP_ABS:
			r[i->to] = fabs(r[i->a]);
			break;
		case OP_SQRT:
			r[i->to] = sqrt(r[i->a]);
			break;
		case OP_JUMP:
			i = p->code + i->to - 1;
			break;
		case OP_JUMP_NEGATIVE:
			if (r[i->a] < 0)
				i = p->code + i->to - 1;
			break;
		case OP_JUMP_ZERO:
			if (r[i->a] == 0)
				i = p->code + i->to - 1;
			break;
		case OP_JUMP_ABOVE:
			if (!(r[i->a] <= r[i->b]))
				i = p->code + i->to - 1;
			break;
		case OP_CALL:
			r[i->to] = call(p->calls[i->extra], r + i->a, i->b);
			break;
		case OP_RETURN:
			return r[i->a];
		case OP_LESS:
		case OP_LESS_EQUAL:
		case OP_EQUAL:
		case OP_NOT_EQUAL:
		case OP_GREATER_EQUAL:
		case OP_GREATER:
		case OP_AND:
		case OP_OR:
		case OP_ATAN2:
		case OP_POW:
		case OP_MOD:
		case OP_DIV:
		case OP_MIN:
		case OP_MAX:
			r[i->to] = binary((enum opcode)i->op, r[i->a], r[i->b]);
			break;
		default:
			r[i->to] = unary((enum opcode)i->op, r[i->a]);
			break;
		}
	}
}

static vec3 point_of(const double *arguments)
{
	return vec(arguments[0], arguments[1], arguments[2]);
}

double program_value(const struct program *p, const double *arguments)
{
	double c[5];
	switch (p->kind) {
	case PROGRAM_CODE:
		return run(p, arguments);
	case PROGRAM_INTERNAL:
		return p->internal->call(
			arguments[0], arguments[1], arguments[2], arguments + 3, &p->world);
	case PROGRAM_PATTERN:
		return pattern_value(
			p->pattern, pattern_warp(p->pattern, point_of(arguments)), NULL);
	default:
		program_components(p, arguments, c);
		return c[0];
	}
}

void program_components(const struct program *p, const double *arguments, double result[5])
{
	memset(result, 0, 5 * sizeof *result);
	if (p->kind == PROGRAM_PIGMENT) {
		colour c;
		pigment_colour(p->pigment, point_of(arguments), NULL, &c);
		result[0] = c.r;
		result[1] = c.g;
		result[2] = c.b;
		result[3] = c.filter;
		result[4] = c.transmit;
	} else if (p->kind == PROGRAM_SPLINE) {
		spline_value(p->spline, arguments[0], result);
	} else if (p->kind == PROGRAM_TRANSFORM) {
		const vec3 q = transform_point(&p->place, point_of(arguments));
		result[0] = q.x;
		result[1] = q.y;
		result[2] = q.z;
	} else {
		result[0] = program_value(p, arguments);
	}
}
