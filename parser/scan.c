/* SPDX-License-Identifier: MIT */
/*
 * Between the directive layer and the grammar: delivers the tokens of one run
 * with the small values the grammar keeps, and remembers open brackets for
 * messages (syntax.c).
 *
 * Numbers inside brackets, the bulk of every large scene, are read whole by the
 * short way (quick.c) where that can be, and reach the grammar as one T_SUM.
 */
#include "build.h"

#include "grammar.tab.h"

#include <stdlib.h>
#include <string.h>

const int keyword_token[KEYWORD_COUNT] = {
#define KEYWORD(word, WORD) [K_##WORD] = KW_##WORD,
#define SYNONYM(word, WORD)
#include "language/keywords.def"
#undef KEYWORD
#undef SYNONYM
};

struct grammar *grammar_state(struct parser *p)
{
	if (!p->grammar)
		p->grammar = ARENA_NEW(p->arena, struct grammar);
	return p->grammar;
}

void grammar_finish(struct parser *p)
{
	if (p->grammar)
		free(p->grammar->args);
}

/* -- Open brackets ------------------------------------------------------------------------ */

static void open_bracket(struct parser *p, struct run *run, int token, span where)
{
	struct grammar *g = p->grammar;
	const size_t at = run->base + run->depth++;
	if (at == g->opening_capacity) {
		const size_t capacity = at ? 2 * at : 64;
		struct opening *grown = ARENA_ARRAY(p->arena, capacity, struct opening);
		if (at)
			memcpy(grown, g->openings, at * sizeof *grown);
		g->openings = grown;
		g->opening_capacity = capacity;
	}
	g->openings[at] = (struct opening){ token, where, run->word_span, run->word };
	g->opening_top = at + 1;
}

static void close_bracket(struct parser *p, struct run *run)
{
	if (!run->depth)
		return;
	run->depth--;
	run->closed = true;
	p->grammar->opening_top = run->base + run->depth;
}

/* Words that are a value themselves: axes, and constants, which come as numbers. */
static bool is_constant(int token)
{
	return token == T_NUMBER || token == KW_X || token == KW_Y || token == KW_Z ||
	       token == KW_U || token == KW_V || token == KW_T;
}

/* Whether the token behind this one may begin a number. Not among the parameters of a function, which
 * may be called x. */
static enum quick_place place_behind(
	const struct parser *p, const struct run *run, const struct queued *t)
{
	if (!run->depth || p->grammar->openings[run->base + run->depth - 1].keyword == K_FUNCTION)
		return NEXT_NONE;
	switch (t->token) {
	case '{':
	case '(':
	case '[':
	case ',':
		return NEXT_ANY;
	case T_SUM:
		return NEXT_AFTER_SUM;
	case KW_MATRIX:
		return NEXT_NONE;
	default:
		if (is_constant(t->token))
			return NEXT_NONE;
		return t->value.keyword != K_NONE && run->token_before != '.' ? NEXT_AFTER_WORD
									      : NEXT_NONE;
	}
}

/* The items that may begin behind a token. An object within a pigment or the like is a pattern, whose
 * pigments are no modifiers. */
static unsigned items_behind(const struct parser *p, const struct run *run, int token)
{
	if (token != '{' && token != '}' && token != T_SHAPE && token != T_MODIFIER)
		return ITEMS_NONE;
	if (!run->depth)
		return run->start_token == T_START_SCENE ? ITEMS_OBJECTS : ITEMS_NONE;
	const struct opening *open = &p->grammar->openings[run->base + run->depth - 1];
	if (is_csg(open->keyword))
		return ITEMS_OBJECTS | ITEMS_MODIFIERS;
	if (open->keyword != K_OBJECT)
		return ITEMS_NONE;
	return run->depth == 1 || is_csg(open[-1].keyword) ? ITEMS_OBJECTS | ITEMS_MODIFIERS
							   : ITEMS_OBJECTS;
}

static void note_token(struct parser *p, struct run *run, const struct queued *t)
{
	run->closed = false;
	switch (t->token) {
	case '{':
		run->braces++;
		open_bracket(p, run, '{', t->where);
		break;
	case '(':
	case '[':
		open_bracket(p, run, t->token, t->where);
		break;
	case '}':
		if (run->braces)
			run->braces--;
		/* fall through */
	case ')':
	case ']':
		close_bracket(p, run);
		break;
	default:
		break;
	}
	run->word_before = run->word;
	run->word = is_constant(t->token) ? K_NONE : t->value.keyword;
	run->word_span = t->where;
	run->next = place_behind(p, run, t);
	run->items = items_behind(p, run, t->token);
	if (t->token == T_SHAPE || t->token == T_MODIFIER) {
		run->word = K_NONE; /* it is complete */
		run->next = NEXT_NONE;
	}
}

