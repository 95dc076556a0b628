/* SPDX-License-Identifier: MIT */
/*
 * Says in plain words what is wrong where the grammar cannot go on: what was
 * found, in which statement, what would be right, and, for the usual slips, how
 * to write it.
 */
#include "build.h"
#include "expand.h"

#include "grammar.tab.h"

#include <string.h>

/* -- Words -------------------------------------------------------------------------------- */

static const char *closing(int token)
{
	return token == '{' ? "}" : token == '(' ? ")" : "]";
}

static bool is_opening(int token)
{
	return token == '{' || token == '(' || token == '[';
}

static bool is_closing(int token)
{
	return token == '}' || token == ')' || token == ']';
}

bool ends_operand(int token)
{
	return token == T_SUM || token == T_NUMBER || token == T_VECTOR || token == T_COLOUR ||
	       token == T_STRING || token == ')' || token == '>';
}

/* Without the article. */
static const char *bare_words(int token)
{
	const char *words = token_words(token);
	return strncmp(words, "a ", 2) == 0    ? words + 2
	       : strncmp(words, "an ", 3) == 0 ? words + 3
					       : words;
}

static const char *found_words(struct parser *p, const struct run *run, const struct queued *t)
{
	switch (t->token) {
	case 0:
		return "the end of the text";
	case T_NUMBER:
		return token_name(&t->value) && t->value.symbol
			       ? arena_printf(p->arena, "float '%s'", token_name(&t->value))
			       : "number";
	case T_HASH:
		return "directive";
	case '<':
		return ends_operand(run->token_before) ? "'<'" : "vector";
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

/* The same in the middle of a sentence. */
static const char *found_phrase(struct parser *p, const struct run *run, const struct queued *t)
{
	const char *words = found_words(p, run, t);
	if (t->token == 0 || *words == '\'')
		return words;
	return arena_printf(p->arena, "%s %s", strchr("aeiou", *words) ? "an" : "a", words);
}

/* -- Names -------------------------------------------------------------------------------- */

/* Whether the grammar could go on with what a name stands for. An element of an array may be
 * anything, and so may what a macro leaves. */
static bool name_fits(const void *context, const struct name *name)
{
	const struct wanted *wanted = context;
	if (name->keyword != K_NONE)
		return wanted_token(wanted, keyword_token[name->keyword]);
	if (name->hidden || !name->binding)
		return false;
	const int token = value_terminal(name->binding->slot);
	return token == T_MACRO || token == T_ARRAY || wanted_token(wanted, token);
}

/* Behind a complete item the grammar has already settled for its end when it meets an error, and
 * would go on with the closing brace only: there any word of a statement may have been meant. */
static bool name_fits_in_block(const void *context, const struct name *name)
{
	(void)context;
	return name->keyword != K_NONE ? !is_directive(name->keyword) : name->binding != NULL;
}

static void report_name(
	struct parser *p, const struct run *run, const struct opening *open, const struct wanted *w)
{
	const struct queued *t = run->last;
	const struct raw_token *next = raw_peek(p);
	const bool assigned =
		!open && run->start_token == T_START_SCENE && next && next->kind == '=';
	const bool behind_item =
		wanted_token(w, '}') || (ends_operand(run->token_before) && !wanted_token(w, '>'));
	const bool in_block = open && open->token == '{' && behind_item &&
			      !names_nearest(&p->expand->names, t->value.name, name_fits, w);
	if (run->token_before == '.')
		parser_error(p, t->where,
			"'%s' is no component: there are x y z t, u v and red green blue filter "
			"transmit gray",
			t->value.name);
	else
		parser_error_undeclared(
			p, t->where, t->value.name, in_block ? name_fits_in_block : name_fits, w);
	if (!run->token_before && run->start_token == T_START_STRING)
		parser_note(p, t->where, "a string stands in double quotes");
	else if (assigned)
		parser_note(p, t->where,
			"a name is given a value by #declare or #local: #declare %s = 1;",
			t->value.name);
}

/* -- Brackets ----------------------------------------------------------------------------- */

/* The bracket that the token stands in, or closes wrongly; NULL: none. */
static const struct opening *bracket_around(
	const struct parser *p, const struct run *run, const struct queued *t)
{
	const size_t depth = is_opening(t->token) ? run->depth - 1
			     : run->closed	  ? run->depth + 1
						  : run->depth;
	return depth ? &p->grammar->openings[run->base + depth - 1] : NULL;
}

static void report_open(struct parser *p, const struct opening *open, span where)
{
	const bool named = open->keyword != K_NONE;
	const char *what =
		named ? keyword_name(open->keyword) : arena_printf(p->arena, "'%c'", open->token);
	parser_error(p, where, "missing %s for %s", closing(open->token), what);
	parser_note(p, named ? open->word : open->where, "%s is opened here", what);
}

/* -- Kinds of values ---------------------------------------------------------------------- */

/* What a run is to read, by its start token. */
static const char *start_words(int start_token)
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
	case T_START_NUMBER:
		return "a number or a vector";
	default:
		return NULL;
	}
}

