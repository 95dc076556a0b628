/* SPDX-License-Identifier: MIT */
/*
 * What would be right, where the likely cause of an error is a habit from another
 * language or one of the usual slips: notes behind the message.
 */
#include "build.h"
#include "expand.h"

#include "grammar.tab.h"

#include <string.h>

bool note_operator(struct parser *p, int token, span where)
{
	if (token == T_LE || token == T_GE || token == T_NE || token == '<' || token == '>' ||
		token == '=' || token == '&' || token == '|' || token == '?')
		parser_note(p, where, "a comparison needs parentheses here: (a > b)");
	else if (token == '%')
		parser_note(p, where, "there is no operator %%: write mod(a, b)");
	else
		return false;
	return true;
}

bool is_object_modifier(enum keyword word)
{
	switch (word) {
	case K_BOUNDED_BY:
	case K_CLIPPED_BY:
	case K_FINISH:
	case K_HOLLOW:
	case K_INTERIOR:
	case K_INTERIOR_TEXTURE:
	case K_INVERSE:
	case K_MATERIAL:
	case K_MATRIX:
	case K_NO_IMAGE:
	case K_NO_REFLECTION:
	case K_NO_SHADOW:
	case K_NORMAL:
	case K_PHOTONS:
	case K_PIGMENT:
	case K_ROTATE:
	case K_SCALE:
	case K_TEXTURE:
	case K_TRANSFORM:
	case K_TRANSLATE:
	case K_UV_MAPPING:
		return true;
	default:
		return false;
	}
}

bool is_axis(enum keyword word)
{
	return word == K_X || word == K_Y || word == K_Z || word == K_T || word == K_U ||
	       word == K_V;
}

bool is_colour_word(enum keyword word)
{
	return word == K_COLOR || (word >= K_RGB && word <= K_RGBT) ||
	       (word >= K_SRGB && word <= K_SRGBT);
}

/* The statement in whose braces a word belongs; K_NONE: it has several, or stands anywhere. */
static enum keyword home_of(enum keyword word)
{
	switch (word) {
	case K_AMBIENT:
	case K_BRILLIANCE:
	case K_CONSERVE_ENERGY:
	case K_CRAND:
	case K_DIFFUSE:
	case K_IRID:
	case K_METALLIC:
	case K_PHONG:
	case K_PHONG_SIZE:
	case K_REFLECTION:
	case K_ROUGHNESS:
	case K_SPECULAR:
		return K_FINISH;
	case K_DISPERSION:
	case K_IOR:
		return K_INTERIOR;
	case K_COLOR_MAP:
	case K_IMAGE_MAP:
	case K_PIGMENT_MAP:
		return K_PIGMENT;
	case K_BUMP_MAP:
	case K_BUMP_SIZE:
	case K_FACETS:
	case K_NORMAL_MAP:
		return K_NORMAL;
	case K_LOCATION:
	case K_LOOK_AT:
	case K_SKY:
		return K_CAMERA;
	case K_AMBIENT_LIGHT:
	case K_ASSUMED_GAMMA:
	case K_CHARSET:
	case K_MAX_TRACE_LEVEL:
		return K_GLOBAL_SETTINGS;
	case K_AREA_LIGHT:
	case K_POINT_AT:
	case K_SHADOWLESS:
	case K_SPOTLIGHT:
		return K_LIGHT_SOURCE;
	default:
		return is_colour_word(word) ? K_PIGMENT : K_NONE;
	}
}

/* Whether a colour may stand in the braces of a statement. */
static bool takes_colour(enum keyword statement)
{
	return statement == K_LIGHT_SOURCE || statement == K_FOG || statement == K_BACKGROUND ||
	       statement == K_FINISH;
}

static bool note_home(struct parser *p, const struct queued *t, const struct opening *open)
{
	const enum keyword home = home_of(t->value.keyword);
	if (home == K_NONE ||
		(open && is_colour_word(t->value.keyword) && takes_colour(open->keyword)) ||
		(open && open->token != '{') || (open && open->keyword == home))
		return false;
	parser_note(p, t->where, "%s belongs in %s { }", keyword_name(t->value.keyword),
		keyword_name(home));
	return true;
}

