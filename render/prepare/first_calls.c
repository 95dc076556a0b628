/* SPDX-License-Identifier: MIT */
/*
 * Functions that remember their first call (f_ridged_mf does) make a picture depend
 * on the order of its rays. So that it is the same for any number of threads, the
 * first calls are made beforehand, in the order of a picture of that size made by
 * one thread without antialiasing. Costs nothing when there is no such function, or
 * all its calls agree.
 *
 * The whole picture is looked through, from its top left until the calls are found,
 * even if only a region of it is wanted: the call that decides may be made outside
 * the region, and a region must be the same bytes as its part of the picture.
 */
#include "pass.h"

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

/* Block by block; false: stopped. */
static bool trace_until_settled(const struct pass *pass, const struct preparation *p)
{
	const size_t columns = ((size_t)p->width + BLOCK - 1) / BLOCK;
	const size_t blocks = columns * (((size_t)p->height + BLOCK - 1) / BLOCK);
	struct worker *w = worker_create(p->scene, p->width, p->height);
	bool goes_on = true;
	for (size_t i = 0; i < blocks && goes_on && is_waiting(p->scene); i++) {
		trace_block(w, (unsigned)(i % columns) * BLOCK, (unsigned)(i / columns) * BLOCK,
			p->width, p->height);
		goes_on = pass_tell(pass, p, (double)(i + 1) / (double)blocks);
	}
	worker_destroy(w);
	return goes_on;
}

static bool first_calls_needed(const struct scene *scene)
{
	return scene->ridged_tables.size > 0;
}

static bool first_calls_run(const struct pass *pass, const struct preparation *p)
{
	settle_uniform(p->scene);
	if (is_waiting(p->scene) && !trace_until_settled(pass, p))
		return false;
	close_unseen(p->scene);
	return true;
}

extern const struct pass pass_first_calls;
const struct pass pass_first_calls = {
	.name = "looking for first calls of functions",
	.needed = first_calls_needed,
	.run = first_calls_run,
};
