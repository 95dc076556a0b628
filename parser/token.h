/* SPDX-License-Identifier: MIT */
/*
 * The border between the directive layer (expand.c and its helpers) and the
 * grammar (grammar.y). Upwards flow typed tokens that carry their value;
 * downwards the directive layer asks for nested parses.
 *
 * The terminals are declared in grammar.y: KW_<WORD> for each line of
 * keywords.def, the punctuation as characters ('{', '<', …) plus T_LE ("<="),
 * T_GE (">="), T_NE ("!="), and for values:
 *
 *   T_NUMBER       float literal, float identifier, constant: number, symbol
 *   T_SUM          a whole sum, from quick_sum only: number
 *   T_VECTOR       vector identifier of 2, 3 or 4 terms: number, symbol
 *   T_COLOUR       colour identifier: number of 5 terms, symbol
 *   T_SHAPE        a whole primitive, from quick_item only: made, keyword
 *   T_MODIFIER     a whole modifier of an object, from quick_item only: made, keyword
 *   T_STRING       string literal: string with escapes done, raw: as written; identifier: string
 *   T_OBJECT T_TEXTURE T_PIGMENT T_NORMAL T_FINISH T_MATERIAL T_INTERIOR
 *   T_MEDIA T_DENSITY T_CAMERA T_FOG T_RAINBOW T_SKY_SPHERE T_TRANSFORM
 *   T_COLOUR_MAP T_PIGMENT_MAP T_NORMAL_MAP T_TEXTURE_MAP T_SLOPE_MAP
 *   T_DENSITY_MAP  identifier of such a value: node (what was declared), symbol
 *   T_FUNCTION     float function identifier: function
 *   T_VECTOR_FUNCTION  function with several components: function
 *   T_SPLINE       spline identifier: spline
 *   T_ARRAY        whole array: symbol
 *   T_MACRO        macro name in a held position
 *   T_FILE         file handle
 *   T_UNDECLARED   a word that names nothing: name
 *   T_HASH         '#' in a held position
 *   T_START_…      first token of a nested parse, see below
 *   0              end of the scene, or of a nested parse after an error
 */
#ifndef LAMBERT_PARSER_TOKEN_H
#define LAMBERT_PARSER_TOKEN_H

#include "parser/ast.h"
#include "names.h"
#include "parser/parser.h"
#include "value.h"

struct parser;
struct symbol;

/* A token's value; which members are set is said above. */
struct token_value {
	enum keyword keyword;
	struct number number;
	const char *string, *raw, *name;
	const struct node *node;
	struct node *made;
	const struct function *function;
	const struct spline *spline;
	struct symbol
		*symbol; /* NULL: not an identifier. For an array element: a symbol that stands
	                          for the element */
};

/* -- Offered by the directive layer to the grammar ---------------------------------------- */

/* The next token for the grammar: directives executed, macros expanded, identifiers resolved. */
int expand_next(struct parser *, struct token_value *, span *);
/* Hands a token back; the next expand_next returns it again. */
void expand_unread(struct parser *, int token, const struct token_value *, span);
/* The name that stands at a place of the text, NULL: something else does. Holds until the next text
 * is read. */
const struct name *expand_name_at(struct parser *, span where);
/* Goes back, in the text being read, to the token that begins at a place. */
void expand_back(struct parser *, span where);
/* Behind a '<': reads `1, -2, 3 >` if nothing but numbers, signs and commas stands there, and says
 * where the '>' is. Only a short cut. */
bool expand_plain_vector(struct parser *, struct number *, span *last);
/* Reads `<1, -2, 3>` and a comma behind it if just that stands there, with as many terms as said.
 * Between the vectors of a list only. */
bool expand_plain_row(struct parser *, unsigned terms, double *);
/* Registers / finds / assigns identifiers for actions that need it (trace's fourth argument). */
void symbol_assign(struct parser *, struct symbol *, const struct value *);
/* What a symbol holds and is called. A declared-but-empty one holds VALUE_NONE. */
const struct value *symbol_value(const struct symbol *);
const char *symbol_name(const struct symbol *);
/* Function parameters hide identifiers while a function body is read. */
void expand_push_names(struct parser *, const char *const *names, size_t count);
void expand_pop_names(struct parser *);

/* After an error in the scene: on to the next statement, if that can be found. */
bool expand_recover(struct parser *);

/* -- Offered by the grammar to the directive layer: nested parses ------------------------- */
/* Each begins at the next token, stops behind the construct and hands the lookahead back. False:
 * an error was reported. The `hold` rules of the gate are the directive layer's. */

bool parse_float(struct parser *, double *);	 /* sum level, must be a float */
bool parse_condition(struct parser *, double *); /* full expression, must be a float */
bool parse_string(struct parser *, const char **, bool file_name); /* string expression */
bool parse_declared(struct parser *, struct value *); /* right side of #declare, macro argument */
bool parse_number_any(struct parser *, struct number *); /* sum level, any number of terms */
bool parse_defaults(struct parser *); /* { … } of #default: updates the state */
/* The whole scene, to the end of the text: its statements in source order. */
bool parse_statements(struct parser *, const struct node **statements);

/* The terminal KW_<WORD> of a keyword. */
extern const int keyword_token[KEYWORD_COUNT];

#endif
