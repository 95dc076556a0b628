/* SPDX-License-Identifier: MIT */
/*
 * Between the directive layer and the grammar: delivers the tokens of one run
 * with the small values the grammar keeps, remembers open brackets for
 * messages, and says in plain words what is wrong at a syntax error.
 *
 * Numbers inside brackets, the bulk of every large scene, are read whole by the
 * short way (quick.c) where that can be, and reach the grammar as one T_SUM.
 */
#include "parser/build.h"

#include "grammar.tab.h"

#include <string.h>

const int keyword_token[KEYWORD_COUNT] = {
#define KEYWORD(word, WORD) [K_##WORD] = KW_##WORD,
#define SYNONYM(word, WORD)
#include "parser/keywords.def"
#undef KEYWORD
#undef SYNONYM
};

struct grammar *grammar_state(struct parser *p)
{
	if (!p->grammar)
		p->grammar = ARENA_NEW(p->arena, struct grammar);
	return p->grammar;
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
	case KW_X:
	case KW_Y:
	case KW_Z:
	case KW_U:
	case KW_V:
	case KW_T:
	case KW_MATRIX:
	case T_NUMBER: /* some constants have a keyword, too */
		return NEXT_NONE;
	default:
		return t->value.keyword != K_NONE && run->token_before != '.' ? NEXT_AFTER_WORD
									      : NEXT_NONE;
	}
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
	run->word = t->value.keyword;
	run->word_span = t->where;
	run->next = place_behind(p, run, t);
}

/* -- The next token ----------------------------------------------------------------------- */

static int fetch(struct parser *p, struct queued *t)
{
	t->value.keyword = K_NONE;
	t->value.symbol = NULL;
	t->token = expand_next(p, &t->value, &t->where);
	return t->token;
}

static struct queued *next_token(struct parser *p, struct run *run)
{
	struct queued *t = &run->present;
	span last;
	if (run->next != NEXT_NONE && !p->grammar->scope &&
		quick_sum(p, run->next, &t->value.number, &t->where)) {
		t->token = T_SUM;
		t->value.keyword = K_NONE;
		t->value.symbol = NULL;
		t->value.name = NULL;
		return t;
	}
	/* Only inside braces, elsewhere the '<' may have to be handed back; and not in the
	 * expressions of functions, where it may mean "less than": min(x<1, 2>y). */
	if (fetch(p, t) == '<' && run->braces && !p->grammar->scope &&
		expand_plain_vector(p, &t->value.number, &last)) {
		t->token = T_VECTOR;
		t->where = span_join(t->where, last);
	}
	return t;
}

/* -- Values of tokens --------------------------------------------------------------------- */

static const char *token_name(const struct token_value *v)
{
	return v->symbol ? symbol_name(v->symbol) : v->name;
}

