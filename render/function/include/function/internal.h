/* SPDX-License-Identifier: MIT */
/*
 * The numbered built-in functions behind the standard functions include:
 * function { internal(n) }. Each is a function of x, y, z and its own
 * parameters p[0], p[1], …
 */
#ifndef LAMBERT_FUNCTION_INTERNAL_H
#define LAMBERT_FUNCTION_INTERNAL_H

#include <limits.h>

struct ridged_table;

/* Octaves, tubes and the like: at most 10000 are worth waiting for. */
static inline double repeats_of(double parameter)
{
	return parameter > 10000 ? 10000 : parameter;
}

/* A parameter without its fraction; what no int holds is the lowest one, as processors have it. */
static inline int whole(double parameter)
{
	return parameter > INT_MIN && parameter < INT_MAX ? (int)parameter : INT_MIN;
}

/* What a built-in may look at besides its arguments. */
struct function_world {
	int noise_generator;	     /* 1 to 3: of the scene */
	struct ridged_table *ridged; /* f_ridged_mf: what the calls of one declaration share */
};

typedef double internal_function(
	double x, double y, double z, const double *p, const struct function_world *);

struct internal_entry {
	const char *name;
	unsigned parameters; /* behind x, y, z */
	internal_function *call;
};

enum { INTERNAL_RIDGED_MF = 59, INTERNAL_COUNT = 79 };

/* The built-in with that number, or NULL. */
const struct internal_entry *internal_find(int number);

#define INTERNAL(number, name, parameters) internal_function f_##name;
#include "function/internal.def"
#undef INTERNAL

#endif
