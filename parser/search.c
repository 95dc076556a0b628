/* SPDX-License-Identifier: MIT */
/*
 * The search for files named by a scene: each spelling of the name in the
 * current folder and the library paths. What is not found there is looked for
 * where authors of scenes may have had it: beside the scene, written in other
 * letter case, with backslashes between the folders.
 */
#include "base/arena.h"
#include "parser/parser.h"

#include <dirent.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool is_file(const struct parse_options *o, const char *path)
{
	struct stat info;
	size_t size;
	if (!stat(path, &info))
		return !S_ISDIR(info.st_mode);
	return scratch_read(o->scratch, path, &size) != NULL;
}

const char *file_in_folder(struct arena *arena, const char *folder, const char *name)
{
	const size_t length = strlen(folder);
	const char *slash = length && folder[length - 1] == '/' ? "" : "/";
	return length ? arena_printf(arena, "%s%s%s", folder, slash, name)
		      : arena_string(arena, name, strlen(name));
}

/* The entry of `folder` that is `name` but for letter case; NULL: none. The first in the order of
 * their bytes, whatever the order of the folder. */
static const char *entry_in_other_case(struct arena *arena, const char *folder, const char *name)
{
	DIR *dir = opendir(*folder ? folder : ".");
	const char *found = NULL;
	if (!dir)
		return NULL;
	for (const struct dirent *e; (e = readdir(dir));)
		if (!strcasecmp(e->d_name, name) && (!found || strcmp(e->d_name, found) < 0))
			found = arena_string(arena, e->d_name, strlen(e->d_name));
	closedir(dir);
	return found;
}

/* Follows `name` from `folder` one part after the other. */
static const char *path_in_other_case(
	const struct parse_options *o, const char *folder, const char *name, struct arena *arena)
{
	const char *path = folder;
	while (*name == '/')
		path = "/", name++;
	while (*name) {
		const size_t length = strcspn(name, "/");
		const char *part = arena_string(arena, name, length);
		const char *exact = file_in_folder(arena, path, part);
		struct stat info;
		if (stat(exact, &info)) {
			part = entry_in_other_case(arena, path, part);
			if (!part)
				return NULL;
			exact = file_in_folder(arena, path, part);
		}
		path = exact;
		name += length;
		name += strspn(name, "/");
	}
	return is_file(o, path) ? path : NULL;
}

typedef const char *(*lookup)(
	const struct parse_options *, const char *folder, const char *name, struct arena *);

static const char *lookup_exact(
	const struct parse_options *o, const char *folder, const char *name, struct arena *arena)
{
	const char *path = file_in_folder(arena, folder, name);
	return is_file(o, path) ? path : NULL;
}

/* In the current folder and the library paths; with `beside`, in the folder of the scene too. */
static const char *in_folders(const struct parse_options *o, const char *name, lookup look,
	bool beside, struct arena *arena)
{
	const char *path = look(o, "", name, arena);
	if (path || *name == '/')
		return path;
	for (size_t i = 0; i < o->library_path_count; i++)
		if ((path = look(o, o->library_paths[i], name, arena)))
			return path;
	return beside && o->scene_folder ? look(o, o->scene_folder, name, arena) : NULL;
}

static bool has_extension(const char *name, const char *const *extensions)
{
	const size_t length = strlen(name);
	for (; extensions && *extensions; extensions++) {
		const size_t n = strlen(*extensions);
		if (length > n && !strcmp(name + length - n, *extensions))
			return true;
	}
	return false;
}

/* All spellings: the name as it is comes first if it has an extension, else last. */
static const char *spellings(const struct parse_options *o, const char *name,
	const char *const *extensions, lookup look, bool beside, struct arena *arena)
{
	const bool bare_first = !extensions || !*extensions || has_extension(name, extensions);
	const char *path = bare_first ? in_folders(o, name, look, beside, arena) : NULL;
	for (; !path && extensions && *extensions; extensions++)
		path = in_folders(
			o, arena_printf(arena, "%s%s", name, *extensions), look, beside, arena);
	return path || bare_first ? path : in_folders(o, name, look, beside, arena);
}

const char *file_find(const struct parse_options *o, const char *name,
	const char *const *extensions, bool *courtesy, struct arena *arena)
{
	*courtesy = false;
	if (!*name)
		return NULL;
	const char *path = spellings(o, name, extensions, lookup_exact, false, arena);
	if (path)
		return path;
	*courtesy = true;
	if ((path = spellings(o, name, extensions, lookup_exact, true, arena)))
		return path;
	char *slashed = arena_string(arena, name, strlen(name));
	for (char *c = slashed; *c; c++)
		if (*c == '\\')
			*c = '/';
	if ((path = spellings(o, slashed, extensions, lookup_exact, true, arena)))
		return path;
	return spellings(o, slashed, extensions, path_in_other_case, true, arena);
}
