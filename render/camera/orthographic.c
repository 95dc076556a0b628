/* SPDX-License-Identifier: MIT */
/* orthographic: all rays have the direction of the camera. */
#include "camera/camera.h"

static ray orthographic_ray(const struct camera *c, double s, double t)
{
	const vec3 across = vec_add(vec_scale(c->right, s), vec_scale(c->up, t));
	return (ray){ vec_add(c->location, across), c->direction };
}

const struct camera_class camera_orthographic = {
	.name = "orthographic", .is_parallel = true, .ray = orthographic_ray
};
