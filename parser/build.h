/* SPDX-License-Identifier: MIT */
/*
 * What the grammar's actions call: building nodes, values and functions. Seen by
 * grammar.y and its helper files only.
 *
 * Arguments of statements are collected on a stack of the parse (struct
 * grammar); a list in the grammar is the height of the stack where it began.
 */
#ifndef LAMBERT_PARSER_BUILD_H
#define LAMBERT_PARSER_BUILD_H

#include "internal.h"
#include "quick.h"

/* -- Semantic values (all fit the 64 bytes of a number with a companion) ------------------ */

struct number_value {
	struct number number;
	struct symbol *symbol; /* an identifier alone, else NULL */
	enum keyword keyword;  /* a constant like true, else K_NONE */
};

enum { FUNCTION_PARAMETERS_MAX = 56 };

/* A string, and how it reads where a file name is expected (backslashes kept). */
struct text_value {
	const char *text, *raw;
};

struct reference {
	const struct node *node;
	const char *name;
};

struct callee {
	const struct function *function;
	const char *name;
};

struct node_list {
	struct node *first, *last;
};

/* Inside the braces of an object: arguments from `start`, items. */
struct body {
	size_t start;
	struct node_list items;
	bool has_bare_font; /* the first argument is a string without a word before it */
};

/* `red F` and the like behind (or instead of) a colour expression. */
struct colour_parts {
	bool set[5];
	double value[5];
};

struct colour_value {
	struct number number;		  /* as written: 1 to 5 terms */
	const struct colour_parts *parts; /* NULL: none */
	bool words;			  /* there is something besides the parts */
};

/* The two colours an entry of a color_map may have. */
struct colour_pair {
	struct colour_value colours[2];
	unsigned count;
};

/* A growing array of numbers. */
struct doubles {
	double *values;
	size_t count, capacity;
	unsigned stride;
	double *extra;	   /* texture indices of mesh2 faces, as many as values; NULL: none */
	unsigned textures; /* of the last face */
};

/* The items of a mesh; plain faces in a row are collected in one array. */
struct mesh_items {
	struct node_list items;
	struct doubles run;
	struct node *run_node; /* the face the run belongs to, and its argument */
	struct arg *run_arg;
};

/* What stands between the braces of an array: values, or braces again. */
struct elements;
struct element {
	struct value value;
	const struct elements *inner; /* NULL: a value */
	span where;
};
struct elements {
	struct element *items;
	size_t count, capacity;
};

/* One run of the grammar; nested parses have one each. */
struct opening {
	int token;
	span where, word;
	enum keyword keyword; /* the word before the bracket, K_NONE: none */
};
struct queued {
	int token;
	span where;
	struct token_value value;
};
struct run {
	int start; /* the start token, 0 once it was delivered */
	int start_token;
	struct queued present;
	const struct queued *last; /* the token delivered last, NULL: none */
	size_t base;		   /* of its openings in those of the grammar */
	size_t depth;		   /* open brackets */
	unsigned braces;
	bool closed;		  /* the last token closed the opening that was at `depth` */
	enum quick_place next;	  /* whether the next token may begin a number */
	unsigned items;		  /* enum quick_items that may begin there */
	enum keyword word;	  /* the last token, if it was a keyword that is no value */
	enum keyword word_before; /* and the one before it */
	int token_before;	  /* the token before the last … */
	span where_before;	  /* … and its place */
	span word_span;
	/* The result. */
	bool accepted;
	struct value value;
	span where; /* of an expression */
	struct text_value text;
	struct node_list list;
};

/* The grammar's state of one parse of a scene. */
struct function_scope;
struct grammar {
	struct arg *args;
	size_t arg_count, arg_capacity;
	struct opening *openings; /* open brackets of all runs */
	size_t opening_top, opening_capacity;
	unsigned nested;	     /* runs within runs */
	struct node_list statements; /* of the scene, those handed over apart */
	struct function_scope *scope;
};
struct grammar *grammar_state(struct parser *);

/* -- ast.c: nodes ------------------------------------------------------------------------- */

size_t args_push_number(struct parser *, struct number, span);
size_t args_push_string(struct parser *, const char *, span);
size_t args_push_function(struct parser *, const struct function *, span);
size_t args_push_array(struct parser *, const double *, size_t count, unsigned stride, span);
size_t args_height(struct parser *);

