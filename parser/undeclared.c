/* SPDX-License-Identifier: MIT */
/*
 * What to say of a word that names nothing: the include file that would declare
 * it, its declaration further down, or the nearest known name. Also where a word
 * that names the wrong thing was declared.
 *
 * Include files are looked through only now, when the scene is wrong anyway: those
 * of the folders that #include searches.
 */
#include "expand.h"

#include <dirent.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum {
	FILE_MOST = 1 << 20,	/* larger files are data */
	FOLDER_MOST = 16 << 20, /* bytes read of a folder */
	ENTRIES_MOST = 2000,	/* names looked at in a folder */
};

/* -- Declarations in a text --------------------------------------------------------------- */

struct reader {
	const char *at, *end;
};

static void skip_comment(struct reader *r)
{
	unsigned depth = 0;
	do {
		const bool pair = r->end - r->at > 1;
		if (pair && r->at[0] == '/' && r->at[1] == '*') {
			depth++;
			r->at += 2;
		} else if (pair && r->at[0] == '*' && r->at[1] == '/') {
			depth--;
			r->at += 2;
		} else {
			r->at++;
		}
	} while (depth && r->at < r->end);
}

static void skip_line(struct reader *r)
{
	while (r->at < r->end && *r->at != '\n' && *r->at != '\r')
		r->at++;
}

static void skip_string(struct reader *r)
{
	for (r->at++; r->at < r->end && *r->at != '"'; r->at++)
		r->at += *r->at == '\\' && r->end - r->at > 1;
	r->at += r->at < r->end;
}

/* Steps over blanks, comments and strings. */
static void skip_between(struct reader *r)
{
	while (r->at < r->end) {
		const char c = r->at[0], next = r->end - r->at > 1 ? r->at[1] : 0;
		if (c == '/' && next == '*')
			skip_comment(r);
		else if (c == '/' && next == '/')
			skip_line(r);
		else if (c == '"')
			skip_string(r);
		else if (c == ' ' || c == '\t' || c == '\n' || c == '\r')
			r->at++;
		else
			return;
	}
}

/* The length of the word that is read; 0: there is none. */
static size_t take_word(struct reader *r, const char **word)
{
	skip_between(r);
	*word = r->at;
	while (r->at < r->end && is_word_character(*r->at))
		r->at++;
	return (size_t)(r->at - *word);
}

static bool is(const char *word, size_t length, const char *text)
{
	return strlen(text) == length && !memcmp(word, text, length);
}

/* The name behind a declaring directive, behind whose '#' the reader stands; NULL: it is another. */
static const char *declared_name(struct reader *r, bool locals, size_t *length)
{
	const char *word;
	*length = take_word(r, &word);
	if (!is(word, *length, "declare") && !is(word, *length, "macro") &&
		!(locals && is(word, *length, "local")))
		return NULL;
	do
		*length = take_word(r, &word);
	while (is(word, *length, "deprecated") || is(word, *length, "once"));
	return word;
}

/* Where a text first declares the name, be it by #local, if that counts; NULL: nowhere. */
static const char *find_declaration(const char *text, size_t size, const char *name, bool locals)
{
	struct reader r = { text, text + size };
	while (skip_between(&r), r.at < r.end) {
		if (*r.at++ != '#')
			continue;
		size_t length;
		const char *word = declared_name(&r, locals, &length);
		if (word && is(word, length, name))
			return word;
	}
	return NULL;
}

/* Where the texts read so far declare a name, if only one place does; else no place. */
static span find_only_declaration(const struct parser *p, const char *name)
{
	span found = NO_SPAN;
	for (const struct source *s = p->expand->sources; s; s = s->previous) {
		const char *const end = s->bytes + s->size;
		for (const char *at = s->bytes;
			(at = find_declaration(at, (size_t)(end - at), name, true)) != NULL;) {
			if (found.source)
				return NO_SPAN;
			found = (span){ s->number, (uint32_t)(at - s->bytes),
				(uint32_t)strlen(name), 0 };
		}
	}
	return found;
}

