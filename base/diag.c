/* SPDX-License-Identifier: MIT */
/*
 * Sources, sites and messages; see diag.h. The lines of a source are indexed
 * when a place in it is first asked for: most sources are never asked about.
 */
#include "base/diag.h"

#include "base/arena.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Deeper chains than this are shown in part: the innermost ones. */
enum { CHAIN_MAX = 8, CONTEXT_MAX = 320 };
/* Of a longer line a place shows a part, so that a message costs the same in a file of one line. */
enum { TEXT_MAX = 4096, TEXT_LEAD = 1024 };

struct source {
	const char *name, *bytes;
	size_t size;
	uint32_t *lines; /* offsets of their first bytes; NULL: not indexed */
	size_t line_count;
};

struct site {
	span call;
	const char *context;
};

/* What the scene needs and is not supported yet. */
struct feature {
	char *message; /* also its name */
	span first;
	unsigned places;
};

struct diag {
	message_sink sink;
	void *user;
	struct source *sources;
	struct site *sites;
	size_t source_count, source_room, site_count, site_room;
	struct feature *features;
	size_t feature_count;
	unsigned mistakes;
	bool muted;
	uint32_t last_site; /* of the last message: its notes need not say the way again */
	bool dropped;	    /* the last error or warning was not shown: nor are its notes */
	uint64_t *seen;	    /* hashes of what was shown, open addressing; 0: free */
	size_t seen_count, seen_room;
	char *lines[CHAIN_MAX + 1];	       /* the text of the places being shown */
	char contexts[CHAIN_MAX][CONTEXT_MAX]; /* what is said of those passed several times */
};

struct diag *diag_create(message_sink sink, void *user)
{
	struct diag *d = memory_alloc(1, sizeof *d);
	*d = (struct diag){ .sink = sink, .user = user };
	return d;
}

void diag_destroy(struct diag *d)
{
	if (!d)
		return;
	for (int i = 0; i <= CHAIN_MAX; i++)
		free(d->lines[i]);
	for (size_t i = 0; i < d->feature_count; i++)
		free(d->features[i].message);
	free(d->features);
	for (size_t i = 0; i < d->source_count; i++)
		free(d->sources[i].lines);
	free(d->sources);
	free(d->sites);
	free(d->seen);
	free(d);
}

uint32_t diag_add_source(struct diag *d, const char *name, const char *bytes, size_t size)
{
	if (d->source_count == d->source_room) {
		d->source_room = d->source_room ? 2 * d->source_room : 16;
		d->sources = memory_grow(d->sources, d->source_room, sizeof *d->sources);
	}
	d->sources[d->source_count++] =
		(struct source){ .name = name, .bytes = bytes, .size = size };
	return (uint32_t)d->source_count;
}

uint32_t diag_add_site(struct diag *d, span call, const char *context)
{
	if (d->site_count == d->site_room) {
		d->site_room = d->site_room ? 2 * d->site_room : 64;
		d->sites = memory_grow(d->sites, d->site_room, sizeof *d->sites);
	}
	d->sites[d->site_count++] = (struct site){ call, context };
	return (uint32_t)d->site_count;
}

/* A newline is LF, CR, CR LF or LF CR; returns its length at p, 0 if there is none. */
static size_t newline_length(const char *p, const char *end)
{
	if (p == end || (*p != '\n' && *p != '\r'))
		return 0;
	return p + 1 < end && (p[1] == '\n' || p[1] == '\r') && p[1] != *p ? 2 : 1;
}

/* Writes the start of every line to `lines` unless that is NULL; returns their number. */
static size_t find_lines(const struct source *s, uint32_t *lines)
{
	size_t count = 0;
	const char *end = s->bytes + s->size;
	if (lines)
		lines[0] = 0;
	for (const char *p = s->bytes; p < end;) {
		const size_t n = newline_length(p, end);
		p += n ? n : 1;
		count += n > 0;
		if (n && lines)
			lines[count] = (uint32_t)(p - s->bytes);
	}
	return count + 1;
}

static void index_lines(struct source *s)
{
	s->lines = memory_alloc(find_lines(s, NULL), sizeof *s->lines);
	s->line_count = find_lines(s, s->lines);
}

/* The line that an offset is in, from 0. */
static size_t line_at(const struct source *s, size_t offset)
{
	size_t low = 0, high = s->line_count;
	while (high - low > 1) {
		const size_t middle = low + (high - low) / 2;
		if (s->lines[middle] <= offset)
			low = middle;
		else
			high = middle;
	}
	return low;
}

