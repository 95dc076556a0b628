/* SPDX-License-Identifier: MIT */
/*
 * Files under way. The writer holds a lock (flock) on its file as long as it
 * lives, however it dies. So a file under the name that the next writer wants,
 * on which nobody holds a lock, was left by a writer that was killed: it is
 * removed. Where a file system has no locks nothing is ever removed.
 */
#include "image_target.h"

#include "base/arena.h"
#include "image/image_format.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* As many as the system follows. */
enum { LINKS_MAX = 40, WRITERS_MAX = 1000 };

static bool fail(char *reason, const char *text)
{
	snprintf(reason, REASON_SIZE, "%s", text);
	return false;
}

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

/* Of the folder in a path, with its slash. */
static int folder_length(const char *path)
{
	const char *slash = strrchr(path, '/');
	return slash ? (int)(slash - path) + 1 : 0;
}

/* ---- where the file is ---- */

/* Where a link leads to; NULL for what is no link. Takes the path. */
static char *follow(char *path)
{
	char to[PATH_MAX];
	const ssize_t n = readlink(path, to, sizeof to);
	if (n < 0 || n == sizeof to)
		return NULL;
	char *next = printed("%.*s%.*s", *to == '/' ? 0 : folder_length(path), path, (int)n, to);
	free(path);
	return next;
}

/* The path behind all links, those to nothing included: the caller's to free. */
static char *resolved(const char *path)
{
	struct stat s;
	char *at = stat(path, &s) == 0 ? realpath(path, NULL) : NULL;
	if (at)
		return at;
	at = printed("%s", path);
	for (int i = 0; stat(path, &s) != 0 && i < LINKS_MAX; i++) {
		char *next = follow(at);
		if (!next)
			break;
		at = next;
	}
	return at;
}

static bool check_folder(const char *path, char *reason)
{
	const int length = folder_length(path);
	char *folder = printed("%.*s", length ? length : 1, length ? path : ".");
	const bool ok =
		access(folder, W_OK | X_OK) == 0 ||
		fail(reason, errno == ENOENT ? "its folder does not exist" : strerror(errno));
	free(folder);
	return ok;
}

/* The system lets its administrator write anything; a file that nobody may write is protected from
 * mistakes all the same. */
static bool check_file(const char *path, const struct stat *s, char *reason)
{
	if (S_ISDIR(s->st_mode))
		return fail(reason, "it is a folder");
	if (access(path, W_OK) != 0)
		return fail(reason, strerror(errno));
	if (S_ISREG(s->st_mode) && !(s->st_mode & 0222))
		return fail(reason, "it is read-only");
	return true;
}

static bool check(const char *path, char *reason)
{
	struct stat s;
	if (stat(path, &s) != 0)
		return errno == ENOENT ? check_folder(path, reason) : fail(reason, strerror(errno));
	return check_file(path, &s, reason) && (!S_ISREG(s.st_mode) || check_folder(path, reason));
}

bool target_check(const char *path, char *reason)
{
	char *at = resolved(path);
	const bool ok = check(at, reason);
	free(at);
	return ok;
}

/* ---- the file under way ---- */

/* Whether the open file is the one of that name, and of this user. */
static bool is_at(int fd, const char *name)
{
	struct stat open, named;
	return fstat(fd, &open) == 0 && lstat(name, &named) == 0 && open.st_dev == named.st_dev &&
	       open.st_ino == named.st_ino && S_ISREG(open.st_mode) && open.st_uid == geteuid();
}

static void remove_abandoned(const char *name)
{
	const int fd = open(name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
	if (fd < 0)
		return;
	if (flock(fd, LOCK_EX | LOCK_NB) == 0 && is_at(fd, name))
		unlink(name);
	close(fd);
}

/* Creates the file and locks it; -1 with errno set. Who looked for abandoned files in between may have
 * removed it: then errno is EEXIST too, for a name not to be had. */
static int create_locked(const char *name, mode_t mode)
{
	const int fd = open(name, O_CREAT | O_EXCL | O_WRONLY | O_NOFOLLOW | O_CLOEXEC, mode);
	if (fd < 0)
		return -1;
	flock(fd, LOCK_EX); /* not to be had everywhere */
	if (is_at(fd, name))
		return fd;
	close(fd);
	errno = EEXIST;
	return -1;
}

static bool create_beside(struct target *t, mode_t mode, char *reason)
{
	const int folder = folder_length(t->path);
	for (int n = 0; n < WRITERS_MAX; n++) {
		t->temporary = printed(
			"%.*s.%.100s.lambert-%d.part", folder, t->path, t->path + folder, n);
		remove_abandoned(t->temporary);
		t->lock = create_locked(t->temporary, mode);
		if (t->lock >= 0)
			return true;
		const int error = errno;
		free(t->temporary);
		t->temporary = NULL;
		if (error != EEXIST)
			return fail(reason, strerror(error));
	}
	return fail(reason, "too many programs are writing it");
}

bool target_init(struct target *t, const char *path, char *reason)
{
	struct stat s;
	*t = (struct target){ .path = resolved(path), .lock = -1 };
	if (!check(t->path, reason))
		return false;
	if (stat(t->path, &s) != 0)
		return create_beside(t, 0666, reason);
	return !S_ISREG(s.st_mode) || create_beside(t, s.st_mode & 0777, reason);
}

const char *target_name(const struct target *t)
{
	return t->temporary ? t->temporary : t->path;
}

bool target_commit(struct target *t, char *reason)
{
	if (!t->temporary)
		return true;
	if (rename(t->temporary, t->path) != 0)
		return fail(reason, strerror(errno));
	free(t->temporary);
	t->temporary = NULL;
	return true;
}

void target_abandon(struct target *t)
{
	if (t->temporary && !t->abandoned)
		unlink(t->temporary);
	t->abandoned = true;
}

void target_finish(struct target *t)
{
	target_abandon(t);
	if (t->lock >= 0)
		close(t->lock);
	free(t->temporary);
	free(t->path);
}