void note_declared(struct parser *p, uint32_t id)
{
	enum { MAIN_FILE = SYMBOL_GLOBAL + 1 }; /* what is above may be a parameter of a macro */
	const struct name *name = &p->expand->names.list[id];
	if (!p->error_shown || !name->binding || name->binding->table > MAIN_FILE)
		return;
	const span where = find_only_declaration(p, name->text);
	if (where.source)
		parser_note(p, where, "'%s' is declared here", name->text);
}

/* -- Include files ------------------------------------------------------------------------ */

static bool is_read(const struct expand *x, const char *path)
{
	for (const struct source *s = x->sources; s; s = s->previous)
		if (!strcmp(s->name, path))
			return true;
	return false;
}

/* The first bytes of a file, memory_alloc'd; NULL: it cannot be read or is too large. */
static char *read_small(const char *path, size_t *size)
{
	struct stat info;
	if (stat(path, &info) || !S_ISREG(info.st_mode)) /* opening a pipe could last */
		return NULL;
	FILE *file = fopen(path, "rb");
	if (!file)
		return NULL;
	char *bytes = memory_alloc(FILE_MOST, 1);
	*size = fread(bytes, 1, FILE_MOST, file);
	const bool good = !ferror(file) && *size < FILE_MOST;
	fclose(file);
	if (good)
		return bytes;
	free(bytes);
	return NULL;
}

