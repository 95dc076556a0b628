/* SPDX-License-Identifier: MIT */
/*
 * From a scene that lowering has filled to one that is ready to be rendered:
 * passes.def lists what is done, in this order. A scene pays for the passes it
 * needs.
 */
#ifndef LAMBERT_PREPARE_PREPARE_H
#define LAMBERT_PREPARE_PREPARE_H

#include <stdbool.h>

struct scene;

struct preparation {
	struct scene *scene;
	unsigned width, height; /* of the whole picture, whatever part of it will be wanted */
	unsigned threads;
	/* Called at the start of each pass and now and then within it, from the caller's thread.
	 * False: stop. May be NULL. */
	bool (*progress)(void *user, const char *pass, double share_done);
	void *user;
};

/* False: stopped by `progress`; the scene is good for nothing but scene_destroy. */
bool scene_prepare(const struct preparation *);

#endif