/* The token `steps` behind the one at a place; NULL: the text ends before. */
static const struct raw_token *raw_behind(struct parser *p, span where, unsigned steps)
{
	const struct frame *f = top_frame(p->expand);
	const struct raw_token *raw = raw_before(p, where, 0);
	return raw && steps < f->tokens + f->end - raw ? raw + steps : NULL;
}

/* The word of an item, and not one of an expression, behind a comma; K_NONE: none is there. */
static enum keyword item_behind(struct parser *p, span where)
{
	const struct raw_token *raw = raw_behind(p, where, 1), *next = raw_behind(p, where, 2);
	const enum keyword word =
		raw && raw->kind == RAW_KEYWORD ? (enum keyword)raw->payload : K_NONE;
	double value;
	return constant_value(p, word, &value) || is_axis(word) || (next && next->kind == '(')
		       ? K_NONE
		       : word;
}

/* `rgb 0.1, 0.2`: the components of a vector without its brackets. */
static bool note_vector(struct parser *p, const struct queued *t, const struct opening *open)
{
	const struct raw_token *word = raw_before(p, t->where, 2);
	const struct raw_token *next = raw_behind(p, t->where, 1);
	const enum keyword item = item_behind(p, t->where);
	const bool in_parentheses = open && open->token == '(' &&
				    (open->keyword == K_NONE || is_colour_word(open->keyword));
	if (in_parentheses)
		parser_note(p, t->where, "a vector is written in angle brackets: <a, b, c>");
	else if (open && open->token == '{' && item != K_NONE)
		parser_note(p, t->where, "a comma separates values only: none stands before %s",
			keyword_name(item));
	else if (next && next->kind == '}')
		parser_note(p, t->where, "a comma separates values only: none stands before '}'");
	else if (word && word->kind == RAW_KEYWORD)
		parser_note(p, t->where, "several numbers are written as one vector: %s <a, b, c>",
			keyword_name((enum keyword)word->payload));
	else
		return false;
	return true;
}

void note_element(struct parser *p, span where, const char *array)
{
	parser_note(p, where, "an element of an array is written %s[0]", array);
}

bool note_bracket(struct parser *p, int token, span where)
{
	const struct raw_token *raw = raw_before(p, where, 1);
	if (!raw || raw->kind != RAW_NAME || (token != '(' && token != '['))
		return false;
	const struct name *name = &p->expand->names.list[raw->payload];
	if (!name->binding)
		return false;
	const bool is_array = name->binding->slot->kind == VALUE_ARRAY;
	if (token == '[' && !is_array)
		parser_note(p, where, "'%s' is %s: only an array has elements", name->text,
			token_words(value_terminal(name->binding->slot)));
	else if (is_array)
		note_element(p, where, name->text);
	else
		parser_note(p, where, "'%s' is neither a macro nor a function", name->text);
	note_declared(p, raw->payload);
	return true;
}

/* How a function is called whose arguments differ in kind; NULL: it is not one of those. */
static const char *call_form(enum keyword word)
{
	switch (word) {
	case K_STR:
		return "str(number, length, digits)";
	case K_STRCMP:
		return "strcmp(s, t)";
	case K_SUBSTR:
		return "substr(s, position, length)";
	case K_VSTR:
		return "vstr(count, vector, separator, length, digits)";
	default:
		return NULL;
	}
}

/* Too few or too many arguments. */
static bool note_call_form(struct parser *p, const struct queued *t, const struct opening *open)
{
	const char *form = open && open->token == '(' ? call_form(open->keyword) : NULL;
	if (!form || (t->token != ')' && t->token != ','))
		return false;
	parser_note(p, t->where, "it is called so: %s", form);
	return true;
}

/* `90x` and `90 x`. */
static bool note_axis(struct parser *p, const struct queued *t)
{
	const struct raw_token *raw = raw_before(p, t->where, 1);
	if (!is_axis(t->value.keyword) || !raw ||
		(raw->kind != RAW_INTEGER && raw->kind != RAW_NUMBER))
		return false;
	const span number = raw_span_at(p, raw);
	parser_note(p, t->where, "a product has its sign: %.*s*%s", (int)number.length,
		source_at(p->expand, number)->bytes + number.offset,
		keyword_name(t->value.keyword));
	return true;
}

