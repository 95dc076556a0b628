/* SPDX-License-Identifier: MIT */
/*
 * Inside the directive layer: the stack of texts being read, the open blocks,
 * the gate, and what its files offer to one another.
 */
#ifndef LAMBERT_PARSER_EXPAND_H
#define LAMBERT_PARSER_EXPAND_H

#include "internal.h"
#include "source.h"
#include "symbol.h"

#include "base/epsilon.h"

enum {
	MAX_BLOCKS = 199,
	MAX_FILES = 32,
	MAX_PARAMETERS = 55,
	MAX_UNREAD = 16,
	MAX_NESTING = 1000,
};

/* A piece of text being read: a file or the body of a macro. */
struct frame {
	struct source *source;
	const struct raw_token *tokens;
	uint32_t position, end;
	uint32_t site;
	bool is_macro;
	unsigned blocks; /* open when it began */
	span call;	 /* the #include or macro call */
	/* The first of the objects that begin between these tokens has something in it that the short
	 * way leaves to the grammar, and the last is where. */
	uint32_t failed_from, failed_to;
};

enum block_kind {
	BLOCK_IF,     /* in a branch that is taken */
	BLOCK_ELSE,   /* in a taken #else */
	BLOCK_SWITCH, /* no case has matched yet */
	BLOCK_CASE,   /* a case has matched */
	BLOCK_WHILE,
	BLOCK_FOR,
	BLOCK_MACRO, /* a running macro: the frame on top of it */
};

struct block {
	enum block_kind kind;
	unsigned frame; /* number of the frame it began in */
	uint32_t start; /* loops: the token after the directive, or of the body */
	uint32_t end;	/* token of the #end, NO_TOKEN: not in this text */
	span opened;
	enum keyword opener;
	double value;	 /* of a switch */
	uint32_t name;	 /* #for: its variable */
	double to, step; /* #for */
};

/* Decides whether directives and macros are executed when the next token is fetched (live) or come
 * back as tokens (held). While an expression is read whose end only the next token shows, what
 * follows a complete operand is held: it must not happen before the expression is used. */
struct gate {
	struct gate *outer;
	bool hold;		     /* held behind operands at depth 0; else always live */
	bool operand;		     /* a complete operand precedes */
	bool dot;		     /* a period precedes */
	unsigned depth;		     /* open brackets */
	unsigned parentheses;	     /* of them: ( */
	uint64_t angles;	     /* one bit per bracket, innermost lowest: it is '<' */
	unsigned delivered;	     /* tokens */
	int first;		     /* the first token … */
	struct value *slot;	     /* … and, for an identifier, where its value is */
	const struct symbol *symbol; /* whose value that is */
	unsigned table;		     /* and in which symbol table */
};

struct macro {
	uint32_t name;
	struct source *source;
	uint32_t start, end; /* of the body */
	unsigned parameter_count;
	uint32_t *parameters; /* name ids */
	const char *context;  /* for messages */
	span last_call;	      /* and the site made for it: loops call from one place */
	uint32_t last_site;
};

/* What a macro is called with. */
struct argument {
	struct value value;
	struct value *slot;	     /* stands for this variable of the caller; NULL: by value */
	const struct symbol *symbol; /* that variable */
};

struct unread {
	int token;
	span where;
	unsigned frame; /* number of frames when it was handed back */
	struct token_value value;
};

/* Where the statement that is being read at the top level of the scene began, see recover.c. */
struct statement_start {
	unsigned frames;   /* up to the file it stands in */
	unsigned began_in; /* and up to the macro that its first token comes from */
	uint32_t position; /* in that file: its first token, or behind the call of the macro */
	unsigned blocks;   /* open before it */
	bool skippable;
};

/* Text on its way to a stream, until its line is complete. */
struct text_line {
	char *bytes;
	size_t length, room;
};

struct scene_file;

