/* SPDX-License-Identifier: MIT */
/*
 * The grammar of the scene language, above the directive layer: what arrives
 * here is a flat stream of typed tokens that carry their values (token.h). The
 * shapes of the nodes are in docs/ast.md.
 *
 * One grammar, several entry points: the first token of a run, T_START_…, says
 * what is to be read. Runs other than T_START_SCENE accept at the first token
 * that cannot continue their construct, and hand it back (ACCEPT).
 *
 * Expressions have two levels. At sum level, where nearly all numbers stand,
 * `<` opens a vector and never means "less than"; relations and everything
 * weaker are read in parentheses and the few places that want a full
 * expression. Values are computed as they are reduced; only function bodies
 * become trees.
 *
 * Nearly all commas are optional, so an expression ends where the next token
 * cannot continue it: `1 -2` is one number, not two. The rules that end an
 * expression carry %prec ENDS, weaker than every operator, which resolves
 * exactly these choices in favour of going on.
 */
%require "3.8"
%define api.pure full
%define api.prefix {grammar_}
%define api.location.type {span}
%define parse.error custom
%locations
%expect 0
%param { struct parser *p } { struct run *run }

%code requires {
#include "build.h"
}

%union {
	enum keyword keyword;
	int token;
	struct number number;
	struct number_value named;
	struct text_value text;
	struct texts *texts;
	struct reference ref;
	const struct function *function;
	struct callee callee;
	const struct spline *spline;
	struct symbol *symbol;
	const char *name;
	struct node *node;
	struct node_list list;
	struct body body;
	struct colour_value colour;
	struct colour_parts *parts;
	struct colour_pair *pair;
	size_t start;
	double real;
	struct doubles *doubles;
	struct mesh_items *mesh;
	struct elements *elements;
	const struct expr *expr;
	struct expr_list *exprs;
	struct value value;
}

%code {
#define YYINITDEPTH 40
#define YYMAXDEPTH 10000 /* what walks the tree recurses as deep */
#define YYLLOC_DEFAULT(Current, Rhs, N) \
	((Current) = (N) == 1 ? YYRHSLOC(Rhs, 1) : \
		     (N) ? span_join(YYRHSLOC(Rhs, 1), YYRHSLOC(Rhs, N)) : \
			   (span){ YYRHSLOC(Rhs, 0).source, \
				   YYRHSLOC(Rhs, 0).offset + YYRHSLOC(Rhs, 0).length, 0, \
				   YYRHSLOC(Rhs, 0).site })

/* Ends a nested run; the token that was read ahead goes back. */
#define ACCEPT                                    \
	do {                                      \
		run_accept(p, run, yychar != GRAMMAR_EMPTY); \
		YYACCEPT;                         \
	} while (0)

/* Takes what follows past the grammar, which must not have read ahead. */
#define MORE(function, list)                       \
	do {                                       \
		if (yychar == GRAMMAR_EMPTY)       \
			function(p, list);         \
	} while (0)

int grammar_lex(GRAMMAR_STYPE *, span *, struct parser *, struct run *);
void grammar_error(const span *, struct parser *, struct run *, const char *);
}

%token T_START_SCENE T_START_FLOAT T_START_CONDITION T_START_STRING T_START_DECLARED
%token T_START_NUMBER T_START_DEFAULTS
%token END 0 "the end of the text"
%token <number> T_SUM "a value"
%token <node> T_SHAPE "a primitive" T_MODIFIER "a modifier"
%token <named> T_NUMBER "a number" T_VECTOR "a vector" T_COLOUR "a colour"
%token <text> T_STRING "a string"
%token <ref> T_OBJECT "an object identifier" T_TEXTURE "a texture identifier"
%token <ref> T_PIGMENT "a pigment identifier" T_NORMAL "a normal identifier"
%token <ref> T_FINISH "a finish identifier" T_MATERIAL "a material identifier"
%token <ref> T_INTERIOR "an interior identifier" T_MEDIA "a media identifier"
%token <ref> T_DENSITY "a density identifier" T_CAMERA "a camera identifier"
%token <ref> T_FOG "a fog identifier" T_RAINBOW "a rainbow identifier"
%token <ref> T_SKY_SPHERE "a sky_sphere identifier" T_TRANSFORM "a transform identifier"
%token <ref> T_COLOUR_MAP "a color_map identifier" T_PIGMENT_MAP "a pigment_map identifier"
%token <ref> T_NORMAL_MAP "a normal_map identifier" T_TEXTURE_MAP "a texture_map identifier"
%token <ref> T_SLOPE_MAP "a slope_map identifier" T_DENSITY_MAP "a density_map identifier"
%token <callee> T_FUNCTION "a function" T_VECTOR_FUNCTION "a vector function"
%token <spline> T_SPLINE "a spline identifier"
%token <symbol> T_ARRAY "an array"
%token <keyword> T_FLAT_TEXTURE "a texture of version 2"
%token T_MACRO "a macro" T_FILE "a file handle" T_HASH "#"
%token <name> T_UNDECLARED "an undeclared word"
%token T_LE "<=" T_GE ">=" T_NE "!="

/* The build puts a %token <keyword> KW_WORD "word" here for each line of keywords.def. */
@KEYWORDS@

/* Weakest first. See the head of the file. */
%precedence ENDS
/* Behind `color`: its colour begins, it does not stand alone. */
%precedence
	T_NUMBER T_VECTOR T_COLOUR T_SUM T_STRING T_FUNCTION T_VECTOR_FUNCTION '!' KW_ABS KW_ACOS
	KW_ACOSH KW_ASC KW_ASIN KW_ASINH KW_ATAN KW_ATAN2 KW_ATANH KW_BITWISE_AND KW_BITWISE_OR
	KW_BITWISE_XOR KW_CEIL KW_CHR KW_CONCAT KW_COS KW_COSH KW_DATETIME KW_DEFINED KW_DEGREES
	KW_DIMENSION_SIZE KW_DIMENSIONS KW_DIV KW_EXP KW_FILE_EXISTS KW_FLOOR KW_INSIDE KW_INT
	KW_LN KW_LOG KW_MAX KW_MAX_EXTENT KW_MIN KW_MIN_EXTENT KW_MOD KW_POW KW_RADIANS KW_RAND
	KW_RGB KW_RGBF KW_RGBFT KW_RGBT KW_SEED KW_SELECT KW_SIN KW_SINH KW_SQRT KW_SRGB KW_SRGBF
	KW_SRGBFT KW_SRGBT KW_STR KW_STRCMP KW_STRLEN KW_STRLWR KW_STRUPR KW_SUBSTR KW_T KW_TAN
	KW_TANH KW_TRACE KW_U KW_V KW_VAL KW_VAXIS_ROTATE KW_VCROSS KW_VDOT KW_VLENGTH
	KW_VNORMALIZE KW_VROTATE KW_VSTR KW_VTURBULENCE KW_X KW_Y KW_Z
%left ','
%left '(' '{' T_SPLINE
%left KW_TEXTURE T_FLAT_TEXTURE KW_RED KW_GREEN KW_BLUE KW_FILTER KW_TRANSMIT KW_ALPHA
%left '?' ':'
%left '&' '|'
%left '<' '>' '=' T_LE T_GE T_NE
%left '+' '-'
%left '*' '/'
%left '.'

%type <number> sum product signed component operand full logic relation
%type <token> relop
%type <keyword> selector float_function list_function comma_function extent_function axis
%type <keyword> rgb_word part_word
%type <real> float
%type <start> one two three four sums comma_sums entry_values
%type <text> string string_function
%type <colour> colour marked_colour worded_colour bare_colour colour_items colour_words
%type <number> rgb rgb_or_black five five_or_black
%type <parts> parts
%type <pair> entry_colours

%%

input:
	  T_START_SCENE scene_items END { run->list = p->grammar->statements; run_accept(p, run, false); YYACCEPT; }
	| T_START_FLOAT sum { run->value.number = number_plain($2); run->where = @2; ACCEPT; }
	| T_START_NUMBER sum { run->value.number = number_plain($2); ACCEPT; }
	| T_START_CONDITION full { run->value.number = $2; run->where = @2; ACCEPT; }
	| T_START_STRING string { run->text = $2; ACCEPT; }
	| T_START_DECLARED value { run->value = $2; ACCEPT; }
	| T_START_DEFAULTS default_block { ACCEPT; }
	;

/* ---------------------------------------------------------------- numbers: sum level */

sum:
	  product
	| T_SUM %prec ENDS
	| sum '+' product { $$ = number_binary(p, '+', $1, $3, @$); }
	| sum '-' product { $$ = number_binary(p, '-', $1, $3, @$); }
	;
product:
	  signed
	| product '*' signed { $$ = number_binary(p, '*', $1, $3, @$); }
	| product '/' signed { $$ = number_binary(p, '/', $1, $3, @$); }
	;
signed:
	  component
	| '+' signed { $$ = $2; }
	| '-' signed { $$ = number_negate($2); }
	| '!' signed { $$ = number_not($2); }
	;
component:
	  operand %prec ENDS
	| operand '.' selector { $$ = number_select(p, $1, $3, @$); }
	;
selector:
	  KW_X | KW_Y | KW_Z | KW_U | KW_V | KW_T
	| KW_RED | KW_GREEN | KW_BLUE | KW_FILTER | KW_TRANSMIT | KW_GRAY
	;
operand:
	  T_NUMBER { $$ = $1.number; }
	| T_VECTOR %prec ENDS { $$ = $1.number; }
	| T_COLOUR { $$ = $1.number; }
	| axis { $$ = number_axis($1); }
	| '<' sums '>' { $$ = number_literal(p, $2, @$); }
	| '<' sums ',' '>' { $$ = number_literal(p, $2, @$); }
	| '(' full ')' { $$ = $2; }
	| float_function '(' full ')' { $$ = builtin_float(p, $1, $3, @$); }
	| list_function '(' sums ')' { $$ = builtin_list(p, $1, $3, @$); }
	| comma_function '(' comma_sums ')' { $$ = builtin_list(p, $1, $3, @$); }
	| KW_VTURBULENCE '(' sums ')' { $$ = builtin_list(p, $1, $3, @$); }
	| KW_VTURBULENCE '(' sums ',' ')' { $$ = builtin_list(p, $1, $3, @$); }
	| extent_function '(' T_OBJECT ')' { $$ = builtin_extent(p, $1, $3, @$); }
	| extent_function '(' T_PIGMENT ')' { $$ = builtin_extent(p, $1, $3, @$); }
	| KW_INSIDE '(' T_OBJECT oc sum ')' { $$ = builtin_inside(p, $3, $5, @$); }
	| KW_TRACE '(' T_OBJECT oc sum oc sum ')'
		{ $$ = builtin_trace(p, $3, $5, $7, NULL, @$); }
	| KW_TRACE '(' T_OBJECT oc sum oc sum ',' T_VECTOR ')'
		{ $$ = builtin_trace(p, $3, $5, $7, $9.symbol, @$); }
	| KW_DIMENSIONS '(' T_ARRAY ')' { $$ = builtin_dimensions(p, $3, @$); }
	| KW_DIMENSION_SIZE '(' T_ARRAY oc float ')'
		{ $$ = builtin_dimension_size(p, $3, $5, @$); }
	| KW_DEFINED '(' identifier ')' { $$ = number_float(1); }
	| KW_DEFINED '(' T_UNDECLARED ')' { $$ = number_float(0); }
	| KW_FILE_EXISTS '(' string ')' { $$ = builtin_file_exists(p, $3.text, @$); }
	| KW_STRLEN '(' string ')' { $$ = number_float(text_length(p, $3.text)); }
	| KW_ASC '(' string ')' { $$ = number_float(text_asc($3.text)); }
	| KW_VAL '(' string ')' { $$ = number_float(text_val($3.text)); }
	| KW_STRCMP '(' string oc string ')'
		{ $$ = number_float(text_compare($3.text, $5.text)); }
	| T_FUNCTION '(' sums ')' { $$ = builtin_call(p, $1, $3, @$); }
	| T_VECTOR_FUNCTION '(' sums ')' { $$ = builtin_call(p, $1, $3, @$); }
	| T_SPLINE '(' float ')' { $$ = spline_call(p, $1, K_NONE, $3, @$); }
	| T_SPLINE '(' float ',' spline_word ')' { $$ = spline_call(p, $1, $5, $3, @$); }
	;