struct node *node_new(struct parser *, enum keyword, span whole, span word);
/* Takes the arguments from `start` up. */
struct node *node_args(struct parser *, enum keyword, span whole, span word, size_t start);
struct node *node_number(struct parser *, enum keyword, span whole, span word, struct number, span);
struct node *node_float(struct parser *, enum keyword, span whole, span word, double, span);
struct node *node_string(struct parser *, enum keyword, span whole, span word, const char *, span);
struct node *node_function(
	struct parser *, enum keyword, span whole, span word, const struct function *, span);
struct node *node_block(struct parser *, enum keyword, span whole, span word, struct node_list);
struct node *node_reference(struct parser *, struct reference, span);
/* A declared value is used here, which uses others in turn: not too deeply. */
void reference_count_levels(struct parser *, const void *declared, span);
/* A block that holds nothing but an identifier. */
struct node *node_wrap(
	struct parser *, enum keyword, span whole, span word, struct reference, span);
struct node_list list_one(struct node *);
struct node_list list_add(struct node_list, struct node *);
struct node_list list_join(struct node_list, struct node_list);

struct node_list list_none(void);
/* Adds to the statements of the scene, which may be handed over on this occasion; `ahead`: a token
 * behind the statement has been read. */
void scene_add(struct parser *, struct node *, bool ahead);
/* Adds to the members of a compound, in the same way. */
struct node_list member_add(
	struct parser *, const struct run *, struct node_list, struct node *, bool ahead);
/* The arguments from `start` up, checked: one letter each, f float, v 3-vector, 2, 4 vectors, c
 * colour, p function, s string; a ? behind a letter: may be missing. */
struct node *node_fit(
	struct parser *, enum keyword, span whole, span word, size_t start, const char *letters);
/* Layers of a texture: the texture itself if there is one. */
struct node *layers_node(struct parser *, struct node_list, span);
/* `sphere { S mods }`: a copy of S, whatever the keyword. */
struct node *copy_node(
	struct parser *, struct reference, span at, span whole, span word, struct node_list);

/* -- statement.c: statements that need more than a node ----------------------------------- */

void camera_check(struct parser *, struct node_list);
struct node *node_matrix(struct parser *, span whole, span word, size_t start);
struct node *magnet_node(
	struct parser *, span whole, span word, double type, span at, struct node *kind);
struct node *parametric_node(struct parser *, span whole, span word,
	const struct function *const functions[3], const span at[3], size_t start,
	struct node_list);
struct node *old_finish_node(
	struct parser *, enum keyword, span whole, span word, double value, span);
struct node *old_colour(struct parser *, struct colour_value, span);
struct node *old_named_colour(struct parser *, struct number_value, span);
struct node *fog_number(struct parser *, struct colour_value, span);
void rainbow_check(struct parser *, const struct node *);
void default_add(struct parser *, struct node *);
void set_gamma(struct parser *, float, span);
void set_noise(struct parser *, double, span);
void set_charset(struct parser *, const struct node *);

/* -- flat.c ------------------------------------------------------------------------------- */

/* An item of a pigment, normal or finish that stands in the texture itself. */
struct node *flat_block(struct parser *, enum keyword block, span whole, struct node_list items);
struct node *flat_ramp(struct parser *, enum keyword pattern, span);
/* A float alone is crand, anything else the colour of the pigment. */
struct node *flat_number(struct parser *, struct colour_value, span);

/* -- shape.c ------------------------------------------------------------------------------ */

/* Primitives: the arguments are checked against a table. */
struct node *shape_node(struct parser *, enum keyword, span whole, span word, struct body);
/* Refuses items like `sturm` where they mean nothing. */
void shape_check_items(struct parser *, const struct node *);
struct body body_add(struct body, struct node *);
/* Refuses a comma before the first argument. */
void body_comma(struct parser *, struct body, span);
struct body body_string(struct parser *, struct body, const char *text, span);
struct node *shape_coefficients(struct parser *, enum keyword, span whole, span word, size_t start,
	span at, struct node_list);
/* The same tree from the terms that are not zero: xyz(i, j, k): coefficient. */
struct node *shape_terms(struct parser *, span whole, span word, size_t start,
	struct node_list terms, struct node_list items);

/* -- mesh.c ------------------------------------------------------------------------------- */

struct node *mesh_face(
	struct parser *, enum keyword, span whole, span word, size_t start, struct node_list tail);
struct mesh_items *mesh_items_new(struct parser *);
struct mesh_items *mesh_add(struct mesh_items *, struct node *);
struct mesh_items *mesh_add_face(
	struct parser *, struct mesh_items *, enum keyword, span word, span last, size_t start);
