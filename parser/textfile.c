/* SPDX-License-Identifier: MIT */
/*
 * #fopen, #fclose, #read and #write: text files of the scene's own.
 *
 * A file to read is lexed like a scene, and #read takes data from its tokens.
 */
#include "expand.h"

#include "grammar.tab.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

struct scene_file {
	const char *path;
	const char *written; /* the path without links, if it was opened to be written */
	span opened;
	FILE *out;	   /* open for writing */
	struct source *in; /* open for reading */
	uint32_t position; /* the next token of `in` */
	struct scene_file *previous;
};

/* -- #fopen, #fclose ---------------------------------------------------------------------- */

static bool open_to_read(struct parser *p, struct scene_file *f, span where)
{
	struct expand *x = p->expand;
	bool courtesy;
	const char *path = file_find(p->options, f->path, NULL, &courtesy, p->arena);
	if (!path) {
		struct stat info;
		const bool is_folder = !stat(f->path, &info) && S_ISDIR(info.st_mode);
		parser_error(p, where,
			is_folder ? "'%s' is a folder: a file to read is wanted"
				  : "file '%s' to read not found",
			f->path);
		return false;
	}
	if (courtesy)
		diag_warning(p->diag, where, "file '%s' found as %s", f->path, path);
	const char *refusal = file_may_read(p->options, path, p->arena);
	if (refusal) {
		parser_error(p, where, "%s", refusal);
		return false;
	}
	f->in = source_open(p->arena, p->diag, &x->names, p->options, path);
	if (!f->in) {
		parser_error(p, where, "cannot read %s: %s", path, strerror(errno));
		return false;
	}
	f->in->is_data = true;
	f->in->previous = x->sources;
	x->sources = f->in;
	return true;
}

/* Whether the scene has written the file before, in this run. */
static bool is_own(const struct expand *x, const char *real)
{
	for (const struct scene_file *f = x->files; f; f = f->previous)
		if (f->written && !strcmp(f->written, real))
			return true;
	return false;
}

/* Whether a path leads to a text of the scene that the scene has not written itself. */
static bool is_scene_text(const struct expand *x, const char *real)
{
	for (const struct source *s = x->sources; s; s = s->previous)
		if (!s->is_data && file_is_same(s->name, real))
			return !is_own(x, real);
	return false;
}

static bool open_to_write(struct parser *p, struct scene_file *f, bool append, span where)
{
	char real[PATH_MAX];
	const bool known = file_true_path(f->path, real);
	if (known && is_scene_text(p->expand, real)) {
		parser_error(
			p, where, "'%s' is a text of this scene: it is not overwritten", f->path);
		return false;
	}
	if (known)
		f->written = arena_string(p->arena, real, strlen(real));
	const char *message = NULL;
	f->out = file_open_to_write(p->options, f->path, append, p->arena, &message);
	if (!f->out)
		parser_error(p, where, "%s", message);
	p->expand->has_written = true;
	return f->out != NULL;
}

static bool open_as(struct parser *p, struct scene_file *f, span where)
{
	struct token_value v;
	span at;
	const int mode = expand_next(p, &v, &at);
	if (p->options->no_file_io) {
		parser_error(p, where, "the scene is not allowed to open '%s': --no-file-io is set",
			f->path);
		return false;
	}
	if (mode == KW_READ)
		return open_to_read(p, f, where);
	if (mode == KW_WRITE || mode == KW_APPEND)
		return open_to_write(p, f, mode == KW_APPEND, where);
	parser_error(
		p, at, "expected read, write or append, found %s", token_describe(p, mode, &v));
	return false;
}

static bool is_named(struct parser *p, const struct scene_file *f, span where)
{
	if (!*f->path)
		parser_error(p, where, "the name of the file is empty");
	return *f->path;
}

bool file_open(struct parser *p, span where)
{
	struct symbols *s = &p->expand->symbols;
	uint32_t name;
	span at;
	struct gate gate;
	if (!raw_name(p, "a name for the file", &name, &at))
		return false;
	struct symbol *symbol = symbol_find(s, name);
	if (symbol && symbol->slot->kind != VALUE_NONE) {
		parser_error(p, at, "'%s' is declared already", symbol->text);
		return false;
	}
	struct scene_file *f = ARENA_NEW(p->arena, struct scene_file);
	f->opened = where;
	gate_open(p, &gate, true);
	const char *path = "";
	bool ok = parse_string(p, &path, true);
	f->path = arena_string(p->arena, path, strlen(path));
	ok = ok && is_named(p, f, where) && open_as(p, f, where);
	gate_close(p);
	if (!ok)
		return false;
	f->previous = p->expand->files;
	p->expand->files = f;
	symbol = symbol_find(s, name); /* again: the expression may have changed what the name is */
	if (!symbol)
		symbol = symbol_create(s, name, SYMBOL_GLOBAL);
	*symbol->slot = (struct value){ .kind = VALUE_FILE, .file = f };
	return true;
}

