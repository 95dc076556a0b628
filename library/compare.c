/* SPDX-License-Identifier: MIT */
/*
 * How two picture files differ: per channel, over all, by shares of pixels within
 * a distance, and by structural similarity (Wang et al. 2004) of the luminance in
 * blocks of 8 x 8, on a scale of 0 to 255.
 *
 * Codes of the same curve are compared as stored. Otherwise both pictures are
 * first brought to one space: encoded as sRGB, times alpha, and within 0 to 1 as
 * soon as one of the files can hold no more.
 */
#include "lambert/lambert.h"

#include "base/arena.h"
#include "base/elementary.h"
#include "image/image.h"
#include "image/image_format.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 8 };

static void complain(lambert_message_function message, void *user, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
static void complain(lambert_message_function message, void *user, const char *format, ...)
{
	char text[1024];
	va_list args;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	if (message)
		message(user, &(struct lambert_message){ .severity = LAMBERT_ERROR, .text = text });
}

/* One space */

static bool has_alpha(const struct image *image)
{
	return image->channels % 2 == 0;
}

/* Alpha that is straight in one and multiplied in in the other, or a curve of its own. Floats are never
 * alike: a distance of linear light says little of what is seen. */
static bool are_stored_alike(const struct image *a, const struct image *b)
{
	const bool same_alpha =
		!has_alpha(a) || !has_alpha(b) || a->premultiplied == b->premultiplied;
	return same_alpha && a->bits <= 16 && b->bits <= 16 &&
	       image_same_curve(image_curve(a), image_curve(b));
}

/* Undoes the product with alpha. Where a colour is brighter than its alpha allows, alpha is raised, as
 * it is when a picture with straight alpha is written. */
static void make_straight(float *sample, unsigned colours)
{
	float *alpha = &sample[colours];
	const float light =
		colours == 1 ? sample[0] : rgb_luminance((rgb){ sample[0], sample[1], sample[2] });
	if (light > *alpha)
		*alpha = fminf(1, light);
	for (unsigned c = 0; c < colours; c++)
		sample[c] = *alpha > 0 ? sample[c] / *alpha : 0;
}

/* What is not a number stays so: it differs from everything. */
static float clip(float x)
{
	return x < 0 ? 0 : x > 1 ? 1 : x;
}

static void bring_to_srgb(struct image *image, bool clipped)
{
	static const struct working_space linear = { .transfer = TRANSFER_LINEAR },
					  srgb = { .transfer = TRANSFER_SRGB };
	const struct working_space curve = image_curve(image);
	const unsigned colours = image->channels - has_alpha(image);
	const size_t pixels = (size_t)image->width * image->height;
	for (size_t i = 0; i < pixels; i++) {
		float *s = image->samples + i * image->channels;
		for (unsigned c = 0; c < colours; c++)
			s[c] = image_convert(curve, linear, s[c]);
		if (has_alpha(image) && image->premultiplied)
			make_straight(s, colours);
		for (unsigned c = 0; c < colours; c++) {
			s[c] = image_convert(linear, srgb, clipped ? clip(s[c]) : s[c]);
			s[c] *= has_alpha(image) ? s[colours] : 1;
		}
	}
	image->bits = 32;
}

/* False when nobody knows how the numbers of one stand for those of the other. */
static bool bring_together(struct image *a, struct image *b)
{
	if (a->is_greymap != b->is_greymap)
		return false;
	if (are_stored_alike(a, b))
		return true;
	const bool clipped = a->bits <= 16 || b->bits <= 16;
	bring_to_srgb(a, clipped);
	bring_to_srgb(b, clipped);
	return true;
}

/* Measures */

/* A sample on the scale of 0 to 255. Codes of up to 16 bits come out exactly, so that equal distances
 * of codes are equal numbers. */
static double scaled(const struct image *image, float sample)
{
	return image->bits > 16 ? 255 * (double)sample : nearbyint(65535 * (double)sample) / 257;
}

/* Red, green, blue, alpha of pixel number i, 0 to 255. */
static void rgba(const struct image *image, size_t i, double out[4])
{
	const float *s = image->samples + i * image->channels;
	const bool is_grey = image->channels < 3;
	for (unsigned c = 0; c < 3; c++)
		out[c] = scaled(image, s[is_grey ? 0 : c]);
	out[3] = has_alpha(image) ? scaled(image, s[image->channels - 1]) : 255;
}

static double luminance(const struct image *image, size_t i)
{
	double c[4];
	rgba(image, i, c);
	return 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2];
}

/* The largest difference of a channel; counts as infinite when one is not a number. */
static double pixel_difference(
	const struct image *a, const struct image *b, size_t i, double difference[4])
{
	double p[4], q[4], largest = 0;
	rgba(a, i, p);
	rgba(b, i, q);
	for (int c = 0; c < 4; c++) {
		difference[c] = p[c] == q[c] ? 0 : fabs(p[c] - q[c]);
		if (isnan(difference[c]))
			difference[c] = INFINITY;
		largest = fmax(largest, difference[c]);
	}
	return largest;
}