struct expand {
	struct names names;
	struct symbols symbols;
	struct source *sources; /* all read, newest first */
	/* Frame 0 is the main file. */
	struct frame frames[MAX_FILES + SYMBOL_TABLES];
	unsigned frame_count, file_count;
	struct block blocks[MAX_BLOCKS];
	unsigned block_count;
	struct gate *gate, scene_gate;
	struct gate before; /* the gate as it was before the latest token */
	struct unread unread[MAX_UNREAD];
	unsigned unread_count;
	unsigned nesting; /* of fetches within fetches */
	struct statement_start statement;
	unsigned recoveries;
	size_t work;	   /* raw tokens read */
	size_t site_count; /* of calls of macros */
	struct text_line debug_line;
	bool has_written;	     /* the scene wrote a file, which it may include later */
	struct scene_file *files;    /* all opened, newest first */
	struct hidden_names *hidden; /* by the parameters of functions being read */
};

/* -- expand.c, raw.c, gate.c -- */

struct expand *expand_create(struct parser *);
void expand_destroy(struct expand *);
/* Begins to read a text; false after an error. */
bool expand_push_file(struct parser *, struct source *, span call);
/* Goes back to the text that led to the present one, which is at its end. False: there is none,
 * or an error. */
bool expand_leave_frame(struct parser *);

/* Between gate_open and gate_close tokens are counted and held by the gate given. */
void gate_open(struct parser *, struct gate *, bool hold);
void gate_close(struct parser *);
/* Whether directives and macros wait. */
bool gate_holds(const struct gate *);
/* Accounts for a token on its way to the grammar. */
void gate_note(struct gate *, int token, const struct token_value *);

/* The text being read. */
static inline struct frame *top_frame(struct expand *x)
{
	return &x->frames[x->frame_count - 1];
}
/* Whether a token that was handed back comes before the raw ones. */
static inline bool has_read_ahead(const struct expand *x)
{
	return x->unread_count && x->unread[x->unread_count - 1].frame >= x->frame_count;
}
/* Runs the directives and macro calls before the next token, as fetching it would; false if there are
 * none. */
bool expand_settle(struct parser *);
/* Goes on to the next piece of the text at the end of the present one; false at the end of the text. */
bool next_piece(struct expand *);
/* Lexes the present text to its end, for who has to look further than what is read next. */
void complete_text(struct expand *);
/* The next raw token as it stands, behind the ends of macros; NULL at the end of a file. */
const struct raw_token *raw_peek_at_end(struct parser *);
static inline const struct raw_token *raw_peek(struct parser *p)
{
	const struct frame *f = top_frame(p->expand);
	const bool plain =
		!p->failed && f->position < f->end && f->tokens[f->position].kind != RAW_ERROR;
	return plain ? &f->tokens[f->position] : raw_peek_at_end(p);
}
/* Steps over the raw token that raw_peek returned. */
static inline void raw_step(struct parser *p)
{
	top_frame(p->expand)->position++;
	p->expand->work++;
}
/* The same; its span. */
span raw_take(struct parser *);
/* Span of the raw token that raw_peek returns. */
span raw_span(struct parser *);
/* Span of a token of the present text. */
span raw_span_at(struct parser *, const struct raw_token *);
/* The text that a place is in; NULL: no place. */
const struct source *source_at(const struct expand *, span where);
/* The token `steps` before the one at a place; NULL: there is none, or it is in another text. */
const struct raw_token *raw_before(struct parser *, span where, unsigned steps);
/* The place to point at when something is missing before `where`: behind the token before if that is
 * on another line. */
span raw_gap_before(struct parser *, span where);
/* Span of a token of a text. */
span raw_span_of(const struct expand *, const struct frame *, struct raw_token);
/* The place behind the last token of a text. */
span raw_end_span(const struct frame *);
/* Length of the word that begins here; 0: none does. */
size_t raw_word_length(const char *text);
/* Says what the lexer stopped at. */
void raw_report_lexical(struct parser *, const struct frame *);
/* Words for a raw token in a message. */
const char *raw_describe(struct parser *, const struct raw_token *);
/* The value of a word like pi, clock or true; false: it is none. */
bool constant_value(struct parser *, enum keyword, double *value);
/* Takes the raw token if it is of that kind (and, for keywords, that payload). */
bool raw_accept(struct parser *, unsigned kind);
bool raw_accept_keyword(struct parser *, enum keyword);
/* Takes a name that is not reserved; false after an error, which says what it is for. */
bool raw_name(struct parser *, const char *what, uint32_t *name, span *);
/* Takes a string literal of the raw token stream. */
const char *raw_string(struct parser *, bool escapes);

