/* SPDX-License-Identifier: MIT */
/*
 * A worker: all that changes while one thread traces. The core is here; each
 * room that remembers something of its own keeps it behind its pointer.
 */
#ifndef LAMBERT_WORKER_WORKER_H
#define LAMBERT_WORKER_WORKER_H

#include "base/arena.h"
#include "sample/sample.h"
#include "scene/scene.h"

/* Counters, one set per worker, added up by index at the end. */
struct trace_stats {
	uint64_t camera_rays, reflected_rays, refracted_rays, transmitted_rays, shadow_rays;
	uint64_t max_level;
};

struct worker {
	const struct scene *scene;
	struct arena *arena;	 /* as long as the worker */
	struct arena *scratch;	 /* as long as a sample */
	struct sample_id sample; /* names random numbers */
	struct trace_stats stats;

	struct surface_memory *surface;
	struct light_memory *light;
	struct integrate_memory *integrate;
};

/* The core; the rooms add their own. */
void worker_init(struct worker *, const struct scene *);
void worker_finish(struct worker *);

#endif
