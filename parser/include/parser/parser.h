/* SPDX-License-Identifier: MIT */
/*
 * The parser's one entry: scene text to AST.
 */
#ifndef LAMBERT_PARSER_PARSER_H
#define LAMBERT_PARSER_PARSER_H

#include "base/arena.h"
#include "base/diag.h"
#include "parser/ast.h"

#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>

/* An identifier made before the first token, as the option Declare=NAME=VALUE does. */
struct declaration {
	const char *name;
	const char *string; /* NULL: a number */
	double number;
};

/* What the language may ask of the renderer while it is being read. Any may be NULL: its use in
 * a scene is then reported as not supported. `object` etc. are declared values. */
struct render_hooks {
	void *user;
	/* What the text read so far has set; `state` may still change until the next question. */
	void (*state)(void *user, const struct language_state *state);
	bool (*inside)(void *user, const struct node *object, const double p[3], bool *answer);
	bool (*trace)(void *user, const struct node *object, const double origin[3],
		const double direction[3], double point[3], double normal[3], bool *found);
	bool (*extent)(void *user, const struct node *object, double lo[3], double hi[3]);
	/* Value of a function at `arguments`; `result` has 1 to 5 terms. */
	bool (*call)(void *user, const struct function *, const double *arguments, double result[5],
		unsigned *terms);
	/* The turbulence vector of vturbulence(). */
	bool (*turbulence)(void *user, double lambda, double omega, int octaves, const double p[3],
		double result[3]);
};

struct parse_options {
	const char *const *library_paths; /* searched after the current directory */
	size_t library_path_count;
	/* Searched last, after a warning: the folder of the scene (lambert's own courtesy). */
	const char *scene_folder;
	const struct declaration *declarations;
	size_t declaration_count;
	const char *include_header; /* read first, as if included; NULL: none */
	double clock;
	bool clock_on;
	int version; /* hundredths; 370 unless an option says otherwise */
	bool version_set;
	bool no_file_io;	       /* refuse #fopen */
	const char *const *read_paths; /* more folders a scene may read below */
	size_t read_path_count;
	const char *const *write_paths; /* more folders a scene may write below */
	size_t write_path_count;
	const char *const *kept_paths; /* files that a scene must not write, wherever they are */
	size_t kept_path_count;
	struct scratch_files *scratch; /* where files go that the scene writes; NULL: to the disk */
	bool no_short_ways;	       /* leave every expression to the grammar: for tests */
	double max_loop_tokens;	       /* give up after that many tokens; 0: no limit */
	FILE *debug_stream;	       /* where #debug, #warning … text goes, NULL: nowhere */
	void (*text)(void *user, enum keyword stream, const char *line); /* K_DEBUG, K_RENDER, … */
	void *text_user;
	/* When somebody has set `asked`, the next directive clears it and tells where it stands; false:
	 * the reading ends there. NULL: nobody asks. */
	atomic_bool *asked;
	bool (*reached)(void *user, span where);
	void *reached_user;
	struct render_hooks hooks;
	/* For large scenes: whenever the statements of the top level have come to some size they are
	 * handed over, in order, and forgotten; only the last of them are in the ast. They live in
	 * `passing`, which is reset behind each call. NULL: the ast has them all. */
	void (*statements)(void *user, const struct node *first);
	/* The same for members of a union or merge that is large itself, whose word stands there: the
	 * statement will come with the others. False: something refers to them, so that they stay until
	 * then. */
	bool (*members)(void *user, span word, const struct node *first);
	void *statements_user;
	struct arena *passing;
};

/* Size of the trees handed over at a time, in bytes: what a processor keeps near. */
enum { PASSING_BYTES = 512 << 10 };

/* Reads `path` (the bytes are `text` when that is not NULL) and everything it includes.
 * Errors go to `diag`; returns NULL after an error. The AST and the sources live in `arena`. */
const struct ast *parse_scene(const char *path, const char *text, size_t size,
	const struct parse_options *, struct diag *, struct arena *arena);

/* The AST as JSON, for `lambert ast`. */
void ast_print_json(const struct ast *, struct diag *, FILE *);

/* Finds a file as the language does: as written, then in each library path, with the extensions
 * tried in order (a NULL-terminated list). Falls back, with *courtesy set, to the scene's folder, other
 * letter case and backslashes. NULL if there is none. */
const char *file_find(const struct parse_options *, const char *name, const char *const *extensions,
	bool *courtesy, struct arena *);

/* The path of a file in a folder, "" the current one, as file_find spells it. */
const char *file_in_folder(struct arena *, const char *folder, const char *name);

/* The path of a file without links; the file need not exist yet, its folder must. */
bool file_true_path(const char *path, char real[PATH_MAX]);
/* Whether both paths lead to one file, by whatever links. False when there is none. */
bool file_is_same(const char *a, const char *b);

/* Files in memory, for a scene that is only looked at (scratch.c). */
struct scratch_files *scratch_create(void);
void scratch_destroy(struct scratch_files *);
/* What was written to a path; NULL: nothing, or `all` is NULL. Valid until it is written again. */
const char *scratch_read(const struct scratch_files *all, const char *path, size_t *size);
/* Begins to write; `real` is a path without links. NULL with errno set. */
FILE *scratch_write(struct scratch_files *all, const char *real, bool append);

/* Whether a scene may read the file: NULL, or the message why not. */
const char *file_may_read(const struct parse_options *, const char *path, struct arena *);
/* Opens a file to which a scene writes; NULL if that is impossible or refused, which the message says. */
FILE *file_open_to_write(const struct parse_options *, const char *path, bool append,
	struct arena *, const char **message);

#endif
