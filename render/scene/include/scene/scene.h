/* SPDX-License-Identifier: MIT */
/*
 * The render scene: what lowering makes of the AST and tracing reads. After
 * scene_commit it is const and shared by all threads without locks.
 */
#ifndef LAMBERT_SCENE_SCENE_H
#define LAMBERT_SCENE_SCENE_H

#include "base/arena.h"
#include "base/colour.h"
#include "base/pointer_map.h"
#include "base/transform.h"
#include "camera/camera.h"
#include "geometry/object.h"

struct accel;
struct light_class;
struct pigment;
struct normal;

struct interior {
	double ior;	   /* 1 if not given */
	double dispersion; /* 1: none */
	int dispersion_samples;
	double caustics; /* as stored: 45 times the scene's number */
	rgb fade_colour;
	double fade_distance, fade_power;
	bool hollow;
};

struct light {
	const struct light_class *kind;
	uint32_t index; /* in scene.lights, by scene_commit */
	bool parallel;
	vec3 location, point_at, axis; /* axis = unit(point_at - location) */
	rgb colour;
	double radius, falloff; /* of the cone: cosines of angles, or lengths; light.h */
	double tightness;
	double fade_distance, fade_power;
	bool media_attenuation, media_interaction;
	bool group_only; /* member of a light_group: lights only its objects */
	const struct object *projected_through; /* or NULL */
	/* area light; count 0: none */
	vec3 area_u, area_v;
	int area_count_u, area_count_v;
	int adaptive;
	bool jitter, circular, orient, area_illumination;
};

struct sky_sphere {
	size_t count; /* pigments, bottom first */
	const struct pigment *const *pigments;
	rgb emission;
	const transform *place; /* NULL: none */
};

struct fog {
	bool ground; /* fog_type 2 */
	colour colour;
	double distance, offset, altitude;
	vec3 up; /* unit */
	bool turbulent;
	vec3 turbulence;
	double turb_depth;
	int octaves;
	float omega, lambda;
};

/* How numbers of the scene become numbers in a file; see image.h. */
enum transfer { TRANSFER_NONE, TRANSFER_LINEAR, TRANSFER_SRGB, TRANSFER_POWER };
struct working_space {
	enum transfer transfer; /* NONE: values are written unconverted (old scenes) */
	float gamma;		/* for TRANSFER_POWER */
};

struct settings {
	int version;	     /* effective language version for rendering, hundredths */
	int max_trace_level; /* 1 to 256 */
	float adc_bailout;
	rgb ambient_light;
	rgb irid_wavelength;
	int quality;	/* 0 to 9 */
	uint32_t frame; /* of an animation: names random numbers */
	bool output_alpha;
	struct working_space working;
	int noise_generator; /* global default, resolved */
};

struct scene {
	struct arena *arena;
	struct settings settings;
	struct camera camera;
	struct object **objects; /* frame-level leaves and compounds, in declaration order */
	size_t object_count, object_room;
	struct light **lights; /* all, in declaration order */
	size_t light_count, light_room;
	const struct fog **fogs;
	size_t fog_count;
	const struct sky_sphere *sky_sphere; /* NULL: none */
	colour background;
	bool has_background;
	struct pointer_map
		ridged_tables; /* struct ridged_table by struct function; see function/ridged.h */

	/* made by scene_commit */
	struct accel *accel;
	const struct light **global_lights; /* those in no group; without black ones */
	size_t global_light_count;
	bool has_tinted_shadows; /* some object casts a shadow that is not opaque */
};

struct scene *scene_create(void);
void scene_destroy(struct scene *);
/* Ranks the objects and builds the acceleration structure with `threads` threads. */
void scene_commit(struct scene *, unsigned threads);

#endif
