/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files: encodes the film, hands it to the writer of its format, and
 * puts the finished file in its place. Until then it stands under another name
 * in the same folder, so that a good picture is never replaced by half of one.
 */
#include "render/image.h"

#include "base/arena.h"
#include "render/image_encode.h"
#include "render/image_format.h"

#include <errno.h>
#include <fcntl.h>
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

/* Formats */

struct format {
	const char *name;		       /* for messages */
	const char *module_name, *compression; /* NULL: written here */
	bool (*write)(FILE *, const struct raster *, char *reason);
	bool grayscale, alpha, is_float;
	int bits_max;
};

// clang-format off
static const struct format formats[] = {
	[IMAGE_PNG]     = { "PNG",  NULL,      NULL,   png_write, true,  true,  false, 16 },
	[IMAGE_PPM]     = { "PPM",  NULL,      NULL,   pnm_write, true,  false, false, 16 },
	[IMAGE_TGA]     = { "TGA",  "targa",   "none", NULL,      false, true,  false, 8 },
	[IMAGE_TGA_RLE] = { "TGA",  "targa",   "rle",  NULL,      false, true,  false, 8 },
	[IMAGE_BMP]     = { "BMP",  "bmp",     "",     NULL,      false, true,  false, 8 },
	[IMAGE_JPEG]    = { "JPEG", "jpeg",    "",     NULL,      false, false, false, 8 },
	[IMAGE_EXR]     = { "EXR",  "openexr", "zip",  NULL,      false, true,  true,  32 },
	[IMAGE_HDR]     = { "HDR",  "hdr",     "",     NULL,      false, false, true,  32 },
	[IMAGE_TIFF]    = { "TIFF", "tiff",    "zip",  NULL,      false, true,  false, 16 },
};
// clang-format on

/* The settings as the format can hold them. */
static struct image_encoding fitted(const struct image_encoding *wanted)
{
	struct image_encoding e = *wanted;
	const struct format *f = &formats[e.format];
	if (e.bits > f->bits_max)
		e.bits = f->bits_max;
	if (f->bits_max == 8)
		e.bits = 8;
	if (e.format == IMAGE_TIFF)
		e.bits = e.bits > 8 ? 16 : 8;
	if (!f->alpha)
		e.alpha = false;
	if (e.format == IMAGE_JPEG || f->is_float)
		e.dither = DITHER_NONE;
	if (e.grayscale && e.format == IMAGE_PNG)
		e.bits = 16;
	if (e.grayscale && e.format == IMAGE_PPM)
		e.file = e.working; /* greymaps hold the numbers of the scene */
	return e;
}

static float file_gamma(const struct image_encoding *e)
{
	return e->file.transfer == TRANSFER_POWER    ? e->file.gamma
	       : e->file.transfer == TRANSFER_LINEAR ? 1
						     : 2.2f;
}

static void raster_row(void *encoder, unsigned y, void *samples)
{
	encoder_row(encoder, y, samples);
}

/* The encoded picture. */
static struct raster raster_of(
	const struct film *film, const struct image_encoding *e, struct encoder *encoder)
{
	return (struct raster){
		.width = film->width,
		.height = film->height,
		.channels = encode_channels(e),
		.sample_bits = formats[e->format].is_float ? 32 : e->bits <= 8 ? 8 : 16,
		.bits = e->bits,
		.row = raster_row,
		.source = encoder,
		.row_bytes = encoder_row_bytes(encoder),
		.gamma = file_gamma(e),
		.is_srgb = e->file.transfer == TRANSFER_SRGB || e->file.transfer == TRANSFER_NONE,
		.is_premultiplied = e->format == IMAGE_EXR,
		.quality = e->quality < 2     ? 85
			   : e->quality > 100 ? 100
					      : e->quality,
	};
}

/* The file under way */

struct target {
	char *path;	 /* where the file shall be, links resolved */
	char *temporary; /* where it is written; NULL: in place */
	mode_t mode;
};

static char *printed(const char *format, ...) __attribute__((format(printf, 1, 2)));
static char *printed(const char *format, ...)
{
	va_list args;
	va_start(args, format);
	const int n = vsnprintf(NULL, 0, format, args);
	va_end(args);
	char *text = memory_alloc((size_t)n + 1, 1);
	va_start(args, format);
	vsnprintf(text, (size_t)n + 1, format, args);
	va_end(args);
	return text;
}

