/* SPDX-License-Identifier: MIT */
/*
 * lambert: renders scenes written in the POV-Ray 3.7 scene language.
 *
 * Load a scene, render it to an image, write the image:
 *
 *     struct lambert_scene_options scene_options;
 *     lambert_scene_options_init(&scene_options);
 *     lambert_scene *scene = lambert_scene_load("first.pov", &scene_options);
 *     struct lambert_render_options render_options;
 *     lambert_render_options_init(&render_options);
 *     lambert_image *image = lambert_render(scene, &render_options);
 *     lambert_image_write(image, "first.png", NULL, NULL, NULL);
 *     lambert_image_destroy(image);
 *     lambert_scene_destroy(scene);
 *
 * The library never prints and never exits (but for lack of memory); messages
 * go to the callback of the options. A scene may be rendered from several
 * threads at once. Whatever was created is destroyed by its _destroy function;
 * destroying NULL does nothing.
 *
 * All callbacks run while the call that was given them runs, one at a time. Those
 * of loading come from a thread of the library's own; the progress of rendering
 * from any of the threads that render; those of writing and comparing from the
 * caller's thread.
 */
#ifndef LAMBERT_LAMBERT_H
#define LAMBERT_LAMBERT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define LAMBERT_VERSION "0.1.0"

typedef struct lambert_scene lambert_scene;
typedef struct lambert_image lambert_image;

enum lambert_severity { LAMBERT_NOTE, LAMBERT_WARNING, LAMBERT_ERROR };

/* A place in the text of a scene. */
struct lambert_place {
	const char *file;	       /* NULL: no place */
	unsigned line, column, length; /* from 1, in bytes */
	const char *text;	       /* the line; of a very long one the part around the place */
	const char *context;	       /* in a chain: "in macro Foo, called here" */
	unsigned text_offset;	       /* bytes of the line before `text`: 0 unless it is a part */
};

/* The strings live as long as the callback runs. */
struct lambert_message {
	enum lambert_severity severity;
	const char *text;
	struct lambert_place place;
	const struct lambert_place
		*chain; /* the includes and macro calls that led there, outwards */
	size_t chain_length;
};
typedef void (*lambert_message_function)(void *user, const struct lambert_message *);

/* Text of #debug, #warning … ; `stream` is "debug", "warning", "render" or "statistics". */
typedef void (*lambert_text_function)(void *user, const char *stream, const char *line);

/* Where the reading of a scene is after that many seconds. False stops it. */
typedef bool (*lambert_reading_function)(void *user, const struct lambert_place *, double seconds);

/* What is done between reading and rendering, in words, how much of it is done, and the seconds since
 * the reading began: at the start of each step, and at most four times a second within it. False
 * stops it. */
typedef bool (*lambert_preparing_function)(
	void *user, const char *what, double share_done, double seconds);

struct lambert_declaration {
	const char *name;
	const char *string; /* NULL: a number */
	double number;
};

struct lambert_scene_options {
	unsigned width, height;		  /* of the picture: image_width, image_height; 160, 120 */
	const char *const *library_paths; /* searched after the current directory */
	size_t library_path_count;
	const struct lambert_declaration *declarations;
	size_t declaration_count;
	const char *include_header; /* read before the scene, or NULL */
	double clock;
	bool clock_on;
	unsigned version; /* language version in hundredths, 0: not given */
	int quality;	  /* 0 to 9; 9 */
	unsigned frame;	  /* of an animation: each has noise of its own; 0 */
	bool output_alpha;
	unsigned threads;  /* 0: as many as processors */
	double loop_limit; /* tokens after which loops are taken for endless; 2e10, 0: none */
	bool no_file_io;   /* #fopen is refused */
	const char *const *read_paths; /* below these a scene may read, beside its own folder, the
					   current directory and the library paths */
	size_t read_path_count;
	const char *const *write_paths; /* and write, beside the current directory */
	size_t write_path_count;
	const char *const *kept_paths; /* files the scene must not write, as the program's own */
	size_t kept_path_count;
	lambert_message_function message; /* may be NULL */
	lambert_text_function text;	  /* may be NULL */
	/* Called at most four times a second, at a directive of the scene, from the thread that
	 * calls the others too. May be NULL. */
	lambert_reading_function progress;
	lambert_preparing_function preparing; /* from that thread; may be NULL */
	void *user;			      /* for all four */
};
void lambert_scene_options_init(struct lambert_scene_options *);

/* Reads, checks and prepares a scene; NULL after an error (the messages say which), or when it was
 * stopped. */
lambert_scene *lambert_scene_load(const char *path, const struct lambert_scene_options *);
void lambert_scene_destroy(lambert_scene *);
struct lambert_scene_stats {
	size_t tokens, objects, lights, unbounded_objects, accel_bytes;
	double parse_cpu, lower_cpu, build_cpu; /* CPU seconds */
};
/* Reads and checks a scene without preparing it; false after an error, or when it was stopped. Every error that loading finds
 * is found. The numbers of what is not prepared stay 0. Nothing is written to the disk: what the scene
 * writes stays in memory, where the scene can read it. */
