/* SPDX-License-Identifier: MIT */
/*
 * The first calls of functions that remember them; see first_calls.h.
 */
#include "prepare/first_calls.h"

#include "function/ridged.h"
#include "scene/scene.h"
#include "integrate/trace.h"

/* The order of pixels is that of POV-Ray: by blocks of this size. */
enum { BLOCK = 32 };

static struct ridged_table *table_at(const struct scene *scene, size_t i)
{
	return scene->ridged_tables.pairs[i].value;
}

/* Whether some first call must still be found. */
static bool is_waiting(const struct scene *scene)
{
	for (size_t i = 0; i < scene->ridged_tables.size; i++) {
		const struct ridged_table *t = table_at(scene, i);
		if (t && t->state == RIDGED_VARIED)
			return true;
	}
	return false;
}

/* What is known already. */
static void settle_uniform(const struct scene *scene)
{
	for (size_t i = 0; i < scene->ridged_tables.size; i++) {
		struct ridged_table *t = table_at(scene, i);
		if (t && t->state == RIDGED_UNIFORM)
			ridged_settle(t, t->h, t->lacunarity);
	}
}

static void close_unseen(const struct scene *scene)
{
	for (size_t i = 0; i < scene->ridged_tables.size; i++) {
		struct ridged_table *t = table_at(scene, i);
		if (t && ridged_is_open(t))
			t->state = RIDGED_UNSEEN;
	}
}

static void trace_block(
	struct worker *w, unsigned left, unsigned top, unsigned width, unsigned height)
{
	for (unsigned y = top; y < top + BLOCK && y < height; y++) {
		for (unsigned x = left; x < left + BLOCK && x < width; x++)
			trace_sample(w, x, y, (struct sample_place){ (int32_t)x, (int32_t)y, 0 });
	}
}

static void trace_until_settled(const struct scene *scene, unsigned width, unsigned height)
{
	struct worker *w = worker_create(scene, width, height);
	for (unsigned top = 0; top < height && is_waiting(scene); top += BLOCK) {
		for (unsigned left = 0; left < width && is_waiting(scene); left += BLOCK)
			trace_block(w, left, top, width, height);
	}
	worker_destroy(w);
}

void first_calls_make(struct scene *scene, unsigned width, unsigned height)
{
	settle_uniform(scene);
	if (is_waiting(scene))
		trace_until_settled(scene, width, height);
	close_unseen(scene);
}