static bool takes_vectors(enum keyword word)
{
	return word == K_VLENGTH || word == K_VDOT || word == K_VCROSS || word == K_VNORMALIZE ||
	       word == K_VROTATE || word == K_VAXIS_ROTATE || word == K_VTURBULENCE ||
	       word == K_VSTR || word == K_TRACE || word == K_INSIDE;
}

static const char *number_words(enum keyword word, bool function)
{
	return function && !takes_vectors(word) ? "a number" : "a number or a vector";
}

/* The kind of value that must stand here, behind a word or, if so, in the brackets of a function.
 * NULL: another thing, or more than one. */
static const char *kind_wanted(const struct wanted *w, enum keyword word, bool function)
{
	/* Where a number may stand so may a string, but only to be compared. */
	if (!wanted_token(w, T_NUMBER))
		return wanted_token(w, T_STRING) ? "a string" : NULL;
	return number_words(word, function);
}

/* Where what was found has its name from. */
static void note_symbol(struct parser *p, const struct queued *t)
{
	const char *name = t->token == T_UNDECLARED ? NULL : token_name(&t->value);
	if (name && t->value.symbol)
		note_declared(p, names_intern(&p->expand->names, name, strlen(name)));
}

/* The word whose argument the token would be. */
static enum keyword argument_of(const struct run *run, const struct opening *open)
{
	if (run->word_before != K_NONE)
		return run->word_before;
	return open && open->token == '(' ? open->keyword : K_NONE;
}

/* A string where a number must stand, and the like. False: it is something else. */
static bool report_kind(
	struct parser *p, const struct run *run, const struct opening *open, const struct wanted *w)
{
	const struct queued *t = run->last;
	const int token = t->token;
	const enum keyword word = argument_of(run, open);
	if (word == K_NONE)
		return false;
	const bool function = word != run->word_before;
	const char *kind = kind_wanted(w, word, function);
	const bool empty = token == ')' && (run->token_before == '(' || run->token_before == ',');
	const bool sign =
		(token == '+' || token == '-' || token == '!') && !ends_operand(run->token_before);
	const bool closes = token == '}' && !function;
	if (!kind || (!empty && !sign && !closes && token != '(' && token != '<' && token < 127))
		return false;
	parser_error(p, t->where, "%s needs %s, found %s", keyword_name(word), kind,
		empty ? "nothing" : found_phrase(p, run, t));
	if (token == T_ARRAY)
		note_element(p, t->where, token_name(&t->value));
	note_symbol(p, t);
	return true;
}

/* A string that was read in the place of a number, since a comparison could have followed. */
static bool report_string(
	struct parser *p, const struct run *run, const struct opening *open, const struct wanted *w)
{
	const int token = run->last->token;
	const bool in_parentheses = open && open->token == '(';
	if (run->token_before != T_STRING || !wanted_token(w, T_LE) || wanted_token(w, '+') ||
		token == '+' || token == '.' || (in_parentheses && open->keyword == K_NONE))
		return false;
	const span where = run->where_before;
	const struct raw_token *raw = raw_before(p, where, 0), *before = raw_before(p, where, 1);
	const bool named = raw && raw->kind == RAW_NAME;
	const char *string = named ? arena_printf(p->arena, "string '%s'",
					     p->expand->names.list[raw->payload].text)
				   : "string";
	const enum keyword word = before && before->kind == RAW_KEYWORD
					  ? (enum keyword)before->payload
				  : in_parentheses ? open->keyword
						   : K_NONE;
	if (word == K_NONE && !open)
		return false;
	if (word != K_NONE)
		parser_error(p, where, "%s needs %s, found a %s", keyword_name(word),
			number_words(word, in_parentheses && word == open->keyword), string);
	else
		parser_error(p, where, "unexpected %s in %s", string, keyword_name(open->keyword));
	if (named)
		note_declared(p, raw->payload);
	return true;
}