/* The next token must be `token`; false after an error. */
bool expect(struct parser *, int token, const char *what);
/* Takes the next token if it is `token`. */
bool accept(struct parser *, int token);
/* Words for a token in a message. */
const char *token_describe(struct parser *, int token, const struct token_value *);

/* Writes a code as UTF-8, three bytes at most, and returns where it ends; one beyond U+FFFF is
 * replaced. */
char *string_put_code(char *out, uint32_t code);

/* Text of a string literal: escapes processed, charset applied. */
const char *string_literal(struct parser *, const char *text, size_t length, span, bool escapes);

/* The same if that needs neither escapes nor a charset; NULL: it does. */
const char *string_plain(struct parser *, const char *text, size_t length);

/* A string as one byte per code, for files and messages: codes above 127 become spaces, below version
 * 3.5 their lower byte. */
const char *string_bytes(struct parser *, const char *text);

/* -- the files of the directives: each returns false after an error -- */

/* directive.c: the directive at the present position, which is stepped over. */
bool directive_run(struct parser *);
/* directive.c: one without its '#'. */
bool directive_bare(struct parser *, enum keyword, span);

/* identifier.c */
/* The token of an identifier: subscripts read. 0 after an error. */
int identifier_token(struct parser *, uint32_t name, span *, struct token_value *);
/* Reads the subscripts behind an array: the element. NULL after an error. */
struct value *identifier_element(struct parser *, struct value *array, const char *name, span *);
/* The index that a subscript means; false after an error. */
bool identifier_index(struct parser *, double subscript, size_t size, const char *name, span where,
	size_t *index);
/* The test of #ifdef and defined(): reads "( N )". */
bool identifier_defined(struct parser *, bool *);

/* declare.c */
bool declare_run(struct parser *, bool local, span);
bool undef_run(struct parser *, span);

/* condition.c */
/* "( condition )": its value. */
bool condition_read(struct parser *, double *value);
bool condition_if(struct parser *, const struct directive *, span);
bool condition_else(struct parser *, const struct directive *, span);
bool condition_elseif(struct parser *, const struct directive *, span);
bool condition_switch(struct parser *, const struct directive *, span);
bool condition_case(struct parser *, const struct directive *, span);

/* block.c */
struct block *block_push(struct parser *, enum block_kind, const struct directive *, span);
bool block_end(struct parser *, span);
bool block_break(struct parser *, span);
/* Moves to the next part of a block whose present part is `part`, over the text between. The part
 * is stepped over; NULL after an error. */
const struct directive *block_skip_to_part(
	struct parser *, const struct directive *part, span opened, span *where);
/* Reports that a block has no end; returns false. `opened`: the span of its directive. */
bool block_report_unclosed(struct parser *, span opened);
/* Reports the blocks that are open at the end of the scene. */
void block_report_open(struct parser *);

/* loop.c */
bool loop_while(struct parser *, const struct directive *, span);
bool loop_for(struct parser *, const struct directive *, span);
/* At the #end: again, or on. */
bool loop_again(struct parser *, span);

/* macro.c */
bool macro_define(struct parser *, const struct directive *, span);
bool macro_call(struct parser *, struct symbol *, span);

/* undeclared.c: whether a name would be declared had there been no error before: what it leads to is none
 * of its own. */
bool name_is_lost(const struct parser *, uint32_t id);
/* Notes after an error where a name is declared, if that is certain. */
void note_declared(struct parser *, uint32_t id);
/* Shows how an element of an array is written. */
void note_element(struct parser *, span where, const char *array);
/* The include file whose name is most like this one, NULL if none is. */
const char *include_nearest(struct parser *, const char *name);

/* include.c */
bool include_run(struct parser *, span);

/* message.c */
bool message_run(struct parser *, enum keyword, span);

/* textfile.c */
bool file_open(struct parser *, span);
bool file_close(struct parser *, span);
bool file_read(struct parser *, span);
bool file_write(struct parser *, span);
/* At the end of the scene: closes what is open; false after an error. */
bool files_finish(struct parser *);

#endif
