/* SPDX-License-Identifier: MIT */
/*
 * The short way for strings: literals, variables and parts of them, and what
 * is asked of them character by character. See quick.c.
 */
#include "quick.h"

#include "build.h"

static bool read_variable(struct quick *q, const char **text)
{
	const struct symbol *symbol;
	const struct value *slot = quick_read_variable(q, &symbol);
	if (!slot || slot->kind != VALUE_STRING)
		return false;
	*text = slot->string;
	return true;
}

static bool read_float(struct quick *q, double *value)
{
	struct number n;
	if (!quick_read_sum(q, &n) || n.terms != 1)
		return false;
	*value = n.v[0];
	return true;
}

/* ( string, first, count ) */
static bool read_substr(struct quick *q, const char **text)
{
	const char *whole;
	double first, count;
	q->at++;
	if (!quick_skip(q, '(') || !quick_read_text(q, &whole) || !quick_skip(q, ',') ||
		!read_float(q, &first) || !quick_skip(q, ',') || !read_float(q, &count) ||
		!quick_skip(q, ')'))
		return false;
	*text = text_substr(q->p, whole, first, count, NO_SPAN);
	return true;
}

static bool read_any(struct quick *q, const char **text)
{
	const struct raw_token *raw = q->at;
	switch (quick_next(q)) {
	case RAW_STRING:
		q->at++;
		*text = string_plain(q->p, q->frame->source->bytes + raw->offset + 1, raw->payload);
		return *text != NULL;
	case RAW_NAME:
		return read_variable(q, text);
	case RAW_KEYWORD:
		return raw->payload == (uint32_t)K_SUBSTR && read_substr(q, text);
	default:
		return false;
	}
}

bool quick_read_text(struct quick *q, const char **text)
{
	if (!quick_go_down(q))
		return false;
	const bool ok = read_any(q, text);
	quick_go_up(q);
	return ok;
}

bool quick_read_text_function(struct quick *q, enum keyword word, struct number *n)
{
	const char *a, *b = "";
	q->at++;
	if (!quick_skip(q, '(') || !quick_read_text(q, &a) ||
		(word == K_STRCMP && (!quick_skip(q, ',') || !quick_read_text(q, &b))) ||
		!quick_skip(q, ')'))
		return false;
	*n = number_float(word == K_ASC	     ? text_asc(a)
			  : word == K_STRLEN ? text_length(q->p, a)
					     : text_compare(a, b));
	return true;
}
