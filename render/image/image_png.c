/* SPDX-License-Identifier: MIT */
/*
 * PNG through libpng. Written files carry gAMA, sRGB and sBIT but neither time
 * stamps nor text: the same picture gives the same bytes. Reading keeps the
 * indices of palette pictures beside the expanded colours.
 *
 * libpng reports errors by longjmp. Everything that must survive the jump lives
 * in a struct outside the function that calls setjmp.
 */
#include "image/image_format.h"

#include "base/arena.h"
#include "image/image.h"

#include <png.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Pictures with more samples are refused: no scene needs them, and damaged headers ask for them. */
static const size_t SAMPLES_MAX = (size_t)1 << 31;

static void on_error(png_structp png, png_const_charp text)
{
	char *reason = png_get_error_ptr(png);
	snprintf(reason, REASON_SIZE, "%s", text);
	png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp text)
{
	(void)png;
	(void)text;
}

/* Writing */

struct writing {
	png_structp png;
	png_infop info;
	const struct raster *raster;
	uint8_t *row;	 /* as encoded */
	uint8_t *filled; /* for codes that do not fill their 8 or 16 bits */
};

static int colour_type(unsigned channels)
{
	static const int types[] = { 0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
		PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA };
	return types[channels];
}

/* Scales an n-bit code to `depth` bits by repeating its leading bits below. */
static unsigned replicate(unsigned code, int n, int depth)
{
	unsigned out = 0;
	for (int shift = depth - n; shift > -n; shift -= n)
		out |= shift >= 0 ? code << shift : code >> -shift;
	return out;
}

static void store(uint8_t *out, unsigned value, int depth)
{
	if (depth == 16)
		*out++ = (uint8_t)(value >> 8);
	*out = (uint8_t)(value & 255);
}

static bool write_row(struct writing *w, unsigned y)
{
	const struct raster *r = w->raster;
	const size_t count = (size_t)r->width * r->channels;
	if (!r->row(r->source, y, w->row))
		return false;
	if (r->sample_bits == 8 && r->bits == 8) {
		png_write_row(w->png, w->row);
		return true;
	}
	const size_t bytes = (size_t)(r->sample_bits / 8);
	for (size_t i = 0; i < count; i++) {
		const unsigned code =
			bytes == 1 ? w->row[i] : ((const uint16_t *)(const void *)w->row)[i];
		store(w->filled + i * bytes, replicate(code, r->bits, r->sample_bits),
			r->sample_bits);
	}
	png_write_row(w->png, w->filled);
	return true;
}

