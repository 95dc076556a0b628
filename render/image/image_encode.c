/* SPDX-License-Identifier: MIT */
/*
 * From the numbers of the film to the codes of a file.
 *
 * A working value is decoded to linear light and encoded with the curve of the
 * file; code = floor(clip(encoded) * M + 1/2) with M = 2^bits - 1. For up to 8
 * bits the codes come from a table of the smallest value that yields each code,
 * found by bisection over the floats: the same codes as the formula, without
 * its powers. The table is entered by the leading bits of the value.
 *
 * Dithering adds an offset before rounding (ordered) or carries the error on to
 * pixels that follow (D1, D2, Floyd and Steinberg 1976).
 */
#include "image_encode.h"

#include "base/arena.h"
#include "base/elementary.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A power this close to 1 is no power at all. */
static const float POWER_IS_LINEAR = 0.01f;
/* Stands for an alpha of 0 where colour is divided by it. */
static const float SMALLEST_ALPHA = 1e-6f;

/* Curves */

static struct working_space simplified(struct working_space s)
{
	if (s.transfer == TRANSFER_POWER && fabsf(1 - 1 / s.gamma) <= POWER_IS_LINEAR)
		s.transfer = TRANSFER_LINEAR;
	return s;
}

static float power(float x, float exponent)
{
	return elementary_powf(fmaxf(x, 0), exponent);
}

static float curve_encode(struct working_space curve, float x)
{
	switch (curve.transfer) {
	case TRANSFER_SRGB:
		return x <= 0.0031308f ? 12.92f * x
				       : 1.055f * elementary_powf(x, 1 / 2.4f) - 0.055f;
	case TRANSFER_POWER:
		return power(x, 1 / curve.gamma);
	default:
		return x;
	}
}

static float curve_decode(struct working_space curve, float y)
{
	switch (curve.transfer) {
	case TRANSFER_SRGB:
		return y < 0.04045f ? y / 12.92f : elementary_powf((y + 0.055f) / 1.055f, 2.4f);
	case TRANSFER_POWER:
		return power(y, curve.gamma);
	default:
		return y;
	}
}

bool image_same_curve(struct working_space a, struct working_space b)
{
	return a.transfer == b.transfer && (a.transfer != TRANSFER_POWER || a.gamma == b.gamma);
}

/* The shortcuts avoid rounding twice. */
float image_convert(struct working_space from, struct working_space to, float x)
{
	from = simplified(from);
	to = simplified(to);
	if (image_same_curve(from, to))
		return x;
	if (from.transfer == TRANSFER_POWER && to.transfer == TRANSFER_POWER)
		return power(x, from.gamma / to.gamma);
	return curve_encode(to, curve_decode(from, x));
}

float encode_value(const struct image_encoding *e, float value)
{
	if (e->working.transfer == TRANSFER_NONE)
		return value;
	return image_convert(e->working, e->file, value);
}

float encode_inverse(const struct image_encoding *e, float encoded)
{
	if (e->working.transfer == TRANSFER_NONE)
		return encoded;
	return image_convert(e->file, e->working, encoded);
}

/* Quantisation */

/* 0 for what is not a number. */
static float clip(float y)
{
	return y > 0 ? (y < 1 ? y : 1) : 0;
}

static unsigned quantise(float y, float maximum)
{
	return (unsigned)floorf(clip(y) * maximum + 0.5f);
}

static unsigned maximum_code(const struct image_encoding *e)
{
	return (1u << e->bits) - 1;
}

enum {
	BUCKET_SHIFT = 16, /* bits of a float that do not choose its bucket */
	FIRST_BUCKET = (127 - 24) << (23 - BUCKET_SHIFT),
	LAST_BUCKET = 127 << (23 - BUCKET_SHIFT), /* begins with 1 */
	BUCKETS = LAST_BUCKET - FIRST_BUCKET + 1,
};

/* lowest[c] is the smallest value with code c or above; a bucket holds the code of its first
 * value. */
struct code_table {
	float lowest[257];
	uint8_t bucket[BUCKETS];
};

static float float_of(uint32_t bits)
{
	float f;
	memcpy(&f, &bits, sizeof f);
	return f;
}

