/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files: transfer curves, quantisation, straight alpha, dithering,
 * and the way to a PNG and back. Reference values were measured with POV-Ray.
 */
#include "base/arena.h"
#include "api.h"
#include "image/image.h"
#include "image_encode.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
/* clang-format off: cmocka needs what stands above */
#include <cmocka.h>
/* clang-format on */

static const struct working_space LINEAR = { TRANSFER_LINEAR, 1 }, SRGB = { TRANSFER_SRGB, 0 },
				  NONE = { TRANSFER_NONE, 0 };

static struct image_encoding encoding(struct working_space working, struct working_space file)
{
	return (struct image_encoding){
		.format = IMAGE_PNG, .bits = 8, .working = working, .file = file
	};
}

static struct film *film_of(unsigned width, unsigned height, colour c)
{
	struct film *film = film_create(width, height);
	for (size_t i = 0; i < (size_t)width * height; i++)
		film->pixels[i] = c;
	return film;
}

/* The codes of a whole film. */
static void encode_codes(const struct film *film, const struct image_encoding *e, void *codes)
{
	struct encoder *encoder = encoder_create(film, e, false);
	for (unsigned y = 0; y < film->height; y++)
		encoder_row(encoder, y, (char *)codes + y * encoder_row_bytes(encoder));
	encoder_destroy(encoder);
}

/* The 8-bit code of a grey of this value. */
static unsigned code(const struct image_encoding *e, float value)
{
	struct film *film = film_of(1, 1, (colour){ value, value, value, 0, 0 });
	uint8_t codes[3];
	encode_codes(film, e, codes);
	film_destroy(film);
	assert_int_equal(codes[0], codes[2]);
	return codes[0];
}

static void curves_agree_with_the_reference(void **state)
{
	(void)state;
	const struct working_space power_22 = { TRANSFER_POWER, 2.2f };
	const struct working_space power_18 = { TRANSFER_POWER, 1.8f };
	const struct image_encoding usual = encoding(LINEAR, SRGB), old = encoding(NONE, SRGB);
	const struct image_encoding file_18 = encoding(LINEAR, power_18);
	const struct image_encoding working_22 = encoding(power_22, SRGB);
	const struct image_encoding both_22 = encoding(power_22, power_22);
	assert_int_equal(code(&usual, 0.5f), 188);
	assert_int_equal(code(&old, 0.5f), 128);
	assert_int_equal(code(&file_18, 0.5f), 174);
	assert_int_equal(code(&working_22, 0.25f), 61);
	assert_int_equal(code(&both_22, 0.25f), 64);
}

static void a_power_near_one_is_linear(void **state)
{
	(void)state;
	const struct image_encoding e =
		encoding(LINEAR, (struct working_space){ TRANSFER_POWER, 1.005f });
	assert_true(encode_value(&e, 0.3f) == 0.3f);
}

static void values_out_of_range_are_clipped(void **state)
{
	(void)state;
	const struct image_encoding e = encoding(LINEAR, SRGB);
	assert_int_equal(code(&e, -1), 0);
	assert_int_equal(code(&e, 7), 255);
	assert_int_equal(code(&e, INFINITY), 255);
	assert_int_equal(code(&e, -INFINITY), 0);
	assert_int_equal(code(&e, NAN), 0);
}

/* The table must give what the formula gives, also right at the steps. */
static void table_equals_formula(const struct image_encoding *e)
{
	enum { COUNT = 200000 };
	const float maximum = (float)((1u << e->bits) - 1);
	struct film *film = film_create(COUNT, 1);
	for (int i = 0; i < COUNT; i++) {
		const float v = (float)i / (COUNT - 1);
		const float step = encode_inverse(e, ((float)(i % 255) + 0.5f) / maximum);
		film->pixels[i] =
			(colour){ v, v * v * v * v, nextafterf(step, i & 1 ? 0 : 1), 0, 0 };
	}
	uint8_t *codes = memory_alloc(COUNT, 3);
	encode_codes(film, e, codes);
	for (int i = 0; i < COUNT; i++) {
		const float *v = &film->pixels[i].r;
		for (int c = 0; c < 3; c++) {
			const float y = fminf(fmaxf(encode_value(e, v[c]), 0), 1);
			assert_int_equal(codes[3 * i + c], (int)floorf(y * maximum + 0.5f));
		}
	}
	free(codes);
	film_destroy(film);
}

