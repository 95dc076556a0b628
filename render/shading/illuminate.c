/* SPDX-License-Identifier: MIT */
/*
 * Direct light on one layer of a surface: Lambert's cosine law with an exponent
 * (brilliance), Phong's highlight about the mirror direction, Blinn's about the
 * half-way vector. What the layer would send on is known before the shadow ray
 * is, so light that could not matter costs no shadow ray.
 */
#include "shading.h"

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

rgb irid_factor(const struct worker *w, const struct point *at, const struct finish *f, vec3 normal,
	vec3 direction)
{
	const struct settings *settings = &w->scene->settings;
	const rgb wavelength = settings->irid_wavelength;
	double thickness = f->irid_thickness;
	if (f->irid_turbulence != 0) {
		const double noise = noise_turbulence_scalar(
			at->surface.point, 5, 0.5f, 2, settings->noise_generator);
		thickness *= 1 + f->irid_turbulence * (2 * noise - 1);
	}
	const double phase =
		2 * M_PI * thickness *
		(fabs(vec_dot(normal, direction)) + fabs(vec_dot(normal, at->surface.direction)));
	return (rgb){ (float)(1 + f->irid * elementary_cos(phase / wavelength.r)),
		(float)(1 + f->irid * elementary_cos(phase / wavelength.g)),
		(float)(1 + f->irid * elementary_cos(phase / wavelength.b)) };
}

/* The lights of a grid are attenuated one by one. */
static void incidence_find(struct incidence *in, const struct light *light, vec3 p, bool grid)
{
	in->distance = light_direction(light, light->location, p, &in->direction);
	in->colour = light->colour;
	if (!grid && light_attenuates(light))
		in->colour = rgb_scale(
			in->colour, light_attenuation(light, p, in->direction, in->distance));
	in->known = true;
}

/* Shadows by quality: none below 4, area lights as points below 5. */
static void incidence_shadow(
	struct worker *w, struct incidence *in, const struct light *light, const struct point *at)
{
	const int quality = w->scene->settings.quality;
	in->shadowed = true;
	if (quality < 4 || (light->type == LIGHT_SHADOWLESS && !light->projected_through))
		return;
	if (light->area_count_u > 0 && quality >= 5)
		in->colour = area_light_filter(w, light, at, in->direction, in->colour);
	else
		in->colour = shadow_filter(w, light, at, in->direction, in->distance, in->colour);
}

/* What a layer makes of light of strength 1 from one direction. */
struct response {
	double diffuse, highlight;
	double cosine;
	bool draws; /* crand takes a random number */
};

