/* SPDX-License-Identifier: MIT */
/*
 * Frame numbers and the clock by POV-Ray's rules: (0,0) and (1,1) for the first
 * and last frame mean a still picture; a cyclic animation has one frame more
 * than it renders, so that the last leads on to the first.
 */
#include "frames.h"

static int larger(int a, int b)
{
	return a > b ? a : b;
}

/* A frame number, or a share of the animation when it lies between 0 and 1. */
static int subset_frame(float v, int initial, int final)
{
	if (v > 0 && v < 1)
		return (int)(((float) final - (float)initial + 1) * v);
	return v > 1e9f ? 1000000000 : v < 0 ? 0 : (int)v;
}

static int digits_of(int n)
{
	int digits = 1;
	for (; n >= 10; n /= 10)
		digits++;
	return digits;
}

void frames_init(struct frames *f, const struct options *o)
{
	const int given_initial = options_set(o, "Initial_Frame") ? o->initial_frame : 0;
	const int given_final = options_set(o, "Final_Frame") ? o->final_frame : 0;
	*f = (struct frames){ .step = larger(o->frame_step, 1) };
	if (given_initial == given_final && (given_final == 0 || given_final == 1))
		return;
	f->is_animation = true;
	f->initial = larger(options_set(o, "Initial_Frame") ? given_initial : 1, 0);
	f->final = larger(options_set(o, "Final_Frame") ? given_final : 1, f->initial);
	f->first = f->initial;
	f->last = f->final;
	if (o->cyclic)
		f->final++;
	if (options_set(o, "Subset_Start_Frame") || o->subset_start > 0)
		f->first = larger(subset_frame(o->subset_start, f->initial, f->final), f->initial);
	if (options_set(o, "Subset_End_Frame") || o->subset_end > 0)
		f->last = subset_frame(o->subset_end, f->initial, f->final);
	f->last = larger(f->last, f->first);
	f->digits = digits_of(f->final);
	/* An animation of one frame stands still; POV-Ray divides by zero here. */
	if (f->final > f->initial)
		f->clock_delta =
			(double)(o->final_clock - o->initial_clock) / (f->final - f->initial);
}

float frames_clock(const struct frames *f, const struct options *o, int frame)
{
	if (!f->is_animation)
		return o->clock;
	return (float)((double)o->initial_clock + f->clock_delta * (frame - f->initial));
}
