/* SPDX-License-Identifier: MIT */
/*
 * Work over threads. Jobs are numbered; which thread runs which job is not
 * defined, so a job must write only what its number owns.
 */
#ifndef LAMBERT_BASE_PARALLEL_H
#define LAMBERT_BASE_PARALLEL_H

#include <stddef.h>

/* Bytes of stack of the threads: enough for deep ray trees whatever the system's default is. */
enum { PARALLEL_STACK = 64 << 20 };

/* Processors available to this process, at least 1. */
unsigned parallel_processors(void);

/* Runs job(user, index, thread) for every index below `count` on `threads` threads (the caller is
 * one of them) and returns when all are done. thread is below `threads`. Indices are handed out in
 * ascending order. */
void parallel_for(size_t count, unsigned threads,
	void (*job)(void *user, size_t index, unsigned thread), void *user);

/* Runs job(user) with `bytes` of stack, of which only what is used takes memory. Until it is done
 * tick(user) is called four times a second from the caller's thread; NULL: nothing is called. */
void parallel_with_stack(
	size_t bytes, void (*job)(void *user), void (*tick)(void *user), void *user);

#endif
