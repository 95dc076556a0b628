/* SPDX-License-Identifier: MIT */
/*
 * #include.
 */
#include "expand.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static const char *const extensions[] = { ".inc", ".INC", NULL };

/* Where a file was looked for, for the message. */
static const char *places(struct parser *p)
{
	const struct parse_options *o = p->options;
	const char *list = "the current folder";
	for (size_t i = 0; i < o->library_path_count; i++)
		list = arena_printf(p->arena, "%s, %s", list, o->library_paths[i]);
	if (o->scene_folder)
		list = arena_printf(p->arena, "%s, the folder of the scene", list);
	return list;
}

static bool report_missing(struct parser *p, const char *name, span where)
{
	struct stat info;
	const char *nearest;
	if (!*name)
		parser_stop(p, where, "the name of the include file is empty");
	else if (!stat(name, &info) && S_ISDIR(info.st_mode))
		parser_stop(p, where, "'%s' is a folder: an include file is wanted", name);
	else if (name[0] == '/')
		parser_stop(p, where, "include file '%s' not found", name);
	else if ((nearest = include_nearest(p, name)))
		parser_stop(
			p, where, "include file '%s' not found; did you mean '%s'?", name, nearest);
	else
		parser_stop(p, where, "include file '%s' not found; looked in %s", name, places(p));
	return false;
}

/* A file read before is not lexed again. */
static struct source *find_source(struct expand *x, const char *path)
{
	for (struct source *s = x->sources; s && !x->has_written; s = s->previous)
		if (!s->has_mark && !s->is_piecewise && !strcmp(s->name, path))
			return s;
	return NULL;
}

static bool include_file(struct parser *p, const char *name, span where)
{
	struct expand *x = p->expand;
	bool courtesy = false;
	const char *path = file_find(p->options, name, extensions, &courtesy, p->arena);
	if (!path)
		return report_missing(p, name, where);
	const char *refusal = file_may_read(p->options, path, p->arena);
	if (refusal) {
		parser_error(p, where, "%s", refusal);
		return false;
	}
	if (courtesy)
		diag_warning(p->diag, where, "include file '%s' found as %s", name, path);
	struct source *s = x->file_count < MAX_FILES ? find_source(x, path) : NULL;
	if (!s && x->file_count < MAX_FILES) {
		s = source_open(p->arena, p->diag, &x->names, p->options, path);
		if (!s) {
			parser_stop(p, where, "cannot read %s: %s", path, strerror(errno));
			return false;
		}
		s->previous = x->sources;
		x->sources = s;
	}
	if (s)
		return expand_push_file(p, s, where);
	parser_error(p, where,
		"include files are nested too deeply: %d are the limit (does '%s' include "
		"itself?)",
		MAX_FILES, name);
	return false;
}

bool include_run(struct parser *p, span where)
{
	const char *name = NULL;
	const struct raw_token *raw = raw_peek(p);
	if (raw && raw->kind == RAW_STRING) {
		where = raw_span(p);
		name = raw_string(p, false);
	} else {
		struct gate gate;
		gate_open(p, &gate, true);
		if (!parse_string(p, &name, true))
			name = NULL;
		gate_close(p);
	}
	return name && !p->failed && include_file(p, name, where);
}