static void write_header(struct writing *w)
{
	const struct raster *r = w->raster;
	png_set_IHDR(w->png, w->info, r->width, r->height, r->sample_bits, colour_type(r->channels),
		PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	png_set_gAMA(w->png, w->info, 1 / (double)r->gamma);
	if (r->is_srgb)
		png_set_sRGB(w->png, w->info, PNG_sRGB_INTENT_PERCEPTUAL);
	const png_byte bits = (png_byte)r->bits;
	const png_color_8 significant = { bits, bits, bits, bits, bits };
	png_set_sBIT(w->png, w->info, &significant);
	png_write_info(w->png, w->info);
}

static bool write_all(struct writing *w, FILE *file)
{
	if (setjmp(png_jmpbuf(w->png)))
		return false;
	png_init_io(w->png, file);
	/* A quarter of the time of the defaults for a sixth more bytes: with simple pictures, packing
	 * them is a good part of the work. */
	png_set_compression_level(w->png, 1);
	png_set_filter(w->png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
	write_header(w);
	for (unsigned y = 0; y < w->raster->height; y++)
		if (!write_row(w, y))
			return false;
	png_write_end(w->png, NULL);
	return true;
}

bool png_write(FILE *file, const struct raster *raster, char *reason)
{
	struct writing w = { .raster = raster };
	w.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, reason, on_error, on_warning);
	w.info = w.png ? png_create_info_struct(w.png) : NULL;
	w.row = memory_alloc(raster->row_bytes, 1);
	w.filled = memory_alloc(raster->row_bytes, 1);
	const bool ok = w.info && write_all(&w, file);
	if (!w.info)
		snprintf(reason, REASON_SIZE, "libpng cannot be used");
	png_destroy_write_struct(&w.png, &w.info);
	free(w.row);
	free(w.filled);
	return ok;
}

/* Reading */

struct reading {
	png_structp png;
	png_infop info;
	struct image *image;
	uint8_t *bytes; /* the rows as libpng expands them */
	size_t row_bytes;
	png_bytep *rows;
};

bool png_recognise(FILE *file)
{
	png_byte signature[8];
	const size_t n = fread(signature, 1, sizeof signature, file);
	rewind(file);
	return n == sizeof signature && png_sig_cmp(signature, 0, sizeof signature) == 0;
}

/* The colours of the palette, with their opacity. */
static void take_palette(struct reading *r)
{
	png_colorp colours = NULL;
	png_bytep alphas = NULL;
	int count = 0, alpha_count = 0;
	if (!png_get_PLTE(r->png, r->info, &colours, &count))
		return;
	png_get_tRNS(r->png, r->info, &alphas, &alpha_count, NULL);
	r->image->palette_size = (unsigned)count;
	for (int i = 0; i < count && i < 256; i++) {
		float *p = r->image->palette[i];
		p[0] = (float)colours[i].red / 255;
		p[1] = (float)colours[i].green / 255;
		p[2] = (float)colours[i].blue / 255;
		p[3] = alphas && i < alpha_count ? (float)alphas[i] / 255 : 1;
	}
}

static void read_gamma(struct reading *r)
{
	int intent;
	double gamma;
	r->image->has_srgb = png_get_sRGB(r->png, r->info, &intent) != 0;
	if (png_get_gAMA(r->png, r->info, &gamma) && gamma > 0)
		r->image->gamma = (float)(1 / gamma);
}

/* Chooses what libpng shall hand out: one byte per index, else 8 or 16 bit samples. */
static void read_header(struct reading *r)
{
	png_read_info(r->png, r->info);
	const int type = png_get_color_type(r->png, r->info);
	r->image->bits = png_get_bit_depth(r->png, r->info);
	read_gamma(r);
	if (type == PNG_COLOR_TYPE_PALETTE) {
		take_palette(r);
		png_set_packing(r->png);
	} else {
		if (type == PNG_COLOR_TYPE_GRAY && r->image->bits < 8)
			png_set_expand_gray_1_2_4_to_8(r->png);
		if (png_get_valid(r->png, r->info, PNG_INFO_tRNS))
			png_set_tRNS_to_alpha(r->png);
	}
	png_set_interlace_handling(r->png);
	png_read_update_info(r->png, r->info);
}

static bool make_room(struct reading *r, char *reason)
{
	struct image *image = r->image;
	image->width = png_get_image_width(r->png, r->info);
	image->height = png_get_image_height(r->png, r->info);
	image->channels = png_get_channels(r->png, r->info);
	if ((size_t)image->width * image->height > SAMPLES_MAX / 4) {
		snprintf(reason, REASON_SIZE, "%u x %u pixels are too many", image->width,
			image->height);
		return false;
	}
	r->row_bytes = png_get_rowbytes(r->png, r->info);
	r->bytes = memory_alloc(image->height, r->row_bytes);
	r->rows = memory_alloc(image->height, sizeof *r->rows);
	for (unsigned y = 0; y < image->height; y++)
		r->rows[y] = r->bytes + y * r->row_bytes;
	return true;
}

static bool read_all(struct reading *r, FILE *file, char *reason)
{
	if (setjmp(png_jmpbuf(r->png)))
		return false;
	png_init_io(r->png, file);
	read_header(r);
	if (!make_room(r, reason))
		return false;
	png_read_image(r->png, r->rows);
	png_read_end(r->png, NULL);
	return true;
}

/* Indices out of the palette (a damaged file) become the last colour's. */
static void expand_palette(struct reading *r)
{
	struct image *image = r->image;
	const size_t pixels = (size_t)image->width * image->height;
	bool has_alpha = false;
	for (unsigned i = 0; i < image->palette_size; i++)
		has_alpha = has_alpha || image->palette[i][3] < 1;
	image->channels = has_alpha ? 4 : 3;
	image->samples = memory_alloc(pixels * image->channels, sizeof *image->samples);
	image->indices = r->bytes;
	r->bytes = NULL;
	for (size_t i = 0; i < pixels; i++) {
		if (image->indices[i] >= image->palette_size)
			image->indices[i] = (unsigned char)(image->palette_size - 1);
		memcpy(image->samples + i * image->channels, image->palette[image->indices[i]],
			image->channels * sizeof *image->samples);
	}
}

static void expand_samples(struct reading *r)
{
	struct image *image = r->image;
	const size_t count = (size_t)image->width * image->height * image->channels;
	image->samples = memory_alloc(count, sizeof *image->samples);
	for (size_t i = 0; i < count; i++) {
		const uint8_t *p = r->bytes + (image->bits == 16 ? 2 * i : i);
		image->samples[i] =
			image->bits == 16 ? (float)(p[0] << 8 | p[1]) / 65535 : (float)p[0] / 255;
	}
}

struct image *png_read(FILE *file, char *reason)
{
	struct reading r = { .image = memory_alloc(1, sizeof *r.image) };
	memset(r.image, 0, sizeof *r.image);
	r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, reason, on_error, on_warning);
	r.info = r.png ? png_create_info_struct(r.png) : NULL;
	bool ok = r.info && read_all(&r, file, reason);
	if (ok && r.image->palette_size)
		expand_palette(&r);
	else if (ok)
		expand_samples(&r);
	png_destroy_read_struct(&r.png, &r.info, NULL);
	free(r.bytes);
	free(r.rows);
	if (!ok) {
		image_destroy(r.image);
		return NULL;
	}
	return r.image;
}
