/* SPDX-License-Identifier: MIT */
/*
 * The stream of typed tokens. A stack of frames (files, macro bodies) yields raw
 * tokens; directives are executed and macros called on the way; what is left is
 * handed to the grammar with its value.
 *
 * What must not happen too early is held back by the gate, see expand.h.
 */
#include "expand.h"

#include "grammar.tab.h"

#include <math.h>
#include <string.h>
#include <time.h>

/* -- Frames ------------------------------------------------------------------------------- */

bool expand_push_file(struct parser *p, struct source *source, span call)
{
	struct expand *x = p->expand;
	if (x->file_count == MAX_FILES) {
		parser_error(p, call, "include files are nested too deeply (%d are the limit)",
			MAX_FILES);
		return false;
	}
	const bool is_main = x->frame_count == 0;
	if (!is_main && !symbols_push(&x->symbols)) {
		parser_error(p, call,
			"macros and include files are nested too deeply (%d are the limit)",
			SYMBOL_TABLES);
		return false;
	}
	x->frames[x->frame_count++] = (struct frame){
		.source = source,
		.tokens = source->tokens,
		.end = source->count,
		.site = is_main ? 0 : diag_add_site(p->diag, call, "included from here"),
		.blocks = x->block_count,
		.call = call,
	};
	x->file_count++;
	return true;
}

/* Whether a loop would be left open in a file that ends. */
static bool loop_crosses_end(struct parser *p, const struct frame *f)
{
	struct expand *x = p->expand;
	for (unsigned i = f->blocks; i < x->block_count; i++) {
		const struct block *b = &x->blocks[i];
		if (b->kind != BLOCK_WHILE && b->kind != BLOCK_FOR)
			continue;
		parser_error(p, b->opened, "#%s must end in the file it begins in",
			keyword_name(b->opener));
		return true;
	}
	return false;
}

bool expand_leave_frame(struct parser *p)
{
	struct expand *x = p->expand;
	struct frame *f = top_frame(x);
	if (x->frame_count == 1)
		return false;
	if (f->is_macro) {
		x->block_count = f->blocks;
	} else {
		if (loop_crosses_end(p, f))
			return false;
		x->file_count--;
	}
	symbols_pop(&x->symbols);
	x->frame_count--;
	return true;
}

/* -- Pieces ------------------------------------------------------------------------------- */

/* The tokens of a source may have moved. */
static void follow_tokens(struct expand *x, const struct source *s)
{
	for (unsigned i = 0; i < x->frame_count; i++)
		if (x->frames[i].source == s)
			x->frames[i].tokens = s->tokens;
}

bool next_piece(struct expand *x)
{
	struct frame *f = top_frame(x);
	if (f->is_macro || !source_continue(f->source, true, false))
		return false;
	follow_tokens(x, f->source);
	f->position = f->source->piece;
	f->end = f->source->count;
	f->failed_from = f->failed_to = 0; /* of tokens that are gone */
	if (x->statement.frames == x->frame_count) {
		x->statement.position = f->position;
		x->statement.skippable &= !f->source->piece_splits;
	}
	return true;
}

void complete_text(struct expand *x)
{
	struct frame *f = top_frame(x);
	if (f->is_macro || !source_continue(f->source, false, true))
		return;
	follow_tokens(x, f->source);
	f->end = f->source->count;
}

/* -- Typed tokens ------------------------------------------------------------------------- */

static double days_since_2000(void)
{
	struct timespec now;
	clock_gettime(CLOCK_REALTIME, &now);
	return ((double)now.tv_sec + (double)(now.tv_nsec / 1000) * 1e-6) / 86400 - 10957;
}

static int number_token(struct token_value *v, double value)
{
	v->number.terms = 1;
	v->number.v[0] = value;
	return T_NUMBER;
}

bool constant_value(struct parser *p, enum keyword keyword, double *value)
{
	switch (keyword) {
	case K_CLOCK:
		*value = p->options->clock;
		return true;
	case K_CLOCK_ON:
		*value = p->options->clock_on;
		return true;
	case K_VERSION:
		*value = p->state->version / 100.0;
		return true;
	case K_PI:
		*value = M_PI;
		return true;
	case K_TRUE:
	case K_YES:
	case K_ON:
		*value = 1;
		return true;
	case K_FALSE:
	case K_NO:
	case K_OFF:
		*value = 0;
		return true;
	case K_NOW:
		*value = days_since_2000();
		return true;
	default:
		return false;
	}
}