/* Copies the line between two offsets, or the part of a long one around `at`; returns where the part
 * begins. */
static size_t copy_text(const struct source *s, size_t from, size_t end, size_t at, char **text)
{
	size_t stop = end;
	if (end - from > TEXT_MAX) {
		from = at - from > TEXT_LEAD ? at - TEXT_LEAD : from;
		stop = end - from > TEXT_MAX ? from + TEXT_MAX : end;
	}
	size_t length = 0;
	while (from + length < stop && !newline_length(s->bytes + from + length, s->bytes + stop))
		length++;
	free(*text);
	*text = memory_alloc(length + 1, 1);
	memcpy(*text, s->bytes + from, length);
	(*text)[length] = 0;
	return from;
}

static struct place resolve(struct diag *d, span where, char **text)
{
	struct place place = { .length = where.length ? where.length : 1 };
	if (where.source == 0 || where.source > d->source_count)
		return place;
	struct source *s = &d->sources[where.source - 1];
	if (!s->lines)
		index_lines(s);
	const size_t at = where.offset < s->size ? where.offset : s->size;
	const size_t line = line_at(s, at), from = s->lines[line];
	const size_t end = line + 1 < s->line_count ? s->lines[line + 1] : s->size;
	place.text_offset = (unsigned)(copy_text(s, from, end, at, text) - from);
	place.file = s->name;
	place.line = (unsigned)line + 1;
	place.column = (unsigned)(at - from) + 1;
	place.text = *text;
	return place;
}

struct place diag_place(struct diag *d, span where)
{
	return resolve(d, where, &d->lines[0]);
}

/* -- What was shown before ---------------------------------------------------------------- */

static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
	const unsigned char *p = bytes;
	for (size_t i = 0; i < size; i++)
		hash = (hash ^ p[i]) * 1099511628211u; /* FNV-1a */
	return hash;
}

static void put_seen(struct diag *d, uint64_t hash)
{
	size_t at = (size_t)hash & (d->seen_room - 1);
	while (d->seen[at])
		at = (at + 1) & (d->seen_room - 1);
	d->seen[at] = hash;
}

static void widen_seen(struct diag *d)
{
	uint64_t *const old = d->seen;
	const size_t old_room = d->seen_room;
	d->seen_room = old_room ? 2 * old_room : 64;
	d->seen = memory_alloc(d->seen_room, sizeof *d->seen);
	memset(d->seen, 0, d->seen_room * sizeof *d->seen);
	for (size_t i = 0; i < old_room; i++)
		if (old[i])
			put_seen(d, old[i]);
	free(old);
}

/* Whether this text is shown at this place for the first time; from now on it was shown. */
static bool first_time(struct diag *d, span where, const char *text)
{
	uint64_t hash = hash_bytes(14695981039346656037u, text, strlen(text));
	hash = hash_bytes(hash, &where.source, sizeof where.source);
	hash = hash_bytes(hash, &where.offset, sizeof where.offset);
	hash += hash == 0;
	for (size_t at = (size_t)hash; d->seen_room; at++) {
		const uint64_t known = d->seen[at & (d->seen_room - 1)];
		if (known == hash)
			return false;
		if (!known)
			break;
	}
	if (2 * ++d->seen_count > d->seen_room)
		widen_seen(d);
	put_seen(d, hash);
	return true;
}

/* -- Messages ----------------------------------------------------------------------------- */

/* The sites that led to a place, each place once: a macro may call itself. */
struct chain {
	const struct site *sites[CHAIN_MAX];
	unsigned times[CHAIN_MAX];
	size_t length;
	unsigned more; /* beyond those */
};

static bool is_same(const struct site *a, const struct site *b)
{
	return a->call.source == b->call.source && a->call.offset == b->call.offset &&
	       (a->context == b->context ||
		       (a->context && b->context && !strcmp(a->context, b->context)));
}

static void add_site(struct chain *chain, const struct site *site)
{
	for (size_t i = 0; i < chain->length; i++)
		if (is_same(chain->sites[i], site)) {
			chain->times[i]++;
			return;
		}
	if (chain->length == CHAIN_MAX) {
		chain->more++;
		return;
	}
	chain->sites[chain->length] = site;
	chain->times[chain->length++] = 1;
}