axis:
	  KW_X | KW_Y | KW_Z | KW_U | KW_V | KW_T
	;
float_function:
	  KW_ABS | KW_ACOS | KW_ACOSH | KW_ASIN | KW_ASINH | KW_ATAN | KW_ATANH | KW_CEIL | KW_COS
	| KW_COSH | KW_DEGREES | KW_EXP | KW_FLOOR | KW_INT | KW_LN | KW_LOG | KW_RADIANS
	| KW_RAND | KW_SEED | KW_SIN | KW_SINH | KW_SQRT | KW_TAN | KW_TANH
	;
list_function:
	  KW_ATAN2 | KW_DIV | KW_MOD | KW_POW | KW_SELECT
	| KW_VDOT | KW_VLENGTH | KW_VCROSS | KW_VNORMALIZE | KW_VROTATE | KW_VAXIS_ROTATE
	;
/* Of any number of arguments. */
comma_function: KW_MAX | KW_MIN | KW_BITWISE_AND | KW_BITWISE_OR | KW_BITWISE_XOR ;
extent_function: KW_MIN_EXTENT | KW_MAX_EXTENT ;
identifier:
	  T_NUMBER | T_VECTOR | T_COLOUR | T_STRING | T_OBJECT | T_TEXTURE | T_PIGMENT | T_NORMAL
	| T_FINISH | T_MATERIAL | T_INTERIOR | T_MEDIA | T_DENSITY | T_CAMERA | T_FOG | T_RAINBOW
	| T_SKY_SPHERE | T_TRANSFORM | T_COLOUR_MAP | T_PIGMENT_MAP | T_NORMAL_MAP | T_TEXTURE_MAP
	| T_SLOPE_MAP | T_DENSITY_MAP | T_FUNCTION | T_VECTOR_FUNCTION | T_SPLINE | T_ARRAY | T_MACRO
	| T_FILE
	;

/* Lists of numbers: each is the height of the argument stack where it begins. */
oc:
	  %empty %prec ENDS
	| ','
	;
one: sum %prec ENDS { $$ = args_push_number(p, $1, @1); } ;
two: one oc sum %prec ENDS { args_push_number(p, $3, @3); $$ = $1; } ;
three: two oc sum %prec ENDS { args_push_number(p, $3, @3); $$ = $1; } ;
four: three oc sum %prec ENDS { args_push_number(p, $3, @3); $$ = $1; } ;
sums:
	  sum %prec ENDS { $$ = args_push_number(p, $1, @1); }
	| sums sum %prec ENDS { args_push_number(p, $2, @2); $$ = $1; }
	| sums ',' sum %prec ENDS { args_push_number(p, $3, @3); $$ = $1; }
	;
comma_sums:
	  sum { $$ = args_push_number(p, $1, @1); }
	| comma_sums ',' sum { args_push_number(p, $3, @3); $$ = $1; }
	;
float: sum %prec ENDS { $$ = number_to_float(p, $1, @1); } ;

/* ---------------------------------------------------------------- numbers: full level */

full:
	  logic %prec ENDS { $$ = number_plain($1); }
	| logic '?' full ':' full
		{ $$ = number_is_true(p, $1, @1) ? $3 : $5; }
	;
logic:
	  relation %prec ENDS
	| logic '&' relation { $$ = number_binary(p, '&', $1, $3, @$); }
	| logic '|' relation { $$ = number_binary(p, '|', $1, $3, @$); }
	;
relation:
	  sum %prec ENDS
	| string relop string %prec '<' { $$ = text_relation($2, $1.text, $3.text); }
	| relation relop sum %prec '<' { $$ = number_binary(p, $2, $1, $3, @$); }
	;
relop:
	  '<' { $$ = '<'; } | '>' { $$ = '>'; } | '=' { $$ = '='; }
	| T_LE { $$ = T_LE; } | T_GE { $$ = T_GE; } | T_NE { $$ = T_NE; }
	;

/* ---------------------------------------------------------------- strings */

string:
	  T_STRING
	| string_function
	;
string_function:
	  KW_CONCAT '(' concat_list ')' { $$ = text_concat(p, $3, @$); }
	| KW_STR '(' float oc float oc float ')' { $$ = text_both(text_str(p, $3, $5, $7)); }
	| KW_VSTR '(' float oc sum oc string oc float oc float ')'
		{ $$ = text_both(text_vstr(p, $3, $5, $7.text, $9, $11, @$)); }
	| KW_CHR '(' full ')'
		{ $$ = text_both(text_chr(p, number_to_float(p, $3, @3), @$)); }
	| KW_SUBSTR '(' string oc float oc float ')'
		{ $$ = text_both(text_substr(p, $3.text, $5, $7, @$)); }
	| KW_STRUPR '(' string ')' { $$ = text_both(text_case(p, $3.text, true, @$)); }
	| KW_STRLWR '(' string ')' { $$ = text_both(text_case(p, $3.text, false, @$)); }
	| KW_DATETIME '(' float ')' { $$ = text_both(text_datetime(p, $3, NULL, @$)); }
	| KW_DATETIME '(' float oc string ')'
		{ $$ = text_both(text_datetime(p, $3, $5.text, @$)); }
	;
%type <texts> concat_list;
concat_list:
	  string { $$ = texts_add(p, texts_new(p), $1); }
	| concat_list oc string { $$ = texts_add(p, $1, $3); }
	;

/* ---------------------------------------------------------------- colours */

colour:
	  colour_items
	| KW_COLOR %prec ENDS { $$ = colour_black(); }
	| KW_COLOR colour_items { $$ = $2; }
	;
/* A colour that shows itself by its first word. */
marked_colour:
	  colour_words
	| worded_colour
	;
worded_colour:
	  KW_COLOR %prec ENDS { $$ = colour_black(); }
	| KW_COLOR colour_items { $$ = $2; }
	;
/* An expression that is a colour without saying so: it must have been declared as one. */
bare_colour:
	  full %prec ENDS
		{ $$ = colour_bare(p, (struct colour_value){ $1, NULL, true }, @$); }
	| full parts %prec ENDS
		{ $$ = colour_bare(p, (struct colour_value){ $1, $2, true }, @$); }
	;
colour_items:
	  colour_words
	| full %prec ENDS { $$ = (struct colour_value){ $1, NULL, true }; }
	| full parts %prec ENDS { $$ = (struct colour_value){ $1, $2, true }; }
	;
colour_words:
	  rgb_word full %prec ENDS { $$ = (struct colour_value){ colour_word(p, $1, $2, @$), NULL, true }; }
	| rgb_word full parts %prec ENDS
		{ $$ = (struct colour_value){ colour_word(p, $1, $2, @$), $3, true }; }
	| parts %prec ENDS { $$ = (struct colour_value){ .number = { .terms = 5 }, .parts = $1 }; }
	;
rgb_word:
	  KW_RGB | KW_RGBF | KW_RGBT | KW_RGBFT | KW_SRGB | KW_SRGBF | KW_SRGBT | KW_SRGBFT
	;
parts:
	  part_word float { $$ = colour_part(p, NULL, $1, $2, @1); }
	| parts part_word float { $$ = colour_part(p, $1, $2, $3, @2); }
	;
part_word: KW_RED | KW_GREEN | KW_BLUE | KW_FILTER | KW_ALPHA | KW_TRANSMIT ;

/* Five terms: with filter and transmit, or without. */
five: colour %prec ENDS { $$ = colour_full(p, $1, @1); } ;
rgb: colour %prec ENDS { $$ = colour_rgb_only(p, $1, @1); } ;
five_or_black:
	  %empty %prec ENDS { $$ = (struct number){ .terms = 5 }; }
	| five
	;
rgb_or_black:
	  %empty %prec ENDS { $$ = (struct number){ .terms = 5 }; }
	| rgb
	;

/* ---------------------------------------------------------------- declared values */

%type <value> value;
value:
	  sum %prec ENDS { $$ = value_number(number_plain($1)); }
	| sum parts %prec ENDS
		{ $$ = value_colour(colour_full(p, (struct colour_value){ $1, $2, true }, @$)); }
	| marked_colour %prec ENDS { $$ = value_colour(colour_full(p, $1, @$)); }
	| string { $$ = value_string($1.text); }
	| KW_ARRAY dimensions %prec ENDS { $$ = value_array(p, $2, @2, NULL, @$); }
	| KW_ARRAY dimensions '{' elements '}' { $$ = value_array(p, $2, @2, $4, @$); }
	| KW_ARRAY dimensions '{' elements ',' '}' { $$ = value_array(p, $2, @2, $4, @$); }
	| T_ARRAY { $$ = value_of_symbol(p, $1, @1); }
	| function { $$ = value_function($1); }
	| T_FUNCTION %prec ENDS { $$ = value_function($1.function); }
	| T_VECTOR_FUNCTION %prec ENDS { $$ = value_function($1.function); }
	| spline { $$ = value_spline($1); }
	| T_SPLINE %prec ENDS { $$ = value_spline($1); }
	| transform { $$ = value_node(T_TRANSFORM, $1); }
	| T_TRANSFORM { $$ = value_node(T_TRANSFORM, $1.node); }
	| pigment { $$ = value_node(T_PIGMENT, $1); }
	| T_PIGMENT { $$ = value_node(T_PIGMENT, $1.node); }
	| normal { $$ = value_node(T_NORMAL, $1); }
	| T_NORMAL { $$ = value_node(T_NORMAL, $1.node); }
	| finish { $$ = value_node(T_FINISH, $1); }
	| T_FINISH { $$ = value_node(T_FINISH, $1.node); }
	| layers %prec ENDS { $$ = value_node(T_TEXTURE, layers_node(p, $1, @$)); }
	| T_TEXTURE { $$ = value_node(T_TEXTURE, $1.node); }
	| color_map { $$ = value_node(T_COLOUR_MAP, $1); }
	| T_COLOUR_MAP { $$ = value_node(T_COLOUR_MAP, $1.node); }
	| pigment_map { $$ = value_node(T_PIGMENT_MAP, $1); }
	| T_PIGMENT_MAP { $$ = value_node(T_PIGMENT_MAP, $1.node); }
	| normal_map { $$ = value_node(T_NORMAL_MAP, $1); }
	| T_NORMAL_MAP { $$ = value_node(T_NORMAL_MAP, $1.node); }
	| texture_map { $$ = value_node(T_TEXTURE_MAP, $1); }
	| T_TEXTURE_MAP { $$ = value_node(T_TEXTURE_MAP, $1.node); }
	| slope_map { $$ = value_node(T_SLOPE_MAP, $1); }
	| T_SLOPE_MAP { $$ = value_node(T_SLOPE_MAP, $1.node); }
	| density_map { $$ = value_node(T_DENSITY_MAP, $1); }
	| T_DENSITY_MAP { $$ = value_node(T_DENSITY_MAP, $1.node); }
	| density { $$ = value_node(T_DENSITY, $1); }
	| T_DENSITY { $$ = value_node(T_DENSITY, $1.node); }
	| media { $$ = value_node(T_MEDIA, $1); }
	| T_MEDIA { $$ = value_node(T_MEDIA, $1.node); }
	| interior { $$ = value_node(T_INTERIOR, $1); }
	| T_INTERIOR { $$ = value_node(T_INTERIOR, $1.node); }
	| material { $$ = value_node(T_MATERIAL, $1); }
	| T_MATERIAL { $$ = value_node(T_MATERIAL, $1.node); }
	| camera { $$ = value_node(T_CAMERA, $1); }
	| T_CAMERA { $$ = value_node(T_CAMERA, $1.node); }
	| fog { $$ = value_node(T_FOG, $1); }
	| T_FOG { $$ = value_node(T_FOG, $1.node); }
	| rainbow { $$ = value_node(T_RAINBOW, $1); }
	| T_RAINBOW { $$ = value_node(T_RAINBOW, $1.node); }
	| sky_sphere { $$ = value_node(T_SKY_SPHERE, $1); }
	| T_SKY_SPHERE { $$ = value_node(T_SKY_SPHERE, $1.node); }
	| object_block { $$ = value_node(T_OBJECT, $1); }
	| T_OBJECT { $$ = value_node(T_OBJECT, $1.node); }
	;
