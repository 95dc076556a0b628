/* SPDX-License-Identifier: MIT */
/*
 * The life of a worker's core.
 */
#include "worker/worker.h"

void worker_init(struct worker *w, const struct scene *scene)
{
	*w = (struct worker){ .scene = scene };
	w->arena = arena_create(0);
	w->scratch = arena_create(0);
}

void worker_finish(struct worker *w)
{
	arena_destroy(w->arena);
	arena_destroy(w->scratch);
}
