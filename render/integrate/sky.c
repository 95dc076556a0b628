/* SPDX-License-Identifier: MIT */
/*
 * What comes from where nothing is: the pigments of sky_sphere over the background.
 * From version 3.7 on they are composited like the layers of a texture; before,
 * filter and transmit of the pigments were multiplied up separately.
 */
#include "integrate.h"

static vec3 sky_point(const struct sky_sphere *sky, vec3 direction)
{
	return sky->place ? transform_point_back(sky->place, direction) : direction;
}

/* The background as this ray meets it: reflections never see through it. */
static colour background(const struct scene *scene, bool reflected)
{
	const bool clear = scene->settings.output_alpha && !reflected;
	if (!scene->has_background)
		return (colour){ .transmit = clear ? 1 : 0 };
	colour b = scene->background;
	if (!clear)
		b.filter = b.transmit = 0;
	return b;
}

static struct radiance layered_sky(const struct scene *scene, vec3 direction, colour behind)
{
	const struct sky_sphere *sky = scene->sky_sphere;
	rgb light = rgb_grey(0), tint = rgb_grey(1);
	if (sky) {
		const vec3 p = sky_point(sky, direction);
		for (size_t i = sky->count; i-- > 0;) {
			colour c;
			if (!pigment_colour(sky->pigments[i], p, NULL, &c))
				continue;
			const rgb own = rgb_scale(colour_rgb(c), colour_opacity(c));
			light = rgb_add(light, rgb_mul(rgb_mul(own, tint), sky->emission));
			tint = rgb_mul(tint, colour_tint(c));
		}
	}
	const rgb own = rgb_scale(colour_rgb(behind), colour_opacity(behind));
	light = rgb_add(light, rgb_mul(own, tint));
	tint = rgb_mul(tint, colour_tint(behind));
	return (struct radiance){ light, fminf(1, fabsf(rgb_luminance(tint))) };
}

static struct radiance old_sky(const struct scene *scene, vec3 direction, colour behind)
{
	const struct sky_sphere *sky = scene->sky_sphere;
	const vec3 p = sky_point(sky, direction);
	rgb light = rgb_grey(0);
	colour f = { 1, 1, 1, 1, 1 };
	float clear = 1;
	for (size_t i = sky->count; i-- > 0;) {
		colour c;
		if (!pigment_colour(sky->pigments[i], p, NULL, &c))
			continue;
		light = rgb_add(light, rgb_scale(colour_rgb(c), clear * colour_opacity(c)));
		f = (colour){ f.r * c.r, f.g * c.g, f.b * c.b, f.filter * c.filter,
			f.transmit * c.transmit };
		clear = fabsf(f.filter) + fabsf(f.transmit);
	}
	light = rgb_add(rgb_mul(light, sky->emission), rgb_mul(colour_rgb(behind), colour_tint(f)));
	return (struct radiance){ light, behind.transmit * f.transmit };
}

struct radiance sky_radiance(const struct scene *scene, vec3 direction, bool reflected)
{
	const colour behind = background(scene, reflected);
	if (scene->settings.version >= 370)
		return layered_sky(scene, direction, behind);
	if (scene->settings.output_alpha && !reflected) /* old scenes: nothing at all is there */
		return (struct radiance){ rgb_grey(0), 1 };
	if (!scene->sky_sphere)
		return (struct radiance){ colour_rgb(behind), behind.transmit };
	return old_sky(scene, direction, behind);
}
