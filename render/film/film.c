/* SPDX-License-Identifier: MIT */
/*
 * Exposing the film: the picture is cut into blocks, threads take the next block
 * that meets the region in row-major order, and each pixel is written by the one
 * thread that owns its block. The blocks are those of the whole picture, because
 * antialiasing looks at a block at a time: a region is the same bytes as its part
 * of the picture.
 *
 * A strategy of several passes decides before each one, block by block, and only
 * then are samples taken: no decision sees half a pass.
 */
#include "film/film.h"

#include "base/arena.h"
#include "base/parallel.h"
#include "film/sums.h"
#include "sampling.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct film *film_create_part(unsigned width, unsigned height, struct block part)
{
	struct film *film = memory_alloc(1, sizeof *film);
	const size_t count = (size_t)(part.right - part.left) * (part.bottom - part.top);
	*film = (struct film){ width, height, part, memory_alloc(count, sizeof *film->pixels),
		NULL };
	memset(film->pixels, 0, count * sizeof *film->pixels);
	return film;
}

struct film *film_create(unsigned width, unsigned height)
{
	return film_create_part(width, height, (struct block){ 0, 0, width, height });
}

void film_destroy(struct film *film)
{
	if (!film)
		return;
	film_sums_destroy(film->sums);
	free(film->pixels);
	free(film);
}

/* What one thread works with. */
struct hand {
	struct worker *worker;
	struct sampler sampler;
	uint64_t wanted; /* samples, by the blocks this thread has planned */
};

struct session {
	struct film *film;
	const struct exposure *exposure;
	struct block region; /* that samples are taken in */
	unsigned block_size;
	unsigned first_column, first_row, columns, rows; /* of blocks */
	struct hand *hands;
	unsigned threads;
	unsigned pass, passes;
	pthread_mutex_t lock; /* of `done` and the progress function */
	unsigned done;
	atomic_bool stop;
};

static void sample_worker(void *worker, size_t count, const struct position *at, colour *out)
{
	for (size_t i = 0; i < count; i++)
		out[i] = trace_sample(worker, at[i].x, at[i].y, at[i].place);
}

/* The last block of a row or column ends with the picture. */
static unsigned block_end(unsigned start, unsigned block_size, unsigned picture_end)
{
	return picture_end - start > block_size ? start + block_size : picture_end;
}

static struct block block_at(const struct session *s, size_t index)
{
	struct block b = {
		.left = (s->first_column + (unsigned)(index % s->columns)) * s->block_size,
		.top = (s->first_row + (unsigned)(index / s->columns)) * s->block_size,
	};
	b.right = block_end(b.left, s->block_size, s->film->width);
	b.bottom = block_end(b.top, s->block_size, s->film->height);
	return b;
}

/* Asks the progress function whether to go on. With the lock. */
static void ask(struct session *s)
{
	const struct exposure *e = s->exposure;
	if (!e->progress(e->user, s->done, s->columns * s->rows * s->passes))
		atomic_store(&s->stop, true);
}

static void report(struct session *s)
{
	const struct exposure *e = s->exposure;
	if (!e->progress || atomic_load(&s->stop))
		return;
	pthread_mutex_lock(&s->lock);
	s->done++;
	if (!atomic_load(&s->stop))
		ask(s);
	pthread_mutex_unlock(&s->lock);
}

/* Between the rows of a block: a slow block must not keep a user waiting. */
static bool is_stopped(void *user)
{
	struct session *s = user;
	const struct exposure *e = s->exposure;
	if (!atomic_load_explicit(&s->stop, memory_order_relaxed) && e->progress) {
		pthread_mutex_lock(&s->lock);
		ask(s);
		pthread_mutex_unlock(&s->lock);
	}
	return atomic_load_explicit(&s->stop, memory_order_relaxed);
}

static void plan_block(void *user, size_t index, unsigned thread)
{
	struct session *s = user;
	struct hand *hand = &s->hands[thread];
	hand->wanted +=
		sampler_plan(&hand->sampler, s->film, s->pass, block_at(s, index), s->region);
}

static void expose_block(void *user, size_t index, unsigned thread)
{
	struct session *s = user;
	if (atomic_load_explicit(&s->stop, memory_order_relaxed))
		return;
	sampler_take(&s->hands[thread].sampler, s->film, block_at(s, index), s->region);
	report(s);
}