static void tables_equal_formulas(void **state)
{
	(void)state;
	static const float gammas[] = { 0.5f, 1, 1.8f, 2.2f, 4 };
	for (int bits = 5; bits <= 8; bits++) {
		for (size_t i = 0; i < sizeof gammas / sizeof *gammas; i++) {
			struct image_encoding e =
				encoding((struct working_space){ TRANSFER_POWER, gammas[i] }, SRGB);
			e.bits = bits;
			table_equals_formula(&e);
		}
		struct image_encoding old = encoding(NONE, SRGB);
		old.bits = bits;
		table_equals_formula(&old);
	}
}

static void encoding_can_be_undone(void **state)
{
	(void)state;
	const struct image_encoding e =
		encoding((struct working_space){ TRANSFER_POWER, 2.2f }, SRGB);
	for (float v = 0; v <= 1; v += 0.01f)
		assert_true(fabsf(encode_inverse(&e, encode_value(&e, v)) - v) < 1e-5f);
}

/* rgb, alpha of one pixel of a PNG with alpha. */
static void straight_codes(colour c, unsigned expected_red, unsigned expected_alpha)
{
	struct image_encoding e = encoding(LINEAR, LINEAR);
	e.alpha = true;
	struct film *film = film_of(1, 1, c);
	uint8_t codes[4];
	encode_codes(film, &e, codes);
	film_destroy(film);
	assert_int_equal(codes[0], expected_red);
	assert_int_equal(codes[3], expected_alpha);
}

static void alpha_is_straight_in_png(void **state)
{
	(void)state;
	straight_codes((colour){ 0.25f, 0, 0, 0, 0.5f }, 128, 128);
	straight_codes((colour){ 0, 0, 0, 0, 1 }, 0, 0);
	/* a highlight raises alpha to its luminance */
	straight_codes((colour){ 0.8f, 0.8f, 0.8f, 0, 0.8f }, 255, 204);
	straight_codes((colour){ 9, 9, 9, 0, 1 }, 255, 255);
}

/* The green codes of a constant rgb <0.1, 0.437, 0.8>, with the picture's first rows as POV-Ray
 * writes them. Error diffusion leaves the first column of row 1 with the error of row 0. */
static void dithering_agrees_with_the_reference(void **state)
{
	(void)state;
	static const struct {
		enum dither dither;
		uint8_t above[4][8]; /* codes less 176 */
	} cases[] = {
		{ DITHER_FS, { { 1, 0, 1, 0, 1, 0, 1, 0 }, { 1, 0, 1, 0, 1, 0, 1, 0 },
				     { 0, 1, 0, 1, 0, 1, 0, 1 }, { 0, 1, 0, 1, 0, 1, 0, 1 } } },
		{ DITHER_D2, { { 1, 0, 1, 0, 1, 0, 1, 0 }, { 1, 0, 1, 0, 1, 0, 1, 0 },
				     { 0, 1, 0, 1, 0, 1, 0, 1 }, { 0, 1, 0, 1, 0, 1, 0, 1 } } },
		{ DITHER_D1, { { 1, 0, 1, 0, 1, 0, 1, 0 }, { 0, 1, 0, 1, 0, 1, 0, 1 },
				     { 1, 0, 1, 1, 0, 1, 0, 1 }, { 1, 0, 1, 0, 1, 0, 1, 0 } } },
		{ DITHER_B3, { { 0, 1, 0, 0, 1, 0, 0, 1 }, { 1, 0, 1, 1, 0, 1, 1, 0 },
				     { 0, 1, 1, 0, 1, 1, 0, 1 }, { 0, 1, 0, 0, 1, 0, 0, 1 } } },
	};
	struct film *film = film_of(13, 7, (colour){ 0.1f, 0.437f, 0.8f, 0, 0 });
	for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
		uint8_t codes[7][13][3];
		struct image_encoding e = encoding(LINEAR, SRGB);
		e.dither = cases[k].dither;
		encode_codes(film, &e, codes);
		for (int y = 0; y < 4; y++)
			for (int x = 0; x < 8; x++)
				assert_int_equal(codes[y][x][1], 176 + cases[k].above[y][x]);
	}
	film_destroy(film);
}

