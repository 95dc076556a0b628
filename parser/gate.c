/* SPDX-License-Identifier: MIT */
/*
 * The gate: follows the tokens of an expression on their way to the grammar, so
 * that it is known where a complete operand stands outside of brackets; there a
 * held gate keeps directives and macros from running, see expand.h.
 */
#include "expand.h"

#include "grammar.tab.h"

void gate_open(struct parser *p, struct gate *g, bool hold)
{
	*g = (struct gate){ .outer = p->expand->gate, .hold = hold };
	p->expand->gate = g;
}

void gate_close(struct parser *p)
{
	p->expand->gate = p->expand->gate->outer;
}

bool gate_holds(const struct gate *g)
{
	return g->hold && g->operand && g->depth == 0;
}

static void gate_bracket(struct gate *g, bool angle)
{
	g->depth++;
	g->angles = g->angles << 1 | angle;
	g->operand = false;
}

static void gate_unbracket(struct gate *g)
{
	if (g->depth)
		g->depth--;
	g->angles >>= 1;
	g->operand = true;
}

static bool is_unit_vector(int token)
{
	return token == KW_X || token == KW_Y || token == KW_Z || token == KW_U || token == KW_V ||
	       token == KW_T;
}

void gate_note(struct gate *g, int token, const struct token_value *v)
{
	if (g->delivered++ == 0) {
		g->first = token;
		g->symbol = v->symbol;
		g->slot = v->symbol ? v->symbol->slot : NULL;
		g->table = v->symbol ? v->symbol->table : 0;
	}
	const bool dot = g->dot;
	g->dot = token == '.';
	switch (token) {
	case '(':
		g->parentheses++;
		gate_bracket(g, false);
		break;
	case '[':
	case '{':
		gate_bracket(g, false);
		break;
	case ')':
		g->parentheses -= g->parentheses > 0;
		gate_unbracket(g);
		break;
	case ']':
	case '}':
		gate_unbracket(g);
		break;
	case '<':
		if (g->operand)
			g->operand = false; /* less than */
		else
			gate_bracket(g, true);
		break;
	case '>':
		if (g->depth && (g->angles & 1))
			gate_unbracket(g);
		else
			g->operand = false; /* greater than */
		break;
	case T_FUNCTION:
	case T_VECTOR_FUNCTION:
	case T_SPLINE: /* the look for the bracket of a call is live */
		g->operand = false;
		break;
	case T_NUMBER:
	case T_VECTOR:
	case T_COLOUR:
	case T_STRING:
	case T_OBJECT:
	case T_TEXTURE:
	case T_PIGMENT:
	case T_NORMAL:
	case T_FINISH:
	case T_MATERIAL:
	case T_INTERIOR:
	case T_MEDIA:
	case T_DENSITY:
	case T_CAMERA:
	case T_FOG:
	case T_RAINBOW:
	case T_SKY_SPHERE:
	case T_TRANSFORM:
	case T_COLOUR_MAP:
	case T_PIGMENT_MAP:
	case T_NORMAL_MAP:
	case T_TEXTURE_MAP:
	case T_SLOPE_MAP:
	case T_DENSITY_MAP:
	case T_ARRAY:
	case T_UNDECLARED:
		g->operand = true;
		break;
	default:
		g->operand = dot || is_unit_vector(token);
		break;
	}
}
