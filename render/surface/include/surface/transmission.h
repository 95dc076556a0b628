/* SPDX-License-Identifier: MIT */
/*
 * How the light from behind a surface comes through.
 */
#ifndef LAMBERT_SURFACE_TRANSMISSION_H
#define LAMBERT_SURFACE_TRANSMISSION_H

#include "surface/layers.h"

struct transmission {
	bool present;
	bool straight; /* unbent */
	bool total;    /* total internal reflection */
	vec3 direction;
	rgb factor;	/* of the light */
	float transmit; /* factor of the transmit */
	float weight;	/* relative to the arriving ray */
};

/* The ray through a part; its factors hold the fading of the interior it leaves. */
void transmission_find(const struct worker *, const struct interaction *, const struct layers *,
	struct transmission *);

#endif
