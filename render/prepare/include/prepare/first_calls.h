/* SPDX-License-Identifier: MIT */
/*
 * Functions that remember their first call (f_ridged_mf does) make a picture depend
 * on the order of its rays. So that it is the same for any number of threads, the
 * first calls are made beforehand, in the order of a picture of that size made by
 * one thread without antialiasing, whatever part of it will be wanted.
 */
#ifndef LAMBERT_PREPARE_FIRST_CALLS_H
#define LAMBERT_PREPARE_FIRST_CALLS_H

struct scene;

/* For a scene that is committed. Costs nothing when there is no such function, or all its calls
 * agree. */
void first_calls_make(struct scene *, unsigned width, unsigned height);

#endif
