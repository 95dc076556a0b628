/* SPDX-License-Identifier: MIT */
/*
 * Everything that can be chosen from outside a scene: by POV-Ray's switches and
 * INI options (options.def) and by lambert's own long options.
 *
 * Numbers are held in single precision, as the language defines: a scene can see
 * the difference.
 */
#ifndef LAMBERT_CLI_OPTIONS_H
#define LAMBERT_CLI_OPTIONS_H

#include "text.h"

#include "lambert/lambert.h"

enum stream {
	STREAM_ALL,
	STREAM_DEBUG,
	STREAM_FATAL,
	STREAM_RENDER,
	STREAM_STATISTIC,
	STREAM_WARNING,
	STREAM_COUNT
};

enum option_kind {
	KIND_BOOL,
	KIND_INT,
	KIND_FLOAT,
	KIND_TEXT,
	KIND_TYPE,     /* output file type: a letter, in the switch also a depth */
	KIND_FILE,     /* a file name, or a truth value for the usual name */
	KIND_DITHER,   /* B2 B3 B4 D1 D2 FS */
	KIND_GAMMA,    /* a number, 0 standing for "sRGB" */
	KIND_COUNT,    /* a number of 0 or more, in double precision */
	KIND_REGION,   /* left,top,right,bottom in pixels */
	KIND_PROGRESS, /* bar, lines or off */
	KIND_LIBRARY,  /* one more folder to search */
	KIND_FOLDERS,  /* one more of a list */
	KIND_DECLARE,  /* name=value */
	KIND_INI,      /* a file to read now */
	KIND_COMMAND,  /* a shell command, never run */
	KIND_RETIRED,
};
enum option_use { USE_USED, USE_IGNORED, USE_REFUSED, USE_QUIET };

/* Who set an option last. */
enum origin { ORIGIN_NOBODY, ORIGIN_DEFAULT_INI, ORIGIN_USER };

enum { OPTION_MAX = 160 };

/* Where an option stands, for messages. */
struct option_place {
	const char *file; /* of INI files; NULL: the command line */
	unsigned line;
	int argument;	  /* from 1 */
	const char *text; /* the argument */
};

struct options {
	struct text_pool pool;
	enum origin origin; /* of what is being read */
	struct option_place place;
	unsigned ini_depth;
	bool strict;		       /* a doubtful value is refused, not only warned of */
	unsigned char set[OPTION_MAX]; /* enum origin, by row of options.def */
	const char *given[OPTION_MAX]; /* the value of those that were set, by row */

	/* picture */
	int width, height;
	float start_column, start_row, end_column, end_row;
	bool has_region; /* in pixels: */
	int region[4];	 /* left, top and one past the right and bottom */
	bool output_to_file;
	char output_type; /* 0: not chosen */
	const char *output;
	bool output_is_exact; /* given with -o: no naming rules apply */
	int bits, compression;
	bool grayscale, output_alpha, dither;
	float file_gamma; /* 0: sRGB */
	const char *dither_method;

	/* scene */
	const char *input, *include_header;
	bool scene_named; /* input is a word of the command line */
	struct text_list library;
	size_t library_named; /* of them: the others are always searched */
	struct lambert_declaration *declarations;
	size_t declaration_count;
	float version, clock;
	int quality;
	bool no_file_io;
	double loop_limit; /* tokens; less than 0: not given */
	struct text_list read_paths, write_paths;
	struct text_list ini_files; /* that were read */

	/* tracing */
	bool antialias, jitter;
	int sampling_method, antialias_depth, block_size, threads;
	float antialias_threshold, antialias_gamma, jitter_amount;

	/* animation */
	int initial_frame, final_frame, frame_step;
	float initial_clock, final_clock, subset_start, subset_end;
	bool cyclic;

	bool continue_trace; /* starts anew, with a note */

	/* refused when on */
	bool clockless, radiosity_from_file, radiosity_to_file, real_time;

	/* text */
	bool all_console, console[STREAM_COUNT], append_file;
	const char *stream_file[STREAM_COUNT];
	const char *create_ini, *stats_file;
	bool verbose, quiet, json;
	const char *progress; /* "bar", "lines", "off"; NULL: by where it goes */
	struct text_list commands;

	/* accepted, without effect */
	bool display, pause, ignored_bool;
	int ignored_int;
	float ignored_float;
	const char *ignored_text;
	char none;
};

void options_init(struct options *);
void options_finish(struct options *);

/* Reads the default INI file, then the arguments. False after a message. */
bool options_read(struct options *, int argc, char **argv);

/* Whether the option of this INI name was set, and by whom. */
enum origin options_set(const struct options *, const char *ini_name);

/* The commands whose help shows an option. */
enum option_shown {
	SHOWN_NOWHERE = 0,
	SHOWN_RENDER = 1,
	SHOWN_CHECK = 2,
	SHOWN_AST = 4,
	SHOWN_SCENE = SHOWN_RENDER | SHOWN_CHECK | SHOWN_AST, /* what a scene can see */
};

/* One row of options.def. */
struct option_row {
	const char *ini, *letters;
	enum option_kind kind;
	size_t field, sign; /* offsets in struct options; that of `none`: nothing */
	enum option_use use;
	double low, high; /* of a number; equal: any */
	const char *name; /* of the long option; NULL: none */
	const char *value;
	unsigned shown;
	const char *help;
	const char *letter; /* -o */
	/* Reads what has a structure of its own; NULL: the row does. `value` is NULL when none is given. */
	bool (*read)(struct options *, const char *value);
};
extern const struct option_row option_rows[];
extern const size_t option_count;
/* NULL when there is none of this name (any letter case). */
const struct option_row *option_find(const char *name, size_t length);

/* Whether it has a sign beside its value. */
bool option_has_sign(const struct option_row *);
/* Sets an option from its value; false after a message. `is_switch`: from a switch with `sign`. */
bool option_apply(
	struct options *, const struct option_row *, const char *value, bool is_switch, char sign);
/* An argument or a line of an INI file in POV-Ray's syntax: see switches.c. */
bool switches_read(struct options *, const char *text, bool in_file);
/* "file" or "file[section]", searched as INI files are. */
bool ini_read(struct options *, const char *request);
/* The one default INI file, if there is any. */
bool ini_read_default(struct options *);
/* An argument of lambert's own style; *used is the number of arguments it took, 0 if it is none.
 * False after a message. */
bool long_option_read(struct options *, int argc, char **argv, int *used);
/* The long options that have a structure of their own. */
bool read_output(struct options *, const char *value);
bool read_size(struct options *, const char *value);
bool read_antialias(struct options *, const char *value);
bool read_declare(struct options *, const char *value);
bool read_format(struct options *, const char *value);
bool read_dither(struct options *, const char *value);
/* Writes the options that were set, in the syntax of INI files. */
bool options_write_ini(const struct options *, const char *path);

/* Says what is wrong with an option and where it stands; always false. */
bool option_error(const struct options *, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
/* The same for what is no error. */
void option_warning(const struct options *, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
void option_note(const struct options *, const char *format, ...)
	__attribute__((format(printf, 2, 3)));
/* Sets an option of this INI name; false after a message. */
bool option_set(struct options *, const char *ini_name, const char *value);
/* Another scene than the one that was named by a word before is an error. */
bool option_scene(struct options *, const char *name);

/* The longest numeric beginning of a text; false when there is none. */
bool option_float(const char *text, float *value);
bool option_int(const char *text, int *value);

#endif
