/* SPDX-License-Identifier: MIT */
/*
 * Where the light comes from and what its cone and distance leave of it. The
 * direction is taken to the place the light is thought to stand at, so the
 * samples of an area light are the same computation with another centre.
 */
#include "shading.h"

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
	if (light->type == LIGHT_CYLINDER) {
		*direction = vec_normalize(vec_sub(centre, light->point_at));
		return vec_dot(to_light, *direction);
	}
	const double distance = vec_length(to_light);
	*direction = vec_scale(to_light, 1 / distance);
	return distance;
}

/* 0 below lo, 1 from hi on, smooth in between. */
static double smooth_step(double lo, double hi, double x)
{
	if (x < lo)
		return 0;
	if (x >= hi)
		return 1;
	const double z = (x - lo) / (hi - lo);
	return (3 - 2 * z) * z * z;
}

static double spot_attenuation(const struct light *light, vec3 direction, double distance)
{
	const double along = vec_dot(direction, light->axis);
	const double cosine = distance > 0 ? -along : along;
	if (cosine <= 0)
		return 0;
	const double lobe = light->tightness != 0 ? elementary_pow(cosine, light->tightness) : 1;
	if (light->radius > 0 && cosine < light->radius)
		return lobe * smooth_step(light->falloff, light->radius, cosine);
	return lobe;
}

/* About the axis through the light itself, for all samples of an area light. */
static double cylinder_attenuation(const struct light *light, vec3 p)
{
	const vec3 from_light = vec_sub(p, light->location);
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

double light_attenuation(const struct light *light, vec3 p, vec3 direction, double distance)
{
	double a = 1;
	if (light->type == LIGHT_SPOT)
		a = spot_attenuation(light, direction, distance);
	else if (light->type == LIGHT_CYLINDER)
		a = cylinder_attenuation(light, p);
	if (a > 0 && light->fade_power > 0 && fabs(light->fade_distance) > NEARLY_ZERO) {
		const double far = distance / light->fade_distance;
		a *= 2 / (1 + (light->fade_power == 2 ? far * far
						      : elementary_pow(far, light->fade_power)));
	}
	return a;
}