/* The name of a function or a spline of the scene without its parentheses. */
static bool report_uncalled(struct parser *p, const struct run *run, const struct wanted *w)
{
	const int before = run->token_before;
	const struct raw_token *raw = raw_before(p, run->where_before, 0);
	if ((before != T_FUNCTION && before != T_VECTOR_FUNCTION && before != T_SPLINE) ||
		!wanted_token(w, '(') || !raw || raw->kind != RAW_NAME)
		return false;
	const char *name = p->expand->names.list[raw->payload].text;
	parser_error(p, run->where_before, "'%s' is %s: its value is written %s(...)", name,
		token_words(before), name);
	note_declared(p, raw->payload);
	return true;
}

/* The parentheses behind a function or a spline of the scene, with nothing in them. */
static bool report_empty_call(struct parser *p, const struct run *run, const struct wanted *w)
{
	const struct queued *t = run->last;
	const struct raw_token *name = raw_before(p, t->where, 2);
	if (t->token != ')' || run->token_before != '(' || !wanted_token(w, T_NUMBER) || !name ||
		name->kind != RAW_NAME)
		return false;
	parser_error(p, t->where, "%s needs an argument, found nothing",
		p->expand->names.list[name->payload].text);
	return true;
}

/* A list that must be long, but is so short that it was read as a vector. */
static bool report_short_list(
	struct parser *p, const struct run *run, const struct opening *open, const struct wanted *w)
{
	const struct queued *t = run->last;
	if (t->token != '<' || !wanted_token(w, '<') || !open || open->keyword == K_NONE)
		return false;
	parser_error(p, t->where, "%s needs a longer list of numbers", keyword_name(open->keyword));
	return true;
}

/* What only ordinary expressions have, in the body of a function. */
static bool report_in_function(struct parser *p, const struct run *run, const struct wanted *w)
{
	const struct queued *t = run->last;
	if (!p->grammar->scope || !wanted_token(w, T_UNDECLARED) ||
		(t->value.keyword == K_NONE && !t->value.symbol))
		return false;
	parser_error(p, t->where, "%s cannot be used in a function%s", found_words(p, run, t),
		t->value.symbol ? ": only floats can" : "");
	if (t->token == T_VECTOR || t->token == T_COLOUR)
		parser_note(p, t->where, "declare a float before: #declare X = %s.x;",
			token_name(&t->value));
	return true;
}

/* -- The wrong place ---------------------------------------------------------------------- */

/* Identifiers of statements, such as textures. */
static bool is_statement_identifier(int token)
{
	return token >= T_OBJECT && token <= T_DENSITY_MAP;
}

/* Without "identifier". */
static const char *kind_of_identifier(struct parser *p, int token)
{
	const char *words = token_words(token), *end = strstr(words, " identifier");
	return arena_printf(p->arena, "%.*s", end ? (int)(end - words) : (int)strlen(words), words);
}

/* What stands between the statements of a scene. */
static bool report_stray(struct parser *p, const struct run *run, const struct opening *open)
{
	const struct queued *t = run->last;
	if (open || run->start_token != T_START_SCENE)
		return false;
	const char *name = token_name(&t->value);
	if (t->token == '}')
		parser_error(p, t->where, "'}' without a '{' before it");
	else if (is_object_modifier(t->value.keyword))
		parser_error(p, t->where,
			"%s stands outside of an object: did the braces before it close too early?",
			keyword_name(t->value.keyword));
	else if (is_statement_identifier(t->token) && name)
		parser_error(p, t->where, "'%s' is %s: it cannot stand outside of a statement",
			name, kind_of_identifier(p, t->token));
	else
		return false;
	return true;
}

