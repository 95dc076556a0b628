/* SPDX-License-Identifier: MIT */
/* From the options of the command line to those of the library. */
#ifndef LAMBERT_CLI_SETUP_H
#define LAMBERT_CLI_SETUP_H

#include "frames.h"
#include "messages.h"

/* Refuses what cannot be done or makes no sense, and says what has no effect; false after a
 * message. */
bool setup_check(struct options *);
/* Strings and lists belong to the options' pool. `frame`: its number, 0 in a still picture. */
void setup_scene(struct options *, struct messages *, const struct frames *, int frame,
	struct lambert_scene_options *);
/* False after a message: the region is not in the picture. */
bool setup_render(const struct options *, struct lambert_render_options *);
/* False after a message: the name of the picture has no format. */
bool setup_output(struct options *, struct lambert_output_options *);

#endif
