/* SPDX-License-Identifier: MIT */
/*
 * The first pass: the scene is complete, and a tree over its objects is built.
 */
#include "pass.h"
#include "scene/scene.h"

static bool commit_run(const struct pass *pass, const struct preparation *p)
{
	(void)pass;
	scene_commit(p->scene, p->threads);
	return true;
}

extern const struct pass pass_commit;
const struct pass pass_commit = { .name = "building the tree of objects", .run = commit_run };
