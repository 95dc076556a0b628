/* SPDX-License-Identifier: MIT */
/*
 * A pass of the preparation: one file each, and one line in passes.def. What it
 * finds out it leaves in the scene, which is const when the last pass is over. Its
 * result must not depend on the number of threads.
 */
#ifndef LAMBERT_PREPARE_PASS_H
#define LAMBERT_PREPARE_PASS_H

#include "prepare/prepare.h"

struct pass {
	const char *name; /* what is being done, for progress */
	/* NULL: every scene needs it. */
	bool (*needed)(const struct scene *);
	/* False: it was stopped. */
	bool (*run)(const struct pass *, const struct preparation *);
};

/* Tells how much of the pass is done; false: stop. */
bool pass_tell(const struct pass *, const struct preparation *, double share_done);

#endif
