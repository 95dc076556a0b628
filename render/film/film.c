/* SPDX-License-Identifier: MIT */
/*
 * Exposing the film: the picture is cut into blocks, threads take the next block
 * that meets the region in row-major order, and each pixel is written by the one
 * thread that owns its block. The blocks are those of the whole picture, because
 * antialiasing looks at a block at a time: a region is the same bytes as its part
 * of the picture.
 */
#include "film/film.h"

#include "base/arena.h"
#include "base/parallel.h"
#include "antialias.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct film *film_create_part(unsigned width, unsigned height, struct block part)
{
	struct film *film = memory_alloc(1, sizeof *film);
	const size_t count = (size_t)(part.right - part.left) * (part.bottom - part.top);
	*film = (struct film){ width, height, part, memory_alloc(count, sizeof *film->pixels) };
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
	free(film->pixels);
	free(film);
}

struct session {
	struct film *film;
	const struct exposure *exposure;
	unsigned block_size;
	unsigned first_column, first_row, columns, rows; /* of blocks */
	struct worker **workers;			 /* one of each per thread */
	struct sampler *samplers;
	pthread_mutex_t lock; /* of `done` and the progress function */
	unsigned done;
	atomic_bool stop;
};

static colour sample_worker(void *worker, double x, double y, struct sample_place place)
{
	return trace_sample(worker, x, y, place);
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
	sampler_block(&s->samplers[thread], s->film, block_at(s, index), s->exposure->region);
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
	return (to - 1) / size - from / size + 1;
}

static struct session session_for(struct film *film, const struct exposure *e)
{
	const struct block r = e->region;
	const unsigned size = e->block_size ? e->block_size : 32;
	return (struct session){
		.film = film,
		.exposure = e,
		.block_size = size,
		.first_column = r.left / size,
		.first_row = r.top / size,
		.columns = blocks_across(r.left, r.right, size),
		.rows = blocks_across(r.top, r.bottom, size),
	};
}

bool film_expose(struct film *film, const struct scene *scene, const struct exposure *e,
	struct trace_stats *stats)
{
	if (e->region.left >= e->region.right || e->region.top >= e->region.bottom)
		return true;
	struct session s = session_for(film, e);
	const size_t blocks = (size_t)s.columns * s.rows;
	const unsigned wanted = e->threads ? e->threads : 1;
	const unsigned threads = wanted < blocks ? wanted : (unsigned)blocks;
	s.workers = memory_alloc(threads, sizeof *s.workers);
	s.samplers = memory_alloc(threads, sizeof *s.samplers);
	for (unsigned i = 0; i < threads; i++) {
		s.workers[i] = worker_create(scene, film->width, film->height);
		sampler_init(&s.samplers[i], &e->antialias, &scene->settings.working, sample_worker,
			s.workers[i]);
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
