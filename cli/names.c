/* SPDX-License-Identifier: MIT */
/*
 * Names of files by POV-Ray's rules: the picture is named after the scene unless
 * said otherwise, in the scene's folder, and its extension always follows from
 * its type. A name given with -o is taken as it is.
 */
#include "names.h"

#include "formats.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *names_file_part(const char *path)
{
	const char *slash = strrchr(path, '/');
	return slash ? slash + 1 : path;
}

/* The scene */

static bool is_readable(const char *path)
{
	struct stat s;
	return stat(path, &s) == 0 && !S_ISDIR(s.st_mode);
}

static const char *find_on_path(struct options *o, const char *name, const char *extension)
{
	const char *path = text_printf(&o->pool, "%s%s", name, extension);
	if (is_readable(path))
		return path;
	for (size_t i = 0; *name != '/' && i < o->library.count; i++) {
		path = text_printf(&o->pool, "%s/%s%s", o->library.items[i], name, extension);
		if (is_readable(path))
			return path;
	}
	return NULL;
}

static bool ends_exactly(const char *text, const char *end)
{
	const size_t n = strlen(text), m = strlen(end);
	return n >= m && strcmp(text + n - m, end) == 0;
}

const char *names_scene(struct options *o)
{
	static const char *const named[] = { "", ".pov", ".POV" };
	static const char *const unnamed[] = { ".pov", ".POV", "" };
	if (strcmp(o->input, "-") == 0)
		return "/dev/stdin";
	const bool has_extension = ends_exactly(o->input, ".pov") || ends_exactly(o->input, ".POV");
	for (int i = 0; i < 3; i++) {
		const char *path = find_on_path(o, o->input, has_extension ? named[i] : unnamed[i]);
		if (path)
			return path;
	}
	return o->input;
}

/* What must not be written */

bool names_same_file(const char *a, const char *b)
{
	struct stat x, y;
	return stat(a, &x) == 0 && stat(b, &y) == 0 && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

bool names_may_write(struct options *o, const char *path)
{
	const char *in_use = names_same_file(path, names_scene(o)) ? "the scene" : NULL;
	for (size_t i = 0; !in_use && i < o->ini_files.count; i++)
		if (names_same_file(path, o->ini_files.items[i]))
			in_use = "an INI file of this run";
	return !in_use || option_error(o, "%s is %s: it is not overwritten", path, in_use);
}

/* The picture */

static bool is_stream_name(const char *name)
{
	return strcmp(name, "-") == 0 || strcmp(name, "stdout") == 0;
}

/* Whether the name is not that of a folder or device. */
static bool may_be_file(const char *path)
{
	struct stat s;
	return !ends_exactly(path, "/") && (stat(path, &s) != 0 || S_ISREG(s.st_mode));
}

bool names_format(struct options *o, struct lambert_format *format)
{
	if (!formats_find_letter(o->output_type, format))
		lambert_format_describe(0, format);
	if (options_set(o, "Output_File_Type") == ORIGIN_USER || !o->output_is_exact ||
		is_stream_name(o->output) || !may_be_file(o->output))
		return true;
	return formats_find_path(o->output, format) || !strchr(names_file_part(o->output), '.') ||
	       option_error(o,
		       "%s: the extension of the picture is none of %s; add one, or choose with "
		       "--format",
		       o->output, formats_extensions(&o->pool));
}

/* Where the extension of the file part begins. */
static size_t stem_length(const char *path)
{
	const char *dot = strrchr(names_file_part(path), '.');
	return dot && dot != names_file_part(path) ? (size_t)(dot - path) : strlen(path);
}

/* As POV-Ray makes it of the given name and the scene's: without the extension of the type. */
static const char *ruled_stem(struct options *o, const char *extension)
{
	const char *given = o->output ? o->output : "";
	const char *file = names_file_part(given);
	if (!*file || strcmp(file, extension) == 0) {
		const char *scene = file == given ? o->input : names_file_part(o->input);
		return text_printf(&o->pool, "%.*s%.*s", (int)(file - given), given,
			(int)stem_length(scene), scene);
	}
	size_t length = strlen(given);
	if (ends_exactly(given, "."))
		length--;
	else if (ends_exactly(given, extension))
		length -= strlen(extension);
	return text_copy(&o->pool, given, length);
}

static const char *exact_name(struct options *o, const char *extension, int frame, int digits)
{
	const char *given = o->output;
	struct stat s;
	if (ends_exactly(given, "/") || (stat(given, &s) == 0 && S_ISDIR(s.st_mode))) {
		const char *scene = names_file_part(o->input);
		given = text_printf(&o->pool, "%s%s%.*s%s", given,
			ends_exactly(given, "/") ? "" : "/", (int)stem_length(scene), scene,
			extension);
	}
	if (!digits)
		return given;
	const int stem = (int)stem_length(given);
	return text_printf(&o->pool, "%.*s%0*d%s", stem, given, digits, frame, given + stem);
}

const char *names_picture(struct options *o, int frame, int digits)
{
	struct lambert_format format;
	if (!names_format(o, &format))
		return NULL;
	const char *extension = formats_extension(&o->pool, &format);
	if (o->output && is_stream_name(o->output))
		return "-";
	if (o->output && strcmp(o->output, "stderr") == 0)
		return "/dev/stderr";
	if (!o->output && strcmp(o->input, "-") == 0) {
		option_error(o, "the scene comes from standard input; name the picture with -o");
		return NULL;
	}
	if (o->output_is_exact)
		return exact_name(o, extension, frame, digits);
	const char *stem = ruled_stem(o, extension);
	if (!digits)
		return text_printf(&o->pool, "%s%s", stem, extension);
	return text_printf(&o->pool, "%s%0*d%s", stem, digits, frame, extension);
}