/* An item or the end of a block behind a comma. */
static bool note_comma(struct parser *p, const struct run *run, const struct opening *open)
{
	const struct queued *t = run->last;
	if (run->token_before != ',' || !open || open->token != '{' ||
		(t->token != '}' && t->value.keyword == K_NONE) || is_directive(t->value.keyword))
		return false;
	parser_note(p, run->where_before, "a comma separates values only: none stands before %s",
		t->token == '}' ? "'}'" : keyword_name(t->value.keyword));
	return true;
}

/* A token that cannot follow an operand. */
static bool note_behind_operand(struct parser *p, const struct run *run, const struct queued *t)
{
	if (t->token != '=' || run->start_token != T_START_SCENE || run->depth)
		return t->token != '<' && note_operator(p, t->token, t->where);
	parser_note(p, run->where_before,
		"a name is given a value by #declare or #local: #declare A = 1;");
	return true;
}

static bool is_string(struct parser *p, const struct raw_token *raw)
{
	const struct symbol *symbol =
		raw && raw->kind == RAW_NAME ? p->expand->names.list[raw->payload].binding : NULL;
	return (raw && raw->kind == RAW_STRING) || (symbol && symbol->slot->kind == VALUE_STRING);
}

/* Whether a string stands before or behind a '+'. A declaration is complete before it. */
static bool joins_strings(struct parser *p, const struct queued *t, int before)
{
	const struct raw_token *last = raw_before(p, t->where, 1);
	const struct raw_token *next = raw_behind(p, t->where, 1);
	return before == T_STRING || is_string(p, last) || is_string(p, next);
}

static bool is_operator(int token)
{
	return token > ' ' && token < 127 && strchr("+-*/<>=&|?:!,(", token);
}

bool note_hint(struct parser *p, const struct run *run, const struct opening *open)
{
	const struct queued *t = run->last;
	const int token = t->token, before = run->token_before;
	const enum keyword word = t->value.keyword;
	if (token == before && (token == '=' || token == '&' || token == '|'))
		parser_note(p, t->where, "the operator is '%c', not '%c%c'", token, token, token);
	else if (token == ')' && before == T_STRING)
		parser_note(p, t->where, "a string can only be compared here: (S = \"x\")");
	else if (token == '+' && joins_strings(p, t, before))
		parser_note(p, t->where, "strings are joined by concat(S, T)");
	else if (token == '\'' || (token == '<' && run->start_token == T_START_STRING && !before))
		parser_note(p, t->where, "a string stands in double quotes");
	else if (token == '^')
		parser_note(p, t->where, "a power is written pow(a, b)");
	else if (token == ';' && run->start_token == T_START_SCENE)
		parser_note(p, t->where, "a ';' ends directives only, such as #declare");
	else if (is_directive(word))
		parser_note(p, t->where, "a directive begins with '#': #%s", keyword_name(word));
	else if (is_colour_word(word) && is_operator(before))
		parser_note(p, t->where,
			"a colour in an expression must be declared: #declare C = rgb 1;");
	else if (open && open->token == '(' && open->keyword == K_FUNCTION && word != K_NONE)
		parser_note(p, t->where, "'%s' is a reserved word and cannot name a parameter",
			keyword_name(word));
	else if (token != '}' && ends_operand(before) && note_row(p, t->where))
		return true;
	else if (note_call_form(p, t, open) || note_axis(p, t) || note_comma(p, run, open))
		return true;
	else if (token == '}' && open && keyword_is_object(open->keyword))
		note_sign(p, span_join(open->where, t->where));
	else if (token == ',')
		return note_vector(p, t, open);
	else if (note_home(p, t, open))
		return true;
	else if (token == T_ARRAY)
		note_element(p, t->where, token_name(&t->value));
	else if (token == '(' || token == '[')
		return note_bracket(p, token, t->where);
	else
		return ends_operand(before) && note_behind_operand(p, run, t);
	return true;
}
