/* SPDX-License-Identifier: MIT */
/*
 * Where the light comes from and what its cone and distance leave of it. The
 * direction is taken to the place the light is thought to stand at, so the
 * samples of an area light are the same computation with another centre.
 */
#include "light/light.h"

#include "base/elementary.h"

double light_direction(const struct light *light, vec3 centre, vec3 p, vec3 *direction)
{
	const vec3 to_light = vec_sub(centre, p);
	if (light->parallel && light->area_count_u > 0) {
		*direction = vec_normalize(vec_sub(centre, light->point_at));
		return vec_dot(to_light, *direction);
	}
	if (light->parallel) { /* the distance is measured along the axis */
		*direction = vec_negate(light->axis);
		return vec_dot(to_light, *direction);
	}
	const double distance = vec_length(to_light);
	*direction = vec_scale(to_light, 1 / distance);
	return distance;
}

double light_attenuation(
	const struct light *light, const vec3 *p, const vec3 *direction, double distance)
{
	double a = light->kind->cone ? light->kind->cone(light, p, direction, distance) : 1;
	if (a > 0 && light->fade_power > 0 && fabs(light->fade_distance) > NEARLY_ZERO) {
		const double far = distance / light->fade_distance;
		a *= 2 / (1 + (light->fade_power == 2 ? far * far
						      : elementary_pow(far, light->fade_power)));
	}
	return a;
}
