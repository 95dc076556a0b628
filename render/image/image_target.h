/* SPDX-License-Identifier: MIT */
/*
 * A file under way: it is written under another name in the folder of the final
 * one and renamed when it is complete.
 */
#ifndef LAMBERT_IMAGE_IMAGE_TARGET_H
#define LAMBERT_IMAGE_IMAGE_TARGET_H

#include <stdbool.h>
#include <stdio.h>

struct target {
	char *path;	 /* where the file shall be, links followed */
	char *temporary; /* where it is written; NULL: in place */
	int lock;	 /* tells others that its writer lives; -1: none */
	bool abandoned;	 /* has been removed already */
};

/* Whether a file could be written there; changes nothing. On failure of these functions `reason` (of
 * REASON_SIZE bytes) says why. */
bool target_check(const char *path, char *reason);
/* Opens the file under way; target_finish belongs to it also after a failure. */
bool target_init(struct target *, const char *path, char *reason);
/* What to write to. */
const char *target_name(const struct target *);
/* Puts the complete file in its place. */
bool target_commit(struct target *, char *reason);
/* Removes it while it is still being written. */
void target_abandon(struct target *);
/* Removes what was not put in its place. */
void target_finish(struct target *);

#endif
