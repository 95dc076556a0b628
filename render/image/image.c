/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files: hands the rows of the film, as they are encoded, to the writer
 * of their format. The file takes the place of an older one when it is complete
 * (image_target.c), so that a good picture is never replaced by half of one.
 */
#include "image/image.h"

#include "base/arena.h"
#include "image_encode.h"
#include "image/image_format.h"
#include "image_target.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The reason of this thread's last failure, for callers that only get a pointer. */
static _Thread_local char reason[REASON_SIZE];

static bool fail(const char **why, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool fail(const char **why, const char *format, ...)
{
	char text[REASON_SIZE];
	va_list args;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	memcpy(reason, text, sizeof text);
	*why = reason;
	return false;
}

/* The settings as the format can hold them. */
static struct image_encoding fitted(const struct image_encoding *wanted)
{
	struct image_encoding e = *wanted;
	const struct image_format_class *f = &image_formats[e.format];
	if (e.bits > f->bits_max)
		e.bits = f->bits_max;
	if (f->whole_bytes)
		e.bits = e.bits > 8 ? 16 : 8;
	if (!f->alpha)
		e.alpha = false;
	if (f->never_dithered)
		e.dither = DITHER_NONE;
	if (e.grayscale && f->grayscale_bits)
		e.bits = f->grayscale_bits;
	if (e.grayscale && f->grayscale_is_raw)
		e.file = e.working;
	return e;
}

static float file_gamma(const struct image_encoding *e)
{
	return e->file.transfer == TRANSFER_POWER    ? e->file.gamma
	       : e->file.transfer == TRANSFER_LINEAR ? 1
						     : 2.2f;
}

/* The rows of a picture on their way to a writer. */
struct rows {
	struct encoder *encoder;
	unsigned height;
	bool (*progress)(void *user, double share_done); /* or NULL */
	void *user;
	bool stopped;	       /* by progress */
	struct target *target; /* the file under way; NULL: standard output */
};

static bool next_row(void *source, unsigned y, void *samples)
{
	struct rows *rows = source;
	if (rows->progress && !rows->progress(rows->user, (double)y / rows->height)) {
		rows->stopped = true;
		if (rows->target) /* now: the writer of the format may not return for a while */
			target_abandon(rows->target);
		return false;
	}
	encoder_row(rows->encoder, y, samples);
	return true;
}

/* The encoded picture. */
static struct raster raster_of(
	const struct film *film, const struct image_encoding *e, struct rows *rows)
{
	return (struct raster){
		.width = film->width,
		.height = film->height,
		.channels = encode_channels(e),
		.sample_bits = image_formats[e->format].is_float ? 32
			       : e->bits <= 8			 ? 8
								 : 16,
		.bits = e->bits,
		.row = next_row,
		.source = rows,
		.row_bytes = encoder_row_bytes(rows->encoder),
		.gamma = file_gamma(e),
		.is_srgb = e->file.transfer == TRANSFER_SRGB || e->file.transfer == TRANSFER_NONE,
		.is_premultiplied = image_formats[e->format].is_premultiplied,
		.quality = e->quality < 2     ? 85
			   : e->quality > 100 ? 100
					      : e->quality,
	};
}

/* Writing */

static bool close_file(FILE *file, const char **why)
{
	const bool broken = ferror(file) != 0;
	const bool closed = (file == stdout ? fflush(file) : fclose(file)) == 0;
	if (broken || !closed)
		return fail(why, "%s", errno ? strerror(errno) : "it cannot be written completely");
	return true;
}

static bool write_stream(
	FILE *file, const struct raster *r, const struct image_format_class *f, const char **why)
{
	char text[REASON_SIZE] = "";
	const bool written = f->write(file, r, text);
	const bool closed = close_file(file, why);
	return closed && (written || fail(why, "%s", text));
}

static bool write_module(const char *path, const struct raster *r,
	const struct image_format_class *f, const char **why)
{
	char text[REASON_SIZE] = "";
	const struct image_module *module = image_module_open(text);
	if (!module || !module->write(path, f->module_name, f->compression, r, text))
		return fail(why, "%s", text);
	return true;
}

static bool write_path(const char *path, const struct raster *r, const struct image_format_class *f,
	const char **why)
{
	if (f->module_name)
		return write_module(path, r, f, why);
	FILE *file = fopen(path, "wb");
	return file ? write_stream(file, r, f, why) : fail(why, "%s", strerror(errno));
}

static bool copy_to_stdout(const char *path, const char **why)
{
	FILE *file = fopen(path, "rb");
	if (!file)
		return fail(why, "%s", strerror(errno));
	char block[16384];
	for (size_t n; (n = fread(block, 1, sizeof block, file)) > 0;)
		fwrite(block, 1, n, stdout);
	fclose(file);
	return close_file(stdout, why);
}

/* A file that has no name any more, so that nothing can be left behind. */
static int open_nameless(const char **why)
{
	const char *folder = getenv("TMPDIR");
	char path[PATH_MAX];
	snprintf(path, sizeof path, "%s/lambert-XXXXXX", folder && *folder ? folder : "/tmp");
	const int fd = mkostemp(path, O_CLOEXEC);
	if (fd < 0)
		fail(why, "%s: %s", path, strerror(errno));
	else
		unlink(path);
	return fd;
}

/* The module writes files only: by way of a temporary one. */
static bool write_stdout(
	const struct raster *r, const struct image_format_class *f, const char **why)
{
	if (!f->module_name)
		return write_stream(stdout, r, f, why);
	const int fd = open_nameless(why);
	if (fd < 0)
		return false;
	char path[64];
	snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
	const bool ok = write_module(path, r, f, why) && copy_to_stdout(path, why);
	close(fd);
	return ok;
}

static bool write_file(const char *path, const struct raster *r, const struct image_format_class *f,
	const char **why)
{
	struct target target;
	struct rows *rows = r->source;
	rows->target = &target;
	char text[REASON_SIZE] = "";
	bool ok = target_init(&target, path, text) || fail(why, "%s", text);
	ok = ok && write_path(target_name(&target), r, f, why) &&
	     (target_commit(&target, text) || fail(why, "%s", text));
	target_finish(&target);
	return ok;
}

/* What the format can hold. */
static bool check_format(
	unsigned width, unsigned height, const struct image_encoding *e, const char **why)
{
	const struct image_format_class *f = &image_formats[e->format];
	if (e->grayscale && !f->grayscale)
		return fail(why, "%s has no grayscale here; PNG and PPM have", f->title);
	if (width > f->side_max || height > f->side_max)
		return fail(why, "%u x %u pixels are too many for %s; a side has at most %u", width,
			height, f->title, f->side_max);
	const double bytes = (double)width * height * encode_channels(e);
	if (f->bytes_max > 0 && bytes > f->bytes_max)
		return fail(why, "%u x %u pixels are too many for %s; it has at most %.0f bytes",
			width, height, f->title, f->bytes_max);
	return true;
}

bool image_check(unsigned width, unsigned height, const struct image_encoding *wanted,
	const char *path, const char **why)
{
	const struct image_encoding e = fitted(wanted);
	char text[REASON_SIZE] = "";
	return check_format(width, height, &e, why) &&
	       (strcmp(path, "-") == 0 || target_check(path, text) || fail(why, "%s", text));
}

bool image_write(const struct film *film, const struct image_encoding *wanted, const char *path,
	bool (*progress)(void *user, double share_done), void *user, const char **why)
{
	const struct image_encoding e = fitted(wanted);
	const struct image_format_class *f = &image_formats[e.format];
	if (!check_format(film->width, film->height, &e, why))
		return false;
	struct rows rows = { .encoder = encoder_create(film, &e, f->is_float),
		.height = film->height,
		.progress = progress,
		.user = user };
	const struct raster r = raster_of(film, &e, &rows);
	const bool ok =
		strcmp(path, "-") == 0 ? write_stdout(&r, f, why) : write_file(path, &r, f, why);
	encoder_destroy(rows.encoder);
	if (rows.stopped)
		*why = NULL;
	return ok;
}

/* Reading */

static struct image *take_picture(struct module_picture *p)
{
	struct image *image = memory_alloc(1, sizeof *image);
	memset(image, 0, sizeof *image);
	image->width = p->width;
	image->height = p->height;
	image->channels = p->channels;
	image->bits = p->bits;
	image->premultiplied = p->is_premultiplied;
	image->has_srgb = p->is_srgb;
	image->gamma = p->gamma;
	image->is_greymap = p->is_greymap;
	const size_t count = (size_t)p->width * p->height * p->channels;
	image->samples = memory_alloc(count, sizeof *image->samples);
	memcpy(image->samples, p->samples, count * sizeof *image->samples);
	return image;
}

static struct image *read_module(const char *path, const char **why)
{
	char text[REASON_SIZE] = "";
	struct module_picture picture = { .samples = NULL };
	const struct image_module *module = image_module_open(text);
	if (!module || !module->read(path, &picture, text)) {
		fail(why, "%s", *text ? text : "it is not a picture");
		return NULL;
	}
	struct image *image = take_picture(&picture);
	module->release(&picture);
	return image;
}

static bool is_readable_file(FILE *file, const char **why)
{
	struct stat s;
	if (!file || fstat(fileno(file), &s) != 0)
		return fail(why, "%s", strerror(errno));
	if (S_ISDIR(s.st_mode))
		return fail(why, "it is a folder");
	return s.st_size > 0 || !S_ISREG(s.st_mode) || fail(why, "the file is empty");
}

struct image *image_read(const char *path, const char **why)
{
	FILE *file = fopen(path, "rb");
	if (!is_readable_file(file, why)) {
		if (file)
			fclose(file);
		return NULL;
	}
	if (!png_recognise(file)) {
		fclose(file);
		return read_module(path, why);
	}
	char text[REASON_SIZE] = "";
	struct image *image = png_read(file, text);
	fclose(file);
	if (!image)
		fail(why, "%s", text);
	return image;
}

struct working_space image_curve(const struct image *image)
{
	if (image->bits > 16)
		return (struct working_space){ .transfer = TRANSFER_LINEAR };
	if (image->has_srgb || !(image->gamma > 0))
		return (struct working_space){ .transfer = TRANSFER_SRGB };
	return (struct working_space){ .transfer = TRANSFER_POWER, .gamma = image->gamma };
}

void image_destroy(struct image *image)
{
	if (!image)
		return;
	free(image->samples);
	free(image->indices);
	free(image);
}