static void convert(GRAMMAR_STYPE *out, int token, const struct token_value *v)
{
	switch (token) {
	case T_NUMBER:
	case T_VECTOR:
	case T_COLOUR:
		out->named = (struct number_value){ v->number, v->symbol };
		if (token == T_NUMBER)
			out->named.number.terms = 1;
		out->named.number.leftover = false;
		break;
	case T_SUM:
		out->number = v->number;
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
	struct queued *t = next_token(p, run);
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

/* -- Messages ----------------------------------------------------------------------------- */

static const char *closing(int token)
{
	return token == '{' ? "}" : token == '(' ? ")" : "]";
}

/* Without the article. */
static const char *bare_words(int token)
{
	const char *words = token_words(token);
	return strncmp(words, "a ", 2) == 0    ? words + 2
	       : strncmp(words, "an ", 3) == 0 ? words + 3
					       : words;
}

static const char *found_words(struct parser *p, const struct queued *t)
{
	switch (t->token) {
	case 0:
		return "the end of the text";
	case T_NUMBER:
		return token_name(&t->value) && t->value.symbol
			       ? arena_printf(p->arena, "float '%s'", token_name(&t->value))
			       : "number";
	case T_SUM:
		return t->value.number.terms == 1 ? "number" : "vector";
	case T_HASH:
		return "directive";
	default:
		break;
	}
	if (t->token > ' ' && t->token < 127)
		return arena_printf(p->arena, "'%c'", t->token);
	if (t->value.keyword != K_NONE)
		return arena_printf(p->arena, "'%s'", keyword_name(t->value.keyword));
	if (t->value.symbol)
		return arena_printf(
			p->arena, "%s '%s'", bare_words(t->token), symbol_name(t->value.symbol));
	return bare_words(t->token);
}

/* The statement whose block is innermost, or NULL. */
static const struct opening *innermost(const struct parser *p, const struct run *run)
{
	return run->depth ? &p->grammar->openings[run->base + run->depth - 1] : NULL;
}

static bool is_closing(int token)
{
	return token == '}' || token == ')' || token == ']';
}

void note_comparison(struct parser *p, int token, span where)
{
	if (token == T_LE || token == T_GE || token == T_NE || token == '<' || token == '>' ||
		token == '=' || token == '&' || token == '|' || token == '?')
		diag_note(p->diag, where, "a comparison needs parentheses here: (a > b)");
}

/* What a run is to read, by its start token. */
static const char *wanted(int start_token)
{
	switch (start_token) {
	case T_START_DECLARED:
		return "a value";
	case T_START_STRING:
		return "a string";
	case T_START_FLOAT:
		return "a float";
	case T_START_CONDITION:
		return "a condition";
	default:
		return NULL;
	}
}

static bool ends_operand(int token)
{
	return token == T_SUM || token == T_NUMBER || token == T_VECTOR || token == T_COLOUR ||
	       token == T_STRING || token == ')' || token == '>';
}

/* Says what would be right where a habit from another language, or a comparison where only sums are
 * read, is the likely cause. */
static void hint(struct parser *p, const struct run *run, const struct queued *t)
{
	const int token = t->token, before = run->token_before;
	const bool doubled = token == before && (token == '=' || token == '&' || token == '|');
	if (doubled)
		diag_note(
			p->diag, t->where, "the operator is '%c', not '%c%c'", token, token, token);
	else if (token == ')' && before == T_STRING)
		diag_note(p->diag, t->where, "a string can only be compared here: (S = \"x\")");
	else if (token == '+' && before == T_STRING)
		diag_note(p->diag, t->where, "strings are joined by concat(S, T)");
	else if (t->value.keyword >= K_RGB && t->value.keyword <= K_RGBT && !ends_operand(before))
		diag_note(p->diag, t->where,
			"a colour in an expression must be declared: #declare C = rgb 1;");
	else if (token == ';' && run->start_token == T_START_SCENE)
		diag_note(p->diag, t->where, "a ';' ends directives only, such as #declare");
	else if (token != '<' && ends_operand(before))
		note_comparison(p, token, t->where);
}

void syntax_error(struct parser *p, struct run *run, const char *expected)
{
	if (p->failed || !run->last)
		return;
	const struct queued *t = run->last;
	if (t->token == T_UNDECLARED && run->token_before == '.') {
		parser_error(p, t->where,
			"'%s' is no component: there are x y z t, u v and red green blue filter "
			"transmit gray",
			t->value.name);
		return;
	}
	if (!expected && !run->token_before)
		expected = wanted(run->start_token);
	if (t->token == T_UNDECLARED) {
		parser_error_undeclared(p, t->where, t->value.name);
		return;
	}
	/* A closing bracket that does not fit has already been taken off the stack. */
	const struct opening *open =
		run->closed ? &p->grammar->openings[run->base + run->depth] : innermost(p, run);
	const char *found = found_words(p, t);
	if (t->token == 0 && open) {
		const bool named = open->keyword != K_NONE;
		const char *what = named ? keyword_name(open->keyword)
					 : arena_printf(p->arena, "'%c'", open->token);
		parser_error(p, t->where, "missing %s for %s", closing(open->token), what);
		diag_note(p->diag, named ? open->word : open->where, "%s is opened here", what);
		return;
	}
	const bool named = open && open->keyword != K_NONE;
	const char *in = named ? arena_printf(p->arena, " in %s", keyword_name(open->keyword)) : "";
	if (run->word_before != K_NONE)
		in = arena_printf(p->arena, " behind %s%s", keyword_name(run->word_before), in);
	if (expected)
		parser_error(p, t->where, "unexpected %s%s: expected %s", found, in, expected);
	else
		parser_error(p, t->where, "unexpected %s%s", found, in);
	if (open && is_closing(t->token) && closing(open->token)[0] != t->token)
		diag_note(p->diag, open->where, "the %c is still open", open->token);
	hint(p, run, t);
}

void grammar_error(const span *, struct parser *, struct run *, const char *);
void grammar_error(const span *where, struct parser *p, struct run *run, const char *message)
{
	(void)run;
	if (!p->failed) /* "memory exhausted": nesting too deep */
		parser_error(p, *where, "too deeply nested here (%s)", message);
}
