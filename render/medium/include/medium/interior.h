/* SPDX-License-Identifier: MIT */
/*
 * The interior of an object.
 */
#ifndef LAMBERT_MEDIUM_INTERIOR_H
#define LAMBERT_MEDIUM_INTERIOR_H

#include "scene/scene.h"

/* An object without one has a plain one, hollow as the object is. */
const struct interior *object_interior(const struct object *);
/* What distance z through an interior leaves of the light. */
rgb interior_fading(const struct interior *, double z);

#endif
