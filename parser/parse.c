/* SPDX-License-Identifier: MIT */
/*
 * From scene text to AST: sets up the parse, declares what options declare,
 * reads the scene, settles what only its end decides.
 */
#include "expand.h"

#include <errno.h>
#include <locale.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

struct language_state *parser_change_state(struct parser *p)
{
	struct language_state *state = arena_copy(p->arena, p->state, sizeof *state);
	p->state = state;
	const struct render_hooks *hooks = &p->options->hooks;
	if (hooks->state)
		hooks->state(hooks->user, state);
	return state;
}

static bool was_reported(const struct parser *p, span where)
{
	for (unsigned i = 0; i < p->error_count; i++)
		if (p->reported[i].source == where.source && p->reported[i].offset == where.offset)
			return true;
	return false;
}

static void report(struct parser *p, span where, const char *format, va_list args)
{
	p->error_shown = false;
	if (p->trial)
		p->refused = true;
	if (p->failed || p->trial)
		return;
	char text[1024];
	vsnprintf(text, sizeof text, format, args);
	p->failed = true;
	if (where.source == 0 && p->expand->frame_count)
		where = raw_span(p); /* the place reached is better than none */
	if (was_reported(p, where) || p->error_count == MOST_ERRORS)
		return;
	p->reported[p->error_count++] = where;
	p->error_shown = true;
	diag_error(p->diag, where, "%s", text);
}

void parser_error(struct parser *p, span where, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	report(p, where, format, args);
	va_end(args);
}

void parser_stop(struct parser *p, span where, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	report(p, where, format, args);
	va_end(args);
	p->stopped = true;
}

void parser_note(struct parser *p, span where, const char *format, ...)
{
	if (!p->error_shown)
		return;
	char text[1024];
	va_list args;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	diag_note(p->diag, where, "%s", text);
}

void parser_warning(struct parser *p, span where, const char *format, ...)
{
	if (p->trial) {
		p->refused = true;
		return;
	}
	char text[1024];
	va_list args;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	diag_warning(p->diag, where, "%s", text);
}

static bool is_word(const char *name)
{
	const size_t length =
		strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_");
	return length && !name[length] && !(*name >= '0' && *name <= '9');
}

/* Declarations of options: the first of a name wins; reserved or impossible names do nothing. */
static void declare_options(struct parser *p)
{
	struct symbols *s = &p->expand->symbols;
	for (size_t i = 0; i < p->options->declaration_count; i++) {
		const struct declaration *d = &p->options->declarations[i];
		if (!is_word(d->name))
			continue;
		const uint32_t id = names_intern(s->names, d->name, strlen(d->name));
		if (s->names->list[id].keyword || symbol_find(s, id))
			continue;
		struct value *v = symbol_create(s, id, SYMBOL_GLOBAL)->slot;
		if (d->string)
			*v = (struct value){
				.kind = VALUE_STRING,
				.string = arena_string(p->arena, d->string, strlen(d->string)),
			};
		else
			*v = (struct value){ .kind = VALUE_NUMBER,
				.number = { 1, false, { d->number } } };
	}
}

/* The file that options want read before the scene. */
static bool begin_header(struct parser *p)
{
	static const char *const extensions[] = { ".inc", ".INC", NULL };
	const char *name = p->options->include_header;
	if (!name)
		return true;
	bool courtesy;
	const char *path = file_find(p->options, name, extensions, &courtesy, p->arena);
	struct expand *x = p->expand;
	struct source *s = path ? source_read(p->arena, p->diag, &x->names, path, false) : NULL;
	if (!s) {
		parser_error(p, NO_SPAN, "cannot read the include header '%s': %s", name,
			path ? strerror(errno) : "not found");
		return false;
	}
	s->previous = x->sources;
	x->sources = s;
	return expand_push_file(p, s, NO_SPAN);
}

static bool begins_with_version(const struct source *s)
{
	return s->count > 0 && s->tokens[0].kind == RAW_DIRECTIVE &&
	       s->directives[s->tokens[0].payload].keyword == K_VERSION;
}

static bool begin(struct parser *p, const char *path, const char *text, size_t size)
{
	struct expand *x = p->expand;
	struct source *s =
		text ? source_create(p->arena, p->diag, &x->names, path, text, size, true)
		     : source_read(p->arena, p->diag, &x->names, path, true);
	if (!s) {
		parser_error(p, NO_SPAN, "cannot read %s: %s", path, strerror(errno));
		return false;
	}
	s->previous = x->sources;
	x->sources = s;
	if (s->has_mark)
		p->charset = CHARSET_UTF8;
	p->version_is_first = p->options->version_set || begins_with_version(s);
	declare_options(p);
	return expand_push_file(p, s, NO_SPAN) && begin_header(p);
}

/* Version rules that only the end of the text decides. */
static void settle(struct parser *p)
{
	if (!p->state->version_set)
		diag_warning(p->diag, NO_SPAN,
			"the scene has no #version: some things follow the rules of 3.6.2");
	else if (!p->version_is_first)
		diag_warning(p->diag, NO_SPAN,
			"the scene does not begin with #version: it is first read as version 3.7");
	if (p->state->noise_generator == 0)
		parser_change_state(p)->noise_generator = p->state->version >= 350 ? 2 : 1;
	if (p->state->version < 350) {
		diag_warning(p->diag, NO_SPAN,
			"the scene ends as one of version %g: what were mistakes of the versions "
			"before 3.5 is not repeated",
			p->state->version / 100.0);
		parser_change_state(p)->version = 350;
	}
}

static const struct ast *finish(struct parser *p, const struct node *statements)
{
	settle(p);
	struct ast *ast = ARENA_NEW(p->arena, struct ast);
	*ast = (struct ast){
		.statements = statements,
		.final = *p->state,
		.token_count = p->token_count,
	};
	return ast;
}

/* The scene; numbers are read and written with a period whatever the country. */
static const struct ast *parse(struct parser *p, const char *path, const char *text, size_t size)
{
	const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
	const locale_t before = plain ? uselocale(plain) : (locale_t)0;
	const struct node *statements = NULL;
	const bool read = begin(p, path, text, size) && parse_statements(p, &statements);
	const bool ok = files_finish(p) && read && !p->failed;
	if (plain) {
		uselocale(before);
		freelocale(plain);
	}
	return ok ? finish(p, statements) : NULL;
}

const struct ast *parse_scene(const char *path, const char *text, size_t size,
	const struct parse_options *options, struct diag *diag, struct arena *arena)
{
	struct language_state *state = ARENA_NEW(arena, struct language_state);
	state->version = options->version ? options->version : 370;
	state->version_set = options->version_set;
	struct parser p = {
		.diag = diag, .arena = arena, .tree = arena, .options = options, .state = state
	};
	held_init(&p.held);
	p.expand = expand_create(&p);
	const struct ast *ast = parse(&p, path, text, size);
	expand_destroy(p.expand);
	grammar_finish(&p);
	held_release(&p.held);
	free(p.seeds);
	pointer_map_release(&p.called);
	pointer_map_release(&p.reference_levels);
	pointer_map_release(&p.reference_parts);
	return ast;
}
