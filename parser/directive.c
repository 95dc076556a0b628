/* SPDX-License-Identifier: MIT */
/*
 * Runs directives: which word calls what. #default and #version, which need
 * little, are here.
 */
#include "expand.h"

#include <math.h>
#include <string.h>

enum { NEWEST_VERSION = 370 };

static bool read_version(struct parser *p, span where)
{
	double version;
	struct gate gate;
	gate_open(p, &gate, true);
	const bool ok = parse_float(p, &version);
	gate.operand = true;
	const bool semicolon = ok && accept(p, ';');
	gate_close(p);
	if (!ok || p->failed)
		return false;
	if (!(version >= 0 && version * 100 + 0.5 < NEWEST_VERSION + 1)) {
		parser_error(p, where, "version %g of the language is unknown: 3.7 is the newest",
			version);
		return false;
	}
	struct language_state *state = parser_change_state(p);
	state->version = (int)(version * 100 + 0.5);
	state->version_set = true;
	if (!semicolon && state->version >= 310)
		diag_warning(p->diag, where, "#version should end with ';'");
	return true;
}

/* Behind `unofficial`: scenes of patched programs give the name of theirs. */
static bool refuse_patched(struct parser *p)
{
	const struct raw_token *raw = raw_peek(p);
	const struct name *name =
		raw && raw->kind == RAW_NAME ? &p->expand->names.list[raw->payload] : NULL;
	if (!name || name->binding)
		return false;
	if (!strcmp(name->text, "lambert"))
		parser_error(p, raw_span(p), "not supported yet: extensions of the language");
	else
		parser_error(p, raw_span(p),
			"the scene is written for %s: the language read here is that of POV-Ray "
			"3.7",
			name->text);
	return true;
}

static bool version_run(struct parser *p, span where)
{
	const struct raw_token *raw = raw_peek(p);
	if (raw && raw->kind == RAW_NAME &&
		!strcmp(p->expand->names.list[raw->payload].text, "unofficial")) {
		raw_take(p);
		if (refuse_patched(p))
			return false;
	}
	return read_version(p, where);
}

static bool run(struct parser *p, enum keyword keyword, const struct directive *d, span where)
{
	switch (keyword) {
	case K_BREAK:
		return block_break(p, where);
	case K_CASE:
	case K_RANGE:
		return condition_case(p, d, where);
	case K_DEBUG:
	case K_WARNING:
	case K_ERROR:
	case K_RENDER:
	case K_STATISTICS:
		return message_run(p, keyword, where);
	case K_DECLARE:
	case K_LOCAL:
		return declare_run(p, keyword == K_LOCAL, where);
	case K_DEFAULT:
		return parse_defaults(p);
	case K_ELSE:
		return condition_else(p, d, where);
	case K_ELSEIF:
		return condition_elseif(p, d, where);
	case K_END:
		return block_end(p, where);
	case K_FCLOSE:
		return file_close(p, where);
	case K_FOPEN:
		return file_open(p, where);
	case K_FOR:
		return loop_for(p, d, where);
	case K_IF:
	case K_IFDEF:
	case K_IFNDEF:
		return condition_if(p, d, where);
	case K_INCLUDE:
		return include_run(p, where);
	case K_MACRO:
		return macro_define(p, d, where);
	case K_READ:
		return file_read(p, where);
	case K_SWITCH:
		return condition_switch(p, d, where);
	case K_UNDEF:
		return undef_run(p, where);
	case K_VERSION:
		return version_run(p, where);
	case K_WHILE:
		return loop_while(p, d, where);
	case K_WRITE:
		return file_write(p, where);
	default:
		parser_error(p, where, "not supported yet: #%s", keyword_name(keyword));
		return false;
	}
}

/* What a directive reads does not touch the gate of the text it stands in. */
static bool run_gated(struct parser *p, enum keyword keyword, const struct directive *d, span where)
{
	struct gate gate;
	gate_open(p, &gate, false);
	const bool ok = run(p, keyword, d, where);
	gate_close(p);
	return ok && !p->failed;
}

/* Tells somebody who asks where the reading is. False: it is to stop there, without an error. */
static bool tell_place(struct parser *p, span where)
{
	const struct parse_options *o = p->options;
	if (!o->asked || !atomic_load_explicit(o->asked, memory_order_relaxed))
		return true;
	atomic_store_explicit(o->asked, false, memory_order_relaxed);
	if (!o->reached(o->reached_user, where))
		p->failed = p->stopped = true;
	return !p->stopped;
}

/* Whether a directive that is faulty changes nothing but the names it declares. */
static bool is_skippable(enum keyword keyword)
{
	return keyword == K_DECLARE || keyword == K_LOCAL || keyword == K_DEFAULT ||
	       keyword == K_DEBUG || keyword == K_WARNING;
}

bool directive_run(struct parser *p)
{
	struct expand *x = p->expand;
	const struct frame *f = &x->frames[x->frame_count - 1];
	held_collect(p);
	/* Those that read statements, which may end a piece, do not need d any more. */
	const struct raw_token *raw = &f->tokens[f->position];
	const struct directive *d = &f->source->directives[raw->payload];
	if (x->gate == &x->scene_gate && !x->gate->depth)
		x->statement.skippable = is_skippable(d->keyword);
	const span where = { f->source->number, raw->offset, d->length, f->site };
	raw_step(p);
	return tell_place(p, where) && run_gated(p, d->keyword, d, where);
}

bool directive_bare(struct parser *p, enum keyword keyword, span where)
{
	if (keyword != K_DEFAULT)
		diag_warning(p->diag, where, "'%s' should be '#%s'", keyword_name(keyword),
			keyword_name(keyword));
	return run_gated(p, keyword, NULL, where);
}