%type <list> layers;
layers:
	  texture { $$ = list_one($1); }
	| layers texture { $$ = list_add($1, $2); }
	;
%type <start> dimensions;
dimensions:
	  '[' sum ']' { $$ = args_push_number(p, $2, @2); }
	| dimensions '[' sum ']' { args_push_number(p, $3, @3); $$ = $1; }
	;
%type <elements> elements;
elements:
	  value { $$ = elements_new(p); elements_add(p, $$, $1, @1); }
	| '{' elements '}' { $$ = elements_new(p); elements_add_inner(p, $$, $2, @$); }
	| '{' elements ',' '}' { $$ = elements_new(p); elements_add_inner(p, $$, $2, @$); }
	| elements value { elements_add(p, $1, $2, @2); $$ = $1; }
	| elements ',' value { elements_add(p, $1, $3, @3); $$ = $1; }
	| elements '{' elements '}' { elements_add_inner(p, $1, $3, @3); $$ = $1; }
	| elements ',' '{' elements '}' { elements_add_inner(p, $1, $4, @4); $$ = $1; }
	| elements '{' elements ',' '}' { elements_add_inner(p, $1, $3, @3); $$ = $1; }
	| elements ',' '{' elements ',' '}' { elements_add_inner(p, $1, $4, @4); $$ = $1; }
	;

%type <spline> spline spline_base;
%type <keyword> spline_type spline_word;
%type <start> spline_entries;
spline: KW_SPLINE '{' spline_base spline_type spline_entries '}'
		{ $$ = spline_build(p, $3, $4, $5, @$); }
	;
spline_base: %empty %prec ENDS { $$ = NULL; } | T_SPLINE ;
spline_type: %empty { $$ = K_NONE; } | spline_word ;
spline_word: KW_LINEAR_SPLINE | KW_QUADRATIC_SPLINE | KW_CUBIC_SPLINE | KW_NATURAL_SPLINE ;
spline_entries:
	  %empty { $$ = args_height(p); }
	| spline_entries sum oc full %prec ENDS { spline_entry(p, number_to_float(p, $2, @2), @2, $4, @4); $$ = $1; }
	| spline_entries sum oc full ',' { spline_entry(p, number_to_float(p, $2, @2), @2, $4, @4); $$ = $1; }
	;

/* ---------------------------------------------------------------- functions */

%type <function> function pattern_function function_body;
%type <expr> fexpr for fand frel fsum fproduct fsigned foperand;
%type <exprs> fargs;
%type <start> parameters parameter_names;
%type <name> parameter_name;
%type <keyword> fcall_word fmember fvariable;

function:
	  pattern_function
	| KW_FUNCTION parameters '{' { function_begin(p, $2, true); } function_body '}'
		{ $$ = $5; }
	;
/* Of x, y and z (or u and v): where it stands it cannot choose its parameters. */
pattern_function:
	  KW_FUNCTION '{' { function_begin(p, args_height(p), false); } function_body '}'
		{ $$ = $4; }
	;
parameters: '(' parameter_names ')' { $$ = $2; } ;
parameter_names:
	  parameter_name { $$ = args_push_string(p, $1, @1); }
	| parameter_names parameter_name { args_push_string(p, $2, @2); $$ = $1; }
	| parameter_names ',' parameter_name { args_push_string(p, $3, @3); $$ = $1; }
	;
parameter_name:
	  T_UNDECLARED
	| fvariable { $$ = keyword_name($1); }
	;
fvariable: KW_X | KW_Y | KW_Z | KW_U | KW_V ;
function_body:
	  fexpr { $$ = function_end(p, $1, @$, NULL, -1); }
	| KW_INTERNAL '(' float ')' { $$ = function_end(p, NULL, @$, NULL, number_truncate($3)); }
	| pigment { $$ = function_end(p, NULL, @$, $1, -1); }
	| transform { $$ = function_end(p, NULL, @$, $1, -1); }
	| KW_PATTERN '{' pattern_body '}'
		{ $$ = function_end(p, NULL, @$, node_block(p, $1, @$, @1, $3), -1); }
	| spline { $$ = function_from_spline(p, $1, @$); }
	;
fexpr: for ;
for:
	  fand
	| for '|' fand { $$ = expr_binary(p, EXPR_OR, $1, $3, @$); }
	;
fand:
	  frel
	| fand '&' frel { $$ = expr_binary(p, EXPR_AND, $1, $3, @$); }
	;
frel:
	  fsum
	| frel '<' fsum { $$ = expr_binary(p, EXPR_LESS, $1, $3, @$); }
	| frel T_LE fsum { $$ = expr_binary(p, EXPR_LESS_EQUAL, $1, $3, @$); }
	| frel '=' fsum { $$ = expr_binary(p, EXPR_EQUAL, $1, $3, @$); }
	| frel T_NE fsum { $$ = expr_binary(p, EXPR_NOT_EQUAL, $1, $3, @$); }
	| frel T_GE fsum { $$ = expr_binary(p, EXPR_GREATER_EQUAL, $1, $3, @$); }
	| frel '>' fsum { $$ = expr_binary(p, EXPR_GREATER, $1, $3, @$); }
	;
fsum:
	  fproduct
	| fsum '+' fproduct { $$ = expr_binary(p, EXPR_ADD, $1, $3, @$); }
	| fsum '-' fproduct { $$ = expr_binary(p, EXPR_SUBTRACT, $1, $3, @$); }
	;
fproduct:
	  fsigned
	| fproduct '*' fsigned { $$ = expr_binary(p, EXPR_MULTIPLY, $1, $3, @$); }
	| fproduct '/' fsigned { $$ = expr_binary(p, EXPR_DIVIDE, $1, $3, @$); }
	;
fsigned:
	  foperand
	| '+' foperand { $$ = expr_unary(p, EXPR_ADD, $2, @$); }
	| '-' foperand { $$ = expr_unary(p, EXPR_NEGATE, $2, @$); }
	;
foperand:
	  T_NUMBER { $$ = expr_number(p, $1, @$); }
	| fvariable { $$ = expr_axis(p, $1, @$); }
	| T_UNDECLARED { $$ = expr_name(p, $1, @$); }
	| '(' fexpr ')' { $$ = expr_group(p, $2, @$); }
	| fcall_word '(' fargs ')' { $$ = expr_builtin(p, $1, $3, @$); }
	| KW_SUM '(' T_UNDECLARED ',' fexpr ',' fexpr ',' { function_loop_begin(p, $3, @3); }
		fexpr ')' { $$ = function_loop_end(p, $1, $5, $7, $10, @$); }
	| KW_PROD '(' T_UNDECLARED ',' fexpr ',' fexpr ',' { function_loop_begin(p, $3, @3); }
		fexpr ')' { $$ = function_loop_end(p, $1, $5, $7, $10, @$); }
	| T_FUNCTION '(' fargs ')' { $$ = expr_call(p, $1, $3, K_NONE, @$); }
	| T_VECTOR_FUNCTION '(' fargs ')' '.' fmember { $$ = expr_call(p, $1, $3, $6, @$); }
	;
fmember:
	  KW_X | KW_Y | KW_Z | KW_U | KW_V | KW_T
	| KW_RED | KW_GREEN | KW_BLUE | KW_FILTER | KW_TRANSMIT | KW_GRAY
	| T_UNDECLARED { $$ = member_hf(p, $1, @1); }
	;
fargs:
	  fexpr { $$ = expr_list_add(p, NULL, $1); }
	| fargs ',' fexpr { $$ = expr_list_add(p, $1, $3); }
	;
fcall_word:
	  KW_SIN | KW_COS | KW_TAN | KW_ASIN | KW_ACOS | KW_ATAN | KW_SINH | KW_COSH | KW_TANH | KW_ASINH
	| KW_ACOSH | KW_ATANH | KW_ABS | KW_DEGREES | KW_RADIANS | KW_INT | KW_FLOOR | KW_CEIL | KW_SQRT
	| KW_EXP | KW_LN | KW_LOG | KW_ATAN2 | KW_POW | KW_MOD | KW_DIV | KW_MIN | KW_MAX | KW_SELECT
	;

/* ---------------------------------------------------------------- transformations */

%type <node> transformation transform transform_item;
%type <list> transform_items transformations;
%type <keyword> move_word;
transformation:
	  move_word one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_MATRIX '<' sums '>' { $$ = node_matrix(p, @$, @1, $3); }
	| transform
	;
move_word: KW_TRANSLATE | KW_ROTATE | KW_SCALE ;
transform:
	  KW_TRANSFORM T_TRANSFORM { $$ = node_wrap(p, $1, @$, @1, $2, @2); }
	| KW_TRANSFORM '{' transform_items '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
transform_items:
	  %empty { $$ = list_none(); }
	| transform_items transform_item { $$ = list_add($1, $2); }
	;
transform_item:
	  transformation
	| T_TRANSFORM { $$ = node_reference(p, $1, @1); }
	| KW_INVERSE { $$ = node_new(p, $1, @$, @1); }
	;
transformations:
	  %empty { $$ = list_none(); }
	| transformations transformation { $$ = list_add($1, $2); }
	;

/* ---------------------------------------------------------------- scene level */

%type <node> scene_item background;
%type <keyword> old_setting;
scene_items:
	  %empty { p->grammar->statements = list_none(); }
	| scene_items scene_item { scene_add(p, $2, yychar != GRAMMAR_EMPTY); }
	| scene_items default_statement
	;
scene_item:
	  object
	| camera
	| fog
	| rainbow
	| sky_sphere
	| media
	| background
	| global_settings
	| old_setting float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	;
old_setting: KW_MAX_TRACE_LEVEL | KW_MAX_INTERSECTIONS ;
background:
	  KW_BACKGROUND '{' '}' { $$ = node_block(p, $1, @$, @1,
			list_one(colour_node(p, (struct number){ .terms = 5 }, @$))); }
	| KW_BACKGROUND '{' five '}'
		{ $$ = node_block(p, $1, @$, @1, list_one(colour_node(p, $3, @3))); }
	;
default_statement: KW_DEFAULT default_block ;
default_block: '{' default_items '}' ;
default_items:
	  %empty
	| default_items default_item
	;
default_item:
	  texture { default_add(p, $1); }
	| pigment { default_add(p, $1); }
	| normal { default_add(p, $1); }
	| finish { default_add(p, $1); }
	| camera { default_add(p, $1); }
	| importance { default_add(p, $1); }
	;

/* ---------------------------------------------------------------- objects */