/* The identifier of a pigment in a normal, and the like. */
static bool report_identifier(struct parser *p, const struct run *run, const struct opening *open)
{
	const struct queued *t = run->last;
	const char *name = token_name(&t->value);
	if (!is_statement_identifier(t->token) || !name || !open || open->token != '{' ||
		open->keyword == K_NONE || run->word_before != K_NONE)
		return false;
	parser_error(p, t->where, "'%s' is %s, which %s does not take here", name,
		kind_of_identifier(p, t->token), keyword_name(open->keyword));
	note_symbol(p, t);
	return true;
}

/* Shows the block that the token stands in, which may lack its brace, unless one sees it anyway. */
static void note_block(struct parser *p, const struct opening *open, span where)
{
	if (open && open->token == '{' && open->keyword != K_NONE &&
		diag_place(p->diag, open->word).line != diag_place(p->diag, where).line)
		parser_note(p, open->word, "%s is opened here; is its '}' missing?",
			keyword_name(open->keyword));
}

/* What a statement is put together of; NULL: not of objects. */
static const char *members_of(enum keyword statement)
{
	return is_csg(statement) || statement == K_CLIPPED_BY || statement == K_BOUNDED_BY
		       ? "objects"
	       : statement == K_MESH ? "triangles"
	       : statement == K_BLOB ? "components"
				     : NULL;
}

/* The name of an object with which a statement begins, of which it is a copy then; NULL: another thing. */
static const struct raw_token *copied_name(struct parser *p, const struct opening *open)
{
	const struct raw_token *raw = raw_inside(p, open);
	const struct symbol *symbol =
		raw && raw->kind == RAW_NAME ? p->expand->names.list[raw->payload].binding : NULL;
	return symbol && value_terminal(symbol->slot) == T_OBJECT ? raw : NULL;
}

/* Whether a token begins what a statement is put together of. */
static bool is_member(enum keyword statement, const struct queued *t)
{
	const enum keyword word = t->value.keyword;
	if (statement == K_MESH)
		return word == K_TRIANGLE || word == K_SMOOTH_TRIANGLE;
	if (statement == K_BLOB)
		return word == K_SPHERE || word == K_CYLINDER;
	return t->token == T_OBJECT || keyword_is_object(word);
}

/* An object behind what changes the objects before it, or behind the only one. */
static bool report_late_object(struct parser *p, const struct run *run, const struct opening *open)
{
	const struct queued *t = run->last;
	if (!open || open->token != '{' || !is_member(open->keyword, t))
		return false;
	const char *members = members_of(open->keyword), *in = keyword_name(open->keyword);
	const char *found = found_words(p, run, t);
	const struct raw_token *copied = members ? copied_name(p, open) : NULL;
	if (copied) {
		const char *name = p->expand->names.list[copied->payload].text;
		parser_error(p, t->where, "unexpected %s in %s", found, in);
		parser_note(p, raw_span_at(p, copied),
			"a name alone makes a copy; among other objects write object { %s }", name);
	} else if (members) {
		parser_error(p, t->where,
			"unexpected %s in %s: its %s stand before the first texture or "
			"transformation",
			found, in, members);
	} else if (open->keyword == K_OBJECT && run->token_before != '{') {
		parser_error(p, t->where,
			"unexpected %s in object: it has a single object; a union has several",
			found);
	} else {
		return false;
	}
	note_block(p, open, t->where);
	return true;
}

/* -- The report --------------------------------------------------------------------------- */

/* The beginning of an open vector, on another line. */
static void note_vector_start(struct parser *p, span where)
{
	enum { FAR = 100 };
	for (unsigned steps = 1; steps < FAR; steps++) {
		const struct raw_token *raw = raw_before(p, where, steps);
		if (!raw || raw->kind == '>' || raw->kind == '}' || raw->kind == '{')
			return;
		if (raw->kind != '<')
			continue;
		const span start = raw_span_at(p, raw);
		if (diag_place(p->diag, start).line != diag_place(p->diag, where).line)
			parser_note(p, start, "the vector begins here");
		return;
	}
}