static int compare_names(const void *a, const void *b)
{
	return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static bool is_include_name(const char *name)
{
	const size_t length = strlen(name);
	return length > 4 &&
	       (!strcmp(name + length - 4, ".inc") || !strcmp(name + length - 4, ".INC"));
}

/* The names of include files in a folder, sorted. */
static size_t list_includes(struct parser *p, const char *folder, const char **names)
{
	DIR *dir = opendir(*folder ? folder : ".");
	size_t count = 0;
	if (!dir)
		return 0;
	unsigned seen = 0;
	for (const struct dirent *e; seen++ < ENTRIES_MOST && (e = readdir(dir));)
		if (is_include_name(e->d_name))
			names[count++] = arena_string(p->arena, e->d_name, strlen(e->d_name));
	closedir(dir);
	qsort(names, count, sizeof *names, compare_names);
	return count;
}

/* The include file of a folder that declares the name; NULL: none. */
static const char *find_in_folder(struct parser *p, const char *folder, const char *name)
{
	const char **files = ARENA_ARRAY(p->arena, ENTRIES_MOST, const char *);
	const size_t count = list_includes(p, folder, files);
	size_t bytes = 0;
	for (size_t i = 0; i < count && bytes < FOLDER_MOST; i++) {
		const char *path = file_in_folder(p->arena, folder, files[i]);
		size_t size;
		if (is_read(p->expand, path) || file_may_read(p->options, path, p->arena))
			continue;
		char *text = read_small(path, &size);
		if (!text)
			continue;
		bytes += size;
		const bool found = find_declaration(text, size, name, false);
		free(text);
		if (found)
			return files[i];
	}
	return NULL;
}

static const char *find_include(struct parser *p, const char *name)
{
	const struct parse_options *o = p->options;
	const char *found = NULL;
	for (size_t i = 0; i < o->library_path_count && !found; i++)
		found = find_in_folder(p, o->library_paths[i], name);
	if (!found)
		found = find_in_folder(p, "", name);
	if (!found && o->scene_folder)
		found = find_in_folder(p, o->scene_folder, name);
	return found;
}

const char *include_nearest(struct parser *p, const char *name)
{
	const struct parse_options *o = p->options;
	const char *nearest = NULL;
	unsigned least = UINT_MAX;
	for (size_t i = 0; i < o->library_path_count + 2; i++) {
		const char *folder = i < o->library_path_count	  ? o->library_paths[i]
				     : i == o->library_path_count ? ""
								  : o->scene_folder;
		const char **files = ARENA_ARRAY(p->arena, ENTRIES_MOST, const char *);
		const size_t count = folder ? list_includes(p, folder, files) : 0;
		for (size_t j = 0; j < count; j++)
			if (names_is_nearer(name, files[j], &least))
				nearest = files[j];
	}
	return nearest;
}

/* -- The message -------------------------------------------------------------------------- */

/* Where the text of the place declares the name, if it does so only behind it; else no place. */
static span find_later(const struct parser *p, span where, const char *name)
{
	const struct source *s = source_at(p->expand, where);
	const char *at = s ? find_declaration(s->bytes, s->size, name, false) : NULL;
	const size_t offset = at ? (size_t)(at - s->bytes) : 0;
	return offset > where.offset
		       ? (span){ s->number, (uint32_t)offset, (uint32_t)strlen(name), where.site }
		       : NO_SPAN;
}

/* Whether the word stands behind a '#', which means nothing before what is no directive. */
static bool is_behind_hash(const struct parser *p, span where)
{
	const struct source *s = source_at(p->expand, where);
	uint32_t at = s ? where.offset : 0;
	while (at > 0 && (s->bytes[at - 1] == ' ' || s->bytes[at - 1] == '\t'))
		at--;
	return at > 0 && s->bytes[at - 1] == '#';
}

static bool is_directive_name(const void *context, const struct name *name)
{
	(void)context;
	return is_directive(name->keyword);
}

struct case_test {
	name_test *test;
	const void *context;
	bool opens; /* a brace follows */
};

/* What include files declare is often a reserved word with a capital letter, such as Red: that is meant
 * unless the word opens a statement. */
static bool is_rather_meant(const void *context, const struct name *name)
{
	const struct case_test *c = context;
	return (name->keyword ? c->opens : name->binding != NULL) && c->test(c->context, name);
}

static const char *find_other_case(
	struct parser *p, const char *name, name_test *test, const void *context)
{
	const struct raw_token *next = raw_peek(p);
	const struct case_test c = { test, context, next && next->kind == '{' };
	return names_in_other_case(&p->expand->names, name, is_rather_meant, &c);
}

static void say(
	struct parser *p, span where, const char *name, name_test *test, const void *context)
{
	if (is_behind_hash(p, where)) {
		const char *nearest =
			names_nearest(&p->expand->names, name, is_directive_name, NULL);
		parser_error(p, where, "there is no directive #%s%s%s%s", name,
			nearest ? "; did you mean #" : "", nearest ? nearest : "",
			nearest ? "?" : "");
		return;
	}
	const span later = find_later(p, where, name);
	if (later.source) {
		parser_error(
			p, where, "undeclared identifier '%s': it is declared only later", name);
		parser_note(p, later, "declared here");
		return;
	}
	const char *nearest = find_other_case(p, name, test, context);
	const char *include = nearest ? NULL : find_include(p, name);
	if (include) {
		parser_error(p, where,
			"undeclared identifier '%s': %s declares it; write #include \"%s\" before",
			name, include, include);
		return;
	}
	if (!nearest)
		nearest = names_nearest(&p->expand->names, name, test, context);
	parser_error(p, where, "undeclared identifier '%s'%s%s%s", name,
		nearest ? "; did you mean '" : "", nearest ? nearest : "", nearest ? "'?" : "");
}

bool name_is_lost(const struct parser *p, uint32_t id)
{
	const struct name *known = &p->expand->names.list[id];
	return known->lost && !known->binding && diag_errors(p->diag);
}

void parser_error_undeclared(
	struct parser *p, span where, const char *name, name_test *test, const void *context)
{
	struct names *names = &p->expand->names;
	const uint32_t id = names_intern(names, name, strlen(name));
	const struct name *known = &names->list[id];
	if (name_is_lost(p, id))
		p->failed = true;
	if (known->binding && known->binding->entered)
		parser_error(p, where, "'%s' is used in its own declaration", name);
	else if (p->failed || p->trial)
		parser_error(p, where, "undeclared identifier '%s'", name);
	else
		say(p, where, name, test, context);
}
