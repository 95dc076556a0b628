/* SPDX-License-Identifier: MIT */
/*
 * Threads that take the next job number from a shared counter.
 */
#include "base/parallel.h"

#include "base/arena.h"

#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

struct work {
	size_t count;
	void (*job)(void *, size_t, unsigned);
	void *user;
	atomic_size_t next;
};

struct helper {
	struct work *work;
	unsigned thread;
	pthread_t id;
};

unsigned parallel_processors(void)
{
	cpu_set_t set;
	if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
		return (unsigned)CPU_COUNT(&set);
	return 1;
}

static void run(struct work *w, unsigned thread)
{
	for (;;) {
		const size_t index = atomic_fetch_add_explicit(&w->next, 1, memory_order_relaxed);
		if (index >= w->count)
			return;
		w->job(w->user, index, thread);
	}
}

static void *helper_main(void *argument)
{
	struct helper *h = argument;
	run(h->work, h->thread);
	return NULL;
}

void parallel_for(size_t count, unsigned threads, void (*job)(void *, size_t, unsigned), void *user)
{
	struct work w = { .count = count, .job = job, .user = user };
	if (threads < 1)
		threads = 1;
	if (threads > count)
		threads = count ? (unsigned)count : 1;
	struct helper *helpers = memory_alloc(threads, sizeof *helpers);
	unsigned started = 1;
	pthread_attr_t attributes;
	pthread_attr_init(&attributes);
	pthread_attr_setstacksize(&attributes, PARALLEL_STACK);
	for (unsigned i = 1; i < threads; i++) {
		helpers[started] = (struct helper){ .work = &w, .thread = i };
		if (pthread_create(
			    &helpers[started].id, &attributes, helper_main, &helpers[started]) == 0)
			started++;
	}
	pthread_attr_destroy(&attributes);
	run(&w, 0);
	for (unsigned i = 1; i < started; i++)
		pthread_join(helpers[i].id, NULL);
	free(helpers);
}

struct deep_job {
	void (*job)(void *);
	void *user;
};

static void *deep_main(void *argument)
{
	const struct deep_job *d = argument;
	d->job(d->user);
	return NULL;
}

/* Whether the thread has ended within a quarter of a second. */
static bool join_soon(pthread_t id)
{
	struct timespec until;
	clock_gettime(CLOCK_REALTIME, &until);
	until.tv_nsec += 250000000;
	until.tv_sec += until.tv_nsec / 1000000000;
	until.tv_nsec %= 1000000000;
	return pthread_timedjoin_np(id, NULL, &until) != ETIMEDOUT;
}

static void join(pthread_t id, void (*tick)(void *), void *user)
{
	if (!tick)
		pthread_join(id, NULL);
	else
		while (!join_soon(id))
			tick(user);
}

void parallel_with_stack(size_t bytes, void (*job)(void *), void (*tick)(void *), void *user)
{
	struct deep_job d = { job, user };
	pthread_t id;
	pthread_attr_t attributes;
	pthread_attr_init(&attributes);
	pthread_attr_setstacksize(&attributes, bytes);
	const bool started = pthread_create(&id, &attributes, deep_main, &d) == 0;
	pthread_attr_destroy(&attributes);
	if (started)
		join(id, tick, user);
	else
		job(user);
}
