/* SPDX-License-Identifier: MIT */
/*
 * Mirrors and refraction. Reflectivity runs from reflection_min looking straight
 * on to reflection_max at grazing angles, by a power of the cosine or by
 * Fresnel's formula for unpolarised light.
 */
#include "surface/specular.h"

#include "base/elementary.h"
#include "medium/interior.h"

double fresnel_reflectance(double eta, double cosine)
{
	const double q = eta * eta + cosine * cosine - 1;
	if (q <= 0)
		return 1;
	const double g = sqrt(q), c = cosine;
	const double a = (g - c) / (g + c);
	const double b = (c * (g + c) - 1) / (c * (g - c) + 1);
	return fmin(1, fmax(0, 0.5 * a * a * (1 + b * b)));
}

/* k parts of a, 1 - k parts of b. */
static rgb rgb_blend(rgb a, rgb b, double k)
{
	return rgb_add(rgb_scale(a, k), rgb_scale(b, 1 - k));
}

static rgb falloff_reflectivity(const struct finish *f, double cosine)
{
	double k = 1 - cosine;
	if (fabs(f->reflection_falloff - 1) > NEARLY_ZERO)
		k = elementary_pow(k, f->reflection_falloff);
	if (fabs(k) <= NEARLY_ZERO)
		return f->reflection_min;
	if (fabs(k - 1) <= NEARLY_ZERO)
		return f->reflection_max;
	return rgb_blend(f->reflection_max, f->reflection_min, k);
}

rgb reflectivity(const struct interaction *it, const struct lobe *lobe, float *weight)
{
	const struct finish *f = lobe->finish;
	const double cosine = -vec_dot(it->surface.direction, lobe->normal);
	rgb amount;
	if (f->fresnel) {
		const double eta =
			interior_stack_fresnel_ratio(it->interiors, object_interior(it->object));
		amount = rgb_blend(
			f->reflection_max, f->reflection_min, fresnel_reflectance(eta, cosine));
		*weight = rgb_max(amount);
	} else {
		amount = falloff_reflectivity(f, cosine);
		*weight = fmaxf(rgb_max(f->reflection_max), rgb_max(f->reflection_min));
	}
	if (f->reflection_metallic != 0)
		amount = rgb_mul(
			amount, metallic_factor(f->reflection_metallic, lobe->pigment, cosine));
	return amount;
}

/* v after reflection at a plane with unit normal n. */
static vec3 mirrored(vec3 v, vec3 n)
{
	return vec_mad(v, -2 * vec_dot(v, n), n);
}

vec3 mirror_direction(vec3 v, vec3 normal, vec3 geometric)
{
	vec3 r = mirrored(v, normal);
	if (vec_dot(r, geometric) < 0) /* below the smooth surface */
		r = vec_dot(r, normal) < 0 ? mirrored(v, geometric) : mirrored(r, geometric);
	return vec_normalize(r);
}

bool refract_direction(vec3 v, vec3 normal, double eta, vec3 *out)
{
	const double along = vec_dot(v, normal);
	const double cosine = fabs(along);
	const double q = 1 + eta * eta * (cosine * cosine - 1);
	if (q < 0)
		return false;
	const vec3 against = along > 0 ? vec_negate(normal) : normal;
	*out = vec_add(vec_scale(v, eta), vec_scale(against, eta * cosine - sqrt(q)));
	return true;
}
