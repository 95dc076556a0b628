/* SPDX-License-Identifier: MIT */
/*
 * What the language asks of the renderer while a scene is being read: trace(),
 * inside(), extents, functions, turbulence. Objects and functions are lowered
 * into a scene of their own, once each.
 */
#ifndef LAMBERT_LIBRARY_HOOKS_H
#define LAMBERT_LIBRARY_HOOKS_H

#include "base/diag.h"
#include "parser/parser.h"

struct hooks;
struct scene;

/* `rendered`: what is made of the scene, or NULL; the answers share with it what functions remember. */
struct hooks *hooks_create(
	struct diag *, const struct parse_options *files, struct scene *rendered);
void hooks_destroy(struct hooks *);
/* The table for parse_options.hooks; its user is the hooks. */
struct render_hooks hooks_table(struct hooks *);

#endif