%type <node> object object_block object_statement modifier parameter importance object_photon clip_block;
%type <node> blob_item isosurface_item parametric_item julia_item contained mesh_item;
%type <node> light_item light_photon group_item triangle_texture face_detail;
%type <list> modifiers objects csg_members some_members clip_items object_photons importance_items;
%type <list> blob_items isosurface_items parametric_items julia_items axes face_tail;
%type <list> light_items light_photons group_items mesh2_items;
%type <list> polynomial_items precomputed;
%type <node> mesh2_item polynomial_item;
%type <body> shape_body shape_args shape_modified;
%type <list> height_field_items;
%type <mesh> mesh_items;
%type <keyword> shape_word csg_word clip_word switch_word flag_word parameter_float curve_word;
%type <keyword> julia_word iso_float parametric_float light_flag light_float light_switch;
%type <keyword> coefficient_word mesh2_word index_word face_word projection_word;
%type <start> bool;
%type <doubles> vector_list face_list;

object:
	  T_OBJECT { $$ = node_reference(p, $1, @1); }
	| object_block
	;
objects:
	  %empty { $$ = list_none(); }
	| objects object { $$ = list_add($1, $2); }
	;
object_block:
	  object_statement { shape_check_items(p, $1); $$ = $1; }
	| T_SHAPE
	;
