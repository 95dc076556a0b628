/* SPDX-License-Identifier: MIT */
/*
 * The weights of f_ridged_mf; see ridged.h.
 */
#include "function/ridged.h"

#include "base/elementary.h"

#include <math.h>
#include <stddef.h>

void ridged_expect(struct ridged_table *t, const double *h, const double *lacunarity)
{
	if (!ridged_is_open(t))
		return;
	const bool first = t->state == RIDGED_UNUSED;
	if (!h || !lacunarity || (!first && (*h != t->h || *lacunarity != t->lacunarity))) {
		t->state = RIDGED_VARIED;
	} else if (first) {
		t->state = RIDGED_UNIFORM;
		t->h = *h;
		t->lacunarity = *lacunarity;
	}
}

void ridged_settle(struct ridged_table *t, double h, double lacunarity)
{
	t->state = RIDGED_SETTLED;
	t->h = h;
	t->lacunarity = lacunarity;
	double frequency = lacunarity;
	for (int i = 0; i < RIDGED_WEIGHTS; i++) {
		t->weights[i] = elementary_pow(frequency, -h);
		frequency *= lacunarity;
	}
}
