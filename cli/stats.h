/* SPDX-License-Identifier: MIT */
/* What a picture cost, as one line of JSON and as a line for people. */
#ifndef LAMBERT_CLI_STATS_H
#define LAMBERT_CLI_STATS_H

#include "messages.h"

struct stats {
	const char *scene, *picture;
	unsigned width, height;
	int frame;
	struct lambert_scene_stats scene_stats;
	struct lambert_render_stats render_stats;
	double total_wall; /* of this frame, from reading to the written picture */
};

/* One JSON object and a newline; "-": standard output. False after a message. */
bool stats_write(const struct stats *, const char *path, bool append);
void stats_say(const struct stats *, struct messages *);

#endif
