/* SPDX-License-Identifier: MIT */
/*
 * Sources and messages. A span says where something stands in the text of the
 * scene; a site says through which includes and macro calls the text was
 * reached. A message is resolved to file, line and column and handed to the
 * caller's sink; nothing here prints.
 */
#ifndef LAMBERT_BASE_DIAG_H
#define LAMBERT_BASE_DIAG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A piece of text: `length` bytes at `offset` of source number `source`, reached through `site`.
 * Source 0 is "no place" (options, the built-in defaults); site 0 is the main scene. */
typedef struct span {
	uint32_t source, offset, length, site;
} span;

enum severity { SEVERITY_NOTE, SEVERITY_WARNING, SEVERITY_ERROR };

/* One resolved place. The strings live as long as the call to the sink. */
struct place {
	const char *file;     /* NULL: no place */
	unsigned line;	      /* from 1 */
	unsigned column;      /* from 1, in bytes */
	unsigned length;      /* bytes to underline, at least 1 */
	unsigned text_offset; /* bytes of the line before `text`: 0 but in a very long line */
	const char *text;     /* the line, without its end; a part of a very long one */
	const char *context;  /* for the entries of `chain`: "in macro Foo called here" … */
};

struct message {
	enum severity severity;
	const char *text;
	struct place place;
	/* Outwards: the includes and macro calls through which `place` was reached; of a note only
	 * where they differ from those of the message before. */
	const struct place *chain;
	size_t chain_length;
};

/* Receives the messages in order. Must not call back into lambert. */
typedef void (*message_sink)(void *user, const struct message *);

struct diag;

struct diag *diag_create(message_sink sink, void *user);
void diag_destroy(struct diag *);

/* Registers a text; name and bytes must outlive the diag. Returns its number, from 1. */
uint32_t diag_add_source(struct diag *, const char *name, const char *bytes, size_t size);
/* Registers that the text at `call` (reached through call.site) leads on to other text:
 * `context` as in struct place, static or outliving the diag. Returns the new site. */
uint32_t diag_add_site(struct diag *, span call, const char *context);

/* An error or a warning is shown once for its place and text, however often a loop or a macro comes
 * by. */
void diag_error(struct diag *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
void diag_warning(struct diag *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* A warning that the scene itself gives: shown each time. */
void diag_scene_warning(struct diag *, span where, const char *text);
/* Goes with the message before, and is shown if that was: "opened here". */
void diag_note(struct diag *, span where, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

/* The scene needs what is not supported yet. That is one error however many places need it: it counts
 * at once, and diag_show_unsupported shows it with the first place and their number. */
void diag_unsupported(struct diag *, span where, const char *what);
void diag_show_unsupported(struct diag *);

/* Whether reports are dropped from now on: while something that was reported is done again. Returns what
 * held before. */
bool diag_mute(struct diag *, bool);

/* Errors so far: all, and those that are mistakes of the scene, not of what it needs. */
unsigned diag_errors(const struct diag *);
unsigned diag_mistakes(const struct diag *);

/* Fills `file`, `line`, `column`, `text` of a place; strings valid until the next call. */
struct place diag_place(struct diag *, span);

#define NO_SPAN ((span){ 0, 0, 0, 0 })

#endif
