/* SPDX-License-Identifier: MIT */
/*
 * What fog does to light on its way.
 */
#ifndef LAMBERT_MEDIUM_FOG_H
#define LAMBERT_MEDIUM_FOG_H

#include "scene/scene.h"

/* Whether there is any. */
static inline bool scene_is_foggy(const struct scene *scene)
{
	return scene->fog_count > 0 && scene->settings.quality >= 9;
}
/* What all fogs do to light over a stretch of a ray: factor, and colour added. */
void fog_effect(const struct scene *, ray, double length, rgb *factor, rgb *added);
/* Mean density of ground fog between two heights in units of fog_alt above fog_offset. */
double fog_mean_density(double s, double e);

#endif