static bool finish_output(struct parser *p, struct scene_file *f, span where)
{
	if (!f->out)
		return true;
	const bool failed = ferror(f->out);
	const bool ok = !fclose(f->out) && !failed;
	f->out = NULL;
	if (!ok)
		parser_error(p, where, "cannot write %s: %s", f->path, strerror(errno));
	return ok;
}

static bool close_file(struct parser *p, struct symbol *symbol, span where)
{
	struct scene_file *f = symbol->slot->file;
	const bool ok = finish_output(p, f, where);
	if (f->in)
		source_finish(f->in); /* its text stays, for messages */
	f->in = NULL;
	symbol->slot->kind = VALUE_NONE;
	symbol_remove(&p->expand->symbols, symbol);
	return ok;
}

bool file_close(struct parser *p, span where)
{
	uint32_t name;
	span at;
	if (!raw_name(p, "the name of a file", &name, &at))
		return false;
	struct symbol *symbol = symbol_find(&p->expand->symbols, name);
	if (!symbol || symbol->slot->kind != VALUE_FILE)
		return true;
	return close_file(p, symbol, where);
}

bool files_finish(struct parser *p)
{
	bool ok = true;
	for (struct scene_file *f = p->expand->files; f; f = f->previous)
		ok = finish_output(p, f, f->opened) && ok;
	return ok;
}

/* The handle behind the bracket of #read and #write. */
static struct symbol *read_handle(struct parser *p, bool to_read)
{
	struct token_value v;
	span where;
	if (!expect(p, '(', "'('"))
		return NULL;
	const int token = expand_next(p, &v, &where);
	if (token == T_UNDECLARED &&
		name_is_lost(p, names_intern(&p->expand->names, v.name, strlen(v.name)))) {
		parser_error_undeclared(p, where, v.name, is_declared, NULL);
		return NULL;
	}
	if (token != T_FILE) {
		parser_error(
			p, where, "expected an open file, found %s", token_describe(p, token, &v));
		if (token == T_UNDECLARED && to_read)
			parser_note(p, where,
				"#read closes a file at its end: read on while defined(%s)",
				v.name);
		return NULL;
	}
	const struct scene_file *f = v.symbol->slot->file;
	if (to_read ? !f->in : !f->out) {
		parser_error(p, where, "file '%s' was opened to be %s", f->path,
			to_read ? "written" : "read");
		return NULL;
	}
	return v.symbol;
}

/* -- #read -------------------------------------------------------------------------------- */

static const struct raw_token *datum_token(const struct scene_file *f)
{
	return f->position < f->in->count ? &f->in->tokens[f->position] : NULL;
}

static bool take_kind(struct scene_file *f, unsigned kind)
{
	const struct raw_token *raw = datum_token(f);
	if (!raw || raw->kind != kind)
		return false;
	f->position++;
	return true;
}

static bool report_datum(struct parser *p, const struct scene_file *f)
{
	const struct raw_token *raw = datum_token(f);
	const uint32_t at = raw ? raw->offset : (uint32_t)f->in->size;
	const span where = { f->in->number, at, 1, 0 };
	if (raw && raw->kind == RAW_ERROR)
		parser_error(p, where, "%s", f->in->error);
	else
		parser_error(
			p, where, "expected a number, a vector of numbers or a string to #read");
	return false;
}

static bool read_number(struct parser *p, struct scene_file *f, double *value)
{
	while (take_kind(f, '+'))
		;
	const bool negative = take_kind(f, '-');
	const struct raw_token *raw = datum_token(f);
	size_t length;
	switch (raw ? raw->kind : RAW_ERROR) {
	case RAW_INTEGER:
		*value = raw->payload;
		break;
	case RAW_NUMBER:
		*value = f->in->numbers[raw->payload];
		break;
	case RAW_NUMBER_TEXT:
		*value = number_at(f->in->bytes + raw->offset, &length);
		break;
	default:
		return report_datum(p, f);
	}
	f->position++;
	if (negative)
		*value = -*value;
	return true;
}