static uint32_t bits_of(float f)
{
	uint32_t bits;
	memcpy(&bits, &f, sizeof bits);
	return bits;
}

static float lowest_value(const struct image_encoding *e, unsigned code)
{
	const float maximum = (float)maximum_code(e);
	uint32_t below = 0, reached = bits_of(1);
	while (reached - below > 1) {
		const uint32_t middle = below + (reached - below) / 2;
		if (quantise(encode_value(e, float_of(middle)), maximum) >= code)
			reached = middle;
		else
			below = middle;
	}
	return float_of(reached);
}

static void table_init(struct code_table *t, const struct image_encoding *e)
{
	const unsigned maximum = maximum_code(e);
	t->lowest[0] = 0;
	for (unsigned c = 1; c <= maximum; c++)
		t->lowest[c] = lowest_value(e, c);
	t->lowest[maximum + 1] = INFINITY;
	unsigned code = 0;
	for (uint32_t b = 0; b < BUCKETS; b++) {
		const float first = float_of((FIRST_BUCKET + b) << BUCKET_SHIFT);
		while (first >= t->lowest[code + 1])
			code++;
		t->bucket[b] = (uint8_t)code;
	}
}

static unsigned table_code(const struct code_table *t, float value)
{
	const float x = clip(value);
	const uint32_t b = bits_of(x) >> BUCKET_SHIFT;
	unsigned code = b < FIRST_BUCKET ? 0 : t->bucket[b - FIRST_BUCKET];
	while (x >= t->lowest[code + 1])
		code++;
	return code;
}

/* Pixels */

unsigned encode_channels(const struct image_encoding *e)
{
	return (e->grayscale ? 1u : 3u) + (e->alpha ? 1u : 0u);
}

/* Colour divided by alpha. A highlight on something transparent is brighter than its alpha allows;
 * alpha is raised for it. */
static void make_straight(rgb *c, float *alpha)
{
	const float grey = rgb_luminance(*c);
	if (grey > *alpha)
		*alpha = fminf(1, grey);
	const float divisor = *alpha == 0 ? SMALLEST_ALPHA : *alpha;
	*c = (rgb){ c->r / divisor, c->g / divisor, c->b / divisor };
}

/* The samples of one pixel in the working space, alpha last. */
static void pixel_samples(const struct image_encoding *e, colour c, float out[4])
{
	rgb light = colour_rgb(c);
	if (e->grayscale)
		light = rgb_grey(rgb_luminance(light));
	float alpha = 1 - c.transmit;
	if (e->alpha && !image_formats[e->format].is_premultiplied)
		make_straight(&light, &alpha);
	unsigned n = 0;
	out[n++] = light.r;
	if (!e->grayscale) {
		out[n++] = light.g;
		out[n++] = light.b;
	}
	out[n] = alpha;
}

/* Dithering */

/* Offset of pixel (x, y) in shares of one step of the codes. */
static float ordered_offset(enum dither dither, unsigned x, unsigned y)
{
	static const float m2[2][2] = { { 1, 3 }, { 4, 2 } };
	static const float m3[3][3] = { { 3, 7, 4 }, { 6, 1, 9 }, { 2, 8, 5 } };
	static const float m4[4][4] = { { 1, 9, 3, 11 }, { 13, 5, 15, 7 }, { 4, 12, 2, 10 },
		{ 16, 8, 14, 6 } };
	switch (dither) {
	case DITHER_B2:
		return m2[x % 2][y % 2] / 4 - 0.5f;
	case DITHER_B3:
		return m3[x % 3][y % 3] / 9 - 0.5f;
	case DITHER_B4:
		return m4[x % 4][y % 4] / 16 - 0.5f;
	default:
		return 0;
	}
}

/* Errors on their way to pixels of this row and the next, one slot beyond each end. */
struct diffusion {
	enum dither dither;
	unsigned width;
	float (*here)[4], (*below)[4];
	float carried[4]; /* D1 */
};

