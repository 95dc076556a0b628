/* SPDX-License-Identifier: MIT */
/*
 * Makes the passes of the preparation one by one.
 */
#include "pass.h"

#include <stddef.h>

#define PASS(name) extern const struct pass pass_##name;
#include "passes.def"
#undef PASS

static const struct pass *const passes[] = {
#define PASS(name) &pass_##name,
#include "passes.def"
#undef PASS
};

bool pass_tell(const struct pass *pass, const struct preparation *p, double share_done)
{
	return !p->progress || p->progress(p->user, pass->name, share_done);
}

bool scene_prepare(const struct preparation *p)
{
	for (size_t i = 0; i < sizeof passes / sizeof *passes; i++) {
		const struct pass *pass = passes[i];
		if (pass->needed && !pass->needed(p->scene))
			continue;
		if (!pass_tell(pass, p, 0) || !pass->run(pass, p))
			return false;
	}
	return true;
}