struct doubles *doubles_new(struct parser *, double expected, unsigned stride);
void doubles_add(struct parser *, struct doubles *, struct number, span);
/* A face of a mesh2 (a vector) or a texture index behind it (one term). */
void doubles_face(struct parser *, struct doubles *, struct number, span);
/* Reads the plain vectors that follow. */
void doubles_add_rows(struct parser *, struct doubles *);
void doubles_face_rows(struct parser *, struct doubles *);
struct node *mesh2_list(struct parser *, enum keyword, span whole, span word, double declared,
	span count_span, const struct doubles *, unsigned stride);
struct node *mesh2_node(struct parser *, struct node_list, span whole, span word);

/* -- number.c ----------------------------------------------------------------------------- */

struct number number_float(double);
struct number number_vector(double x, double y, double z);
/* The unit vector that x, y, z, u, v or t is. */
struct number number_axis(enum keyword);
struct number number_negate(struct number);
struct number number_not(struct number);
/* `op`: the operator's token. */
struct number number_binary(struct parser *, int op, struct number, struct number, span);
enum { COMPONENT_GRAY = 5 };
/* 0 to 4, or COMPONENT_GRAY, of a word like x, u, red or gray. */
unsigned component_index(enum keyword);
struct number number_select(struct parser *, struct number, enum keyword component, span);
/* A vector literal from the arguments above `start`. */
struct number number_literal(struct parser *, size_t start, span);
/* Conversions to what a place wants; an error is reported and a usable value returned. */
double number_to_float(struct parser *, struct number, span);
/* `keep` leaves the terms as written and only checks. */
void number_to_vector(struct parser *, struct number, unsigned terms, span, double out[5]);
struct number number_check(struct parser *, struct number, unsigned terms, span);
/* Without leftover: what a full expression, a group or a #declare yields. */
struct number number_plain(struct number);
int number_truncate(double);
bool number_is_true(struct parser *, struct number, span);

/* -- colour.c ----------------------------------------------------------------------------- */

struct number colour_word(struct parser *, enum keyword, struct number, span);
struct colour_value colour_black(void);
struct colour_parts *colour_part(
	struct parser *, struct colour_parts *, enum keyword, double value, span word);
/* To five terms rounded to float. */
struct number colour_full(struct parser *, struct colour_value, span);
struct number colour_rgb_only(struct parser *, struct colour_value, span);
/* Refuses what is no colour: the place wants the word color or rgb. */
struct colour_value colour_bare(struct parser *, struct colour_value, span);
struct node *colour_node(struct parser *, struct number, span);
struct node *colour_map_node(struct parser *, span whole, span word, struct node_list);
struct colour_pair *colour_pair(struct parser *, struct colour_value, const struct colour_value *);
struct node_list colour_map_entry(
	struct parser *, span whole, size_t start, const struct colour_pair *);
struct node *slope_entry(struct parser *, span whole, size_t start);
struct node *map_entry(struct parser *, span whole, size_t start, struct node_list, bool colours);

/* -- text.c ------------------------------------------------------------------------------- */

struct text_value text_both(const char *);
/* The arguments of a concat, and what they make. */
struct texts *texts_new(struct parser *);
struct texts *texts_add(struct parser *, struct texts *, struct text_value);
struct text_value text_concat(struct parser *, const struct texts *, span);
const char *text_str(struct parser *, double, double length, double precision);
const char *text_vstr(struct parser *, double n, struct number, const char *between, double length,
	double precision, span);
const char *text_chr(struct parser *, double, span);
const char *text_substr(struct parser *, const char *, double first, double count, span);
const char *text_case(struct parser *, const char *, bool upper, span);
const char *text_datetime(struct parser *, double, const char *format, span);
double text_length(struct parser *, const char *);
double text_asc(const char *);
double text_compare(const char *, const char *);
struct number text_relation(int op, const char *, const char *);
double text_val(const char *);

/* -- builtin.c ---------------------------------------------------------------------------- */

/* Whether a call has a right number of arguments; if not an error is reported. */
bool arguments_fit(
	struct parser *, const char *name, size_t found, size_t least, size_t most, span);
bool builtin_fits(struct parser *, enum keyword, size_t found, span);
/* A float function of one argument. */
struct number builtin_float(struct parser *, enum keyword, struct number, span);
/* Functions whose arguments are on the stack. */
struct number builtin_list(struct parser *, enum keyword, size_t start, span);
struct number builtin_extent(struct parser *, enum keyword, struct reference, span);
struct number builtin_inside(struct parser *, struct reference, struct number, span);
struct number builtin_trace(struct parser *, struct reference, struct number origin,
	struct number direction, struct symbol *normal, span);
struct number builtin_dimensions(struct parser *, const struct symbol *, span);
struct number builtin_dimension_size(struct parser *, const struct symbol *, double, span);
struct number builtin_file_exists(struct parser *, const char *, span);
struct number builtin_call(struct parser *, struct callee, size_t start, span);

