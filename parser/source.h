/* SPDX-License-Identifier: MIT */
/*
 * Source texts and their raw tokens. A text is read whole and lexed once, into
 * 8 bytes per token; what loops and macros do later is to replay these tokens.
 * The parts of a block (#if … #else … #end) are linked while lexing, so that
 * skipping text is one jump.
 *
 * A large scene is lexed in pieces, each when the one before has been read: it ends
 * behind a closing brace between two statements or, within a very long one, behind a
 * vector or an item, and outside of any block. The next piece takes the room of the
 * tokens that nobody will read again, which are all but those of pieces with macros.
 */
#ifndef LAMBERT_PARSER_SOURCE_H
#define LAMBERT_PARSER_SOURCE_H

#include "base/diag.h"
#include "names.h"
#include "parser/parser.h"

/* Kinds below 128 are the punctuation character itself. */
enum raw_kind {
	RAW_INTEGER = 128, /* payload: the value */
	RAW_NUMBER,	   /* payload: index into numbers */
	RAW_NUMBER_TEXT,   /* to be read again from the text: numbers is full */
	RAW_STRING,	   /* payload: bytes between the quotes */
	RAW_KEYWORD,	   /* payload: enum keyword */
	RAW_NAME,	   /* payload: id of the name */
	RAW_DIRECTIVE,	   /* payload: index into directives; stands for '#' and the word */
	RAW_LE,		   /* <= */
	RAW_GE,		   /* >= */
	RAW_NE,		   /* != */
	RAW_ERROR,	   /* the text goes wrong here: see error; the last token */
};

enum { RAW_PAYLOAD_MAX = (1 << 24) - 1 };

struct raw_token {
	uint32_t offset;
	uint32_t kind : 8, payload : 24;
};

#define NO_TOKEN UINT32_MAX

/* A directive in the text. The parts of one block are chained; `end` is the matching #end. */
struct directive {
	enum keyword keyword;
	uint32_t token;	 /* where it stands itself */
	uint32_t length; /* in bytes, from # to the end of the word */
	uint32_t next;	 /* token of the next part of the block: #else, #case …, #end */
	uint32_t end;	 /* token of the matching #end */
};

struct source {
	const char *name;
	char *bytes; /* followed by two zero bytes */
	size_t size;
	uint32_t number; /* for diag */
	bool has_mark;	 /* began with a byte-order mark */
	struct raw_token *tokens;
	uint32_t count, room;
	double *numbers;
	uint32_t number_count, number_room;
	struct directive *directives;
	uint32_t directive_count, directive_room;
	struct lexing *rest; /* more of the text is to be lexed; or NULL */
	bool is_piecewise;   /* the text was not lexed all at once */
	/* where the present piece begins */
	uint32_t piece, piece_number, piece_directive;
	bool piece_splits; /* a statement began before */
	const char *error; /* of the last token if that is RAW_ERROR */
	uint32_t error_offset, error_length;
	bool is_data;		 /* for #read, not a part of the scene */
	struct source *previous; /* of all read by this parse */
};

/* Makes a source of a text: copies, registers and lexes it. `main_file`: a byte-order mark is
 * dropped, and what is lexed may be the first piece only. Owned by the arena but for the token arrays:
 * source_finish. */
struct source *source_create(struct arena *, struct diag *, struct names *, const char *name,
	const char *text, size_t size, bool main_file);
/* The same with the bytes of a file; NULL with errno set if it cannot be read. */
struct source *source_read(
	struct arena *, struct diag *, struct names *, const char *path, bool main_file);
/* The same with what the scene has written to that path in memory, if it has. */
struct source *source_open(struct arena *, struct diag *, struct names *,
	const struct parse_options *, const char *path);
/* Lexes the next piece, or all that is left, if there is more. The tokens may move. `forget`: those of
 * the present piece are not needed any more, and the next one, from s->piece on, may take their place;
 * else what is new stands behind them. */
bool source_continue(struct source *, bool forget, bool all);
/* Frees the tokens of the source (the text stays for messages). */
void source_finish(struct source *);

/* Letters, digits and '_'. */
static inline bool is_word_character(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
	       c == '_';
}

/* Value and length of the number literal at `text`, which is one. */
double number_at(const char *text, size_t *length);
/* The same when its first digits have been read. */
double number_behind(const char *text, size_t digits, uint64_t value, size_t *length);

/* -- between the lexer, binary.c and source.c -- */

/* binary.c: what the bytes are, if they are no text; NULL: they may be one. */
const char *binary_kind(const char *bytes, size_t size);
/* Size without the zeros at the end. */
size_t text_size(const char *bytes, size_t size);

/* lexer.l: begins to read the text. */
struct lexing *lex_begin(struct source *, struct names *, struct arena *);
/* Fills in tokens: up to a place where a piece may end behind the token `least`, true if there is
 * more to come. */
bool lex_source(struct lexing *, uint32_t least);
void lex_end(struct lexing *);
void source_grow(struct source *);
static inline void source_push(struct source *s, unsigned kind, uint32_t offset, uint32_t payload)
{
	if (s->count == s->room)
		source_grow(s);
	s->tokens[s->count++] =
		(struct raw_token){ offset, kind & 0xFF, payload & RAW_PAYLOAD_MAX };
}
void source_push_number(struct source *, uint32_t offset, double value);
void source_push_directive(struct source *, enum keyword, uint32_t offset, uint32_t length);
/* Whether a word after # is a directive. */
bool is_directive(enum keyword);
/* Whether a directive begins a block; is a further part of one, #end included. */
bool directive_opens(enum keyword);
bool directive_continues(enum keyword);

#endif