static struct chain find_chain(const struct diag *d, uint32_t site)
{
	struct chain chain = { .length = 0 };
	while (site && site <= d->site_count) {
		const struct site *s = &d->sites[site - 1];
		add_site(&chain, s);
		site = s->call.site;
	}
	return chain;
}

/* What leads from entry i of the chain to the one before. */
static const char *context_of(struct diag *d, const struct chain *chain, size_t i)
{
	const char *context = chain->sites[i]->context;
	const unsigned times = chain->times[i], more = i + 1 < CHAIN_MAX ? 0 : chain->more;
	char *text = d->contexts[i];
	if (times == 1 && !more)
		return context;
	const int length =
		snprintf(text, CONTEXT_MAX - 64, "%s", context ? context : "reached from here");
	char *end = text + (length < CONTEXT_MAX - 64 ? length : CONTEXT_MAX - 65);
	if (times > 1)
		end += snprintf(end, 32, " (%u times)", times);
	if (more)
		snprintf(end, 32, ", and %u more", more);
	return text;
}

static void show(struct diag *d, enum severity severity, span where, const char *text)
{
	struct place places[CHAIN_MAX];
	const bool same_way = severity == SEVERITY_NOTE && where.site == d->last_site;
	const struct chain chain = find_chain(d, same_way ? 0 : where.site);
	for (size_t i = 0; i < chain.length; i++) {
		places[i] = resolve(d, chain.sites[i]->call, &d->lines[i + 1]);
		places[i].context = context_of(d, &chain, i);
	}
	const struct message m = {
		.severity = severity,
		.text = text,
		.place = resolve(d, where, &d->lines[0]),
		.chain = places,
		.chain_length = chain.length,
	};
	d->last_site = where.site;
	d->sink(d->user, &m);
}

static void deliver(
	struct diag *d, enum severity severity, span where, const char *format, va_list args)
{
	char text[1024];
	vsnprintf(text, sizeof text, format, args);
	d->dropped = d->muted || !first_time(d, where, text);
	if (d->dropped)
		return;
	d->mistakes += severity == SEVERITY_ERROR;
	show(d, severity, where, text);
}

void diag_error(struct diag *d, span where, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	deliver(d, SEVERITY_ERROR, where, format, args);
	va_end(args);
}

void diag_warning(struct diag *d, span where, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	deliver(d, SEVERITY_WARNING, where, format, args);
	va_end(args);
}

void diag_scene_warning(struct diag *d, span where, const char *text)
{
	d->dropped = d->muted;
	if (!d->dropped)
		show(d, SEVERITY_WARNING, where, text);
}

void diag_note(struct diag *d, span where, const char *format, ...)
{
	if (d->muted || d->dropped)
		return;
	char text[1024];
	va_list args;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	show(d, SEVERITY_NOTE, where, text);
}

/* -- What is not supported yet ------------------------------------------------------------ */

static struct feature *find_feature(struct diag *d, const char *message)
{
	for (size_t i = 0; i < d->feature_count; i++)
		if (!strcmp(d->features[i].message, message))
			return &d->features[i];
	return NULL;
}

static struct feature *add_feature(struct diag *d, const char *message, span first)
{
	const size_t size = strlen(message) + 1;
	char *copy = memory_alloc(size, 1);
	memcpy(copy, message, size);
	d->features = memory_grow(d->features, d->feature_count + 1, sizeof *d->features);
	d->features[d->feature_count] = (struct feature){ .message = copy, .first = first };
	return &d->features[d->feature_count++];
}

void diag_unsupported(struct diag *d, span where, const char *what)
{
	char message[256];
	snprintf(message, sizeof message, "not supported yet: %s", what);
	if (d->muted || !first_time(d, where, message))
		return;
	struct feature *f = find_feature(d, message);
	if (!f)
		f = add_feature(d, message, where);
	f->places++;
}

void diag_show_unsupported(struct diag *d)
{
	char text[320];
	for (size_t i = 0; i < d->feature_count; i++) {
		const struct feature *f = &d->features[i];
		snprintf(text, sizeof text, "%s (the first of %u places)", f->message, f->places);
		show(d, SEVERITY_ERROR, f->first, f->places > 1 ? text : f->message);
	}
}

bool diag_mute(struct diag *d, bool muted)
{
	const bool before = d->muted;
	d->muted = muted;
	return before;
}

unsigned diag_errors(const struct diag *d)
{
	return d->mistakes + (unsigned)d->feature_count;
}

unsigned diag_mistakes(const struct diag *d)
{
	return d->mistakes;
}