/* -- spline.c ----------------------------------------------------------------------------- */

/* Keys and values are on the stack, alternating. */
const struct spline *spline_build(
	struct parser *, const struct spline *base, enum keyword type, size_t start, span);
void spline_entry(struct parser *, double key, span, struct number, span);
struct number spline_call(
	struct parser *, const struct spline *, enum keyword type, double at, span);

/* -- function.c --------------------------------------------------------------------------- */

/* Opens the scope of a function body; the parameter names are string arguments from `start`. */
void function_begin(struct parser *, size_t start, bool listed);
const struct function *function_end(
	struct parser *, const struct expr *, span, struct node *, int internal);
const struct function *function_from_spline(struct parser *, const struct spline *, span);
unsigned function_terms(const struct function *);
void function_loop_begin(struct parser *, const char *name, span);
const struct expr *function_loop_end(struct parser *, enum keyword, const struct expr *from,
	const struct expr *to, const struct expr *body, span);
const struct expr *expr_number(struct parser *, struct number_value, span);
const struct expr *expr_name(struct parser *, const char *, span);
const struct expr *expr_axis(struct parser *, enum keyword, span);
const struct expr *expr_unary(struct parser *, enum expr_kind, const struct expr *, span);
/* The member named by a word that is not reserved: `hf`. */
enum keyword member_hf(struct parser *, const char *, span);
const struct expr *expr_binary(
	struct parser *, enum expr_kind, const struct expr *, const struct expr *, span);
const struct expr *expr_group(struct parser *, const struct expr *, span);

/* Arguments of a call. */
struct expr_list {
	const struct expr **items;
	size_t count, capacity;
};
struct expr_list *expr_list_add(struct parser *, struct expr_list *, const struct expr *);
const struct expr *expr_builtin(struct parser *, enum keyword, const struct expr_list *, span);
const struct expr *expr_call(
	struct parser *, struct callee, const struct expr_list *, enum keyword component, span);

/* -- values ------------------------------------------------------------------------------- */

struct value value_number(struct number);
struct value value_colour(struct number);
struct value value_string(const char *);
struct value value_node(int token, const struct node *);
struct value value_function(const struct function *);
struct value value_spline(const struct spline *);
struct value value_of_symbol(struct parser *, struct symbol *, span);
struct value value_array(struct parser *, size_t start, span dims, const struct elements *, span);
struct elements *elements_new(struct parser *);
void elements_add(struct parser *, struct elements *, struct value, span);
void elements_add_inner(struct parser *, struct elements *, const struct elements *, span);

/* -- scan.c ------------------------------------------------------------------------------- */

/* Ends a run; the token that was read ahead, if any, goes back to the directive layer. */
void run_accept(struct parser *, struct run *, bool ahead);
/* The last token, for messages: what was read whole is taken back and its first token read. */
const struct queued *run_unfold(struct parser *, struct run *);
/* How the text calls the thing a token stands for, NULL: not by a name. */
const char *token_name(const struct token_value *);

/* -- grammar.y ---------------------------------------------------------------------------- */

/* What the grammar could go on with at an error. */
struct wanted {
	const char *list;    /* in words, NULL: too much */
	const bool *symbols; /* by the grammar's number of a terminal */
};
bool wanted_token(const struct wanted *, int token);
/* A terminal in plain words. */
const char *token_words(int token);

/* -- syntax.c ----------------------------------------------------------------------------- */

/* Reports what is wrong at the last token. */
void syntax_error(struct parser *, struct run *, const struct wanted *);
/* Whether a token ends something that an operator could follow. */
bool ends_operand(int token);
/* hint.c: notes what would be right instead of the last token, if one can guess. `open`: the bracket it
 * stands in, or NULL. */
bool note_hint(struct parser *, const struct run *, const struct opening *open);
bool is_axis(enum keyword);
bool is_colour_word(enum keyword);

/* hint_values.c: notes that a '-' or '+' among the values was read as an operator, if it looks like a
 * sign; of a span, and of the arguments from `start`. */
void note_sign(struct parser *, span values);
void note_sign_in(struct parser *, size_t start);
/* Notes how a row of numbers, in which or behind which `where` stands, is written as a vector. */
bool note_row(struct parser *, span where);
/* The same where the first of too many arguments are three floats. */
void note_point(struct parser *, const struct arg *args, size_t count);
/* The first token behind an opening bracket of the present text, or NULL. */
const struct raw_token *raw_inside(struct parser *, const struct opening *);

#endif