static bool read_vector(struct parser *p, struct scene_file *f, struct value *v)
{
	unsigned terms = 0;
	while (!take_kind(f, '>')) {
		if (terms == 5 || !read_number(p, f, &v->number.v[terms]))
			return report_datum(p, f);
		terms++;
		take_kind(f, ',');
	}
	if (terms < 2)
		return report_datum(p, f);
	v->number.terms = (uint8_t)terms;
	if (terms == 5) {
		v->kind = VALUE_COLOUR;
		for (int i = 0; i < 5; i++)
			v->number.v[i] = (float)v->number.v[i];
	}
	return true;
}

static bool read_datum(struct parser *p, struct scene_file *f, struct value *v)
{
	const struct raw_token *raw = datum_token(f);
	if (raw->kind == RAW_STRING) {
		const span where = { f->in->number, raw->offset, raw->payload + 2, 0 };
		f->position++;
		v->kind = VALUE_STRING;
		v->string = string_literal(
			p, f->in->bytes + raw->offset + 1, raw->payload, where, true);
		return v->string != NULL;
	}
	v->kind = VALUE_NUMBER;
	v->number = (struct number){ .terms = 1 };
	return take_kind(f, '<') ? read_vector(p, f, v) : read_number(p, f, &v->number.v[0]);
}

/* What is read into. */
struct variable {
	struct symbol *symbol;
	struct value *slot;
	struct array *array; /* the slot is an element of it; or NULL */
	span where;
};

/* It exists as a float, 3-vector or string, or not at all. */
static bool read_variable(struct parser *p, struct variable *to)
{
	struct symbols *s = &p->expand->symbols;
	uint32_t name;
	if (!raw_name(p, "a variable to read", &name, &to->where))
		return false;
	struct symbol *symbol = symbol_find(s, name);
	if (!symbol)
		symbol = symbol_create(s, name, SYMBOL_GLOBAL);
	*to = (struct variable){ symbol, symbol->slot, NULL, to->where };
	const struct raw_token *raw;
	while (to->slot->kind == VALUE_ARRAY && (raw = raw_peek(p)) && raw->kind == '[') {
		to->array = to->slot->array;
		to->slot = identifier_element(p, to->slot, symbol->text, &to->where);
		if (!to->slot)
			return false;
	}
	const struct value *v = to->slot;
	const bool fits =
		v->kind == VALUE_NONE || v->kind == VALUE_STRING ||
		(v->kind == VALUE_NUMBER && (v->number.terms == 1 || v->number.terms == 3));
	const bool open = to->array && to->array->kind == VALUE_NONE;
	if (fits && !open)
		return true;
	parser_error(p, to->where, "'%s' cannot be read into: %s", symbol->text,
		open ? "the array has no elements yet that show their type"
		     : "it is no float, 3-vector or string");
	return false;
}

/* Reads one datum. Without a comma behind it the token that is there instead is lost, as the
 * language has it; at the end of the file the handle goes. */
static bool read_into(struct parser *p, struct symbol *handle, const struct variable *to)
{
	struct scene_file *f = handle->slot->file;
	struct value v;
	if (f->position == f->in->count)
		return close_file(p, handle, to->where);
	if (!read_datum(p, f, &v)) {
		parser_note(p, to->where, "it would be read into this");
		return false;
	}
	if (to->array && !array_accepts(to->array, &v)) {
		parser_error(
			p, to->where, "the datum does not have the type of the array's elements");
		return false;
	}
	*to->slot = v;
	if (f->position == f->in->count)
		return close_file(p, handle, to->where);
	f->position++;
	return true;
}

bool file_read(struct parser *p, span where)
{
	(void)where;
	struct symbol *handle = read_handle(p, true);
	if (!handle)
		return false;
	handle->kept = true;
	raw_accept(p, ',');
	for (bool first = true; !raw_accept(p, ')'); first = false) {
		struct variable to = { .where = NO_SPAN };
		if (!read_variable(p, &to))
			return false;
		/* One without a datum counts as defined all the same, if it is the first. */
		if (first && to.slot->kind == VALUE_NONE && !to.array)
			to.symbol->awaited = true;
		if (handle->slot->kind == VALUE_FILE && !read_into(p, handle, &to))
			return false;
		raw_accept(p, ',');
	}
	return !p->failed;
}

/* -- #write ------------------------------------------------------------------------------- */

struct format {
	int token;
	unsigned bytes;
	bool big_endian;
	double lo, hi;
};

