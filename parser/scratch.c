/* SPDX-License-Identifier: MIT */
/*
 * Files that a scene writes while it is only looked at. They stay in memory, under
 * the path they would have, and the scene finds them there when it reads on.
 */
#include "parser/parser.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct scratch_file {
	struct scratch_file *next;
	char path[PATH_MAX]; /* without links */
	char *bytes;	     /* as far as they are written out; made by open_memstream */
	size_t size;
};

struct scratch_files {
	struct scratch_file *first;
};

struct scratch_files *scratch_create(void)
{
	struct scratch_files *all = memory_alloc(1, sizeof *all);
	all->first = NULL;
	return all;
}

void scratch_destroy(struct scratch_files *all)
{
	if (!all)
		return;
	for (struct scratch_file *f = all->first, *next; f; f = next) {
		next = f->next;
		free(f->bytes);
		free(f);
	}
	free(all);
}

static struct scratch_file *find(const struct scratch_files *all, const char *real)
{
	struct scratch_file *f = all ? all->first : NULL;
	while (f && strcmp(f->path, real) != 0)
		f = f->next;
	return f;
}

const char *scratch_read(const struct scratch_files *all, const char *path, size_t *size)
{
	char real[PATH_MAX];
	const struct scratch_file *f =
		all && all->first && file_true_path(path, real) ? find(all, real) : NULL;
	if (!f)
		return NULL;
	*size = f->size;
	return f->bytes;
}

/* What is no regular file begins empty: to open a pipe would wait for a writer. */
static void copy_file(const char *path, FILE *to)
{
	char buffer[1 << 14];
	struct stat info;
	FILE *from = stat(path, &info) == 0 && S_ISREG(info.st_mode) ? fopen(path, "rb") : NULL;
	for (size_t n; from && (n = fread(buffer, 1, sizeof buffer, from)) > 0;)
		fwrite(buffer, 1, n, to);
	if (from)
		fclose(from);
}

/* Whether a file of that path could be written, with the reason in errno. */
static bool could_be_written(const char *real)
{
	struct stat info;
	char folder[PATH_MAX];
	if (lstat(real, &info) == 0) {
		errno = S_ISDIR(info.st_mode) ? EISDIR : ELOOP;
		return !S_ISDIR(info.st_mode) && !S_ISLNK(info.st_mode) && access(real, W_OK) == 0;
	}
	snprintf(folder, sizeof folder, "%s", real);
	*strrchr(folder, '/') = 0;
	return access(*folder ? folder : "/", W_OK) == 0;
}

/* A stream onto the file that begins with what is there: written before, or on the disk. */
FILE *scratch_write(struct scratch_files *all, const char *real, bool append)
{
	if (!could_be_written(real))
		return NULL;
	struct scratch_file *f = find(all, real);
	char *before = f ? f->bytes : NULL;
	const size_t size = f ? f->size : 0;
	const bool is_new = !f;
	if (is_new) {
		f = memory_alloc(1, sizeof *f);
		*f = (struct scratch_file){ .next = all->first };
		snprintf(f->path, sizeof f->path, "%s", real);
		all->first = f;
	}
	f->bytes = NULL;
	f->size = 0;
	FILE *out = open_memstream(&f->bytes, &f->size);
	if (out && append && before)
		fwrite(before, 1, size, out);
	else if (out && append && is_new)
		copy_file(real, out);
	if (out)
		fflush(out);
	free(before);
	return out;
}
