/* SPDX-License-Identifier: MIT */
/*
 * User-defined functions, compiled: flat register code, evaluated without
 * allocation. Made by lower/lower_function.c, const afterwards.
 */
#ifndef LAMBERT_FUNCTION_PROGRAM_H
#define LAMBERT_FUNCTION_PROGRAM_H

#include "base/transform.h"
#include "function/internal.h"

#include <stddef.h>
#include <stdint.h>

struct pattern;
struct pigment;

/* to = a op b, on registers. */
enum opcode {
	OP_ADD,
	OP_SUBTRACT,
	OP_MULTIPLY,
	OP_DIVIDE,
	OP_NEGATE,
	OP_MOVE,
	OP_LESS,
	OP_LESS_EQUAL,
	OP_EQUAL,
	OP_NOT_EQUAL,
	OP_GREATER_EQUAL,
	OP_GREATER,
	OP_AND,
	OP_OR,
	OP_SIN,
	OP_COS,
	OP_TAN,
	OP_ASIN,
	OP_ACOS,
	OP_ATAN,
	OP_SINH,
	OP_COSH,
	OP_TANH,
	OP_ASINH,
	OP_ACOSH,
	OP_ATANH,
	OP_ABS,
	OP_INT,
	OP_FLOOR,
	OP_CEIL,
	OP_SQRT,
	OP_EXP,
	OP_LN,
	OP_LOG,
	OP_ATAN2,
	OP_POW,
	OP_MOD,
	OP_DIV,
	OP_MIN,
	OP_MAX,
	OP_JUMP,	  /* to instruction `to` */
	OP_JUMP_NEGATIVE, /* to instruction `to` if register a < 0 */
	OP_JUMP_ZERO,	  /* … if register a == 0 */
	OP_JUMP_ABOVE,	  /* … if register a > register b, or either is not a number */
	OP_CALL,	  /* to = component b of calls[extra], arguments from register a on */
	OP_RETURN,	  /* register a */
};

struct instruction {
	uint8_t op, extra;
	uint16_t to, a, b;
};

enum program_kind {
	PROGRAM_CODE,
	PROGRAM_INTERNAL,
	PROGRAM_PATTERN,
	PROGRAM_PIGMENT,
	PROGRAM_TRANSFORM,
	PROGRAM_SPLINE,
};

enum { PROGRAM_REGISTERS_MAX = 256, PROGRAM_CALLS_MAX = 255, PROGRAM_PARAMETERS_MAX = 56 };

struct program {
	enum program_kind kind;
	unsigned parameters; /* arguments of a call */
	unsigned components; /* of the result, 1 to 5 */
	struct function_world world;
	/* PROGRAM_CODE: parameters and loop variables come first, then the constants */
	unsigned registers, first_constant, constant_count;
	const double *constants;
	const struct instruction *code;
	const struct program *const *calls;
	/* the others */
	const struct internal_entry *internal;
	const struct pattern *pattern;
	const struct pigment *pigment;
	transform place;
	const struct spline *spline;
};

/* The first component of the result. */
double program_value(const struct program *, const double *arguments);
/* All components; those beyond `components` are 0. */
void program_components(const struct program *, const double *arguments, double result[5]);

#endif