static const struct format *find_format(int token)
{
	// clang-format off
	static const struct format formats[] = {
		{ KW_SINT8,    1, false, -128, 127 },
		{ KW_UINT8,    1, false, 0, 255 },
		{ KW_SINT16LE, 2, false, -32768, 32767 },
		{ KW_SINT16BE, 2, true,  -32768, 32767 },
		{ KW_UINT16LE, 2, false, 0, 65535 },
		{ KW_UINT16BE, 2, true,  0, 65535 },
		{ KW_SINT32LE, 4, false, -2147483648.0, 2147483647 },
		{ KW_SINT32BE, 4, true,  -2147483648.0, 2147483647 },
	};
	// clang-format on
	for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++)
		if (formats[i].token == token)
			return &formats[i];
	return NULL;
}

static void write_binary(FILE *out, const struct format *format, double value)
{
	const double rounded = value >= format->hi  ? format->hi
			       : value > format->lo ? floor(value + 0.5)
						    : format->lo;
	const uint32_t bits = (uint32_t)(int64_t)rounded;
	for (unsigned i = 0; i < format->bytes; i++) {
		const unsigned shift = 8 * (format->big_endian ? format->bytes - 1 - i : i);
		putc((int)(bits >> shift & 0xFF), out);
	}
}

static void write_number(FILE *out, const struct format *format, const struct number *n)
{
	if (format) {
		for (unsigned i = 0; i < n->terms; i++)
			write_binary(out, format, n->v[i]);
		return;
	}
	if (n->terms == 1) {
		fprintf(out, "%g", n->v[0]);
		return;
	}
	for (unsigned i = 0; i < n->terms; i++)
		fprintf(out, "%c%g", i ? ',' : '<', n->v[i]);
	fputs("> ", out);
}

static bool starts_string(int token)
{
	return token == T_STRING || token == KW_STR || token == KW_VSTR || token == KW_CONCAT ||
	       token == KW_CHR || token == KW_SUBSTR || token == KW_STRUPR || token == KW_STRLWR ||
	       token == KW_DATETIME;
}

static bool starts_colour(int token)
{
	return token == T_COLOUR || token == KW_COLOR || token == KW_RGB || token == KW_RGBF ||
	       token == KW_RGBT || token == KW_RGBFT || token == KW_SRGB || token == KW_SRGBF ||
	       token == KW_SRGBT || token == KW_SRGBFT;
}

/* Whether the handle still stands for that file, which a macro in the item may have closed. */
static bool is_open(struct parser *p, const struct symbol *handle, const FILE *out, span where)
{
	if (handle->slot->kind == VALUE_FILE && handle->slot->file->out == out)
		return true;
	parser_error(p, where, "the file was closed while it was being written");
	return false;
}

static bool write_item(struct parser *p, const struct symbol *handle, FILE *out, int token,
	const struct format *format, span where)
{
	if (starts_colour(token)) {
		parser_error(p, where,
			"a colour cannot be written: write its components, as <C.red, C.green>");
		return false;
	}
	if (starts_string(token)) {
		const char *text;
		if (!parse_string(p, &text, false) || !is_open(p, handle, out, where))
			return false;
		fputs(string_bytes(p, text), out);
		return true;
	}
	struct number number;
	if (!parse_number_any(p, &number) || !is_open(p, handle, out, where))
		return false;
	write_number(out, format, &number);
	return true;
}

/* What stays in memory must not fill it. */
static bool within_memory(struct parser *p, FILE *out, span where)
{
	enum { LIMIT = 256 << 20 };
	if (!p->options->scratch || ftello(out) <= LIMIT)
		return true;
	parser_error(p, where, "the scene writes more than %d MB, which stay in memory here",
		LIMIT >> 20);
	return false;
}

bool file_write(struct parser *p, span where)
{
	struct symbol *handle = read_handle(p, false);
	if (!handle)
		return false;
	FILE *out = handle->slot->file->out;
	const struct format *format = NULL;
	for (;;) {
		struct token_value v;
		span at;
		const int token = expand_next(p, &v, &at);
		if (p->failed)
			return false;
		if (token == ')')
			return within_memory(p, out, where);
		if (token == ',') {
			format = NULL;
			continue;
		}
		if (find_format(token)) {
			format = find_format(token);
			continue;
		}
		expand_unread(p, token, &v, at);
		if (!write_item(p, handle, out, token, format, at))
			return false;
	}
}
