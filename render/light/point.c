/* SPDX-License-Identifier: MIT */
/*
 * Lights that shine the same in all directions: the plain one, which has no word,
 * and the one that only brightens (shadowless).
 */
#include "light/light.h"

const struct light_class light_point = {
	.name = "point", .casts_shadows = true, .makes_highlights = true
};
const struct light_class light_shadowless = { .name = "shadowless" };
