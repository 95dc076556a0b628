/* SPDX-License-Identifier: MIT */
/*
 * What the files of the shading half share: trace.c follows rays, shade.c makes
 * a colour of a surface point, illuminate.c adds the lights, light.c and
 * shadow.c say what of a light arrives, area_light.c does so for area lights,
 * secondary.c finds reflected and refracted rays, containment.c knows what a ray
 * is inside of, sky.c and fog.c fill the space between.
 *
 * Everything that changes while tracing belongs to one worker. Growing lists of
 * the worker are used as stacks and addressed by index, because deeper levels of
 * the ray tree may move them.
 */
#ifndef LAMBERT_SHADING_SHADING_H
#define LAMBERT_SHADING_SHADING_H

#include "accel/accel.h"

#include "base/elementary.h"
#include "texture/texture.h"
#include "shading/trace.h"

/* Below this in magnitude, numbers of the language count as zero. */
#define NEARLY_ZERO 1e-10

/* What is seen along a ray. */
struct seen {
	rgb light;
	float transmit; /* share of what is behind the picture */
};

/* The interiors a ray is in, in the order of entering. Lists too long for the struct live in an
 * arena; a copy of such a list is marked as borrowed and gets an array of its own when it changes. */
enum { CONTAINMENT_INLINE = 4 };
struct containment {
	uint32_t count, room; /* room: of spill */
	bool borrowed;	      /* spill belongs to the list this is a copy of */
	const struct interior *own[CONTAINMENT_INLINE];
	const struct interior **spill; /* all of them, if room > 0 */
};

/* One ray of the tree. */
struct path {
	ray ray;
	struct containment inside;
	float weight;	 /* share in the picture, for adc_bailout */
	int level;	 /* compared with max_trace_level */
	uint32_t kind;	 /* enum ray_kind */
	bool straight;	 /* goes on unbent through a surface: keeps the level */
	uint32_t vertex; /* of the ray tree it ends at: names random numbers */
};

/* A point of a surface seen along a path. */
struct point {
	struct surface surface;
	const struct path *path;
	const struct object *object;
	double depth;	 /* distance along the path */
	uint32_t layers; /* shaded so far */
	bool shares_lights;
	size_t shared; /* with shares_lights: where in worker.incidences this point's are */
};

/* What arrives at a point from a light. */
struct incidence {
	vec3 direction; /* unit, towards the light */
	double distance;
	rgb colour;
	bool known;    /* the above are filled in */
	bool shadowed; /* colour is after shadows */
};

/* A reflection to be traced when all layers are done. */
struct reflection {
	uint32_t number; /* of the layer */
	const struct finish *finish;
	vec3 normal;
	rgb amount;
	float weight;
};

/* How the light from behind a surface comes through. */
struct passage {
	bool present;
	bool straight; /* unbent */
	bool total;    /* total internal reflection */
	vec3 direction;
	rgb factor;	/* of the light */
	float transmit; /* factor of the transmit */
	float weight;	/* relative to the arriving ray */
};

/* A point of an area light, once it has been asked. */
struct grid_sample {
	rgb colour;
	uint32_t round; /* it was found in; another one: not known */
};

/* Levels of the ray tree whose shadows are remembered apart: neighbouring camera rays are alike, and
 * so are their reflections. */
enum { BLOCKER_LEVELS = 4 };

struct worker {
	const struct scene *scene;
	unsigned width, height;
	struct arena *arena;	     /* as long as the worker */
	struct arena *scratch;	     /* as long as a sample */
	struct arena *shadow;	     /* as long as a shadow ray */
	const struct light **lights; /* those that are in no group */
	size_t light_count;
	const struct object **blockers; /* by light and level: what blocked it last, or NULL */
	struct containment at_camera;
	bool origin_moves;   /* at_camera is found anew for each camera ray */
	bool has_shadow_fog; /* some light is attenuated by the fog on its way */

	struct texture_part *parts;
	size_t part_count, part_room;
	struct reflection *reflections;
	size_t reflection_count, reflection_room;
	struct incidence *incidences;
	size_t incidence_count, incidence_room;

	struct grid_sample *grid; /* of the area light being asked */
	size_t grid_room;
	uint32_t grid_round;

	struct sample_id sample; /* names random numbers */
	struct trace_stats stats;
};

static inline bool rgb_is_dark(rgb c)
{
	return rgb_max_abs(c) < (float)NEARLY_ZERO;
}
static inline bool rgb_is_zero(rgb c)
{
	return c.r == 0 && c.g == 0 && c.b == 0;
}

/* pow(). The exponents of scenes are mostly whole numbers, and then a few products are faster. */
static inline double power_of(double base, double exponent)
{
	if (!(exponent >= 0 && exponent <= 4096) || exponent != (double)(int)exponent)
		return elementary_pow(base, exponent);
	double result = 1;
	for (unsigned n = (unsigned)exponent; n != 0; n >>= 1, base *= base)
		result *= n & 1 ? base : 1;
	return result;
}

/* ---- trace.c ---- */

/* The colour seen along the path; *path is used up. */
struct seen trace_path(struct worker *, struct path *);