bool lambert_scene_check(
	const char *path, const struct lambert_scene_options *, struct lambert_scene_stats *);
/* Reads a scene and prints its syntax tree as JSON; false after an error. Nothing is written to the
 * disk, as by lambert_scene_check. */
bool lambert_scene_print_ast(const char *path, const struct lambert_scene_options *, FILE *);
/* Prints a text as a JSON string in UTF-8; bytes that are no UTF-8 count as Latin-1. */
void lambert_print_json_string(const char *text, FILE *);
void lambert_scene_statistics(const lambert_scene *, struct lambert_scene_stats *);

struct lambert_render_stats {
	uint64_t camera_rays, reflected_rays, refracted_rays, transmitted_rays, shadow_rays,
		max_level;
	double trace_cpu, trace_wall; /* seconds */
};

struct lambert_render_options {
	int antialias_method;	    /* 0 none, 1, 2; 0 */
	double antialias_threshold; /* 0.3 */
	int antialias_depth;	    /* 3 */
	double antialias_jitter;    /* 1; 0: none */
	double antialias_gamma;	    /* 2.5 */
	unsigned left, top, right,
		bottom;	     /* region: first and one past the last; all 0: everything */
	unsigned block_size; /* 32 */
	unsigned threads;    /* 0: as many as processors */
	/* Called now and then; false stops the rendering. May be NULL. */
	bool (*progress)(void *user, double share_done);
	void *user;
	struct lambert_render_stats *stats; /* filled when not NULL */
};
void lambert_render_options_init(struct lambert_render_options *);

/* NULL when it was stopped. Never fails otherwise. */
lambert_image *lambert_render(const lambert_scene *, const struct lambert_render_options *);
void lambert_image_destroy(lambert_image *);
unsigned lambert_image_width(const lambert_image *);
unsigned lambert_image_height(const lambert_image *);
/* What was rendered of the picture, and what an image has in memory: left, top, right, bottom; first
 * and one past the last pixel. The rest of the picture is black. */
void lambert_image_region(const lambert_image *, unsigned region[4]);
/* Five floats a pixel of the region, row-major from its top left: red, green, blue (working space,
 * premultiplied), filter (0) and 1 - alpha. Lives as long as the image. */
const float *lambert_image_pixels(const lambert_image *);

/* A format of picture files. */
struct lambert_format {
	const char *name;	/* "jpeg" */
	const char *extensions; /* "jpg jpeg": the usual one first */
	char letter;		/* of POV-Ray's Output_File_Type */
	bool grayscale, alpha;	/* what it can hold */
	bool alpha_is_rarely_read;
	bool is_float; /* linear, without limits */
	int bits_max;
};
/* Format number i from 0; false: there are no more. */
bool lambert_format_describe(size_t i, struct lambert_format *);
/* By name or extension, in any letter case; false: there is none. */
bool lambert_format_find(const char *name, struct lambert_format *);
/* The name of kind number i of dithering from 0; NULL: there are no more. */
const char *lambert_dither_name(size_t i);

struct lambert_output_options {
	const char *format; /* a name; NULL: from the extension of the path, else "png" */
	int bits;	    /* 5 to 16; 8 */
	bool grayscale, alpha;
	double file_gamma;  /* 0: sRGB */
	const char *dither; /* a name; NULL: none */
	int quality;	    /* JPEG, 2 to 100; 0: 85 */
	/* Called for each row; false stops the writing. May be NULL. */
	bool (*progress)(void *user, double share_done);
	void *user;
};
void lambert_output_options_init(struct lambert_output_options *);
/* Whether a picture of this size could be written to `path`: its format holds it, and the place may be
 * written to. To be asked before rendering. False: the message says why. Changes nothing. */
bool lambert_output_check(const char *path, unsigned width, unsigned height,
	const struct lambert_output_options *, lambert_message_function, void *user);
/* Writes a picture; "-" is standard output. Options NULL: defaults. False: the message says why, or it
 * was stopped; nothing is left behind. */
bool lambert_image_write(const lambert_image *, const char *path,
	const struct lambert_output_options *, lambert_message_function, void *user);

/* How two picture files differ, scaled to 0…255: as stored where both hold codes of the same curve, with
 * the same kind of alpha; otherwise encoded as sRGB and multiplied by alpha. What a file says of its
 * curve counts; else floats are linear and codes are sRGB. */
struct lambert_difference {
	unsigned width, height;
	bool as_stored;
	double maximum[4], rmse[4];	     /* red, green, blue, alpha */
	double rmse_all, psnr;		     /* over red, green and blue */
	double within_1, within_2, within_8; /* shares of pixels, all channels */
	double lowest_ssim;		     /* over the 8 x 8 blocks, of luminance */
	unsigned worst_x, worst_y;
	double worst;
};
/* False: a file cannot be read, the sizes differ, or one is a PGM and the other is not (nobody knows its
 * curve); the message says so. `heatmap`: a PNG to write, or
 * NULL. */
bool lambert_compare(const char *a, const char *b, const char *heatmap, struct lambert_difference *,
	lambert_message_function, void *user);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