static int keyword_value(struct parser *p, enum keyword keyword, struct token_value *v)
{
	double value;
	bool defined;
	v->keyword = keyword;
	if (keyword == K_DEFINED)
		return identifier_defined(p, &defined) ? number_token(v, defined) : 0;
	if (keyword == K_TEXTURE && p->state->version < 300)
		return T_FLAT_TEXTURE;
	return constant_value(p, keyword, &value) ? number_token(v, value) : keyword_token[keyword];
}

/* Whether a name is that of a macro at the moment. */
static bool is_macro(const struct expand *x, uint32_t name)
{
	const struct name *n = &x->names.list[name];
	return !n->hidden && n->binding && n->binding->slot->kind == VALUE_MACRO;
}

/* A name; -1: it was a macro, go on. `name` is at the present position. */
static int name_fetch(struct parser *p, uint32_t name, struct token_value *v, span *where)
{
	struct expand *x = p->expand;
	const struct name *n = &x->names.list[name];
	v->name = n->text;
	struct symbol *symbol = n->hidden ? NULL : n->binding;
	if (symbol && symbol->slot->kind == VALUE_MACRO) {
		if (gate_holds(x->gate)) {
			v->symbol = symbol;
			return T_MACRO; /* not taken: it is there again when the gate is live */
		}
		raw_step(p);
		return macro_call(p, symbol, *where) ? -1 : 0;
	}
	raw_step(p);
	if (!symbol)
		return T_UNDECLARED;
	return identifier_token(p, name, where, v);
}

/* In a held position: the rest of an #if whose branch ends may be passed over all the same, which
 * lets a macro give back a value from within an #if. */
static bool passes_gate(const struct expand *x, const struct directive *d)
{
	if (d->keyword != K_ELSE && d->keyword != K_ELSEIF && d->keyword != K_END)
		return false;
	const enum block_kind kind =
		x->block_count ? x->blocks[x->block_count - 1].kind : BLOCK_MACRO;
	return kind == BLOCK_IF || (kind == BLOCK_ELSE && d->keyword == K_END);
}

/* The end of the present text was reached: 0 at the end of the scene. */
static int at_end(struct parser *p, span *where)
{
	*where = raw_end_span(top_frame(p->expand));
	if (expand_leave_frame(p))
		return -1;
	if (!p->failed && p->expand->frame_count == 1)
		block_report_open(p);
	return 0;
}

/* Before version 1.5 there are sums in parentheses only: a sign begins the next number, as in
 * <0 0 -1>. */
static bool separates_numbers(const struct parser *p, int sign)
{
	const struct gate *g = p->expand->gate;
	return (sign == '-' || sign == '+') && p->state->version < 150 && g->operand &&
	       !g->parentheses;
}

static int fetch_raw(struct parser *p, struct token_value *v, span *where)
{
	struct expand *x = p->expand;
	struct frame *f = top_frame(x);
	if (f->position == f->end && !next_piece(x))
		return at_end(p, where);
	const struct raw_token raw = f->tokens[f->position];
	if (raw.kind == RAW_DIRECTIVE) {
		if (!gate_holds(x->gate) || passes_gate(x, &f->source->directives[raw.payload]))
			return directive_run(p) ? -1 : 0;
		*where = raw_span_of(x, f, raw);
		return T_HASH; /* not taken either */
	}
	*where = raw_span_of(x, f, raw);
	switch (raw.kind) {
	case RAW_INTEGER:
		raw_step(p);
		return number_token(v, raw.payload);
	case RAW_NUMBER:
		raw_step(p);
		return number_token(v, f->source->numbers[raw.payload]);
	case RAW_NUMBER_TEXT: {
		size_t length;
		raw_step(p);
		return number_token(v, number_at(f->source->bytes + raw.offset, &length));
	}
	case RAW_STRING: {
		const char *text = f->source->bytes + raw.offset + 1;
		raw_step(p);
		v->raw = string_literal(p, text, raw.payload, *where, false);
		v->string = memchr(text, '\\', raw.payload)
				    ? string_literal(p, text, raw.payload, *where, true)
				    : v->raw;
		return v->string ? T_STRING : 0;
	}
	case RAW_KEYWORD:
		raw_step(p);
		return keyword_value(p, (enum keyword)raw.payload, v);
	case RAW_NAME:
		return name_fetch(p, raw.payload, v, where);
	case RAW_LE:
		raw_step(p);
		return T_LE;
	case RAW_GE:
		raw_step(p);
		return T_GE;
	case RAW_NE:
		raw_step(p);
		return T_NE;
	case RAW_ERROR:
		raw_report_lexical(p, f);
		return 0;
	default:
		if (separates_numbers(p, (int)raw.kind))
			return ','; /* and then the sign */
		raw_step(p);
		return (int)raw.kind;
	}
}

