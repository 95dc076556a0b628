/* SPDX-License-Identifier: MIT */
/*
 * INI files: lines of options, in sections. The lines before the first [label]
 * always apply, those of a section only when the file was asked for as
 * file[label]. Exactly one default file is read, the first that there is.
 */
#include "options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* A file that includes itself would never end. */
enum { DEPTH_MAX = 16 };

/* Finding the file */

static bool is_file(const char *path)
{
	FILE *file = fopen(path, "rb");
	if (file)
		fclose(file);
	return file != NULL;
}

static bool has_short_extension(const char *name)
{
	const char *slash = strrchr(name, '/');
	const char *dot = strrchr(slash ? slash : name, '.');
	return dot && strlen(dot + 1) <= 3;
}

/* The name itself or with .ini, in one folder ("" for the current one). */
static const char *find_in(struct options *o, const char *folder, const char *name)
{
	static const char *const extensions[] = { "", ".ini", ".INI" };
	for (size_t i = has_short_extension(name) ? 0 : 1; i < 3; i++) {
		const char *path = text_printf(
			&o->pool, "%s%s%s%s", folder, *folder ? "/" : "", name, extensions[i]);
		if (is_file(path))
			return path;
	}
	return NULL;
}

static const char *find(struct options *o, const char *name)
{
	const char *path = find_in(o, "", name);
	for (size_t i = 0; !path && *name != '/' && i < o->library.count; i++)
		path = find_in(o, o->library.items[i], name);
	return path;
}

/* Reading it */

/* Cuts the line at *p off and moves on; a newline is LF, CR, CR LF or LF CR. */
static char *next_line(char **p)
{
	char *line = *p;
	char *end = line + strcspn(line, "\r\n");
	*p = end;
	if (!*end)
		return line;
	const char first = *end;
	*(*p)++ = 0;
	if ((**p == '\r' || **p == '\n') && **p != first)
		++*p;
	return line;
}

/* The label of a line "[label]", in place; NULL for other lines. */
static char *label_of(char *line)
{
	line += strspn(line, " \t");
	char *end = *line == '[' ? strchr(line, ']') : NULL;
	if (!end)
		return NULL;
	*end = 0;
	return line + 1;
}

/* With `section` the lines of that section as well. */
static bool read_lines(struct options *o, char *text, const char *section)
{
	bool applies = true, found = !section;
	while (*text) {
		char *line = next_line(&text);
		o->place.line++;
		const char *label = label_of(line);
		if (label)
			applies = section && strcasecmp(label, section) == 0;
		else if (applies && !switches_read(o, line, true))
			return false;
		found = found || (label && applies);
	}
	if (!found)
		option_warning(o, "there is no section [%s] in this file", section);
	return true;
}

static bool read_file(struct options *o, const char *path, const char *section)
{
	if (o->ini_depth == DEPTH_MAX)
		return option_error(o, "INI files are nested more than %d deep", DEPTH_MAX);
	size_t size;
	char *text = text_of_file(&o->pool, path, &size);
	if (!text)
		return option_error(o, "the INI file %s cannot be read: %s", path, strerror(errno));
	if (strlen(text) != size)
		return option_error(o, "%s is no INI file: it is not text", path);
	text_list_add(&o->pool, &o->ini_files, path);
	const struct option_place before = o->place;
	o->place = (struct option_place){ .file = path };
	o->ini_depth++;
	const bool ok =
		strncmp(text, "\xEF\xBB\xBF", 3) != 0
			? read_lines(o, text, section)
			: option_error(o, "an INI file must not begin with a byte-order mark");
	o->ini_depth--;
	o->place = before;
	return ok;
}

bool ini_read(struct options *o, const char *request)
{
	const char *bracket = strchr(request, '[');
	const char *end = bracket ? strchr(bracket, ']') : NULL;
	if (bracket && !end)
		return option_error(o,
			"%s: the section needs its ]; a label with blanks needs quotes inside the "
			"argument",
			request);
	const char *name =
		bracket ? text_copy(&o->pool, request, (size_t)(bracket - request)) : request;
	const char *section =
		bracket ? text_copy(&o->pool, bracket + 1, (size_t)(end - bracket - 1)) : NULL;
	const char *path = find(o, name);
	if (!path)
		return option_error(o,
			"there is no INI file \"%s\" (a scene ends in .pov or is given as +I%s)",
			name, name);
	return read_file(o, path, section);
}

static const char *below_home(struct options *o, const char *name)
{
	const char *home = getenv("HOME");
	return home ? text_printf(&o->pool, "%s/%s", home, name) : NULL;
}

bool ini_read_default(struct options *o)
{
	const char *named = getenv("POVINI");
	if (named && *named && access(named, R_OK) != 0)
		option_note(o, "the INI file %s of the environment variable POVINI cannot be read",
			named);
	const char *const candidates[] = {
		named && *named ? named : NULL,
		"povray.ini",
		below_home(o, ".povray/3.7/povray.ini"),
		"/etc/povray/3.7/povray.ini",
		below_home(o, ".povrayrc"),
		"/etc/povray.ini",
	};
	for (size_t i = 0; i < sizeof candidates / sizeof *candidates; i++)
		if (candidates[i] && access(candidates[i], R_OK) == 0)
			return read_file(o, candidates[i], NULL);
	return true;
}
