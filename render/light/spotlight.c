/* SPDX-License-Identifier: MIT */
/* spotlight: a cone of light, full up to `radius`, nothing from `falloff` on. */
#include "light/light.h"

#include "base/elementary.h"
#include "cone.h"

static double spotlight_cone(
	const struct light *light, const vec3 *p, const vec3 *direction, double distance)
{
	(void)p;
	const double along = vec_dot(*direction, light->axis);
	const double cosine = distance > 0 ? -along : along;
	if (cosine <= 0)
		return 0;
	const double lobe = light->tightness != 0 ? elementary_pow(cosine, light->tightness) : 1;
	if (light->radius > 0 && cosine < light->radius)
		return lobe * smooth_step(light->falloff, light->radius, cosine);
	return lobe;
}

const struct light_class light_spotlight = {
	.name = "spotlight",
	.casts_shadows = true,
	.makes_highlights = true,
	.has_cone = true,
	.has_angles = true,
	.radius = 30,
	.falloff = 45,
	.cone = spotlight_cone,
};
