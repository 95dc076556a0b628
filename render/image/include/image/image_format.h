/* SPDX-License-Identifier: MIT */
/*
 * The readers and writers behind image.h, and the C interface of the module
 * lambert-oiio.so. Readable from C and C++.
 */
#ifndef LAMBERT_IMAGE_IMAGE_FORMAT_H
#define LAMBERT_IMAGE_IMAGE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { REASON_SIZE = 256 };

/* An encoded picture on its way to a file; it is never in memory as a whole. */
struct raster {
	unsigned width, height, channels;
	int sample_bits; /* 8, 16, or 32 for floats */
	int bits;	 /* that mean something */
	bool (*row)(void *source, unsigned y,
		void *samples); /* asked for in order from 0; false: stop */
	void *source;
	size_t row_bytes;
	float gamma; /* of the file; 2.2 for sRGB */
	bool is_srgb;
	bool is_premultiplied;
	int quality; /* JPEG */
};

/* A picture as the module found it; `samples` is freed by `release`. */
struct module_picture {
	unsigned width, height, channels;
	int bits; /* per sample in the file; 32 for floats */
	float *samples;
	bool is_premultiplied, is_srgb;
	float gamma;	 /* 0: not stated */
	bool is_greymap; /* see image.h */
};

/* What the module offers under the name IMAGE_MODULE_SYMBOL. On failure `reason` (of REASON_SIZE
 * bytes) says why. `format` and `compression` are names OpenImageIO knows; "": no choice. */
struct image_module {
	bool (*write)(const char *path, const char *format, const char *compression,
		const struct raster *, char *reason);
	bool (*read)(const char *path, struct module_picture *, char *reason);
	void (*release)(struct module_picture *);
};
#define IMAGE_MODULE_FILE   "lambert-oiio.so"
#define IMAGE_MODULE_SYMBOL "lambert_image_module"

/* Opens the module; it stays open. NULL with `reason` set when it cannot be found. */
const struct image_module *image_module_open(char *reason);

#ifndef __cplusplus
struct image;

bool png_write(FILE *, const struct raster *, char *reason);
/* Whether the file begins like a PNG; the position is left at the start. */
bool png_recognise(FILE *);
struct image *png_read(FILE *, char *reason);

/* Netpbm: P5 or P6. */
bool pnm_write(FILE *, const struct raster *, char *reason);
#endif

#ifdef __cplusplus
}
#endif

#endif