/* A name beside `path` that no file has yet; the file is created. */
static char *create_beside(const char *path, mode_t mode)
{
	const char *slash = strrchr(path, '/');
	const int folder = slash ? (int)(slash - path) + 1 : 0;
	for (unsigned n = 0; n < 1000; n++) {
		char *name = printed(
			"%.*s.%.100s.%ld-%u.part", folder, path, path + folder, (long)getpid(), n);
		const int fd = open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
		if (fd >= 0) {
			close(fd);
			return name;
		}
		const int error = errno;
		free(name);
		errno = error;
		if (error != EEXIST)
			break;
	}
	return NULL;
}

static void target_finish(struct target *t)
{
	if (t->temporary)
		unlink(t->temporary);
	free(t->temporary);
	free(t->path);
}

static bool target_init(struct target *t, const char *path, const char **why)
{
	struct stat s;
	*t = (struct target){ .mode = 0666 };
	t->path = realpath(path, NULL);
	if (!t->path)
		t->path = printed("%s", path);
	const bool exists = stat(t->path, &s) == 0;
	if (exists && S_ISDIR(s.st_mode))
		return fail(why, "it is a folder");
	if (exists && !S_ISREG(s.st_mode))
		return true;
	if (exists && access(t->path, W_OK) != 0)
		return fail(why, "%s", strerror(errno));
	if (exists)
		t->mode = s.st_mode & 0777;
	t->temporary = create_beside(t->path, t->mode);
	return t->temporary || fail(why, "%s", strerror(errno));
}

static const char *target_name(const struct target *t)
{
	return t->temporary ? t->temporary : t->path;
}

static bool target_commit(struct target *t, const char **why)
{
	if (!t->temporary)
		return true;
	if (rename(t->temporary, t->path) != 0)
		return fail(why, "%s", strerror(errno));
	free(t->temporary);
	t->temporary = NULL;
	return true;
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
	FILE *file, const struct raster *r, const struct format *f, const char **why)
{
	char text[REASON_SIZE] = "";
	const bool written = f->write(file, r, text);
	const bool closed = close_file(file, why);
	return closed && (written || fail(why, "%s", text));
}

static bool write_module(
	const char *path, const struct raster *r, const struct format *f, const char **why)
{
	char text[REASON_SIZE] = "";
	const struct image_module *module = image_module_open(text);
	if (!module || !module->write(path, f->module_name, f->compression, r, text))
		return fail(why, "%s", text);
	return true;
}

static bool write_path(
	const char *path, const struct raster *r, const struct format *f, const char **why)
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

/* The module writes files only: by way of a temporary one. */
static bool write_stdout(const struct raster *r, const struct format *f, const char **why)
{
	if (!f->module_name)
		return write_stream(stdout, r, f, why);
	const char *folder = getenv("TMPDIR");
	char *path = printed("%s/lambert-XXXXXX", folder && *folder ? folder : "/tmp");
	const int fd = mkstemp(path);
	bool ok = fd >= 0 || fail(why, "%s: %s", path, strerror(errno));
	if (fd >= 0) {
		close(fd);
		ok = write_module(path, r, f, why) && copy_to_stdout(path, why);
		unlink(path);
	}
	free(path);
	return ok;
}

static bool write_file(
	const char *path, const struct raster *r, const struct format *f, const char **why)
{
	struct target target;
	const bool ok = target_init(&target, path, why) &&
			write_path(target_name(&target), r, f, why) && target_commit(&target, why);
	target_finish(&target);
	return ok;
}

bool image_write(const struct film *film, const struct image_encoding *wanted, const char *path,
	const char **why)
{
	const struct image_encoding e = fitted(wanted);
	const struct format *f = &formats[e.format];
	if (e.grayscale && !f->grayscale)
		return fail(why, "%s has no grayscale here; PNG and PPM have", f->name);
	struct encoder *encoder = encoder_create(film, &e, f->is_float);
	const struct raster r = raster_of(film, &e, encoder);
	const bool ok =
		strcmp(path, "-") == 0 ? write_stdout(&r, f, why) : write_file(path, &r, f, why);
	encoder_destroy(encoder);
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

void image_destroy(struct image *image)
{
	if (!image)
		return;
	free(image->samples);
	free(image->indices);
	free(image);
}
