/* SPDX-License-Identifier: MIT */
/*
 * User-defined functions, compiled once each.
 */
#ifndef LAMBERT_LOWER_LOWER_FUNCTION_H
#define LAMBERT_LOWER_LOWER_FUNCTION_H

#include "function/program.h"
#include "lower/lower.h"

/* NULL after an error. */
const struct program *lower_function(struct lowering *, const struct function *);

#endif