/* What could stand here instead; NULL: too many things. */
static const char *expected_words(
	const struct run *run, const struct opening *open, const struct wanted *w)
{
	if (wanted_token(w, '>') && !wanted_token(w, T_GE))
		return "a number or '>'";
	if (w->list)
		return w->list;
	const bool number = wanted_token(w, T_NUMBER), string = wanted_token(w, T_STRING);
	if (!run->token_before)
		return start_words(run->start_token);
	if (open && wanted_token(w, KW_SPHERE) && !wanted_token(w, '}') && !number)
		return "an object";
	if (number && !ends_operand(run->token_before))
		return string ? "a value" : "a number or a vector";
	return string ? "a string" : NULL;
}

/* The directive whose first token stands at a place; NULL: there is none. */
static const char *directive_before(struct parser *p, span where)
{
	const struct raw_token *raw = raw_before(p, where, 1);
	const struct source *s = source_at(p->expand, where);
	return raw && raw->kind == RAW_DIRECTIVE ? keyword_name(s->directives[raw->payload].keyword)
						 : NULL;
}

/* Where it stands: behind which word or operator, in which statement. */
static const char *context_words(
	struct parser *p, const struct run *run, const struct opening *open)
{
	const char *in = "";
	const int before = run->token_before;
	const char *directive = before ? NULL : directive_before(p, run->last->where);
	if (directive)
		return arena_printf(p->arena, " behind #%s", directive);
	const bool behind_operator = before > ' ' && before < 127 && strchr("+-*/=<>&|?:", before);
	if (open && open->keyword != K_NONE)
		in = arena_printf(p->arena, " in %s", keyword_name(open->keyword));
	if (run->word_before != K_NONE)
		in = arena_printf(p->arena, " behind %s%s", keyword_name(run->word_before), in);
	else if (behind_operator && before != run->last->token)
		in = arena_printf(p->arena, " behind '%c'%s", before, in);
	return in;
}

static void report_unexpected(
	struct parser *p, const struct run *run, const struct opening *open, const struct wanted *w)
{
	const struct queued *t = run->last;
	const char *expected = expected_words(run, open, w);
	const char *found = t->token == 0 ? "end of the text" : found_words(p, run, t);
	const bool in_vector = wanted_token(w, '>') && !wanted_token(w, T_GE);
	const span where = run->token_before || run->start_token == T_START_SCENE
				   ? t->where
				   : raw_gap_before(p, t->where);
	if (t->token == '}' && run->token_before == '{' && open && open->keyword != K_NONE)
		parser_error(p, t->where, "%s is empty%s%s", keyword_name(open->keyword),
			expected ? ": expected " : "", expected ? expected : "");
	else
		parser_error(p, where, "unexpected %s%s%s%s", found, context_words(p, run, open),
			expected ? ": expected " : "", expected ? expected : "");
	note_symbol(p, t);
	if (in_vector && ends_operand(run->token_before))
		note_operator(p, t->token, t->where);
	if (in_vector)
		note_vector_start(p, t->where);
	else if (open && is_closing(t->token) && closing(open->token)[0] != t->token)
		parser_note(p, open->where, "the %c is still open", open->token);
	else if (!note_hint(p, run, open) && (t->value.keyword != K_NONE || t->token == '{'))
		note_block(p, open, t->where);
}

void syntax_error(struct parser *p, struct run *run, const struct wanted *w)
{
	if (p->failed || !run->last)
		return;
	const struct queued *t = run_unfold(p, run);
	const struct opening *open = bracket_around(p, run, t);
	if (p->failed)
		return;
	if (t->token == T_UNDECLARED)
		report_name(p, run, open, w);
	else if (t->token == 0 && open)
		report_open(p, open, t->where);
	else if (!report_in_function(p, run, w) && !report_string(p, run, open, w) &&
		 !report_uncalled(p, run, w) && !report_kind(p, run, open, w) &&
		 !report_empty_call(p, run, w) && !report_short_list(p, run, open, w) &&
		 !report_stray(p, run, open) && !report_late_object(p, run, open) &&
		 !report_identifier(p, run, open))
		report_unexpected(p, run, open, w);
	/* What it would have opened cannot be told from what follows. */
	if (!open && directive_opens(t->value.keyword))
		p->stopped = true;
}

void grammar_error(const span *, struct parser *, struct run *, const char *);
void grammar_error(const span *where, struct parser *p, struct run *run, const char *message)
{
	(void)run;
	(void)message; /* "memory exhausted", always: of the grammar's stack */
	if (!p->failed)
		parser_error(p, *where, "too deeply nested");
}