/* Between two statements of the scene, and before each token of theirs that stands outside of
 * brackets. */
static void note_statement(struct expand *x)
{
	unsigned frames = x->frame_count;
	while (x->frames[frames - 1].is_macro)
		frames--;
	x->statement = (struct statement_start){
		.frames = frames,
		.began_in = x->frame_count,
		.position = x->frames[frames - 1].position,
		.blocks = frames < x->frame_count ? x->frames[frames].blocks : x->block_count,
		.skippable = true,
	};
}

/* Directives and macro calls read their own parts by the same way: `#if #if #if …` is a recursion
 * that must end. */
static int fetch(struct parser *p, struct token_value *v, span *where)
{
	struct expand *x = p->expand;
	if (x->nesting == MAX_NESTING) {
		parser_stop(p, raw_span(p), "directives and macro calls are nested too deeply");
		return 0;
	}
	if (x->gate == &x->scene_gate && !x->gate->depth)
		note_statement(x);
	x->nesting++;
	const int token = fetch_raw(p, v, where);
	x->nesting--;
	return token;
}

bool expand_settle(struct parser *p)
{
	struct expand *x = p->expand;
	struct token_value v = { .keyword = K_NONE };
	span where;
	for (bool any = false;; any = true) {
		const struct raw_token *raw =
			has_read_ahead(x) || gate_holds(x->gate) ? NULL : raw_peek(p);
		if (!raw || has_read_ahead(x) ||
			(raw->kind != RAW_DIRECTIVE &&
				(raw->kind != RAW_NAME || !is_macro(x, raw->payload))))
			return any;
		fetch(p, &v, &where);
	}
}

/* Words of directives that work without '#' between the statements of a scene. */
static bool is_bare_directive(const struct expand *x, enum keyword keyword)
{
	return (keyword == K_DECLARE || keyword == K_INCLUDE || keyword == K_DEFAULT) &&
	       x->gate == &x->scene_gate && x->gate->depth == 0;
}

/* Takes back the token handed back last, unless it belongs behind the text being read now. */
static bool take_unread(struct expand *x, int *token, struct token_value *v, span *where)
{
	if (!has_read_ahead(x))
		return false;
	const struct unread *u = &x->unread[--x->unread_count];
	*token = u->token;
	*v = u->value;
	*where = u->where;
	return true;
}

int expand_next(struct parser *p, struct token_value *v, span *where)
{
	struct expand *x = p->expand;
	int token = -1;
	while (token < 0 && !p->failed) {
		if (!take_unread(x, &token, v, where)) {
			*v = (struct token_value){ 0 };
			token = fetch(p, v, where);
		}
		if (token > 0 && v->keyword && is_bare_directive(x, v->keyword))
			token = directive_bare(p, v->keyword, *where) ? -1 : 0;
	}
	if (p->failed) {
		*v = (struct token_value){ 0 };
		*where = NO_SPAN;
		return 0;
	}
	if (symbols_are_old(&x->symbols, ++p->token_count))
		symbols_recycle(&x->symbols, p->token_count);
	x->before = *x->gate;
	gate_note(x->gate, token, v);
	return token;
}

const struct name *expand_name_at(struct parser *p, span where)
{
	struct names *names = &p->expand->names;
	const struct source *s = source_at(p->expand, where);
	const size_t length = s ? raw_word_length(s->bytes + where.offset) : 0;
	return length ? &names->list[names_intern(names, s->bytes + where.offset, length)] : NULL;
}

void expand_back(struct parser *p, span where)
{
	struct frame *f = top_frame(p->expand);
	while (f->position && f->tokens[f->position - 1].offset >= where.offset)
		f->position--;
}

void expand_unread(struct parser *p, int token, const struct token_value *v, span where)
{
	struct expand *x = p->expand;
	if (x->before.outer == x->gate->outer && x->before.delivered + 1 == x->gate->delivered)
		*x->gate = x->before;
	else if (x->gate->delivered)
		x->gate->delivered--;
	if (token == T_HASH || token == T_MACRO || token == 0)
		return; /* were not taken */
	if (x->unread_count == MAX_UNREAD) {
		parser_error(p, where, "too many tokens read ahead");
		return;
	}
	x->unread[x->unread_count++] = (struct unread){
		.token = token, .where = where, .frame = x->frame_count, .value = *v
	};
}

/* -- Small readers for the directives ----------------------------------------------------- */