/* -- The next token ----------------------------------------------------------------------- */

static int fetch(struct parser *p, struct queued *t)
{
	t->value.keyword = K_NONE;
	t->value.symbol = NULL;
	t->token = expand_next(p, &t->value, &t->where);
	return t->token;
}

static bool next_sum(struct parser *p, struct run *run)
{
	struct queued *t = &run->present;
	if (run->next == NEXT_NONE || p->grammar->scope ||
		!quick_sum(p, run->next, &t->value.number, &t->where))
		return false;
	t->token = T_SUM;
	t->value.keyword = K_NONE;
	t->value.symbol = NULL;
	t->value.name = NULL;
	return true;
}

/* A whole item, behind the directives and macro calls before it. */
static bool next_item(struct parser *p, struct run *run)
{
	struct queued *t = &run->present;
	struct token_value *v = &t->value;
	bool modifier;
	if (run->items == ITEMS_NONE ||
		(!quick_item(p, run->items, &v->made, &v->keyword, &t->where, &modifier) &&
			!(expand_settle(p) && quick_item(p, run->items, &v->made, &v->keyword,
						      &t->where, &modifier))))
		return false;
	t->token = modifier ? T_MODIFIER : T_SHAPE;
	v->symbol = NULL;
	v->name = NULL;
	return true;
}

static void next_token(struct parser *p, struct run *run)
{
	struct queued *t = &run->present;
	span last;
	/* Only inside braces, elsewhere the '<' may have to be handed back; and not in the
	 * expressions of functions, where it may mean "less than": min(x<1, 2>y). */
	if (fetch(p, t) == '<' && run->braces && !p->grammar->scope &&
		expand_plain_vector(p, &t->value.number, &last)) {
		t->token = T_VECTOR;
		t->where = span_join(t->where, last);
	}
}

const struct queued *run_unfold(struct parser *p, struct run *run)
{
	const int token = run->last->token;
	if (token == T_SUM || token == T_SHAPE || token == T_MODIFIER) {
		expand_back(p, run->last->where);
		fetch(p, &run->present);
	}
	return run->last;
}

/* -- Values of tokens --------------------------------------------------------------------- */

const char *token_name(const struct token_value *v)
{
	return v->symbol ? symbol_name(v->symbol) : v->name;
}

static void convert(GRAMMAR_STYPE *out, int token, const struct token_value *v)
{
	switch (token) {
	case T_NUMBER:
	case T_VECTOR:
	case T_COLOUR:
		out->named = (struct number_value){ v->number, v->symbol, v->keyword };
		if (token == T_NUMBER)
			out->named.number.terms = 1;
		out->named.number.leftover = false;
		break;
	case T_SUM:
		out->number = v->number;
		break;
	case T_SHAPE:
	case T_MODIFIER:
		out->node = v->made;
		break;
	case T_STRING:
		out->text = (struct text_value){ v->string, v->raw ? v->raw : v->string };
		break;
	case T_FUNCTION:
	case T_VECTOR_FUNCTION:
		out->callee = (struct callee){ v->function, token_name(v) };
		break;
	case T_SPLINE:
		out->spline = v->spline;
		break;
	case T_ARRAY:
		out->symbol = v->symbol;
		break;
	case T_UNDECLARED:
		out->name = v->name;
		break;
	default:
		if (v->keyword != K_NONE)
			out->keyword = v->keyword;
		else
			out->ref = (struct reference){ v->node, token_name(v) };
		break;
	}
}

int grammar_lex(GRAMMAR_STYPE *, span *, struct parser *, struct run *);
int grammar_lex(GRAMMAR_STYPE *value, span *where, struct parser *p, struct run *run)
{
	if (run->start) {
		const int start = run->start;
		run->start = 0;
		*where = NO_SPAN;
		return start;
	}
	run->token_before = run->last ? run->last->token : 0;
	run->where_before = run->present.where;
	struct queued *t = &run->present;
	if (!next_item(p, run) && !next_sum(p, run))
		next_token(p, run);
	if (p->failed)
		t->token = 0;
	note_token(p, run, t);
	run->last = t;
	*where = t->where;
	convert(value, t->token, &t->value);
	return t->token;
}

void run_accept(struct parser *p, struct run *run, bool ahead)
{
	run->accepted = true;
	if (ahead && run->last && !p->failed)
		expand_unread(p, run->last->token, &run->last->value, run->last->where);
}
