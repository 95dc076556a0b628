/* SPDX-License-Identifier: MIT */
/*
 * Where texts go: messages as compilers print them (place, source line, caret,
 * the chain of includes and macro calls), text of the scene, summaries. To the
 * console unless switched off, and to the files that the options name.
 */
#ifndef LAMBERT_CLI_MESSAGES_H
#define LAMBERT_CLI_MESSAGES_H

#include "options.h"

#include <stdio.h>

struct messages {
	const struct options *options;
	FILE *files[STREAM_COUNT]; /* NULL: none */
	FILE *json;		   /* messages as JSON lines go here instead; NULL: nowhere */
	bool terminal;		   /* the console is one */
	bool colour;
	enum stream last; /* of the last message: its notes go there too */
	char file[256];	  /* the place shown last */
	unsigned line, column;
	bool line_open; /* a progress bar stands on the console's current line */
	unsigned errors, warnings;
};

/* Opens the files in the folder of `picture` (NULL: the current one); false after a message. */
bool messages_init(struct messages *, struct options *, const char *picture, bool append);
void messages_finish(struct messages *);

/* Callbacks for the library; `user` is a struct messages. */
void messages_take(void *user, const struct lambert_message *);
void messages_take_text(void *user, const char *stream, const char *line);

/* Takes what shows the progress off the console's current line. */
void messages_clear_line(struct messages *);

/* A line of the program itself on one of the streams. */
void messages_say(struct messages *, enum stream, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

#endif