const char *token_describe(struct parser *p, int token, const struct token_value *v)
{
	if (token == 0)
		return "the end of the text";
	if (token == T_HASH)
		return "a directive";
	if (v->name)
		return arena_printf(p->arena, "'%s'", v->name);
	if (v->keyword)
		return arena_printf(p->arena, "'%s'", keyword_name(v->keyword));
	if (token == T_STRING)
		return "a string";
	if (token == T_NUMBER)
		return arena_printf(p->arena, "the number %g", v->number.v[0]);
	if (token == T_LE || token == T_GE || token == T_NE)
		return "a comparison";
	return arena_printf(p->arena, "'%c'", token);
}

/* Looks for a punctuation mark in the raw tokens, which spares typing and handing back whatever else
 * is there. */
enum looked { LOOKED_NO, LOOKED_YES, LOOKED_UNSURE };
static enum looked look(struct parser *p, int token)
{
	static const struct token_value none = { .keyword = K_NONE };
	struct expand *x = p->expand;
	if (has_read_ahead(x) || !raw_peek(p) || has_read_ahead(x))
		return LOOKED_UNSURE;
	struct frame *f = top_frame(x);
	const struct raw_token raw = f->tokens[f->position];
	switch (raw.kind) {
	case RAW_DIRECTIVE:
		return gate_holds(x->gate) && !passes_gate(x, &f->source->directives[raw.payload])
			       ? LOOKED_NO
			       : LOOKED_UNSURE;
	case RAW_NAME:
		return is_macro(x, raw.payload) && !gate_holds(x->gate) ? LOOKED_UNSURE : LOOKED_NO;
	case RAW_KEYWORD:
		return x->gate == &x->scene_gate ? LOOKED_UNSURE : LOOKED_NO;
	default:
		break;
	}
	if ((int)raw.kind != token)
		return LOOKED_NO;
	f->position++;
	x->work++;
	p->token_count++;
	x->before = *x->gate;
	gate_note(x->gate, token, &none);
	return LOOKED_YES;
}

bool is_declared(const void *context, const struct name *name)
{
	(void)context;
	return name->binding != NULL;
}

bool expect(struct parser *p, int token, const char *what)
{
	if (look(p, token) == LOOKED_YES)
		return true;
	struct token_value v;
	span where;
	const int found = expand_next(p, &v, &where);
	if (found == token && !p->failed)
		return true;
	if (found == T_UNDECLARED && token != '(')
		parser_error_undeclared(p, where, v.name, is_declared, NULL);
	if (token == ')' || token == '(' || token == ';')
		where = raw_gap_before(p, where);
	parser_error(p, where, "expected %s, found %s", what, token_describe(p, found, &v));
	return false;
}

bool accept(struct parser *p, int token)
{
	const enum looked looked = look(p, token);
	if (looked != LOOKED_UNSURE)
		return looked == LOOKED_YES;
	struct token_value v;
	span where;
	const int found = expand_next(p, &v, &where);
	if (found == token)
		return true;
	expand_unread(p, found, &v, where);
	return false;
}

/* -- Names hidden by the parameters of a function ------------------------------------------- */

struct hidden_names {
	struct hidden_names *outer;
	size_t count;
	uint32_t ids[];
};

void expand_push_names(struct parser *p, const char *const *names, size_t count)
{
	struct expand *x = p->expand;
	struct hidden_names *h = arena_alloc(p->arena, sizeof *h + count * sizeof h->ids[0]);
	*h = (struct hidden_names){ .outer = x->hidden, .count = count };
	for (size_t i = 0; i < count; i++) {
		h->ids[i] = names_intern(&x->names, names[i], strlen(names[i]));
		x->names.list[h->ids[i]].hidden++;
	}
	x->hidden = h;
}

void expand_pop_names(struct parser *p)
{
	struct hidden_names *h = p->expand->hidden;
	for (size_t i = 0; i < h->count; i++)
		p->expand->names.list[h->ids[i]].hidden--;
	p->expand->hidden = h->outer;
}

void symbol_assign(struct parser *p, struct symbol *symbol, const struct value *value)
{
	*symbol->slot = value_copy(p, value);
}

/* -- Beginning and end -------------------------------------------------------------------- */

struct expand *expand_create(struct parser *p)
{
	struct expand *x = ARENA_NEW(p->arena, struct expand);
	names_init(&x->names, p->arena);
	symbols_init(&x->symbols, &x->names, p->arena);
	x->gate = &x->scene_gate;
	return x;
}

void expand_destroy(struct expand *x)
{
	for (struct source *s = x->sources; s; s = s->previous)
		source_finish(s);
	names_finish(&x->names);
}