static void diffusion_init(struct diffusion *d, enum dither dither, unsigned width)
{
	*d = (struct diffusion){ .dither = dither, .width = width };
	if (dither != DITHER_D2 && dither != DITHER_FS)
		return;
	const size_t slots = (size_t)width + 2;
	d->here = memory_alloc(slots, sizeof *d->here);
	d->below = memory_alloc(slots, sizeof *d->below);
	memset(d->here, 0, slots * sizeof *d->here);
	memset(d->below, 0, slots * sizeof *d->below);
}

static void diffusion_finish(struct diffusion *d)
{
	free(d->here);
	free(d->below);
}

/* The error that reaches pixel x. POV-Ray takes the error of a row's first pixel before it turns to
 * the row's buffer, so that pixel gets what its upper neighbour got; so do we. */
static void diffusion_fetch(struct diffusion *d, unsigned x, float error[4])
{
	if (d->dither == DITHER_D1)
		memcpy(error, d->carried, sizeof d->carried);
	else if (d->here)
		memcpy(error, d->here[x + 1], sizeof *d->here);
	else
		memset(error, 0, 4 * sizeof *error);
	if (x > 0 || !d->here)
		return;
	float(*const old)[4] = d->here;
	d->here = d->below;
	d->below = old;
	memset(old, 0, ((size_t)d->width + 2) * sizeof *old);
}

static void spread(float slot[4], const float error[4], float share)
{
	for (int i = 0; i < 4; i++)
		slot[i] += error[i] * share;
}

static void diffusion_store(struct diffusion *d, unsigned x, const float error[4])
{
	const unsigned slot = x + 1;
	switch (d->dither) {
	case DITHER_D1:
		memcpy(d->carried, error, sizeof d->carried);
		break;
	case DITHER_D2:
		spread(d->here[slot + 1], error, 1 / 2.f);
		spread(d->below[slot], error, 1 / 4.f);
		spread(d->below[slot + 1], error, 1 / 4.f);
		break;
	case DITHER_FS:
		spread(d->here[slot + 1], error, 7 / 16.f);
		spread(d->below[slot - 1], error, 3 / 16.f);
		spread(d->below[slot], error, 5 / 16.f);
		spread(d->below[slot + 1], error, 1 / 16.f);
		break;
	default:
		break;
	}
}

/* Rows */

static void put_code(const struct image_encoding *e, void *codes, size_t index, unsigned code)
{
	if (e->bits <= 8)
		((uint8_t *)codes)[index] = (uint8_t)code;
	else
		((uint16_t *)codes)[index] = (uint16_t)code;
}

struct encoder {
	const struct film *film;
	struct image_encoding encoding;
	unsigned channels, colours; /* samples of a pixel; those that are not alpha */
	bool is_float;
	struct working_space working; /* floats: what they are decoded from */
	struct code_table *table;     /* for up to 8 bits without dithering */
	struct diffusion diffusion;   /* with dithering */
	colour *pixels;		      /* of a row that the film does not keep as a whole */
	void *black; /* a row without pixels of the film, as encoded; NULL: none yet */
	size_t row_bytes;
};

static void plain_row(const struct encoder *c, const colour *pixels, void *codes)
{
	const struct image_encoding *e = &c->encoding;
	const float maximum = (float)maximum_code(e);
	for (size_t x = 0; x < c->film->width; x++) {
		float s[4];
		pixel_samples(e, pixels[x], s);
		for (unsigned i = 0; i < c->channels; i++) {
			const unsigned code = i >= c->colours ? quantise(s[i], maximum)
					      : c->table      ? table_code(c->table, s[i])
							 : quantise(encode_value(e, s[i]), maximum);
			put_code(e, codes, x * c->channels + i, code);
		}
	}
}

/* The code of one sample; *error is what arrives from other pixels, then what goes on to them. */
static unsigned dithered_code(
	const struct image_encoding *e, float sample, bool is_alpha, float offset, float *error)
{
	const float maximum = (float)maximum_code(e);
	const float x = sample + *error;
	const float y = is_alpha ? x : encode_value(e, x);
	const unsigned code = quantise(y + offset / maximum, maximum);
	const float stored = (float)code / maximum;
	*error = clip(x) - (is_alpha ? stored : encode_inverse(e, stored));
	return code;
}

