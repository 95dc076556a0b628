/* SPDX-License-Identifier: MIT */
/*
 * The end of scenes that grow without one: a macro that calls itself twice, an
 * array that holds the one before twice. The option --loop-limit says how many
 * tokens may be read, and what all of it may come to in bytes: a twentieth of
 * that number, which is 1 GB by default.
 *
 * What a text spells out is not growth: to each byte of it TEXT_SHARE are added.
 */
#include "expand.h"

enum {
	FREE_BYTES = 16 << 20, /* that any scene may use */
	TOKENS_PER_BYTE = 20,
	SITE_BYTES = 32,  /* of a place from which a macro was called, for messages */
	PASSED_SHARE = 3, /* of the trees handed over a scene keeps a part, about this one */
	TEXT_SHARE = 100, /* bytes of a tree for one of the text, more than any text needs */
};

static double held_now(const struct parser *p)
{
	const struct held *h = &p->held;
	size_t bytes = arena_used(h->texts) + h->array_bytes + arena_used(p->arena) +
		       p->passed_bytes / PASSED_SHARE;
	bytes += p->expand->site_count * SITE_BYTES;
	if (p->tree != p->arena)
		bytes += arena_used(p->tree);
	return (double)bytes;
}

static double text_share(const struct expand *x)
{
	double bytes = 0;
	for (const struct source *s = x->sources; s; s = s->previous)
		bytes += (double)s->size;
	return TEXT_SHARE * bytes;
}

bool growth_permits(struct parser *p, double more, span where)
{
	const double most = FREE_BYTES + p->options->max_loop_tokens / TOKENS_PER_BYTE;
	if (p->options->max_loop_tokens == 0 || held_now(p) + more <= most ||
		held_now(p) + more <= most + text_share(p->expand))
		return true;
	parser_stop(p, where,
		"this scene grows without end: what its loops, macros and arrays make has come to "
		"%.3g bytes (--loop-limit permits more)",
		held_now(p) + more);
	return false;
}
