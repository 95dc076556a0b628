/* SPDX-License-Identifier: MIT */
/*
 * Exposing the film: the region is cut into blocks from its own corner, threads
 * take the next block in row-major order, and each pixel is written by the one
 * thread that owns its block.
 */
#include "film/film.h"

#include "base/arena.h"
#include "base/parallel.h"
#include "antialias.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct film *film_create(unsigned width, unsigned height)
{
	struct film *film = memory_alloc(1, sizeof *film);
	const size_t count = (size_t)width * height;
	*film = (struct film){ width, height, memory_alloc(count, sizeof *film->pixels) };
	memset(film->pixels, 0, count * sizeof *film->pixels);
	return film;
}

void film_destroy(struct film *film)
{
	if (!film)
		return;
	free(film->pixels);
	free(film);
}

struct session {
	struct film *film;
	const struct exposure *exposure;
	unsigned block_size, columns, rows;
	struct worker **workers; /* one of each per thread */
	struct sampler *samplers;
	pthread_mutex_t lock; /* of `done` and the progress function */
	unsigned done;
	atomic_bool stop;
};

static colour sample_worker(void *worker, double x, double y, struct sample_place place)
{
	return trace_sample(worker, x, y, place);
}

static struct block block_at(const struct session *s, size_t index)
{
	const struct exposure *e = s->exposure;
	struct block b = { .left = e->left + (unsigned)(index % s->columns) * s->block_size,
		.top = e->top + (unsigned)(index / s->columns) * s->block_size };
	b.right = e->right - b.left > s->block_size ? b.left + s->block_size : e->right;
	b.bottom = e->bottom - b.top > s->block_size ? b.top + s->block_size : e->bottom;
	return b;
}

static void report(struct session *s)
{
	const struct exposure *e = s->exposure;
	if (!e->progress || atomic_load(&s->stop))
		return;
	pthread_mutex_lock(&s->lock);
	s->done++;
	if (!atomic_load(&s->stop) && !e->progress(e->user, s->done, s->columns * s->rows))
		atomic_store(&s->stop, true);
	pthread_mutex_unlock(&s->lock);
}

/* Between the rows of a block: a slow block must not keep a user waiting. */
static bool is_stopped(void *user)
{
	struct session *s = user;
	const struct exposure *e = s->exposure;
	if (!atomic_load_explicit(&s->stop, memory_order_relaxed) && e->progress) {
		pthread_mutex_lock(&s->lock);
		if (!e->progress(e->user, s->done, s->columns * s->rows))
			atomic_store(&s->stop, true);
		pthread_mutex_unlock(&s->lock);
	}
	return atomic_load_explicit(&s->stop, memory_order_relaxed);
}

static void expose_block(void *user, size_t index, unsigned thread)
{
	struct session *s = user;
	if (atomic_load_explicit(&s->stop, memory_order_relaxed))
		return;
	sampler_block(&s->samplers[thread], s->film, block_at(s, index));
	report(s);
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
	return (to - from - 1) / size + 1;
}

/* A block larger than the region is the region. */
static unsigned usual_block(const struct exposure *e)
{
	const unsigned width = e->right - e->left, height = e->bottom - e->top;
	const unsigned longest = width > height ? width : height;
	const unsigned size = e->block_size ? e->block_size : 32;
	return size < longest ? size : longest;
}

bool film_expose(struct film *film, const struct scene *scene, const struct exposure *e,
	struct trace_stats *stats)
{
	if (e->left >= e->right || e->top >= e->bottom)
		return true;
	struct session s = { .film = film, .exposure = e, .block_size = usual_block(e) };
	s.columns = blocks_across(e->left, e->right, s.block_size);
	s.rows = blocks_across(e->top, e->bottom, s.block_size);
	const size_t blocks = (size_t)s.columns * s.rows;
	const unsigned wanted = e->threads ? e->threads : 1;
	const unsigned threads = wanted < blocks ? wanted : (unsigned)blocks;
	s.workers = memory_alloc(threads, sizeof *s.workers);
	s.samplers = memory_alloc(threads, sizeof *s.samplers);
	for (unsigned i = 0; i < threads; i++) {
		s.workers[i] = worker_create(scene, film->width, film->height);
		sampler_init(&s.samplers[i], &e->antialias, &scene->settings.working, s.block_size,
			sample_worker, s.workers[i]);
		s.samplers[i].cancelled = is_stopped;
		s.samplers[i].cancelled_user = &s;
	}
	pthread_mutex_init(&s.lock, NULL);
	atomic_init(&s.stop, false);

	parallel_for(blocks, threads, expose_block, &s);

	pthread_mutex_destroy(&s.lock);
	for (unsigned i = 0; i < threads; i++) {
		if (stats)
			add_stats(stats, &s.workers[i]->stats);
		worker_destroy(s.workers[i]);
		sampler_finish(&s.samplers[i]);
	}
	free(s.workers);
	free(s.samplers);
	return !atomic_load(&s.stop);
}
