/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files. PNG goes through libpng; everything else through the module
 * lambert-oiio.so, which is opened only when such a file is read or written.
 * Writing goes to a file beside the target, which is renamed over it when it is
 * complete: a half-written picture never replaces a good one.
 */
#ifndef LAMBERT_IMAGE_IMAGE_H
#define LAMBERT_IMAGE_IMAGE_H

#include "film/film.h"

#include <stdio.h>

enum image_format {
#define FORMAT(id, ...) IMAGE_##id,
#include "image/formats.def"
#undef FORMAT
	IMAGE_FORMAT_COUNT
};

struct raster;

/* What a format is called and what it can hold. */
struct image_format_class {
	const char *title;		       /* for messages */
	const char *name;		       /* for users and callers */
	const char *extensions;		       /* the usual one first, blanks between them */
	char letter;			       /* of POV-Ray's Output_File_Type */
	const char *module_name, *compression; /* for the module; NULL: written here by */
	bool (*write)(FILE *, const struct raster *, char *reason);
	bool grayscale, alpha;
	bool grayscale_is_raw; /* holds the numbers of the scene */
	int grayscale_bits;    /* 0: as chosen */
	bool is_premultiplied; /* the others have straight alpha */
	bool alpha_is_rarely_read;
	bool is_float;	  /* linear light, nothing cut */
	bool whole_bytes; /* 8 or 16 bits, none between */
	bool never_dithered;
	int bits_max;
	unsigned side_max; /* pixels */
	double bytes_max;  /* of samples; 0: no limit */
};
extern const struct image_format_class image_formats[IMAGE_FORMAT_COUNT];
/* By name or extension, in any letter case. */
bool image_find_format(const char *name, enum image_format *);

enum dither {
	DITHER_NONE,
	DITHER_B2,
	DITHER_B3,
	DITHER_B4,
	DITHER_D1,
	DITHER_D2,
	DITHER_FS,
	DITHER_COUNT
};
extern const char *const image_dithers[DITHER_COUNT]; /* names; "": none */
bool image_find_dither(const char *name, enum dither *);

struct image_encoding {
	enum image_format format;
	int bits; /* 5 to 16 */
	bool grayscale, alpha;
	struct working_space working; /* of the film's numbers */
	struct working_space file;    /* File_Gamma: sRGB by default */
	enum dither dither;
	int quality; /* JPEG, 2 to 100; 0: 85 */
};

/* Whether a picture of this size could be written to `path`; "-" is standard output. Changes nothing.
 * On failure *why is set to a message (in the thread's buffer). */
bool image_check(unsigned width, unsigned height, const struct image_encoding *, const char *path,
	const char **why);
/* Writes the film. On failure *why is set as above, and nothing is left behind. `progress` (or NULL)
 * is called before each row; false: the writing is stopped, and *why is NULL. */
bool image_write(const struct film *, const struct image_encoding *, const char *path,
	bool (*progress)(void *user, double share_done), void *user, const char **why);

/* A picture read from a file, as stored: 8 or 16 bit samples scaled to 0…1, or floats. */
struct image {
	unsigned width, height, channels; /* 1 grey, 2 grey+alpha, 3 rgb, 4 rgba */
	float *samples;			  /* row-major from the top left */
	int bits;			  /* per sample in the file; 32 for floats */
	bool premultiplied;
	bool has_srgb;	 /* the file says so */
	float gamma;	 /* of the file; 0: not stated */
	bool is_greymap; /* PGM: does not say whether it holds sRGB or the numbers of a scene */
	/* palette images keep their indices */
	unsigned char *indices;
	unsigned palette_size;
	float palette[256][4];
};
/* NULL on failure, with *why set. The format is recognised from the contents. */
struct image *image_read(const char *path, const char **why);
void image_destroy(struct image *);

/* How the samples of the file stand for light: as the file says; else floats are linear and codes are
 * sRGB. */
struct working_space image_curve(const struct image *);
bool image_same_curve(struct working_space, struct working_space);
/* A number of one curve on another. */
float image_convert(struct working_space from, struct working_space to, float x);

#endif