/* ---- shade.c ---- */

/* The colour of a hit without what comes through it. If *onward is present, *path has become the
 * ray that goes on. */
struct seen shade_hit(struct worker *, struct path *, const struct hit *, struct passage *onward);
/* The texture that shows at a hit, and the point to evaluate it at. Turns the normal. */
const struct texture *surface_open(
	struct surface *, const struct hit *, const ray *, vec3 *evaluate_at);

/* Resolves a patterned texture into parts[returned] to parts[part_count - 1]; the caller sets
 * part_count back when it is done with them. */
size_t parts_resolve(struct worker *, const struct texture *, vec3 p, struct surface *);
/* The perturbed normal of a layer. */
vec3 layer_normal(
	const struct worker *, const struct texture_part *, const struct layer *, struct surface *);

/* ---- illuminate.c ---- */

/* One layer as the lights see it. */
struct coat {
	uint32_t number; /* among all layers at the point */
	const struct finish *finish;
	rgb pigment;
	float own; /* share of its own colour: 1 - what comes through */
	vec3 normal;
};
/* Diffuse light and highlights from all lights. */
rgb illuminate(struct worker *, const struct point *, const struct coat *);
/* Iridescence: factors for light from `direction`. */
rgb irid_factor(const struct worker *, const struct point *, const struct finish *, vec3 normal,
	vec3 direction);
/* Colour shift of metallic highlights and reflections: 1 + metallic (1 - Fr)(pigment - 1). */
rgb metallic_factor(float metallic, rgb pigment, double cosine);

/* ---- light.c ---- */

/* The unit direction from p towards the light, seen as standing at `centre`, and the distance as
 * the light counts it (negative behind a parallel light). */
double light_direction(const struct light *, vec3 centre, vec3 p, vec3 *direction);
/* Whether cone or distance take anything of the light. */
static inline bool light_attenuates(const struct light *light)
{
	return light->type == LIGHT_SPOT || light->type == LIGHT_CYLINDER || light->fade_power > 0;
}
/* What they leave of it. */
double light_attenuation(const struct light *, vec3 p, vec3 direction, double distance);

/* ---- shadow.c, area_light.c ---- */

/* What of `colour` arrives at the point from a light `distance` away in `direction`. */
rgb shadow_filter(struct worker *, const struct light *, const struct point *, vec3 direction,
	double distance, rgb colour);
/* The same, averaged over an area light. */
rgb area_light_filter(
	struct worker *, const struct light *, const struct point *, vec3 direction, rgb colour);
/* The axes of the light's grid seen from a point: square to the direction with `orient`. */
struct area_axes {
	vec3 u, v;
};
struct area_axes area_light_axes(const struct light *, vec3 to_centre);
/* Where the light of grid point (u, v) stands, with its own jitter. */
vec3 area_light_point(const struct light *, const struct area_axes *, int u, int v,
	struct sample_id, uint32_t vertex);

/* ---- secondary.c ---- */

/* Share of light reflected by a surface of relative index `eta`. */
double fresnel_reflectance(double eta, double cosine);
/* How much of each colour the layer reflects. */
rgb reflectivity(const struct point *, const struct coat *, float *weight);
/* Mirrors the ray at the bumpy normal, kept above the smooth surface. */
vec3 mirror_direction(vec3 v, vec3 normal, vec3 geometric);
/* The direction after refraction with index ratio eta; false: total internal reflection. */
bool refract_direction(vec3 v, vec3 normal, double eta, vec3 *out);
/* What distance z through an interior leaves of the light. */
rgb interior_fading(const struct interior *, double z);
/* The ray that goes on from the point. `path` may be the path of the point itself. */
void passage_follow(struct worker *, const struct point *, const struct passage *, struct path *);

/* ---- containment.c ---- */

const struct interior *object_interior(const struct object *);
/* Makes *c a copy to be changed on its own, while the original stays as it is. */
static inline void containment_borrow(struct containment *c, const struct containment *original)
{
	*c = *original;
	c->borrowed = true;
}
bool containment_has(const struct containment *, const struct interior *);
/* Removes the interior if it is there, appends it if not. */
void containment_toggle(struct containment *, const struct interior *, struct arena *);
/* Whether fog fills the space the ray is in. */
bool containment_is_hollow(const struct containment *);
/* Ratio of indices on crossing the surface of an interior. */
double containment_ratio(const struct containment *, const struct interior *);
/* Relative index for Fresnel's formula. */
double containment_fresnel_ratio(const struct containment *, const struct interior *);
/* All interiors around p. */
struct containment containment_at(const struct scene *, vec3 p, struct arena *);

/* ---- sky.c, fog.c ---- */

/* What is seen where nothing is. */
struct seen sky_seen(const struct scene *, vec3 direction, bool reflected);
/* What all fogs do to light over a stretch of a ray: factor, and colour added. */
void fog_effect(const struct scene *, ray, double length, rgb *factor, rgb *added);
/* Mean density of ground fog between two heights in units of fog_alt above fog_offset. */
double fog_mean_density(double s, double e);

#endif
