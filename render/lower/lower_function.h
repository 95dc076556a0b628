/* SPDX-License-Identifier: MIT */
/*
 * User-defined functions, compiled once each.
 */
#ifndef LAMBERT_RENDER_LOWER_LOWER_FUNCTION_H
#define LAMBERT_RENDER_LOWER_LOWER_FUNCTION_H

#include "render/function/program.h"
#include "render/lower/lower.h"

/* NULL after an error. */
const struct program *lower_function(struct lowering *, const struct function *);

#endif
