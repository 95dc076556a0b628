/* SPDX-License-Identifier: MIT */
/*
 * Fog: light fades with the distance travelled, and the fog's colour takes its
 * place. Ground fog has density 1 below fog_offset and 1 / (1 + h^2) above it;
 * its mean over a stretch is known in closed form, an arctangent. Several fogs
 * do not attenuate each other's colour.
 */
#include "medium/fog.h"

#include "base/elementary.h"
#include "noise/noise.h"

double fog_mean_density(double s, double e)
{
	if (s <= 0 && e <= 0)
		return 1;
	if (s <= 0)
		return (elementary_atan(e) - s) / (e - s);
	if (e <= 0)
		return (elementary_atan(s) - e) / (s - e);
	if (fabs(s - e) <= NEARLY_ZERO)
		return 1 / (s * s + 1);
	return (elementary_atan(s) - elementary_atan(e)) / (s - e);
}

/* Turbulence shortens the way. The vector sets the frequency, turb_depth the strength. */
static double turbulent_length(const struct scene *scene, const struct fog *fog, ray r, double z)
{
	const double near = elementary_exp(-z / fog->distance);
	const vec3 q = vec_mul(ray_at(r, z / 2), fog->turbulence);
	const double noise =
		fog->turb_depth * noise_turbulence_scalar(q, fog->octaves, fog->omega, fog->lambda,
					  scene->settings.noise_generator);
	return z * (1 - near * fmin(1, noise));
}

static double fog_transmittance(const struct scene *scene, const struct fog *fog, ray r, double z)
{
	double length = fog->turbulent ? turbulent_length(scene, fog, r, z) : z;
	if (fog->ground) {
		const double start = vec_dot(r.origin, fog->up);
		const double end = vec_dot(ray_at(r, z), fog->up);
		length *= fog_mean_density(
			(start - fog->offset) / fog->altitude, (end - fog->offset) / fog->altitude);
	}
	return fmax(elementary_exp(-length / fog->distance), fog->colour.transmit);
}

void fog_effect(const struct scene *scene, ray r, double length, rgb *factor, rgb *added)
{
	*factor = rgb_grey(1);
	*added = rgb_grey(0);
	for (size_t i = 0; i < scene->fog_count; i++) {
		const struct fog *fog = scene->fogs[i];
		if (fabs(fog->distance) <= NEARLY_ZERO)
			continue;
		const rgb tint = colour_rgb(fog->colour);
		const float filter = fog->colour.filter;
		const double a = fog_transmittance(scene, fog, r, length);
		const rgb through = rgb_add(rgb_grey(1 - filter), rgb_scale(tint, filter));
		*factor = rgb_mul(*factor, rgb_scale(through, a));
		*added = rgb_add(*added, rgb_scale(tint, 1 - a));
	}
}
