/* SPDX-License-Identifier: MIT */
/*
 * Reflected and refracted rays: how much, which way, and what the interior
 * takes. Reflectivity runs from reflection_min looking straight on to
 * reflection_max at grazing angles, by a power of the cosine or by Fresnel's
 * formula for unpolarised light.
 */
#include "shading.h"

#include "base/elementary.h"

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

rgb reflectivity(const struct point *at, const struct coat *coat, float *weight)
{
	const struct finish *f = coat->finish;
	const double cosine = -vec_dot(at->surface.direction, coat->normal);
	rgb amount;
	if (f->fresnel) {
		const double eta =
			containment_fresnel_ratio(&at->path->inside, object_interior(at->object));
		amount = rgb_blend(
			f->reflection_max, f->reflection_min, fresnel_reflectance(eta, cosine));
		*weight = rgb_max(amount);
	} else {
		amount = falloff_reflectivity(f, cosine);
		*weight = fmaxf(rgb_max(f->reflection_max), rgb_max(f->reflection_min));
	}
	if (f->reflection_metallic != 0)
		amount = rgb_mul(
			amount, metallic_factor(f->reflection_metallic, coat->pigment, cosine));
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

rgb interior_fading(const struct interior *i, double z)
{
	if (fabs(i->fade_distance) <= NEARLY_ZERO)
		return rgb_grey(1);
	const double x = z / i->fade_distance;
	const rgb k = i->fade_colour;
	const rgb rest = { 1 - k.r, 1 - k.g, 1 - k.b };
	if (i->fade_power >= 1000)
		return (rgb){ (float)elementary_exp(-rest.r * x),
			(float)elementary_exp(-rest.g * x), (float)elementary_exp(-rest.b * x) };
	return rgb_add(k, rgb_scale(rest, 1 / (1 + power_of(x, i->fade_power))));
}

void passage_follow(
	struct worker *w, const struct point *at, const struct passage *passage, struct path *path)
{
	struct path next = *at->path;
	if (path != at->path)
		next.inside.borrowed = true;
	next.ray = (ray){ at->surface.point, passage->direction };
	next.weight *= passage->weight;
	next.straight = passage->straight;
	next.vertex = sample_vertex(at->path->vertex, 0);
	if (passage->total)
		next.kind = RAY_REFLECTED;
	else
		containment_toggle(&next.inside, object_interior(at->object), w->scratch);
	if (next.kind == RAY_CAMERA)
		next.kind = RAY_SECONDARY;

	if (passage->straight)
		w->stats.transmitted_rays++;
	else if (passage->total)
		w->stats.reflected_rays++;
	else
		w->stats.refracted_rays++;
	*path = next;
}
