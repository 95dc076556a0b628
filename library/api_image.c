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

bool lambert_format_describe(size_t i, struct lambert_format *format)
{
	if (i >= IMAGE_FORMAT_COUNT)
		return false;
	const struct image_format_class *f = &image_formats[i];
	*format = (struct lambert_format){
		.name = f->name,
		.extensions = f->extensions,
		.letter = f->letter,
		.grayscale = f->grayscale,
		.alpha = f->alpha,
		.alpha_is_rarely_read = f->alpha_is_rarely_read,
		.is_float = f->is_float,
		.bits_max = f->bits_max,
	};
	return true;
}

bool lambert_format_find(const char *name, struct lambert_format *format)
{
	enum image_format found;
	return image_find_format(name, &found) && lambert_format_describe(found, format);
}

const char *lambert_dither_name(size_t i)
{
	return i + 1 < DITHER_COUNT ? image_dithers[i + 1] : NULL;
}

static enum image_format format_of_path(const char *path)
{
	const char *dot = strrchr(path, '.');
	enum image_format format;
	return dot && image_find_format(dot + 1, &format) ? format : IMAGE_PNG;
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
	if (!options->format) {
		e->format = format_of_path(path);
	} else if (!image_find_format(options->format, &e->format)) {
		*why = "the format is unknown";
		return false;
	}
	if (!image_find_dither(options->dither ? options->dither : "", &e->dither)) {
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
