/* SPDX-License-Identifier: MIT */
/* perspective: all rays start at the location, as through a pinhole. */
#include "camera/camera.h"

static ray perspective_ray(const struct camera *c, double s, double t)
{
	const vec3 across = vec_add(vec_scale(c->right, s), vec_scale(c->up, t));
	return (ray){ c->location, vec_add(c->direction, across) };
}

const struct camera_class camera_perspective = { .name = "perspective", .ray = perspective_ray };
