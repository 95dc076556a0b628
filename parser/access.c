/* SPDX-License-Identifier: MIT */
/*
 * What a scene may touch. It can be a stranger's: it may write below the current
 * folder only, and read below that, below its own folder, in the library and
 * below the user's home folder but for what is hidden there, unless options allow
 * more. Links are followed before that is decided.
 */
#include "base/arena.h"
#include "parser/parser.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool is_below(const char *path, const char *folder)
{
	char real[PATH_MAX];
	if (!realpath(*folder ? folder : ".", real))
		return false;
	const size_t length = strlen(real);
	return !strncmp(path, real, length) &&
	       (path[length] == '/' || path[length] == 0 || real[length - 1] == '/');
}

static bool is_below_any(const char *path, const char *const *folders, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (is_below(path, folders[i]))
			return true;
	return false;
}

static bool allows_writing(const struct parse_options *o, const char *real)
{
	return is_below(real, ".") || is_below_any(real, o->write_paths, o->write_path_count);
}

/* Whether the path is below the home folder with no hidden folder or file on the way. */
static bool is_at_home(const char *real)
{
	const char *home = getenv("HOME");
	char folder[PATH_MAX];
	if (!home || *home != '/' || !realpath(home, folder) || !folder[1] ||
		!is_below(real, folder))
		return false;
	return !strstr(real + strlen(folder), "/.");
}

static bool allows_reading(const struct parse_options *o, const char *real)
{
	return allows_writing(o, real) || is_at_home(real) ||
	       (o->scene_folder && is_below(real, o->scene_folder)) ||
	       is_below_any(real, o->library_paths, o->library_path_count) ||
	       is_below_any(real, o->read_paths, o->read_path_count);
}

bool file_true_path(const char *path, char real[PATH_MAX])
{
	if (realpath(path, real))
		return true;
	if (errno != ENOENT)
		return false;
	const char *slash = strrchr(path, '/');
	const char *last = slash ? slash + 1 : path;
	char folder[PATH_MAX];
	const size_t length = slash ? (size_t)(slash - path) : 0;
	if (length >= sizeof folder)
		return false;
	memcpy(folder, path, length);
	folder[length] = 0;
	if (!realpath(length ? folder : slash ? "/" : ".", real))
		return false;
	const size_t used = strlen(real);
	if (used + 1 + strlen(last) >= PATH_MAX)
		return false;
	if (used > 1)
		strcat(real, "/");
	strcat(real, last);
	return true;
}

bool file_is_same(const char *a, const char *b)
{
	struct stat x, y;
	return stat(a, &x) == 0 && stat(b, &y) == 0 && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

static bool is_kept(const struct parse_options *o, const char *real)
{
	for (size_t i = 0; i < o->kept_path_count; i++)
		if (file_is_same(real, o->kept_paths[i]))
			return true;
	return false;
}

/* What waits for somebody at its other end is no file of a scene. */
static bool is_pipe(const char *path)
{
	struct stat s;
	return stat(path, &s) == 0 && (S_ISFIFO(s.st_mode) || S_ISSOCK(s.st_mode));
}

const char *file_may_read(const struct parse_options *o, const char *path, struct arena *arena)
{
	char real[PATH_MAX];
	if (!file_true_path(path, real))
		return arena_printf(arena, "cannot read %s: %s", path, strerror(errno));
	if (allows_reading(o, real))
		return is_pipe(real) ? arena_printf(arena, "'%s' is a pipe, not a file", path)
				     : NULL;
	return arena_printf(arena,
		"the scene is not allowed to read '%s', which is not below its folder, the current "
		"folder, the home folder (hidden ones apart) or a library path; --allow-read "
		"permits more",
		path);
}

/* A link at the end of `real` leads to nothing yet, else it would have been followed: it is refused. */
static FILE *open_inside(const char *real, bool append)
{
	const int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | (append ? O_APPEND : O_TRUNC);
	const int descriptor = open(real, flags, 0666);
	return descriptor < 0 ? NULL : fdopen(descriptor, append ? "ab" : "wb");
}

FILE *file_open_to_write(const struct parse_options *o, const char *path, bool append,
	struct arena *arena, const char **message)
{
	char real[PATH_MAX];
	const bool known = file_true_path(path, real);
	if (known && !allows_writing(o, real)) {
		*message = arena_printf(arena,
			"the scene is not allowed to write '%s', which is not below the current "
			"folder; --allow-write permits more",
			path);
		return NULL;
	}
	if (known && is_kept(o, real)) {
		*message = arena_printf(
			arena, "'%s' is in use by this run: it is not overwritten", path);
		return NULL;
	}
	if (known && is_pipe(real)) {
		*message = arena_printf(arena, "'%s' is a pipe, not a file", path);
		return NULL;
	}
	FILE *file = !known	  ? NULL
		     : o->scratch ? scratch_write(o->scratch, real, append)
				  : open_inside(real, append);
	if (!file)
		*message = arena_printf(arena, "cannot write %s: %s", path, strerror(errno));
	return file;
}
