/* SPDX-License-Identifier: MIT */
/*
 * The renderer at the service of the parser; see hooks.h.
 */
#include "hooks.h"

#include "base/pointer_map.h"
#include "accel/accel.h"
#include "lower/draft.h"
#include "lower/lower_function.h"
#include "noise/noise.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Smallest distance that trace() reports. */
#define TRACE_MIN 1e-6

/* A declared object, ready to be asked. */
struct probe {
	struct object **objects;
	size_t count;
	struct accel *accel;
	box extent; /* as the language counts it */
};

struct hooks {
	struct scene *scene;
	const struct language_state *state;
	struct lower_options options;
	struct lowering lowering;
	struct pointer_map probes; /* by node */
};

static const struct language_state language_at_first = { .version = 370, .version_set = true };

struct hooks *hooks_create(
	struct diag *diag, const struct parse_options *files, struct scene *rendered)
{
	struct hooks *h = memory_alloc(1, sizeof *h);
	*h = (struct hooks){ .scene = scene_create(), .state = &language_at_first };
	h->options =
		(struct lower_options){ .width = 1, .height = 1, .quality = 9, .files = files };
	lowering_init(&h->lowering, &h->options, diag, h->scene);
	h->lowering.for_questions = true;
	if (rendered)
		h->lowering.rendered = rendered;
	lowering_settle(&h->lowering, h->state);
	return h;
}

void hooks_destroy(struct hooks *h)
{
	if (!h)
		return;
	for (size_t i = 0; i < h->probes.size; i++) {
		struct probe *p = h->probes.pairs[i].value;
		if (p) {
			accel_destroy(p->accel);
			free(p->objects);
		}
	}
	lowering_release(&h->lowering);
	pointer_map_release(&h->probes);
	scene_destroy(h->scene);
	free(h);
}

static void hook_state(void *user, const struct language_state *state)
{
	struct hooks *h = user;
	h->state = state;
}

/* What depends on the end of the text is settled for the text read so far. */
static void settle(struct hooks *h)
{
	lowering_settle(&h->lowering, h->state);
}

/* Functions compiled for another noise generator are forgotten. */
static struct lowering *lowering_now(struct hooks *h)
{
	const int before = h->scene->settings.noise_generator;
	settle(h);
	if (h->scene->settings.noise_generator != before) {
		pointer_map_release(&h->lowering.functions);
		h->lowering.functions = (struct pointer_map){ 0 };
	}
	return &h->lowering;
}

static struct probe *probe_create(struct hooks *h, const struct node *object)
{
	struct probe *p = ARENA_NEW(h->scene->arena, struct probe);
	const size_t first = h->scene->object_count;
	struct draft *d = draft_from_node(lowering_now(h), object);
	if (!d)
		return NULL;
	p->extent = d->extras->extent->box;
	draft_emit(&h->lowering, d, object->state);
	settle(h);
	lowering_forget(&h->lowering);
	p->count = h->scene->object_count - first;
	p->objects = memory_alloc(p->count, sizeof *p->objects);
	for (size_t i = 0; i < p->count; i++) {
		p->objects[i] = h->scene->objects[first + i];
		p->objects[i]->rank = (uint32_t)i;
		p->objects[i]->visible_to |= RAY_CAMERA;
	}
	return p;
}

static struct probe *probe_of(struct hooks *h, const struct node *object)
{
	struct probe *p = pointer_map_find(&h->probes, object);
	if (!p) {
		p = probe_create(h, object);
		if (p)
			pointer_map_add(&h->probes, object, p);
	}
	return p;
}

static vec3 to_vec(const double p[3])
{
	return vec(p[0], p[1], p[2]);
}

static void from_vec(vec3 v, double out[3])
{
	out[0] = v.x;
	out[1] = v.y;
	out[2] = v.z;
}

static bool hook_inside(void *user, const struct node *object, const double p[3], bool *answer)
{
	const struct probe *probe = probe_of(user, object);
	if (!probe)
		return false;
	for (size_t i = 0; i < probe->count; i++) {
		if (!object_is_solid(probe->objects[i])) {
			diag_error(((struct hooks *)user)->lowering.diag, object->span,
				"inside() needs a solid object: this one has no inside");
			*answer = false;
			return true;
		}
	}
	*answer = false;
	for (size_t i = 0; i < probe->count && !*answer; i++)
		*answer = object_inside(probe->objects[i], to_vec(p));
	return true;
}

static bool hook_trace(void *user, const struct node *object, const double origin[3],
	const double direction[3], double point[3], double normal[3], bool *found)
{
	struct probe *probe = probe_of(user, object);
	if (!probe)
		return false;
	if (!probe->accel)
		probe->accel = accel_build(probe->objects, probe->count, 1);
	const ray r = { to_vec(origin), vec_normalize(to_vec(direction)) };
	struct hit hit;
	*found = vec_length2(r.direction) > 0 &&
		 accel_nearest(probe->accel, &r, TRACE_MIN, T_MISS, RAY_ALL, &hit);
	const vec3 p = *found ? ray_at(r, hit.t) : vec(0, 0, 0);
	from_vec(p, point);
	from_vec(*found ? object_normal(&hit, p) : p, normal);
	return true;
}

/* The language keeps boxes as a corner and lengths, in single precision. */
static void float_box(double lo, double hi, double *out_lo, double *out_hi)
{
	const float corner = (float)lo, length = (float)(hi - lo);
	*out_lo = corner;
	*out_hi = corner + length;
}

static bool hook_extent(void *user, const struct node *object, double lo[3], double hi[3])
{
	const struct probe *probe = probe_of(user, object);
	if (!probe)
		return false;
	box b = probe->extent;
	if (box_is_unbounded(b) || box_is_empty(b))
		b = box_everything();
	float_box(b.lo.x, b.hi.x, &lo[0], &hi[0]);
	float_box(b.lo.y, b.hi.y, &lo[1], &hi[1]);
	float_box(b.lo.z, b.hi.z, &lo[2], &hi[2]);
	return true;
}

static bool hook_call(void *user, const struct function *f, const double *arguments,
	double result[5], unsigned *terms)
{
	struct hooks *h = user;
	const struct program *p = lower_function(lowering_now(h), f);
	settle(h);
	if (!p)
		return false;
	program_components(p, arguments, result);
	*terms = p->components;
	return true;
}

static bool hook_turbulence(
	void *user, double lambda, double omega, int octaves, const double p[3], double result[3])
{
	(void)user;
	from_vec(noise_turbulence(to_vec(p), octaves, omega, lambda), result);
	return true;
}

struct render_hooks hooks_table(struct hooks *h)
{
	return (struct render_hooks){
		.user = h,
		.state = hook_state,
		.inside = hook_inside,
		.trace = hook_trace,
		.extent = hook_extent,
		.call = hook_call,
		.turbulence = hook_turbulence,
	};
}
