/* SPDX-License-Identifier: MIT */
/*
 * Camera rays. A picture position (x, y) becomes s in (-1/2, 1/2) to the right
 * and t in (-1/2, 1/2) upwards; each type of camera makes a ray of them. The
 * vectors arrive final: angle, look_at and transformations are in them.
 */
#include "shading/trace.h"

bool camera_ray(
	const struct camera *c, double x, double y, unsigned width, unsigned height, ray *out)
{
	const double s = (x + 0.5) / width - 0.5;
	/* counted from below, or rounding puts the exact horizon on another side than POV-Ray's does */
	const double t = (height - 0.5 - y) / height - 0.5;
	const vec3 across = vec_add(vec_scale(c->right, s), vec_scale(c->up, t));

	switch (c->type) {
	case CAMERA_PERSPECTIVE:
		out->origin = c->location;
		out->direction = vec_add(c->direction, across);
		break;
	case CAMERA_ORTHOGRAPHIC:
		out->origin = vec_add(c->location, across);
		out->direction = c->direction;
		break;
	}
	const double length = vec_length(out->direction);
	if (!(length > 0) || !isfinite(length))
		return false;
	out->direction = vec_scale(out->direction, 1 / length);
	return true;
}