static void measure_pixels(
	const struct image *a, const struct image *b, struct lambert_difference *d)
{
	const size_t pixels = (size_t)a->width * a->height;
	double squares[4] = { 0 };
	size_t within[3] = { 0 };
	static const double limits[3] = { 1, 2, 8 };
	d->worst = -1;
	for (size_t i = 0; i < pixels; i++) {
		double difference[4];
		const double largest = pixel_difference(a, b, i, difference);
		for (int c = 0; c < 4; c++) {
			squares[c] += difference[c] * difference[c];
			d->maximum[c] = fmax(d->maximum[c], difference[c]);
		}
		for (int k = 0; k < 3; k++)
			within[k] += largest <= limits[k];
		if (largest > d->worst) {
			d->worst = largest;
			d->worst_x = (unsigned)(i % a->width);
			d->worst_y = (unsigned)(i / a->width);
		}
	}
	const double n = (double)pixels;
	for (int c = 0; c < 4; c++)
		d->rmse[c] = sqrt(squares[c] / n);
	d->rmse_all = sqrt((squares[0] + squares[1] + squares[2]) / (3 * n));
	d->psnr = d->rmse_all > 0 ? 20 * elementary_log10(255 / d->rmse_all) : INFINITY;
	d->within_1 = (double)within[0] / n;
	d->within_2 = (double)within[1] / n;
	d->within_8 = (double)within[2] / n;
}

/* Similarity of one block, 1 when equal. */
static double block_ssim(const struct image *a, const struct image *b, unsigned left, unsigned top,
	unsigned width, unsigned height)
{
	const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
	double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
	for (unsigned y = top; y < top + height; y++) {
		for (unsigned x = left; x < left + width; x++) {
			const size_t i = (size_t)y * a->width + x;
			const double p = luminance(a, i), q = luminance(b, i);
			sa += p;
			sb += q;
			saa += p * p;
			sbb += q * q;
			sab += p * q;
		}
	}
	const double n = (double)width * height;
	const double ma = sa / n, mb = sb / n;
	const double va = saa / n - ma * ma, vb = sbb / n - mb * mb, cov = sab / n - ma * mb;
	return (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

/* Blocks stand side by side; the last of a row or column is moved inwards to be whole. */
static double lowest_ssim(const struct image *a, const struct image *b)
{
	const unsigned width = a->width < BLOCK ? a->width : BLOCK;
	const unsigned height = a->height < BLOCK ? a->height : BLOCK;
	double lowest = 1;
	for (unsigned y = 0; y < a->height; y += BLOCK) {
		for (unsigned x = 0; x < a->width; x += BLOCK) {
			const unsigned left = x + width > a->width ? a->width - width : x;
			const unsigned top = y + height > a->height ? a->height - height : y;
			const double s = block_ssim(a, b, left, top, width, height);
			if (!(s >= lowest))
				lowest = isnan(s) ? -1 : s;
		}
	}
	return lowest;
}

/* Black - blue - red - yellow - white; square root, so that small differences show. */
static colour heat(double difference)
{
	static const rgb stops[5] = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 },
		{ 1, 1, 1 } };
	const double t = 4 * sqrt(fmin(difference, 255) / 255);
	const int i = t < 3 ? (int)t : 3;
	const rgb c = rgb_add(rgb_scale(stops[i], 1 - (t - i)), rgb_scale(stops[i + 1], t - i));
	return (colour){ c.r, c.g, c.b, 0, 0 };
}

static bool write_heatmap(const struct image *a, const struct image *b, const char *path,
	lambert_message_function message, void *user)
{
	const size_t pixels = (size_t)a->width * a->height;
	struct film *film = film_create(a->width, a->height);
	for (size_t i = 0; i < pixels; i++) {
		double difference[4];
		film->pixels[i] = heat(pixel_difference(a, b, i, difference));
	}
	const struct image_encoding plain = { .format = IMAGE_PNG, .bits = 8 };
	const char *why = NULL;
	const bool ok = image_write(film, &plain, path, NULL, NULL, &why);
	film_destroy(film);
	if (!ok)
		complain(message, user, "the heat map %s cannot be written: %s", path, why);
	return ok;
}

static struct image *read_picture(const char *path, lambert_message_function message, void *user)
{
	const char *why = NULL;
	struct image *image = image_read(path, &why);
	if (!image)
		complain(message, user, "the picture %s cannot be read: %s", path, why);
	return image;
}

static bool measure(struct image *a, struct image *b, const char *heatmap,
	struct lambert_difference *d, lambert_message_function message, void *user)
{
	if (a->width != b->width || a->height != b->height) {
		complain(message, user, "the pictures differ in size: %u x %u and %u x %u",
			a->width, a->height, b->width, b->height);
		return false;
	}
	if (!bring_together(a, b)) {
		complain(message, user,
			"a PGM does not say whether it holds sRGB or the numbers of a scene: it is "
			"compared with a PGM only");
		return false;
	}
	*d = (struct lambert_difference){
		.width = a->width, .height = a->height, .as_stored = a->bits <= 16
	};
	measure_pixels(a, b, d);
	d->lowest_ssim = lowest_ssim(a, b);
	return !heatmap || write_heatmap(a, b, heatmap, message, user);
}

bool lambert_compare(const char *a, const char *b, const char *heatmap,
	struct lambert_difference *difference, lambert_message_function message, void *user)
{
	struct image *first = read_picture(a, message, user);
	struct image *second = first ? read_picture(b, message, user) : NULL;
	const bool ok = second && measure(first, second, heatmap, difference, message, user);
	image_destroy(first);
	image_destroy(second);
	return ok;
}