/* Files */

static char folder[] = "/tmp/lambert-test-XXXXXX";

static int make_folder(void **state)
{
	(void)state;
	return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
	(void)state;
	return rmdir(folder); /* fails when something was left behind */
}

static const char *in_folder(const char *name)
{
	static char path[256];
	snprintf(path, sizeof path, "%s/%s", folder, name);
	return path;
}

/* Red ramp across, green ramp down, half transparent. */
static struct film *ramps(unsigned width, unsigned height)
{
	struct film *film = film_create(width, height);
	for (unsigned y = 0; y < height; y++)
		for (unsigned x = 0; x < width; x++)
			film->pixels[y * width + x] = (colour){ 0.5f * (float)x / (float)width,
				0.5f * (float)y / (float)height, 0.2f, 0, 0.5f };
	return film;
}

static void comes_back(int bits, bool alpha, bool grayscale)
{
	struct film *film = ramps(37, 11);
	struct image_encoding e = encoding(LINEAR, SRGB);
	e.bits = bits;
	e.alpha = alpha;
	e.grayscale = grayscale;
	const char *path = in_folder("picture.png"), *why = NULL;
	assert_true(image_write(film, &e, path, NULL, NULL, &why));
	struct image *image = image_read(path, &why);
	assert_non_null(image);
	assert_int_equal(unlink(path), 0);
	if (grayscale)
		e.bits = 16;
	assert_int_equal(image->width, 37);
	assert_int_equal(image->height, 11);
	assert_int_equal(image->channels, encode_channels(&e));
	assert_int_equal(image->bits, e.bits <= 8 ? 8 : 16);
	assert_true(image->has_srgb);
	assert_true(fabsf(image->gamma - 2.2f) < 1e-3f);
	const size_t count = (size_t)37 * 11 * image->channels;
	uint16_t *codes = memory_alloc(count, 2);
	encode_codes(film, &e, codes);
	const float maximum = (float)((1u << e.bits) - 1);
	for (size_t i = 0; i < count; i++) {
		const unsigned c = e.bits <= 8 ? ((uint8_t *)codes)[i] : codes[i];
		/* codes of other depths are scaled by repeating their bits: at most a step off */
		assert_true(fabsf(image->samples[i] - (float)c / maximum) <
			    (e.bits == 8 || e.bits == 16 ? 1e-6f : 1 / 255.f));
		const float back = image->samples[i] * maximum;
		assert_int_equal((unsigned)lroundf(back), c);
	}
	free(codes);
	image_destroy(image);
	film_destroy(film);
}

static void png_comes_back(void **state)
{
	(void)state;
	for (int bits = 5; bits <= 16; bits++) {
		comes_back(bits, false, false);
		comes_back(bits, true, false);
	}
	comes_back(8, false, true);
	comes_back(8, true, true);
}

static void same_picture_same_bytes(void **state)
{
	(void)state;
	struct film *film = ramps(20, 20);
	const struct image_encoding e = encoding(LINEAR, SRGB);
	char *bytes[2];
	size_t sizes[2];
	for (int i = 0; i < 2; i++) {
		const char *path = in_folder("same.png"), *why = NULL;
		assert_true(image_write(film, &e, path, NULL, NULL, &why));
		FILE *file = fopen(path, "rb");
		assert_non_null(file);
		bytes[i] = memory_alloc(65536, 1);
		sizes[i] = fread(bytes[i], 1, 65536, file);
		fclose(file);
		unlink(path);
		if (i == 0)
			usleep(1100000); /* the time of day must not show */
	}
	assert_int_equal(sizes[0], sizes[1]);
	assert_memory_equal(bytes[0], bytes[1], sizes[0]);
	assert_null(memmem(bytes[0], sizes[0], "tIME", 4));
	free(bytes[0]);
	free(bytes[1]);
	film_destroy(film);
}