object_statement:
	  KW_OBJECT '{' object modifiers '}'
		{ $$ = node_block(p, K_OBJECT, @$, @1, list_join(list_one($3), $4)); }
	| shape_word '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| shape_word '{' shape_body '}' { $$ = shape_node(p, $1, @$, @1, $3); }
	| csg_word '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| csg_word '{' csg_members modifiers '}'
		{ $$ = node_block(p, $1 == K_COMPOSITE ? K_UNION : $1, @$, @1,
			list_join($3, $4)); }
	| coefficient_word '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| coefficient_word '{' '<' sums '>' modifiers '}'
		{ $$ = shape_coefficients(p, $1, @$, @1, $4, @4, $6); }
	| KW_POLY '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_POLY '{' one oc '<' sums '>' modifiers '}'
		{ $$ = shape_coefficients(p, $1, @$, @1, $3, @6, $8); }
	| KW_POLYNOMIAL '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_POLYNOMIAL '{' one oc polynomial_items modifiers '}'
		{ $$ = shape_terms(p, @$, @1, $3, $5, $6); }
	| KW_BLOB '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_BLOB '{' blob_items modifiers '}' { $$ = node_block(p, $1, @$, @1, list_join($3, $4)); }
	| KW_HEIGHT_FIELD '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_HEIGHT_FIELD '{' image height_field_items '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| KW_ISOSURFACE '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_ISOSURFACE '{' pattern_function isosurface_items modifiers '}'
		{ $$ = node_function(p, $1, @$, @1, $3, @3); $$->children = list_join($4, $5).first; }
	| KW_PARAMETRIC '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_PARAMETRIC '{' pattern_function oc pattern_function oc pattern_function oc two
	  parametric_items modifiers '}'
		{ $$ = parametric_node(p, @$, @1, (const struct function *[]){ $3, $5, $7 },
			(span[]){ @3, @5, @7 }, $9, list_join($10, $11)); }
	| KW_JULIA_FRACTAL '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_JULIA_FRACTAL '{' one julia_items modifiers '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "4"); $$->children = list_join($4, $5).first; }
	| KW_MESH '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_MESH '{' mesh_items modifiers '}'
		{ $$ = node_block(p, $1, @$, @1, list_join($3->items, $4)); }
	| KW_MESH2 '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_MESH2 '{' mesh2_items modifiers '}'
		{ $$ = mesh2_node(p, list_join($3, $4), @$, @1); }
	| KW_LIGHT_SOURCE '{' T_OBJECT modifiers '}' { $$ = copy_node(p, $3, @3, @$, @1, $4); }
	| KW_LIGHT_SOURCE '{' one oc rgb_or_black light_items '}'
		{ args_push_number(p, $5, @5); $$ = node_fit(p, $1, @$, @1, $3, "vc");
		  $$->children = $6.first; }
	| KW_LIGHT_GROUP '{' group_items '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
csg_word: KW_UNION | KW_COMPOSITE | KW_MERGE | KW_INTERSECTION | KW_DIFFERENCE ;
/* A bare identifier as the first member would be the copy above. */
csg_members:
	  %empty { $$ = list_none(); }
	| some_members
	;
some_members:
	  object_block { $$ = list_one($1); }
	| some_members object { $$ = member_add(p, run, $1, $2, yychar != GRAMMAR_EMPTY); }
	;
coefficient_word: KW_CUBIC | KW_QUARTIC ;

/* Primitives whose inside is a list of numbers and a few words. */
shape_word: @SHAPES@ ; /* by the build, from shapes.def */
/* No more numbers behind the first modifier. */
shape_body:
	  shape_args
	| shape_modified
	;
shape_args:
	  %empty { $$ = (struct body){ .start = args_height(p) }; }
	| shape_args sum %prec ENDS { args_push_number(p, $2, @2); $$ = $1; }
	| shape_args ',' sum %prec ENDS
		{ body_comma(p, $1, @2); args_push_number(p, $3, @3); $$ = $1; }
	| shape_args string { $$ = body_string(p, $1, $2.text, @2); }
	| shape_args ',' string { body_comma(p, $1, @2); $$ = body_string(p, $1, $3.text, @3); }
	| shape_args KW_TTF string { args_push_string(p, $3.raw, @2); $$ = $1; }
	| shape_args KW_INTERNAL float { args_push_number(p, number_float($3), @2); $$ = $1; }
	| shape_args parameter { $$ = body_add($1, $2); }
	;
shape_modified:
	  shape_args modifier { $$ = body_add($1, $2); }
	| shape_modified modifier { $$ = body_add($1, $2); }
	| shape_modified parameter { $$ = body_add($1, $2); }
	| shape_modified T_COLOUR %prec ENDS { $$ = body_add($1, old_named_colour(p, $2, @2)); }
	;
height_field_items:
	  %empty { $$ = list_none(); }
	| height_field_items parameter { $$ = list_add($1, $2); }
	| height_field_items modifier { $$ = list_add($1, $2); }
	;
parameter:
	  curve_word { $$ = node_new(p, $1, @$, @1); }
	| parameter_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_UV_VECTORS four { $$ = node_fit(p, $1, @$, @1, $2, "2222"); }
	;
curve_word:
	  KW_LINEAR_SPLINE | KW_QUADRATIC_SPLINE | KW_CUBIC_SPLINE | KW_BEZIER_SPLINE | KW_B_SPLINE
	| KW_LINEAR_SWEEP | KW_CONIC_SWEEP | KW_OPEN | KW_SMOOTH
	;
parameter_float:
	  KW_TYPE | KW_FLATNESS | KW_U_STEPS | KW_V_STEPS | KW_ACCURACY | KW_TOLERANCE | KW_WATER_LEVEL
	;
polynomial_items:
	  %empty { $$ = list_none(); }
	| polynomial_items polynomial_item { $$ = list_add($1, $2); }
	;
polynomial_item:
	  KW_XYZ '(' three ')' ':' sum oc
		{ args_push_number(p, $6, @6); $$ = node_fit(p, $1, @$, @1, $3, "ffff"); }
	;
blob_items:
	  %empty { $$ = list_none(); }
	| blob_items blob_item { $$ = list_add($1, $2); }
	;
blob_item:
	  KW_THRESHOLD float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_COMPONENT three { $$ = node_fit(p, $1, @$, @1, $2, "ffv"); }
	| KW_SPHERE '{' two oc strength modifiers '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "vff"); $$->children = $6.first; }
	| KW_CYLINDER '{' three oc strength modifiers '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "vvff"); $$->children = $6.first; }
	;
strength:
	  sum %prec ENDS { args_push_number(p, $1, @1); }
	| KW_STRENGTH sum %prec ENDS { args_push_number(p, $2, @2); }
	;
isosurface_items:
	  %empty { $$ = list_none(); }
	| isosurface_items isosurface_item { $$ = list_add($1, $2); }
	;
isosurface_item:
	  contained
	| iso_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_EVALUATE three { $$ = node_fit(p, $1, @$, @1, $2, "fff"); }
	| KW_ALL_INTERSECTIONS { $$ = node_new(p, $1, @$, @1); }
	| KW_OPEN { $$ = node_new(p, $1, @$, @1); }
	;
iso_float: KW_THRESHOLD | KW_ACCURACY | KW_MAX_GRADIENT | KW_MAX_TRACE ;
contained:
	  KW_CONTAINED_BY '{' KW_BOX '{' two '}' '}'
		{ $$ = node_block(p, $1, @$, @1, list_one(node_fit(p, $3, @3, @3, $5, "vv"))); }
	| KW_CONTAINED_BY '{' KW_SPHERE '{' two '}' '}'
		{ $$ = node_block(p, $1, @$, @1, list_one(node_fit(p, $3, @3, @3, $5, "vf"))); }
	;
parametric_items:
	  %empty { $$ = list_none(); }
	| parametric_items parametric_item { $$ = list_add($1, $2); }
	;
parametric_item:
	  contained
	| parametric_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_PRECOMPUTE float axes
		{ $$ = node_float(p, $1, @$, @1, $2, @2); $$->children = $3.first; }
	;
parametric_float: KW_ACCURACY | KW_MAX_GRADIENT ;
axes:
	  %empty { $$ = list_none(); }
	| axes precomputed { $$ = list_join($1, $2); }
	| axes ',' precomputed { $$ = list_join($1, $3); }
	;
precomputed:
	  KW_X { $$ = list_one(node_new(p, $1, @$, @1)); }
	| KW_Y { $$ = list_one(node_new(p, $1, @$, @1)); }
	| KW_Z { $$ = list_one(node_new(p, $1, @$, @1)); }
	;
julia_items:
	  %empty { $$ = list_none(); }
	| julia_items julia_item { $$ = list_add($1, $2); }
	;
julia_item:
	  KW_MAX_ITERATION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_PRECISION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_SLICE two { $$ = node_fit(p, $1, @$, @1, $2, "4f"); }
	| KW_PWR '(' two ')' { $$ = node_fit(p, $1, @$, @1, $3, "ff"); }
	| julia_word { $$ = node_new(p, $1, @$, @1); }
	;
julia_word:
	  KW_HYPERCOMPLEX | KW_QUATERNION | KW_SQR | KW_CUBE | KW_RECIPROCAL | KW_EXP | KW_LN | KW_SIN
	| KW_ASIN | KW_COS | KW_ACOS | KW_TAN | KW_ATAN | KW_SINH | KW_ASINH | KW_COSH | KW_ACOSH | KW_TANH
	| KW_ATANH
	;

mesh_items:
	  %empty { $$ = mesh_items_new(p); }
	| mesh_items mesh_item { $$ = mesh_add($1, $2); }
	| mesh_items face_word '{' sums '}' { $$ = mesh_add_face(p, $1, $2, @2, @5, $4); }
	;
mesh_item:
	  face_word '{' sums face_tail '}' { $$ = mesh_face(p, $1, @$, @1, $3, $4); }
	| KW_INSIDE_VECTOR one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	;
face_word: KW_TRIANGLE | KW_SMOOTH_TRIANGLE ;
face_tail:
	  face_detail { $$ = list_one($1); }
	| face_tail face_detail { $$ = list_add($1, $2); }
	;
face_detail:
	  KW_UV_VECTORS three { $$ = node_fit(p, $1, @$, @1, $2, "222"); }
	| texture_word '{' triangle_texture '}'
		{ $$ = node_block(p, K_TRIANGLE_TEXTURES, @$, @1, list_one($3)); }
	| KW_TEXTURE_LIST '{' triangle_texture oc triangle_texture oc triangle_texture '}'
		{ $$ = node_block(p, K_TRIANGLE_TEXTURES, @$, @1,
			list_add(list_add(list_one($3), $5), $7)); }
	;
triangle_texture: T_TEXTURE { $$ = node_reference(p, $1, @1); } ;

mesh2_items:
	  %empty { $$ = list_none(); }
	| mesh2_items mesh2_item { $$ = list_add($1, $2); }
	;
mesh2_item:
	  mesh2_word '{' float oc
		{ $<doubles>$ = doubles_new(p, $3, 3); MORE(doubles_add_rows, $<doubles>$); } vector_list '}'
		{ $$ = mesh2_list(p, $1, @$, @1, $3, @3, $6, 3); }
	| KW_UV_VECTORS '{' float oc
		{ $<doubles>$ = doubles_new(p, $3, 2); MORE(doubles_add_rows, $<doubles>$); } vector_list '}'
		{ $$ = mesh2_list(p, $1, @$, @1, $3, @3, $6, 2); }
	| index_word '{' float oc
		{ $<doubles>$ = doubles_new(p, $3, 3); MORE(doubles_add_rows, $<doubles>$); } vector_list '}'
		{ $$ = mesh2_list(p, $1, @$, @1, $3, @3, $6, 3); }
	| KW_FACE_INDICES '{' float oc
		{ $<doubles>$ = doubles_new(p, $3, 3); MORE(doubles_face_rows, $<doubles>$); } face_list '}'
		{ $$ = mesh2_list(p, $1, @$, @1, $3, @3, $6, 3); }
	| KW_TEXTURE_LIST '{' float oc texture_items '}'
		{ $$ = node_float(p, $1, @$, @1, $3, @3); $$->children = $5.first; }
	| KW_INSIDE_VECTOR one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	;
mesh2_word: KW_VERTEX_VECTORS | KW_NORMAL_VECTORS ;
index_word: KW_UV_INDICES | KW_NORMAL_INDICES ;
%type <list> texture_items;
texture_items:
	  %empty { $$ = list_none(); }
	| texture_items texture { $$ = list_add($1, $2); }
	| texture_items texture ',' { $$ = list_add($1, $2); }
	;
vector_list:
	  %empty { $$ = $<doubles>0; }
	| vector_list sum %prec ENDS { doubles_add(p, $1, $2, @2); $$ = $1; }
	| vector_list sum ',' { doubles_add(p, $1, $2, @2); $$ = $1; }
	| vector_list T_SUM ',' { doubles_add(p, $1, $2, @2); MORE(doubles_add_rows, $1); $$ = $1; }
	| vector_list T_VECTOR ',' { doubles_add(p, $1, $2.number, @2); $$ = $1; }
	;
/* Faces and the texture indices behind them; one term is a texture index. */
face_list:
	  %empty { $$ = $<doubles>0; }
	| face_list sum %prec ENDS { doubles_face(p, $1, $2, @2); $$ = $1; }
	| face_list sum ',' { doubles_face(p, $1, $2, @2); $$ = $1; }
	| face_list T_SUM ',' { doubles_face(p, $1, $2, @2); MORE(doubles_face_rows, $1); $$ = $1; }
	| face_list T_VECTOR ',' { doubles_face(p, $1, $2.number, @2); $$ = $1; }
	;

light_items:
	  %empty { $$ = list_none(); }
	| light_items light_item { $$ = list_add($1, $2); }
	;
light_item:
	  color_map
	| light_flag { $$ = node_new(p, $1, @$, @1); }
	| light_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| light_switch bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_POINT_AT one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_AREA_LIGHT four { $$ = node_fit(p, $1, @$, @1, $2, "vvff"); }
	| projection_word '{' object modifiers '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| KW_PHOTONS '{' light_photons '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| transformation
	;
light_flag:
	  KW_SPOTLIGHT | KW_SHADOWLESS | KW_CYLINDER | KW_PARALLEL | KW_JITTER | KW_CIRCULAR | KW_ORIENT
	;
light_float:
	  KW_RADIUS | KW_FALLOFF | KW_TIGHTNESS | KW_ADAPTIVE | KW_FADE_DISTANCE | KW_FADE_POWER
	;
light_switch: KW_AREA_ILLUMINATION | KW_MEDIA_ATTENUATION | KW_MEDIA_INTERACTION ;
projection_word: KW_LOOKS_LIKE | KW_PROJECTED_THROUGH ;
light_photons:
	  %empty { $$ = list_none(); }
	| light_photons light_photon { $$ = list_add($1, $2); }
	;
light_photon:
	  KW_REFRACTION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_REFLECTION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_AREA_LIGHT { $$ = node_new(p, $1, @$, @1); }
	;
group_items:
	  %empty { $$ = list_none(); }
	| group_items group_item { $$ = list_add($1, $2); }
	;
group_item:
	  object
	| transformation
	| KW_GLOBAL_LIGHTS bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_PHOTONS '{' object_photons '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;

modifiers:
	  %empty { $$ = list_none(); }
	| modifiers modifier { $$ = list_add($1, $2); }
	| modifiers T_COLOUR %prec ENDS { $$ = list_add($1, old_named_colour(p, $2, @2)); }
	;
modifier:
	  transformation
	| texture
	| pigment
	| normal
	| finish
	| KW_INTERIOR_TEXTURE '{' texture_body '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| interior
	| material
	| T_MODIFIER
	| clip_word '{' clip_block '}' { $$ = node_block(p, $1, @$, @1, list_one($3)); }
	| clip_word '{' clip_items '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| flag_word { $$ = node_new(p, $1, @$, @1); }
	| switch_word bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_SPLIT_UNION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_PHOTONS '{' object_photons '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| importance
	| marked_colour %prec ENDS { $$ = old_colour(p, $1, @$); }
	| KW_DTAG string { $$ = node_string(p, $1, @$, @1, $2.text, @2); }
	;
flag_word: KW_UV_MAPPING | KW_INVERSE | KW_NO_SHADOW | KW_CUTAWAY_TEXTURES ;
switch_word:
	  KW_HOLLOW | KW_NO_IMAGE | KW_NO_REFLECTION | KW_NO_RADIOSITY | KW_DOUBLE_ILLUMINATE | KW_STURM
	| KW_HIERARCHY
	;
bool:
	  %empty %prec ENDS { $$ = args_height(p); }
	| one
	;
clip_word: KW_CLIPPED_BY | KW_BOUNDED_BY ;
clip_block: clip_word { $$ = node_new(p, $1, @$, @1); } ;
clip_items: object objects transformations
		{ $$ = list_join(list_join(list_one($1), $2), $3); }
	;
object_photons:
	  %empty { $$ = list_none(); }
	| object_photons object_photon { $$ = list_add($1, $2); }
	;
object_photon:
	  KW_TARGET bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_PASS_THROUGH bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_COLLECT bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_REFRACTION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_REFLECTION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	;
importance: KW_RADIOSITY '{' importance_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
importance_items:
	  %empty { $$ = list_none(); }
	| importance_items KW_IMPORTANCE float
		{ $$ = list_add($1, node_float(p, $2, @2, @2, $3, @3)); }
	;

/* ---------------------------------------------------------------- textures */

%type <node> texture pigment normal density finish;
%type <node> texture_item normal_special density_special pattern image;
%type <node> tiles material_map normal_pattern bitmap_item image_option modifier_item slope_item;
%type <list> texture_body texture_names texture_items_plain texture_tail textures;
%type <ref> texture_name;
%type <list> pigment_body pigment_entry normal_body density_body density_entry pattern_body;
%type <list> pigment_first pigment_entry_first pigment_ref density_ref density_first;
%type <list> density_entry_first pattern_modifiers image_options bitmap_options slope_items amount;
%type <node> pigment_special pigment_list_item;
%type <list> pigment_list normal_list texture_list density_list;
%type <keyword> plain_pattern float_pattern list_word image_type pattern_float;
%type <keyword> pattern_vector pattern_flag bitmap_flag bitmap_float bitmap_pair share_word;

texture:
	  KW_TEXTURE '{' texture_body '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| T_FLAT_TEXTURE '{' flat_body '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
texture_word: KW_TEXTURE | T_FLAT_TEXTURE ;
texture_body:
	  texture_items_plain
	| pattern pattern_modifiers { $$ = list_join(list_one($1), $2); }
	| list_word texture_list pattern_modifiers
		{ $$ = list_join(list_one(node_block(p, $1, @1, @1, $2)), $3); }
	| KW_OBJECT '{' object transformations texture_list '}' pattern_modifiers
		{ $$ = list_join(list_one(node_block(p, $1, @$, @1,
			list_join(list_join(list_one($3), $4), $5))), $7); }
	| KW_UV_MAPPING texture_body
		{ $$ = list_one(node_block(p, $1, @$, @1, $2)); }
	| tiles texture_tail { $$ = list_join(list_one($1), $2); }
	| material_map texture_tail { $$ = list_join(list_one($1), $2); }
	;
/* Names stand first. */
texture_names:
	  %empty { $$ = list_none(); }
	| T_TEXTURE { $$ = list_one(node_reference(p, $1, @1)); }
	| texture_names texture_name { $$ = list_add($1, node_reference(p, $2, @2)); }
	;
texture_name: T_PIGMENT | T_NORMAL | T_FINISH ;
texture_items_plain:
	  texture_names
	| texture_items_plain texture_item { $$ = list_add($1, $2); }
	;
texture_item:
	  pigment
	| normal
	| finish
	| transformation
	| KW_NO_BUMP_SCALE { $$ = node_new(p, $1, @$, @1); }
	;
texture_tail:
	  %empty { $$ = list_none(); }
	| texture_tail transformation { $$ = list_add($1, $2); }
	| texture_tail KW_NO_BUMP_SCALE { $$ = list_add($1, node_new(p, $2, @2, @2)); }
	;
tiles: KW_TILES '{' textures KW_TILE2 textures '}'
		{ $$ = node_block(p, $1, @$, @1,
			list_add($3, node_block(p, $4, @4, @4, $5))); }
	;
/* Before version 3.0 the items of pigment, normal and finish stand in the texture itself, where each changes
 * what there is already, as a block of its own would. */
%type <list> flat_body flat_items flat_checks;
%type <node> flat_check flat_item flat_pigment flat_normal flat_finish;
%type <keyword> texture_word flat_pattern flat_bumps flat_wave flat_turbulence flat_float;
flat_body:
	  flat_items
	| tiles texture_tail { $$ = list_join(list_one($1), $2); }
	| material_map texture_tail { $$ = list_join(list_one($1), $2); }
	;
flat_items:
	  texture_names
	| flat_items flat_item { $$ = list_add($1, $2); }
	;
flat_item:
	  texture_item
	| flat_pigment { $$ = flat_block(p, K_PIGMENT, @$, list_one($1)); }
	| KW_MARBLE { $$ = flat_ramp(p, $1, @$); }
	| KW_WOOD { $$ = flat_ramp(p, $1, @$); }
	| flat_normal { $$ = flat_block(p, K_NORMAL, @$, list_one($1)); }
	| flat_bumps float
		{ $$ = flat_block(p, K_NORMAL, @$, list_add(list_one(node_new(p, $1, @1, @1)),
			node_float(p, K_BUMP_SIZE, @2, @2, $2, @2))); }
	| flat_finish { $$ = flat_block(p, K_FINISH, @$, list_one($1)); }
	| full %prec ENDS { $$ = flat_number(p, (struct colour_value){ $1, NULL, true }, @$); }
	| full parts %prec ENDS { $$ = flat_number(p, (struct colour_value){ $1, $2, true }, @$); }
	;
flat_pigment:
	  marked_colour %prec ENDS { $$ = colour_node(p, colour_full(p, $1, @1), @1); }
	| flat_pattern { $$ = node_new(p, $1, @$, @1); }
	| KW_GRADIENT one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_CHECKER flat_checks { $$ = node_block(p, $1, @$, @1, $2); }
	| KW_HEXAGON flat_checks oc flat_check %prec ENDS
		{ $$ = node_block(p, $1, @$, @1, list_add($2, $4)); }
	| KW_IMAGE_MAP '{' image bitmap_options '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| KW_TURBULENCE one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| flat_turbulence float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_QUICK_COLOR five { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| color_map
	;
flat_pattern: KW_AGATE | KW_BOZO | KW_GRANITE | KW_LEOPARD | KW_ONION | KW_SPOTTED ;
flat_turbulence: KW_OCTAVES | KW_OMEGA | KW_LAMBDA ;
flat_check: five { $$ = node_number(p, K_LIST_ITEM, @$, @1, $1, @1); } ;
flat_checks: flat_check oc flat_check %prec ENDS { $$ = list_add(list_one($1), $3); } ;
flat_normal:
	  KW_BUMP_MAP '{' image bitmap_options '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| flat_wave float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	;
flat_bumps: KW_BUMPS | KW_DENTS | KW_RIPPLES | KW_WAVES | KW_WRINKLES ;
flat_wave: KW_FREQUENCY | KW_PHASE ;
flat_finish:
	  flat_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_METALLIC { $$ = node_new(p, $1, @$, @1); }
	| KW_AMBIENT float { $$ = node_number(p, $1, @$, @1, number_float($2), @2); }
	| KW_REFLECTION float { $$ = node_number(p, $1, @$, @1, number_float($2), @2); }
	| KW_IOR float { $$ = old_finish_node(p, $1, @$, @1, $2, @2); }
	| KW_REFRACTION float { $$ = old_finish_node(p, $1, @$, @1, $2, @2); }
	;
flat_float:
	  KW_BRILLIANCE | KW_CRAND | KW_DIFFUSE | KW_PHONG | KW_PHONG_SIZE | KW_ROUGHNESS | KW_SPECULAR
	;
textures:
	  %empty { $$ = list_none(); }
	| textures texture { $$ = list_add($1, $2); }
	;
material_map: KW_MATERIAL_MAP '{' image bitmap_options textures '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_join(list_one($3), $4), $5)); }
	;

pigment: KW_PIGMENT '{' pigment_body '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
pigment_body:
	  pigment_ref pigment_first pattern_modifiers { $$ = list_join(list_join($1, $2), $3); }
	| pigment_ref KW_UV_MAPPING pigment_body
		{ $$ = list_add($1, node_block(p, $2, @2, @2, $3)); }
	;
pigment_ref:
	  %empty { $$ = list_none(); }
	| T_PIGMENT { $$ = list_one(node_reference(p, $1, @1)); }
	;
pigment_first:
	  %empty { $$ = list_none(); }
	| marked_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| bare_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| pigment_special { $$ = list_one($1); }
	;
/* The same behind the value of a map entry, where an expression would be read as another value. */
pigment_entry:
	  pigment_ref pigment_entry_first pattern_modifiers
		{ $$ = list_join(list_join($1, $2), $3); }
	| pigment_ref KW_UV_MAPPING pigment_body
		{ $$ = list_add($1, node_block(p, $2, @2, @2, $3)); }
	;
pigment_entry_first:
	  %empty { $$ = list_none(); }
	| marked_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| pigment_special { $$ = list_one($1); }
	;
pigment_special:
	  pattern
	| KW_IMAGE_MAP '{' image bitmap_options '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| list_word pigment_list { $$ = node_block(p, $1, @$, @1, $2); }
	| KW_OBJECT '{' object transformations pigment_list '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_join(list_one($3), $4), $5)); }
	;
pigment_list:
	  %empty { $$ = list_none(); }
	| pigment_list pigment_list_item %prec ENDS { $$ = list_add($1, $2); }
	| pigment_list pigment_list_item ',' { $$ = list_add($1, $2); }
	;
pigment_list_item:
	  five { $$ = node_number(p, K_LIST_ITEM, @$, @1, $1, @1); }
	| pigment
	;

normal: KW_NORMAL '{' normal_body '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
normal_body:
	  pattern_modifiers
	| normal_pattern amount pattern_modifiers
		{ $$ = list_join(list_join(list_one($1), $2), $3); }
	| T_NORMAL amount pattern_modifiers
		{ $$ = list_join(list_join(list_one(node_reference(p, $1, @1)), $2), $3); }
	| T_NORMAL normal_pattern amount pattern_modifiers
		{ $$ = list_join(list_join(list_add(list_one(node_reference(p, $1, @1)), $2), $3), $4); }
	| KW_UV_MAPPING normal_body { $$ = list_one(node_block(p, $1, @1, @1, $2)); }
	| T_NORMAL KW_UV_MAPPING normal_body
		{ $$ = list_add(list_one(node_reference(p, $1, @1)), node_block(p, $2, @2, @2, $3)); }
	;
amount:
	  %empty { $$ = list_none(); }
	| float { $$ = list_one(node_float(p, K_BUMP_SIZE, @1, @1, $1, @1)); }
	| ',' float { $$ = list_one(node_float(p, K_BUMP_SIZE, @2, @2, $2, @2)); }
	;
normal_pattern:
	  pattern
	| normal_special
	;
normal_special:
	  KW_BUMP_MAP '{' image bitmap_options '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	| KW_FACETS { $$ = node_new(p, $1, @$, @1); }
	| list_word normal_list { $$ = node_block(p, $1, @$, @1, $2); }
	| KW_OBJECT '{' object transformations normal_list '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_join(list_one($3), $4), $5)); }
	;
normal_list:
	  %empty { $$ = list_none(); }
	| normal_list normal %prec ENDS { $$ = list_add($1, $2); }
	| normal_list normal ',' { $$ = list_add($1, $2); }
	;

density: KW_DENSITY '{' density_body '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
density_body:
	  density_ref density_first pattern_modifiers { $$ = list_join(list_join($1, $2), $3); }
	| density_ref KW_UV_MAPPING density_body
		{ $$ = list_add($1, node_block(p, $2, @2, @2, $3)); }
	;
density_ref:
	  %empty { $$ = list_none(); }
	| T_DENSITY { $$ = list_one(node_reference(p, $1, @1)); }
	;
density_first:
	  %empty { $$ = list_none(); }
	| marked_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| bare_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| density_special { $$ = list_one($1); }
	;
density_entry:
	  density_ref density_entry_first pattern_modifiers
		{ $$ = list_join(list_join($1, $2), $3); }
	| density_ref KW_UV_MAPPING density_body
		{ $$ = list_add($1, node_block(p, $2, @2, @2, $3)); }
	;
density_entry_first:
	  %empty { $$ = list_none(); }
	| marked_colour { $$ = list_one(colour_node(p, colour_full(p, $1, @1), @1)); }
	| density_special { $$ = list_one($1); }
	;
density_special:
	  pattern
	| list_word density_list { $$ = node_block(p, $1, @$, @1, $2); }
	| KW_OBJECT '{' object transformations density_list '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_join(list_one($3), $4), $5)); }
	;
density_list:
	  %empty { $$ = list_none(); }
	| density_list density %prec ENDS { $$ = list_add($1, $2); }
	| density_list density ',' { $$ = list_add($1, $2); }
	;
texture_list:
	  %empty { $$ = list_none(); }
	| texture_list texture %prec ENDS { $$ = list_add($1, $2); }
	| texture_list texture ',' { $$ = list_add($1, $2); }
	;

/* function { pattern { … } } */
pattern_body:
	  pattern pattern_modifiers { $$ = list_join(list_one($1), $2); }
	| list_word pattern_modifiers { $$ = list_join(list_one(node_new(p, $1, @1, @1)), $2); }
	| KW_FACETS pattern_modifiers { $$ = list_join(list_one(node_new(p, $1, @1, @1)), $2); }
	| KW_OBJECT '{' object transformations '}' pattern_modifiers
		{ $$ = list_join(list_one(node_block(p, $1, @1, @1,
			list_join(list_one($3), $4))), $6); }
	;

/* Patterns that every kind of block has. */
pattern:
	  plain_pattern { $$ = node_new(p, $1, @$, @1); }
	| float_pattern float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_GRADIENT one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_JULIA two { $$ = node_fit(p, $1, @$, @1, $2, "2f"); }
	| KW_MAGNET float KW_MANDEL float { $$ = magnet_node(p, @$, @1, $2, @2,
		node_float(p, $3, @3, @3, $4, @4)); }
	| KW_MAGNET float KW_JULIA two { $$ = magnet_node(p, @$, @1, $2, @2,
		node_fit(p, $3, @3, @3, $4, "2f")); }
	| KW_SLOPE one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_SLOPE '{' sums slope_items '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "vf?f?"); $$->children = $4.first; }
	| KW_SLOPE '{' KW_POINT_AT sums slope_items '}'
		{ $$ = node_fit(p, $1, @$, @1, $4, "vf?f?");
		  $$->children = list_join(list_one(node_new(p, $3, @3, @3)), $5).first; }
	| KW_DENSITY_FILE KW_DF3 string { $$ = node_string(p, $1, @$, @1, $3.raw, @3); }
	| pattern_function { $$ = node_function(p, K_FUNCTION, @$, @1, $1, @1); }
	| KW_PIGMENT_PATTERN '{' pigment_body '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| KW_IMAGE_PATTERN '{' image bitmap_options '}'
		{ $$ = node_block(p, $1, @$, @1, list_join(list_one($3), $4)); }
	;
plain_pattern:
	  KW_AGATE | KW_BOZO | KW_BOXED | KW_BUMPS | KW_CELLS | KW_CRACKLE | KW_CYLINDRICAL | KW_DENTS
	| KW_GRANITE | KW_LEOPARD | KW_MARBLE | KW_ONION | KW_PLANAR | KW_QUILTED | KW_RADIAL | KW_RIPPLES
	| KW_SPHERICAL | KW_SPOTTED | KW_WAVES | KW_WOOD | KW_WRINKLES | KW_AOI | KW_PAVEMENT | KW_AVERAGE
	;
float_pattern: KW_SPIRAL1 | KW_SPIRAL2 | KW_TILING | KW_MANDEL ;
list_word: KW_CHECKER | KW_BRICK | KW_HEXAGON | KW_SQUARE | KW_TRIANGULAR | KW_CUBIC ;
slope_items:
	  %empty { $$ = list_none(); }
	| slope_items slope_item { $$ = list_add($1, $2); }
	;
slope_item: KW_ALTITUDE sums { $$ = node_fit(p, $1, @$, @1, $2, "vf?f?"); } ;

image:
	  image_type string image_options
		{ $$ = node_string(p, $1, @$, @1, $2.raw, @2); $$->children = $3.first; }
	| string image_options
		{ $$ = node_string(p, K_IMAGE_FILE, @$, @1, $1.raw, @1); $$->children = $2.first; }
	| KW_FUNCTION two '{' { function_begin(p, args_height(p), false); } function_body '}'
		image_options
		{ args_push_function(p, $5, @5);
		  $$ = node_fit(p, K_FUNCTION, @$, @1, $2, "ffp"); $$->children = $7.first; }
	;
image_type:
	  KW_GIF | KW_TGA | KW_PNG | KW_JPEG | KW_TIFF | KW_BMP | KW_PPM | KW_PGM | KW_IFF | KW_POT | KW_SYS
	| KW_EXR | KW_HDR
	;
image_options:
	  %empty { $$ = list_none(); }
	| image_options image_option { $$ = list_add($1, $2); }
	;
image_option:
	  KW_GAMMA float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_GAMMA KW_SRGB { $$ = node_new(p, $1, @$, @1); }
	| KW_PREMULTIPLIED bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	;
bitmap_options:
	  %empty { $$ = list_none(); }
	| bitmap_options bitmap_item { $$ = list_add($1, $2); }
	;
bitmap_item:
	  bitmap_flag { $$ = node_new(p, $1, @$, @1); }
	| bitmap_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| bitmap_pair one { $$ = node_fit(p, $1, @$, @1, $2, "2"); }
	| share_word KW_ALL float
		{ $$ = node_float(p, $1, @$, @1, $3, @3);
		  $$->children = node_new(p, $2, @2, @2); }
	| share_word two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	;
bitmap_flag: KW_ONCE | KW_USE_COLOR | KW_USE_INDEX | KW_USE_ALPHA ;
bitmap_float: KW_MAP_TYPE | KW_INTERPOLATE | KW_BUMP_SIZE ;
bitmap_pair: KW_REPEAT | KW_OFFSET ;
share_word: KW_FILTER | KW_TRANSMIT ;

pattern_modifiers:
	  %empty { $$ = list_none(); }
	| pattern_modifiers modifier_item { $$ = list_add($1, $2); }
	;
modifier_item:
	  transformation
	| pattern_vector one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| pattern_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| pattern_flag { $$ = node_new(p, $1, @$, @1); }
	| KW_POLY_WAVE bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_EXTERIOR one { $$ = node_fit(p, $1, @$, @1, $2, "f"); }
	| KW_EXTERIOR two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	| KW_INTERIOR one { $$ = node_fit(p, $1, @$, @1, $2, "f"); }
	| KW_INTERIOR two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	| KW_QUICK_COLOR five_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| KW_WARP '{' warp '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| color_map
	| pigment_map
	| normal_map
	| slope_map
	| texture_map
	| density_map
	;
pattern_vector: KW_TURBULENCE | KW_BRICK_SIZE | KW_FORM | KW_METRIC ;
pattern_float:
	  KW_OCTAVES | KW_OMEGA | KW_LAMBDA | KW_FREQUENCY | KW_PHASE | KW_BUMP_SIZE | KW_ACCURACY
	| KW_NOISE_GENERATOR | KW_AGATE_TURB | KW_MORTAR | KW_CONTROL0 | KW_CONTROL1 | KW_INTERPOLATE
	| KW_OFFSET | KW_COORDS | KW_SIZE | KW_EXPONENT | KW_NUMBER_OF_SIDES | KW_NUMBER_OF_TILES
	| KW_PATTERN
	;
pattern_flag:
	  KW_RAMP_WAVE | KW_TRIANGLE_WAVE | KW_SINE_WAVE | KW_SCALLOP_WAVE | KW_CUBIC_WAVE
	| KW_NO_BUMP_SCALE | KW_SOLID
	;

%type <list> warp warp_items;
%type <node> warp_item;
%type <keyword> warp_shape warp_vector warp_float;
warp:
	  KW_TURBULENCE one warp_items
		{ $$ = list_join(list_one(node_fit(p, $1, @1, @1, $2, "v")), $3); }
	| KW_REPEAT one warp_items
		{ $$ = list_join(list_one(node_fit(p, $1, @1, @1, $2, "v")), $3); }
	| KW_BLACK_HOLE two warp_items
		{ $$ = list_join(list_one(node_fit(p, $1, @1, @1, $2, "vf")), $3); }
	| warp_shape warp_items { $$ = list_join(list_one(node_new(p, $1, @1, @1)), $2); }
	| KW_PLANAR { $$ = list_one(node_new(p, $1, @$, @1)); }
	| KW_PLANAR two { $$ = list_one(node_fit(p, $1, @$, @1, $2, "vf")); }
	| KW_CUBIC { $$ = list_one(node_new(p, $1, @$, @1)); }
	;
warp_shape: KW_CYLINDRICAL | KW_SPHERICAL | KW_TOROIDAL ;
warp_items:
	  %empty { $$ = list_none(); }
	| warp_items warp_item { $$ = list_add($1, $2); }
	;
warp_item:
	  warp_vector one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| warp_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_INVERSE { $$ = node_new(p, $1, @$, @1); }
	;
warp_vector: KW_OFFSET | KW_FLIP | KW_REPEAT | KW_TURBULENCE | KW_ORIENTATION ;
warp_float:
	  KW_OCTAVES | KW_OMEGA | KW_LAMBDA | KW_STRENGTH | KW_FALLOFF | KW_TYPE | KW_DIST_EXP
	| KW_MAJOR_RADIUS
	;

/* ---------------------------------------------------------------- maps */

%type <node> color_map pigment_map normal_map texture_map slope_map density_map;
%type <node> pigment_map_entry normal_map_entry texture_map_entry slope_map_entry density_map_entry;
%type <list> color_entries color_entry pigment_entries normal_entries texture_entries;
%type <list> slope_entries density_entries;

color_map:
	  KW_COLOR_MAP '{' T_COLOUR_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_COLOR_MAP '{' color_entries '}' { $$ = colour_map_node(p, @$, @1, $3); }
	;
color_entries:
	  color_entry
	| color_entries color_entry { $$ = list_join($1, $2); }
	;
color_entry:
	  '[' sums entry_colours ']' { $$ = colour_map_entry(p, @$, $2, $3); }
	| '[' sums ',' ']' { $$ = colour_map_entry(p, @$, $2, NULL); }
	| '[' sums ',' marked_colour ']'
		{ $$ = colour_map_entry(p, @$, $2, colour_pair(p, $4, NULL)); }
	;
entry_colours:
	  %empty { $$ = NULL; }
	| marked_colour %prec ENDS { $$ = colour_pair(p, $1, NULL); }
	| marked_colour worded_colour %prec ENDS { $$ = colour_pair(p, $1, &$2); }
	;
entry_values:
	  %empty { $$ = args_height(p); }
	| sums oc
	;
pigment_map:
	  KW_PIGMENT_MAP '{' T_PIGMENT_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_PIGMENT_MAP '{' pigment_entries '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
pigment_entries:
	  pigment_map_entry { $$ = list_one($1); }
	| pigment_entries pigment_map_entry { $$ = list_add($1, $2); }
	;
pigment_map_entry:
	  '[' entry_values pigment_entry ']' { $$ = map_entry(p, @$, $2, $3, true); }
	;
normal_map:
	  KW_NORMAL_MAP '{' T_NORMAL_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_NORMAL_MAP '{' normal_entries '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
normal_entries:
	  normal_map_entry { $$ = list_one($1); }
	| normal_entries normal_map_entry { $$ = list_add($1, $2); }
	;
normal_map_entry:
	  '[' entry_values normal_body ']' { $$ = map_entry(p, @$, $2, $3, false); }
	;
texture_map:
	  KW_TEXTURE_MAP '{' T_TEXTURE_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_TEXTURE_MAP '{' texture_entries '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
texture_entries:
	  texture_map_entry { $$ = list_one($1); }
	| texture_entries texture_map_entry { $$ = list_add($1, $2); }
	;
texture_map_entry:
	  '[' entry_values texture_body ']' { $$ = map_entry(p, @$, $2, $3, false); }
	;
density_map:
	  KW_DENSITY_MAP '{' T_DENSITY_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_DENSITY_MAP '{' density_entries '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
density_entries:
	  density_map_entry { $$ = list_one($1); }
	| density_entries density_map_entry { $$ = list_add($1, $2); }
	;
density_map_entry:
	  '[' entry_values density_entry ']' { $$ = map_entry(p, @$, $2, $3, true); }
	;
slope_map:
	  KW_SLOPE_MAP '{' T_SLOPE_MAP '}' { $$ = node_wrap(p, $1, @$, @1, $3, @3); }
	| KW_SLOPE_MAP '{' slope_entries '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
slope_entries:
	  slope_map_entry { $$ = list_one($1); }
	| slope_entries slope_map_entry { $$ = list_add($1, $2); }
	;
slope_map_entry:
	  '[' two ']' { $$ = slope_entry(p, @$, $2); }
	;

/* ---------------------------------------------------------------- finish */

%type <list> finish_items irid_items subsurface_items reflection_items albedo;
%type <node> finish_item irid_item subsurface_item reflection_item;
%type <keyword> finish_float finish_rgb finish_albedo subsurface_word old_finish;
%type <start> reflection_colours;

finish:
	  KW_FINISH '{' finish_items '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
finish_items:
	  %empty { $$ = list_none(); }
	| T_FINISH { $$ = list_one(node_reference(p, $1, @1)); }
	| finish_items finish_item { $$ = list_add($1, $2); }
	| finish_items KW_REFLECTION %prec ENDS { $$ = $1; } /* changes nothing */
	;
finish_item:
	  finish_rgb rgb_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| finish_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| finish_albedo albedo one
		{ $$ = node_fit(p, $1, @$, @1, $3, "f"); $$->children = $2.first; }
	| KW_DIFFUSE albedo one { $$ = node_fit(p, $1, @$, @1, $3, "f"); $$->children = $2.first; }
	| KW_DIFFUSE albedo two { $$ = node_fit(p, $1, @$, @1, $3, "ff"); $$->children = $2.first; }
	| KW_CONSERVE_ENERGY { $$ = node_new(p, $1, @$, @1); }
	| KW_METALLIC bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_REFLECTION rgb { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| KW_REFLECTION '{' reflection_colours reflection_items '}'
		{ $$ = node_args(p, $1, @$, @1, $3); $$->children = $4.first; }
	| KW_IRID '{' one irid_items '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "f"); $$->children = $4.first; }
	| KW_SUBSURFACE '{' subsurface_items '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| old_finish float { $$ = old_finish_node(p, $1, @$, @1, $2, @2); }
	;
finish_rgb: KW_AMBIENT | KW_EMISSION ;
finish_float: KW_BRILLIANCE | KW_CRAND | KW_PHONG_SIZE | KW_ROUGHNESS | KW_REFLECTION_EXPONENT ;
finish_albedo: KW_PHONG | KW_SPECULAR ;
old_finish: KW_IOR | KW_CAUSTICS | KW_REFRACTION ;
albedo:
	  %empty { $$ = list_none(); }
	| KW_ALBEDO { $$ = list_one(node_new(p, $1, @$, @1)); }
	;
reflection_colours:
	  %empty %prec ENDS { $$ = args_push_number(p, (struct number){ .terms = 5 }, @$); }
	| rgb %prec ENDS { $$ = args_push_number(p, $1, @1); }
	| ',' { $$ = args_push_number(p, (struct number){ .terms = 5 }, @1); }
	| ',' rgb
		{
			$$ = args_push_number(p, (struct number){ .terms = 5 }, @1);
			args_push_number(p, $2, @2);
		}
	| rgb ',' { $$ = args_push_number(p, $1, @1); }
	| rgb oc rgb { $$ = args_push_number(p, $1, @1); args_push_number(p, $3, @3); }
	;
reflection_items:
	  %empty { $$ = list_none(); }
	| reflection_items reflection_item { $$ = list_add($1, $2); }
	;
reflection_item:
	  KW_FRESNEL bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_METALLIC bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_FALLOFF float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_EXPONENT float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	;
irid_items:
	  %empty { $$ = list_none(); }
	| irid_items irid_item { $$ = list_add($1, $2); }
	;
irid_item:
	  KW_THICKNESS float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_TURBULENCE one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	;
subsurface_items:
	  %empty { $$ = list_none(); }
	| subsurface_items subsurface_item { $$ = list_add($1, $2); }
	;
subsurface_item: subsurface_word rgb_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); } ;
subsurface_word: KW_TRANSLUCENCY | KW_ANISOTROPY ;

/* ---------------------------------------------------------------- camera */

%type <node> camera camera_item;
%type <list> camera_items mesh_camera_items;
%type <keyword> camera_word camera_vector camera_float;

camera: KW_CAMERA '{' camera_items '}'
		{ $$ = node_block(p, $1, @$, @1, $3); camera_check(p, $3); }
	;
camera_items:
	  %empty { $$ = list_none(); }
	| T_CAMERA { $$ = list_one(node_reference(p, $1, @1)); }
	| camera_items camera_item { $$ = list_add($1, $2); }
	;
camera_item:
	  camera_word { $$ = node_new(p, $1, @$, @1); }
	| KW_CYLINDER float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_MESH_CAMERA '{' sums mesh_camera_items '}'
		{ $$ = node_fit(p, $1, @$, @1, $3, "fff?"); $$->children = $4.first; }
	| camera_vector one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| camera_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_ANGLE { $$ = node_new(p, $1, @$, @1); }
	| KW_ANGLE sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| KW_BLUR_SAMPLES sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| KW_BOKEH '{' pigment '}' { $$ = node_block(p, $1, @$, @1, list_one($3)); }
	| normal
	| transformation
	;
camera_word:
	  KW_PERSPECTIVE | KW_ORTHOGRAPHIC | KW_FISHEYE | KW_ULTRA_WIDE_ANGLE | KW_OMNIMAX | KW_PANORAMIC
	| KW_SPHERICAL
	;
camera_vector:
	  KW_LOCATION | KW_LOOK_AT | KW_SKY | KW_UP | KW_RIGHT | KW_DIRECTION | KW_FOCAL_POINT
	;
camera_float: KW_APERTURE | KW_CONFIDENCE | KW_VARIANCE ;
mesh_camera_items:
	  %empty { $$ = list_none(); }
	| mesh_camera_items object { $$ = list_add($1, $2); }
	| mesh_camera_items KW_SMOOTH { $$ = list_add($1, node_new(p, $2, @2, @2)); }
	;

/* ---------------------------------------------------------------- atmosphere, media, interior */

%type <node> fog fog_item rainbow rainbow_item sky_sphere sky_item media media_item scatter_item;
%type <node> interior interior_item material material_item;
%type <list> fog_items rainbow_items sky_items media_items scatter_items interior_items;
%type <list> material_items;
%type <keyword> fog_float rainbow_float media_float media_rgb interior_float;

fog: KW_FOG '{' fog_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
fog_items:
	  %empty { $$ = list_none(); }
	| T_FOG { $$ = list_one(node_reference(p, $1, @1)); }
	| fog_items fog_item { $$ = list_add($1, $2); }
	;
fog_item:
	  fog_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_TURBULENCE one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_UP one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| marked_colour %prec ENDS { $$ = colour_node(p, colour_full(p, $1, @1), @1); }
	| full %prec ENDS { $$ = fog_number(p, (struct colour_value){ $1, NULL, true }, @$); }
	| full parts %prec ENDS { $$ = fog_number(p, (struct colour_value){ $1, $2, true }, @$); }
	| transformation
	;
fog_float:
	  KW_DISTANCE | KW_FOG_TYPE | KW_FOG_OFFSET | KW_FOG_ALT | KW_TURB_DEPTH | KW_OCTAVES | KW_OMEGA
	| KW_LAMBDA
	;
rainbow: KW_RAINBOW '{' rainbow_items '}'
		{ $$ = node_block(p, $1, @$, @1, $3); rainbow_check(p, $$); }
	;
rainbow_items:
	  %empty { $$ = list_none(); }
	| T_RAINBOW { $$ = list_one(node_reference(p, $1, @1)); }
	| rainbow_items rainbow_item { $$ = list_add($1, $2); }
	;
rainbow_item:
	  rainbow_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_DIRECTION one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| KW_UP one { $$ = node_fit(p, $1, @$, @1, $2, "v"); }
	| color_map
	;
rainbow_float:
	  KW_ANGLE | KW_WIDTH | KW_DISTANCE | KW_JITTER | KW_ARC_ANGLE | KW_FALLOFF_ANGLE
	;
sky_sphere: KW_SKY_SPHERE '{' sky_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
sky_items:
	  %empty { $$ = list_none(); }
	| T_SKY_SPHERE { $$ = list_one(node_reference(p, $1, @1)); }
	| sky_items sky_item { $$ = list_add($1, $2); }
	;
sky_item:
	  pigment
	| KW_EMISSION rgb { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| transformation
	;
media: KW_MEDIA '{' media_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
media_items:
	  %empty { $$ = list_none(); }
	| T_MEDIA { $$ = list_one(node_reference(p, $1, @1)); }
	| media_items media_item { $$ = list_add($1, $2); }
	;
media_item:
	  media_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_SAMPLES sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| media_rgb rgb_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| KW_COLLECT bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_SCATTERING '{' one oc rgb_or_black scatter_items '}'
		{ args_push_number(p, $5, @5); $$ = node_fit(p, $1, @$, @1, $3, "fc");
		  $$->children = $6.first; }
	| density
	| transformation
	;
media_float:
	  KW_INTERVALS | KW_METHOD | KW_JITTER | KW_AA_THRESHOLD | KW_AA_LEVEL | KW_CONFIDENCE | KW_VARIANCE
	| KW_RATIO
	;
media_rgb: KW_ABSORPTION | KW_EMISSION ;
scatter_items:
	  %empty { $$ = list_none(); }
	| scatter_items scatter_item { $$ = list_add($1, $2); }
	;
scatter_item:
	  KW_ECCENTRICITY float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_EXTINCTION float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	;
interior: KW_INTERIOR '{' interior_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
interior_items:
	  %empty { $$ = list_none(); }
	| T_INTERIOR { $$ = list_one(node_reference(p, $1, @1)); }
	| interior_items interior_item { $$ = list_add($1, $2); }
	;
interior_item:
	  interior_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_FADE_COLOR rgb_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| media
	;
interior_float:
	  KW_IOR | KW_DISPERSION | KW_DISPERSION_SAMPLES | KW_CAUSTICS | KW_FADE_DISTANCE | KW_FADE_POWER
	| KW_REFRACTION
	;
material: KW_MATERIAL '{' material_items '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
material_items:
	  %empty { $$ = list_none(); }
	| T_MATERIAL { $$ = list_one(node_reference(p, $1, @1)); }
	| material_items material_item { $$ = list_add($1, $2); }
	;
material_item:
	  texture
	| KW_INTERIOR_TEXTURE '{' texture_body '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| interior
	| transformation
	;

/* ---------------------------------------------------------------- global settings */

%type <node> global_settings setting radiosity_setting photon_setting subsurface_setting charset;
%type <list> settings radiosity_settings photon_settings subsurface_settings;
%type <keyword> setting_float setting_rgb radiosity_float photon_float charset_word file_word;

global_settings: KW_GLOBAL_SETTINGS '{' settings '}' { $$ = node_block(p, $1, @$, @1, $3); } ;
settings:
	  %empty { $$ = list_none(); }
	| settings setting { $$ = list_add($1, $2); }
	;
setting:
	  KW_ASSUMED_GAMMA float
		{ $$ = node_float(p, $1, @$, @1, $2, @2); set_gamma(p, (float)$2, @2); }
	| KW_ASSUMED_GAMMA KW_SRGB { $$ = node_new(p, $1, @$, @1); set_gamma(p, -1, @2); }
	| KW_NOISE_GENERATOR float
		{ $$ = node_float(p, $1, @$, @1, $2, @2); set_noise(p, $2, @2); }
	| setting_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| setting_rgb rgb_or_black { $$ = node_number(p, $1, @$, @1, $2, @2); }
	| KW_CHARSET charset { $$ = node_block(p, $1, @$, @1, list_one($2)); set_charset(p, $2); }
	| KW_HF_GRAY_16 bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	| KW_SUBSURFACE '{' subsurface_settings '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| KW_RADIOSITY '{' radiosity_settings '}' { $$ = node_block(p, $1, @$, @1, $3); }
	| KW_PHOTONS '{' photon_settings '}' { $$ = node_block(p, $1, @$, @1, $3); }
	;
setting_float:
	  KW_ADC_BAILOUT | KW_MAX_TRACE_LEVEL | KW_MAX_INTERSECTIONS | KW_NUMBER_OF_WAVES | KW_MM_PER_UNIT
	;
setting_rgb: KW_AMBIENT_LIGHT | KW_IRID_WAVELENGTH ;
charset: charset_word { $$ = node_new(p, $1, @$, @1); } ;
charset_word: KW_ASCII | KW_UTF8 | KW_SYS ;
subsurface_settings:
	  %empty { $$ = list_none(); }
	| subsurface_settings subsurface_setting { $$ = list_add($1, $2); }
	;
subsurface_setting:
	  KW_SAMPLES two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	| KW_RADIOSITY bool { $$ = node_fit(p, $1, @$, @1, $2, "f?"); }
	;
radiosity_settings:
	  %empty { $$ = list_none(); }
	| radiosity_settings radiosity_setting { $$ = list_add($1, $2); }
	;
radiosity_setting:
	  KW_COUNT sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| KW_NEAREST_COUNT sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| radiosity_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| file_word string { $$ = node_string(p, $1, @$, @1, $2.raw, @2); }
	;
radiosity_float:
	  KW_ERROR_BOUND | KW_LOW_ERROR_FACTOR | KW_MINIMUM_REUSE | KW_MAXIMUM_REUSE | KW_RECURSION_LIMIT
	| KW_BRIGHTNESS | KW_GRAY_THRESHOLD | KW_PRETRACE_START | KW_PRETRACE_END | KW_ADC_BAILOUT
	| KW_MAX_SAMPLE | KW_ALWAYS_SAMPLE | KW_NORMAL | KW_MEDIA | KW_SUBSURFACE
	;
file_word: KW_LOAD_FILE | KW_SAVE_FILE ;
photon_settings:
	  %empty { $$ = list_none(); }
	| photon_settings photon_setting { $$ = list_add($1, $2); }
	;
photon_setting:
	  photon_float float { $$ = node_float(p, $1, @$, @1, $2, @2); }
	| KW_GATHER two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	| KW_EXPAND_THRESHOLDS two { $$ = node_fit(p, $1, @$, @1, $2, "ff"); }
	| KW_RADIUS { $$ = node_new(p, $1, @$, @1); }
	| KW_RADIUS sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?f?f?"); }
	| KW_MEDIA sums { $$ = node_fit(p, $1, @$, @1, $2, "ff?"); }
	| file_word string { $$ = node_string(p, $1, @$, @1, $2.raw, @2); }
	;
photon_float:
	  KW_SPACING | KW_COUNT | KW_AUTOSTOP | KW_JITTER | KW_MAX_TRACE_LEVEL | KW_ADC_BAILOUT
	;

%%

const char *token_words(int token)
{
	return yysymbol_name(YYTRANSLATE(token));
}

bool wanted_token(const struct wanted *wanted, int token)
{
	return wanted->symbols[YYTRANSLATE(token)];
}

/* Says what would have been right, in words if those are few. */
static int yyreport_syntax_error(const yypcontext_t *context, struct parser *p, struct run *run)
{
	enum { FEW = 4 };
	yysymbol_kind_t expected[YYNTOKENS];
	bool symbols[YYNTOKENS] = { false };
	struct wanted wanted = { .symbols = symbols };
	const int n = yypcontext_expected_tokens(context, expected, YYNTOKENS);
	for (int i = 0; i < n; i++) {
		const char *name = yysymbol_name(expected[i]);
		symbols[expected[i]] = true;
		if (n <= FEW)
			wanted.list = i == 0 ? name
					     : arena_printf(p->arena, "%s%s%s", wanted.list,
						       i + 1 < n ? ", " : " or ", name);
	}
	syntax_error(p, run, &wanted);
	return 0;
}