static double diffuse_response(const struct finish *f, double k, double cosine)
{
	const double c = fabs(cosine);
	return k * (f->brilliance == 1 ? c : power_of(c, f->brilliance));
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

/* False: the layer shows nothing of light from there. With `both_sides` it does not matter which
 * side the light is on. */
static bool respond(const struct light *light, const struct point *at, const struct coat *coat,
	vec3 direction, bool both_sides, struct response *out)
{
	const struct finish *f = coat->finish;
	const double cosine = vec_dot(coat->normal, direction);
	const bool behind = !both_sides && cosine < NEARLY_ZERO;
	if (behind && f->diffuse_back == 0)
		return false;

	*out = (struct response){ .cosine = cosine };
	const double k = behind ? f->diffuse_back : f->diffuse;
	if (k > 0) {
		out->diffuse = diffuse_response(f, k, cosine);
		out->draws = f->crand > 0;
	}
	if (!behind && light->type != LIGHT_SHADOWLESS) {
		const vec3 v = at->surface.direction;
		if (f->phong > 0)
			out->highlight += phong_response(f, v, coat->normal, direction);
		if (f->specular > 0)
			out->highlight += specular_response(f, v, coat->normal, direction);
	}
	return out->diffuse != 0 || out->highlight != 0 || out->draws;
}

/* The light sent to the viewer of light `arriving` from `direction`. */
static rgb answer(struct worker *w, const struct point *at, const struct coat *coat, vec3 direction,
	const struct response *response, rgb arriving)
{
	const struct finish *f = coat->finish;
	double diffuse = response->diffuse * coat->own;
	if (response->draws)
		diffuse -= f->crand * worker_random(w);
	rgb sum = rgb_scale(rgb_mul(coat->pigment, arriving), diffuse);
	if (response->highlight != 0) {
		if (f->metallic > 0)
			arriving = rgb_mul(arriving,
				metallic_factor(f->metallic, coat->pigment, response->cosine));
		sum = rgb_add(sum, rgb_scale(arriving, response->highlight));
	}
	if (f->irid > 0)
		sum = rgb_mul(sum, irid_factor(w, at, f, coat->normal, direction));
	return sum;
}

/* area_illumination: each light of the grid lights by itself, under the common shadow. */
static rgb light_grid(struct worker *w, const struct point *at, const struct coat *coat,
	const struct light *light, const struct incidence *in)
{
	const int count_u = light->area_count_u, count_v = light->area_count_v;
	const vec3 p = at->surface.point;
	const struct area_axes axes = area_light_axes(light, in->direction);
	const rgb share = rgb_scale(in->colour, 1.0 / (count_u * count_v));
	rgb sum = rgb_grey(0);
	for (int v = 0; v < count_v; v++) {
		for (int u = 0; u < count_u; u++) {
			const vec3 centre = area_light_point(w, light, &axes, u, v);
			vec3 direction;
			struct response response;
			const double distance = light_direction(light, centre, p, &direction);
			if (!respond(light, at, coat, direction, at->object->double_illuminate,
				    &response))
				continue;
			const double left = light_attenuation(light, p, direction, distance);
			sum = rgb_add(sum,
				answer(w, at, coat, direction, &response, rgb_scale(share, left)));
		}
	}
	return sum;
}

/* Whether a light that stands at one point is behind a layer that shows nothing of such light. This
 * is seen before its direction is made unit: a sine of rounding errors is no cosine of 1e-10. */
static bool is_wasted(const struct light *light, const struct point *at, const struct coat *coat)
{
	if (light->type == LIGHT_CYLINDER || light->parallel || coat->finish->diffuse_back != 0)
		return false;
	return vec_dot(coat->normal, vec_sub(light->location, at->surface.point)) <= 0;
}

static rgb light_one(struct worker *w, const struct point *at, const struct coat *coat,
	const struct light *light, struct incidence *in)
{
	const bool grid = light->area_illumination && light->area_count_u > 0 &&
			  w->scene->settings.quality >= 5;
	const bool both_sides = at->object->double_illuminate || light->area_illumination;
	struct response response;
	if (!grid && !both_sides && is_wasted(light, at, coat))
		return rgb_grey(0);
	if (!in->known)
		incidence_find(in, light, at->surface.point, grid);
	if (rgb_is_dark(in->colour))
		return rgb_grey(0);
	if (!grid && !respond(light, at, coat, in->direction, both_sides, &response))
		return rgb_grey(0);
	if (!in->shadowed)
		incidence_shadow(w, in, light, at);
	if (rgb_is_dark(in->colour))
		return rgb_grey(0);
	if (grid)
		return light_grid(w, at, coat, light, in);
	return answer(w, at, coat, in->direction, &response, in->colour);
}

rgb illuminate(struct worker *w, const struct point *at, const struct coat *coat)
{
	const struct finish *f = coat->finish;
	rgb sum = rgb_grey(0);
	if (f->diffuse == 0 && f->diffuse_back == 0 && f->phong == 0 && f->specular == 0)
		return sum;

	if (at->object->global_lights) {
		for (size_t i = 0; i < w->light_count; i++) {
			struct incidence own = { .known = false };
			struct incidence *in =
				at->shares_lights ? &w->incidences[at->shared + i] : &own;
			sum = rgb_add(sum, light_one(w, at, coat, w->lights[i], in));
		}
	}
	const struct object_extras *extras = at->object->extras;
	for (const struct light *const *l = extras ? extras->lights : NULL; l && *l; l++) {
		struct incidence own = { .known = false };
		sum = rgb_add(sum, light_one(w, at, coat, *l, &own));
	}
	return sum;
}
