/* SPDX-License-Identifier: MIT */
/*
 * The interior of an object, and how light fades in it.
 */
#include "medium/interior.h"

#include "base/elementary.h"

/* Of objects that were given none. */
static const struct interior solid = { .ior = 1, .dispersion = 1 };
static const struct interior hollow = { .ior = 1, .dispersion = 1, .hollow = true };

const struct interior *object_interior(const struct object *object)
{
	if (object->interior)
		return object->interior;
	return object->hollow ? &hollow : &solid;
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
