/* SPDX-License-Identifier: MIT */
/*
 * What f_ridged_mf multiplies its octaves by. POV-Ray works it out at the first
 * call of a function { internal(59) }, from the H and the lacunarity of that
 * call, and uses it for all later calls of the same declaration, whatever they
 * ask for; pictures are tuned on that (tests/scenes/function_ridged_mf.pov).
 *
 * Which call is the first: one made while the text is read; else the only one
 * there can be, if all calls have the same constants; else it is found by
 * tracing (see render/prepare/first_calls.c). All this is over before threads share the
 * table.
 */
#ifndef LAMBERT_FUNCTION_RIDGED_H
#define LAMBERT_FUNCTION_RIDGED_H

#include <stdbool.h>

enum { RIDGED_WEIGHTS = 32 };

struct ridged_table {
	enum {
		RIDGED_UNUSED,
		RIDGED_UNIFORM, /* every call so far has these H and lacunarity */
		RIDGED_VARIED,	/* which call comes first is not known */
		RIDGED_SETTLED,
		RIDGED_UNSEEN, /* no call came: should there be one, it has its own weights */
	} state;
	double h, lacunarity;
	double weights
		[RIDGED_WEIGHTS]; /* of the octaves, from the second one on; settled tables only */
};

/* The picture may have a call with these; NULL: with what is only known when it is made. */
void ridged_expect(struct ridged_table *, const double *h, const double *lacunarity);
/* A call is made, or is certain to be the first. */
void ridged_settle(struct ridged_table *, double h, double lacunarity);

/* Whether the first call decides. */
static inline bool ridged_is_open(const struct ridged_table *t)
{
	return t->state < RIDGED_SETTLED;
}

#endif