/* A picture that cannot be written leaves the folder as it was. */
static void failure_leaves_nothing(void **state)
{
	(void)state;
	struct film *film = ramps(4, 4);
	struct image_encoding e = encoding(LINEAR, SRGB);
	const char *why = NULL;
	assert_false(image_write(film, &e, in_folder("no/such/folder.png"), NULL, NULL, &why));
	assert_non_null(why);
	why = NULL;
	assert_false(image_write(film, &e, folder, NULL, NULL, &why));
	assert_string_equal(why, "it is a folder");
	e.format = IMAGE_TGA;
	e.grayscale = true;
	assert_false(image_write(film, &e, in_folder("grey.tga"), NULL, NULL, &why));
	assert_int_not_equal(access(in_folder("grey.tga"), F_OK), 0);
	film_destroy(film);
}

/* What is no picture is refused with a reason. */
static void damaged_files_are_refused(void **state)
{
	(void)state;
	struct film *film = ramps(40, 40);
	const struct image_encoding e = encoding(LINEAR, SRGB);
	const char *path = in_folder("damaged.png"), *why = NULL;
	assert_true(image_write(film, &e, path, NULL, NULL, &why));
	film_destroy(film);
	struct stat s;
	assert_int_equal(stat(path, &s), 0);
	for (off_t length = s.st_size - 1; length >= 0; length -= length > 40 ? 29 : 1) {
		assert_int_equal(truncate(path, length), 0);
		why = NULL;
		assert_null(length > 8 || length == 0 ? image_read(path, &why) : NULL);
		assert_true(length > 0 && length <= 8 ? why == NULL : why != NULL);
	}
	unlink(path);
	assert_null(image_read(in_folder("missing.png"), &why));
	assert_null(image_read(folder, &why));
}

static void take_message(void *user, const struct lambert_message *message)
{
	(void)message;
	++*(int *)user;
}

static void differences_are_measured(void **state)
{
	(void)state;
	struct film *film = film_of(20, 10, (colour){ 0.5f, 0.5f, 0.5f, 0, 0 });
	const struct image_encoding e = encoding(NONE, SRGB);
	char a[256], b[256];
	const char *why = NULL;
	int messages = 0;
	snprintf(a, sizeof a, "%s", in_folder("a.png"));
	snprintf(b, sizeof b, "%s", in_folder("b.png"));
	assert_true(image_write(film, &e, a, NULL, NULL, &why));
	film->pixels[3 * 20 + 7].g = 138 / 255.f; /* 10 more than its 128 */
	film->pixels[0].r = 130 / 255.f;
	assert_true(image_write(film, &e, b, NULL, NULL, &why));
	film_destroy(film);
	struct lambert_difference d;
	assert_true(lambert_compare(a, a, NULL, &d, take_message, &messages));
	assert_true(d.worst == 0 && d.rmse_all == 0 && d.within_1 == 1 && d.lowest_ssim == 1);
	assert_true(isinf(d.psnr));
	assert_true(lambert_compare(a, b, in_folder("heat.png"), &d, take_message, &messages));
	assert_int_equal(d.worst_x, 7);
	assert_int_equal(d.worst_y, 3);
	assert_true(d.worst == 10 && d.maximum[1] == 10 && d.maximum[0] == 2 && d.maximum[3] == 0);
	assert_true(fabs(d.rmse_all - sqrt(104 / 600.)) < 1e-12);
	assert_true(
		d.within_1 == 198 / 200. && d.within_2 == 199 / 200. && d.within_8 == 199 / 200.);
	assert_true(d.lowest_ssim < 1);
	assert_int_equal(messages, 0);
	assert_false(lambert_compare(a, in_folder("none.png"), NULL, &d, take_message, &messages));
	assert_int_equal(messages, 1);
	unlink(a);
	unlink(b);
	assert_int_equal(unlink(in_folder("heat.png")), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(curves_agree_with_the_reference),
		cmocka_unit_test(a_power_near_one_is_linear),
		cmocka_unit_test(values_out_of_range_are_clipped),
		cmocka_unit_test(tables_equal_formulas),
		cmocka_unit_test(encoding_can_be_undone),
		cmocka_unit_test(alpha_is_straight_in_png),
		cmocka_unit_test(dithering_agrees_with_the_reference),
		cmocka_unit_test(png_comes_back),
		cmocka_unit_test(same_picture_same_bytes),
		cmocka_unit_test(failure_leaves_nothing),
		cmocka_unit_test(damaged_files_are_refused),
		cmocka_unit_test(differences_are_measured),
	};
	return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
