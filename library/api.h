/* SPDX-License-Identifier: MIT */
/*
 * What stands behind the handles of lambert/lambert.h that more than one file
 * of the library looks into.
 */
#ifndef LAMBERT_LIBRARY_API_H
#define LAMBERT_LIBRARY_API_H

#include "lambert/lambert.h"
#include "film/film.h"

/* Owns the film. */
struct lambert_image {
	struct film *film;
	struct working_space working; /* of the film's numbers */
	bool output_alpha;	      /* the scene was rendered for a picture with alpha */
};

#endif
