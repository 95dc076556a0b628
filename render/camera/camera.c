/* SPDX-License-Identifier: MIT */
/*
 * The list of cameras, and the way from a sample position to a unit ray.
 */
#include "camera/camera.h"

#include <string.h>

#define CAMERA(name) extern const struct camera_class camera_##name;
#include "cameras.def"
#undef CAMERA

static const struct camera_class *const cameras[] = {
#define CAMERA(name) &camera_##name,
#include "cameras.def"
#undef CAMERA
};

const struct camera_class *camera_find(const char *word)
{
	for (size_t i = 0; i < sizeof cameras / sizeof cameras[0]; i++) {
		if (strcmp(cameras[i]->name, word) == 0)
			return cameras[i];
	}
	return NULL;
}

bool camera_ray(
	const struct camera *c, double x, double y, unsigned width, unsigned height, ray *out)
{
	const double s = (x + 0.5) / width - 0.5;
	/* counted from below, or rounding puts the exact horizon on another side than POV-Ray's does */
	const double t = (height - 0.5 - y) / height - 0.5;
	*out = c->kind->ray(c, s, t);
	const double length = vec_length(out->direction);
	if (!(length > 0) || !isfinite(length))
		return false;
	out->direction = vec_scale(out->direction, 1 / length);
	return true;
}
