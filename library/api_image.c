/* SPDX-License-Identifier: MIT */
/*
 * The public functions of pictures: what lambert_render returned, looked at and
 * written to a file.
 */
#include "api.h"
#include "image/image.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static_assert(
	sizeof(colour) == 5 * sizeof(float), "lambert_image_pixels hands out colours as floats");

void lambert_image_destroy(lambert_image *image)
{
	if (!image)
		return;
	film_destroy(image->film);
	free(image);
}

unsigned lambert_image_width(const lambert_image *image)
{
	return image->film->width;
}

unsigned lambert_image_height(const lambert_image *image)
{
	return image->film->height;
}

void lambert_image_region(const lambert_image *image, unsigned region[4])
{
	const struct block *part = &image->film->part;
	region[0] = part->left;
	region[1] = part->top;
	region[2] = part->right;
	region[3] = part->bottom;
}

const float *lambert_image_pixels(const lambert_image *image)
{
	return &image->film->pixels->r;
}

void lambert_output_options_init(struct lambert_output_options *options)
{
	*options = (struct lambert_output_options){ .bits = 8 };
}

static const struct {
	char letter;
	enum image_format format;
} letters[] = {
	{ 'N', IMAGE_PNG },
	{ 'P', IMAGE_PPM },
	{ 'T', IMAGE_TGA },
	{ 'C', IMAGE_TGA_RLE },
	{ 'B', IMAGE_BMP },
	{ 'J', IMAGE_JPEG },
	{ 'E', IMAGE_EXR },
	{ 'H', IMAGE_HDR },
	{ 'F', IMAGE_TIFF },
};

static const struct {
	const char *extension;
	enum image_format format;
} extensions[] = {
	{ "ppm", IMAGE_PPM },
	{ "pgm", IMAGE_PPM },
	{ "tga", IMAGE_TGA },
	{ "bmp", IMAGE_BMP },
	{ "jpg", IMAGE_JPEG },
	{ "jpeg", IMAGE_JPEG },
	{ "exr", IMAGE_EXR },
	{ "hdr", IMAGE_HDR },
	{ "tif", IMAGE_TIFF },
	{ "tiff", IMAGE_TIFF },
};

static const char *const dithers[] = {
	[DITHER_NONE] = "",
	[DITHER_B2] = "B2",
	[DITHER_B3] = "B3",
	[DITHER_B4] = "B4",
	[DITHER_D1] = "D1",
	[DITHER_D2] = "D2",
	[DITHER_FS] = "FS",
};

static enum image_format format_of_path(const char *path)
{
	const char *dot = strrchr(path, '.');
	for (size_t i = 0; dot && i < sizeof extensions / sizeof *extensions; i++)
		if (strcasecmp(dot + 1, extensions[i].extension) == 0)
			return extensions[i].format;
	return IMAGE_PNG;
}

static bool find_format(char letter, const char *path, enum image_format *format)
{
	if (!letter) {
		*format = format_of_path(path);
		return true;
	}
	for (size_t i = 0; i < sizeof letters / sizeof *letters; i++) {
		if (letters[i].letter == letter) {
			*format = letters[i].format;
			return true;
		}
	}
	return false;
}

static bool find_dither(const char *name, enum dither *dither)
{
	for (size_t i = 0; i < sizeof dithers / sizeof *dithers; i++) {
		if (strncmp(dithers[i], name, 3) == 0) {
			*dither = (enum dither)i;
			return true;
		}
	}
	return false;
}

/* Sets what the caller chose. False with a reason. */
static bool choose_encoding(const struct lambert_output_options *options, const char *path,
	struct image_encoding *e, const char **why)
{
	*e = (struct image_encoding){
		.bits = options->bits < 5    ? 5
			: options->bits > 16 ? 16
					     : options->bits,
		.grayscale = options->grayscale,
		.alpha = options->alpha,
		.file = { .transfer = options->file_gamma > 0 ? TRANSFER_POWER : TRANSFER_SRGB,
			.gamma = (float)options->file_gamma },
		.quality = options->quality,
	};
	if (!find_format(options->format, path, &e->format)) {
		*why = "the format is unknown";
		return false;
	}
	if (!find_dither(options->dither, &e->dither)) {
		*why = "the kind of dithering is unknown";
		return false;
	}
	return true;
}

/* Tells that, and why, a picture cannot be written. */
static bool complain(
	const char *path, const char *why, lambert_message_function message, void *user)
{
	char text[1024];
	snprintf(text, sizeof text, "the picture %s cannot be written: %s", path, why);
	if (message)
		message(user, &(struct lambert_message){ .severity = LAMBERT_ERROR, .text = text });
	return false;
}

bool lambert_output_check(const char *path, unsigned width, unsigned height,
	const struct lambert_output_options *options, lambert_message_function message, void *user)
{
	struct image_encoding encoding;
	const char *why = NULL;
	return (choose_encoding(options, path, &encoding, &why) &&
		       image_check(width, height, &encoding, path, &why)) ||
	       complain(path, why, message, user);
}

bool lambert_image_write(const lambert_image *image, const char *path,
	const struct lambert_output_options *options, lambert_message_function message, void *user)
{
	struct lambert_output_options defaults;
	lambert_output_options_init(&defaults);
	const struct lambert_output_options *o = options ? options : &defaults;
	struct image_encoding encoding;
	const char *why = NULL;
	if (!choose_encoding(o, path, &encoding, &why))
		return complain(path, why, message, user);
	encoding.alpha = encoding.alpha && image->output_alpha;
	encoding.working = image->working;
	return image_write(image->film, &encoding, path, o->progress, o->user, &why) ||
	       (why && complain(path, why, message, user));
}