static void dithered_row(struct encoder *c, unsigned y, const colour *pixels, void *codes)
{
	const struct image_encoding *e = &c->encoding;
	const bool diffuses = e->dither >= DITHER_D1;
	for (unsigned x = 0; x < c->film->width; x++) {
		float s[4], error[4];
		pixel_samples(e, pixels[x], s);
		diffusion_fetch(&c->diffusion, x, error);
		const float offset = diffuses ? 0 : ordered_offset(e->dither, x, y);
		for (unsigned i = 0; i < c->channels; i++)
			put_code(e, codes, (size_t)x * c->channels + i,
				dithered_code(e, s[i], i >= c->colours, offset, &error[i]));
		if (diffuses)
			diffusion_store(&c->diffusion, x, error);
	}
}

static void linear_row(const struct encoder *c, const colour *pixels, float *samples)
{
	for (size_t x = 0; x < c->film->width; x++) {
		float s[4];
		pixel_samples(&c->encoding, pixels[x], s);
		for (unsigned i = 0; i < c->colours; i++)
			s[i] = curve_decode(c->working, s[i]);
		memcpy(samples + x * c->channels, s, c->channels * sizeof *s);
	}
}

static void encode_row(struct encoder *c, unsigned y, const colour *pixels, void *out)
{
	if (c->is_float)
		linear_row(c, pixels, out);
	else if (c->encoding.dither == DITHER_NONE)
		plain_row(c, pixels, out);
	else
		dithered_row(c, y, pixels, out);
}

/* The pixels of a row, black where the film keeps none. */
static const colour *row_pixels(struct encoder *c, unsigned y)
{
	const struct film *film = c->film;
	const struct block *part = &film->part;
	const unsigned width = part->right - part->left;
	const bool is_kept = y >= part->top && y < part->bottom;
	if (is_kept && width == film->width)
		return film_pixel(film, 0, y);
	memset(c->pixels, 0, film->width * sizeof *c->pixels);
	if (is_kept)
		memcpy(c->pixels + part->left, film_pixel(film, part->left, y),
			width * sizeof *c->pixels);
	return c->pixels;
}

/* Without dithering black rows are all the same. */
static void black_row(struct encoder *c, unsigned y, void *out)
{
	if (!c->black) {
		c->black = memory_alloc(c->row_bytes, 1);
		encode_row(c, y, row_pixels(c, y), c->black);
	}
	memcpy(out, c->black, c->row_bytes);
}

struct encoder *encoder_create(
	const struct film *film, const struct image_encoding *e, bool is_float)
{
	struct encoder *c = memory_alloc(1, sizeof *c);
	*c = (struct encoder){ .film = film,
		.encoding = *e,
		.channels = encode_channels(e),
		.is_float = is_float,
		.working = simplified(e->working) };
	c->colours = c->channels - (e->alpha ? 1 : 0);
	c->row_bytes = (size_t)film->width * c->channels *
		       (is_float	     ? sizeof(float)
			       : e->bits > 8 ? sizeof(uint16_t)
					     : sizeof(uint8_t));
	c->pixels = memory_alloc(film->width, sizeof *c->pixels);
	if (!is_float && e->dither == DITHER_NONE && e->bits <= 8) {
		c->table = memory_alloc(1, sizeof *c->table);
		table_init(c->table, e);
	}
	diffusion_init(&c->diffusion, e->dither, film->width);
	return c;
}

void encoder_destroy(struct encoder *c)
{
	if (!c)
		return;
	diffusion_finish(&c->diffusion);
	free(c->table);
	free(c->pixels);
	free(c->black);
	free(c);
}

size_t encoder_row_bytes(const struct encoder *c)
{
	return c->row_bytes;
}

void encoder_row(struct encoder *c, unsigned y, void *out)
{
	const struct block *part = &c->film->part;
	const bool is_black = y < part->top || y >= part->bottom;
	if (is_black && (c->is_float || c->encoding.dither == DITHER_NONE))
		black_row(c, y, out);
	else
		encode_row(c, y, row_pixels(c, y), out);
}