/* Whether some pixel wants samples in this pass. */
static bool plan_pass(struct session *s)
{
	uint64_t wanted = 0;
	for (unsigned i = 0; i < s->threads; i++)
		s->hands[i].wanted = 0;
	parallel_for((size_t)s->columns * s->rows, s->threads, plan_block, s);
	for (unsigned i = 0; i < s->threads; i++)
		wanted += s->hands[i].wanted;
	return wanted > 0;
}

static void expose_passes(struct session *s)
{
	const bool plans = s->exposure->sampling->wanted != NULL;
	for (s->pass = 0; s->pass < s->passes && !atomic_load(&s->stop); s->pass++) {
		if (plans && !plan_pass(s))
			return;
		s->done = s->pass * s->columns * s->rows;
		parallel_for((size_t)s->columns * s->rows, s->threads, expose_block, s);
	}
}

/* Colours from sums. */
static void resolve(struct film *film, struct block region)
{
	for (unsigned y = region.top; y < region.bottom; y++) {
		for (unsigned x = region.left; x < region.right; x++)
			*film_pixel(film, x, y) = pixel_sum_mean(film_sum(film->sums, x, y));
	}
}

static void add_stats(struct trace_stats *to, const struct trace_stats *from)
{
	to->camera_rays += from->camera_rays;
	to->reflected_rays += from->reflected_rays;
	to->refracted_rays += from->refracted_rays;
	to->transmitted_rays += from->transmitted_rays;
	to->shadow_rays += from->shadow_rays;
	if (from->max_level > to->max_level)
		to->max_level = from->max_level;
}

static unsigned blocks_across(unsigned from, unsigned to, unsigned size)
{
	return (to - 1) / size - from / size + 1;
}

static unsigned grown_end(unsigned end, unsigned by, unsigned limit)
{
	return limit - end > by ? end + by : limit;
}

/* Later passes look around, and so does what they look at. */
static struct block sampled_region(const struct film *film, const struct exposure *e)
{
	const struct sampling_class *c = e->sampling;
	const struct block r = e->region;
	const unsigned by = c->wanted && c->passes > 1 ? (c->passes - 1) * c->reach : 0;
	return (struct block){ r.left > by ? r.left - by : 0, r.top > by ? r.top - by : 0,
		grown_end(r.right, by, film->width), grown_end(r.bottom, by, film->height) };
}

static struct session session_for(struct film *film, const struct exposure *e)
{
	const struct block r = sampled_region(film, e);
	const unsigned size = e->block_size ? e->block_size : 32;
	return (struct session){
		.film = film,
		.exposure = e,
		.region = r,
		.block_size = size,
		.first_column = r.left / size,
		.first_row = r.top / size,
		.columns = blocks_across(r.left, r.right, size),
		.rows = blocks_across(r.top, r.bottom, size),
		.passes = e->sampling->wanted ? e->sampling->passes : 1,
	};
}

static void session_begin(struct session *s, const struct scene *scene)
{
	const struct exposure *e = s->exposure;
	const size_t blocks = (size_t)s->columns * s->rows;
	const unsigned wanted = e->threads ? e->threads : 1;
	s->threads = wanted < blocks ? wanted : (unsigned)blocks;
	s->hands = memory_zeroed(s->threads, sizeof *s->hands);
	for (unsigned i = 0; i < s->threads; i++) {
		struct hand *hand = &s->hands[i];
		hand->worker = worker_create(scene, s->film->width, s->film->height);
		sampler_init(&hand->sampler, e->sampling, &e->antialias, &scene->settings.working,
			sample_worker, hand->worker);
		hand->sampler.cancelled = is_stopped;
		hand->sampler.cancelled_user = s;
	}
	pthread_mutex_init(&s->lock, NULL);
	atomic_init(&s->stop, false);
}

static void session_end(struct session *s, struct trace_stats *stats)
{
	pthread_mutex_destroy(&s->lock);
	for (unsigned i = 0; i < s->threads; i++) {
		if (stats)
			add_stats(stats, &s->hands[i].worker->stats);
		worker_destroy(s->hands[i].worker);
		sampler_finish(&s->hands[i].sampler);
	}
	free(s->hands);
}

bool film_expose(struct film *film, const struct scene *scene, const struct exposure *e,
	struct trace_stats *stats)
{
	if (e->region.left >= e->region.right || e->region.top >= e->region.bottom)
		return true;
	struct session s = session_for(film, e);
	session_begin(&s, scene);
	if (e->sampling->wanted) {
		film_sums_destroy(film->sums);
		film->sums = film_sums_create(s.region);
	}
	expose_passes(&s);
	if (e->sampling->wanted)
		resolve(film, e->region);
	const bool complete = !atomic_load(&s.stop);
	session_end(&s, stats);
	return complete;
}
