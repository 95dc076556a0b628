/* SPDX-License-Identifier: MIT */
/*
 * Shows how far the rendering is: a bar with the time that remains on a
 * terminal, a line for every tenth otherwise. Notices when the user wants to
 * stop.
 */
#ifndef LAMBERT_CLI_PROGRESS_H
#define LAMBERT_CLI_PROGRESS_H

#include "messages.h"

enum progress_style { PROGRESS_OFF, PROGRESS_LINES, PROGRESS_BAR };

struct progress {
	struct messages *messages;
	enum progress_style style;
	const char *what;   /* name of the picture */
	double start, last; /* seconds */
	int tenths;	    /* reported so far */
};

void progress_init(struct progress *, struct messages *, const char *what);
/* For struct lambert_render_options; `user` is a struct progress. */
bool progress_step(void *user, double share_done);
/* For struct lambert_scene_options; `user` is a struct messages. On a terminal, when loading takes
 * long. */
bool progress_reading(void *user, const struct lambert_place *, double seconds);
bool progress_preparing(void *user, const char *what, double share_done, double seconds);
/* Takes the bar away. */
void progress_finish(struct progress *);

/* Seconds since some moment. */
double progress_clock(void);

#endif
