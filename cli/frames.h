/* SPDX-License-Identifier: MIT */
/* Which frames are rendered, and what each of them sees. */
#ifndef LAMBERT_CLI_FRAMES_H
#define LAMBERT_CLI_FRAMES_H

#include "options.h"

struct frames {
	bool is_animation;
	int initial, final; /* as the scene sees them; 0 in a still picture */
	int first, last, step;
	int digits;	    /* of the number in the file name; 0: none */
	double clock_delta; /* rounded once, with the clock */
};

void frames_init(struct frames *, const struct options *);
/* The clock of a frame: worked out in double, rounded to single precision once. */
float frames_clock(const struct frames *, const struct options *, int frame);

#endif
