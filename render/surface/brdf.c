/* SPDX-License-Identifier: MIT */
/*
 * The one model of how a surface sends light on: Lambert's cosine law with an
 * exponent (brilliance), Phong's highlight about the mirror direction, Blinn's
 * about the half-way vector; metallic and iridescent colour shifts, and grain
 * (crand). It knows no light sources: what arrives is given.
 */
#include "surface/brdf.h"

#include "base/elementary.h"
#include "noise/noise.h"

#include <math.h>

/* Below this cosine a narrow highlight counts as dark. */
#define PHONG_CUTOFF 0.0008

rgb metallic_factor(float metallic, rgb pigment, double cosine)
{
	double fresnel = 0; /* a curve close to Fresnel's, for angles in quarter turns */
	if (cosine <= 1) {
		const double x = elementary_acos(fmax(-1, cosine)) / (M_PI / 2);
		fresnel = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
		fresnel = fmin(1, fmax(0, fresnel));
	}
	const double k = metallic * (1 - fresnel);
	return (rgb){ (float)(1 + k * (pigment.r - 1)), (float)(1 + k * (pigment.g - 1)),
		(float)(1 + k * (pigment.b - 1)) };
}

rgb irid_factor(const struct worker *w, const struct interaction *it, const struct lobe *lobe,
	vec3 direction)
{
	const struct finish *f = lobe->finish;
	const struct settings *settings = &w->scene->settings;
	const rgb wavelength = settings->irid_wavelength;
	double thickness = f->irid_thickness;
	if (f->irid_turbulence != 0) {
		const double noise = noise_turbulence_scalar(
			it->surface.point, 5, 0.5f, 2, settings->noise_generator);
		thickness *= 1 + f->irid_turbulence * (2 * noise - 1);
	}
	const double phase = 2 * M_PI * thickness *
			     (fabs(vec_dot(lobe->normal, direction)) +
				     fabs(vec_dot(lobe->normal, it->surface.direction)));
	return (rgb){ (float)(1 + f->irid * elementary_cos(phase / wavelength.r)),
		(float)(1 + f->irid * elementary_cos(phase / wavelength.g)),
		(float)(1 + f->irid * elementary_cos(phase / wavelength.b)) };
}

static double phong_response(const struct finish *f, vec3 v, vec3 normal, vec3 direction)
{
	const vec3 mirrored = vec_mad(v, -2 * vec_dot(v, normal), normal);
	const double c = vec_dot(mirrored, direction);
	if (c > 0 && (f->phong_size < 60 || c > PHONG_CUTOFF))
		return f->phong * power_of(c, f->phong_size);
	return 0;
}

static double specular_response(const struct finish *f, vec3 v, vec3 normal, vec3 direction)
{
	const vec3 halfway = vec_sub(direction, v);
	const double length = vec_length(halfway);
	const double c = length > 0 ? vec_dot(halfway, normal) / length : 0;
	return c > 0 ? f->specular * power_of(c, f->specular_power) : 0;
}

double brdf_highlight(const struct interaction *it, const struct lobe *lobe, const vec3 *direction)
{
	const struct finish *f = lobe->finish;
	const vec3 v = it->surface.direction;
	double sum = 0;
	if (f->phong > 0)
		sum += phong_response(f, v, lobe->normal, *direction);
	if (f->specular > 0)
		sum += specular_response(f, v, lobe->normal, *direction);
	return sum;
}

double brdf_grain(const struct worker *w, const struct interaction *it, const struct lobe *lobe,
	uint32_t light)
{
	const uint64_t grain = sample_dimension(it->vertex, SAMPLE_GRAIN);
	const uint64_t of_lobe = sample_subdimension(grain, lobe->number);
	return lobe->finish->crand * sample_1d(w->sample, sample_subdimension(of_lobe, light));
}
