/* SPDX-License-Identifier: MIT */
/* cylinder: a beam of light, full up to `radius` from its axis, nothing from `falloff` on. */
#include "light/light.h"

#include "base/elementary.h"
#include "cone.h"

/* About the axis through the light itself, for all samples of an area light. */
static double cylinder_cone(
	const struct light *light, const vec3 *p, const vec3 *direction, double distance)
{
	(void)direction, (void)distance;
	const vec3 from_light = vec_sub(*p, light->location);
	const double along = vec_dot(from_light, light->axis);
	if (along <= 0)
		return 0;
	const double off_axis = vec_length(vec_mad(from_light, -along, light->axis));
	if (off_axis >= light->falloff)
		return 0;
	const double x = 1 - off_axis / light->falloff;
	const double lobe = light->tightness != 0 ? elementary_pow(x, light->tightness) : 1;
	if (light->radius > 0 && off_axis > light->radius)
		return lobe * smooth_step(0, 1 - light->radius / light->falloff, x);
	return lobe;
}

const struct light_class light_cylinder = {
	.name = "cylinder",
	.is_parallel = true,
	.casts_shadows = true,
	.makes_highlights = true,
	.has_cone = true,
	.radius = 0.75,
	.falloff = 1,
	.cone = cylinder_cone,
};
