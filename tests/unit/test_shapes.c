/* SPDX-License-Identifier: MIT */
/*
 * Geometry: what the answers of a shape owe each other, over random rays.
 */
#include "geometry/shape.h"
#include "geometry/glyph.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static double random_unit(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11) * 0x1p-53;
}

static vec3 random_vector(uint64_t *state, double reach)
{
	const double x = random_unit(state), y = random_unit(state), z = random_unit(state);
	return vec(reach * (2 * x - 1), reach * (2 * y - 1), reach * (2 * z - 1));
}

/* From somewhere around the origin towards the middle. */
static ray random_ray(uint64_t *state, double reach)
{
	const vec3 from = random_vector(state, reach), to = random_vector(state, 0.8);
	return (ray){ from, vec_normalize(vec_sub(to, from)) };
}

/* ---- samples ---- */

struct sample {
	const char *word;
	double values[18]; /* parameters in order */
	bool is_closed;	   /* crossings alternate */
	bool is_star;	   /* behind every surface point is the inside */
};

static const struct sample samples[] = {
	{ "sphere", { 0.1, -0.2, 0.3, 0.8 }, true, true },
	{ "box", { -0.5, 0.6, -0.7, 0.8, -0.4, 0.3 }, true, true },
	{ "cylinder", { -0.3, -0.5, 0.2, 0.4, 0.6, 0.1, 0.4 }, true, true },
	{ "cone", { -0.3, -0.5, 0.2, 0.5, 0.4, 0.6, 0.1, 0.2 }, true, true },
	{ "cone", { 0, -0.5, 0, 0.5, 0, 0.6, 0, 0 }, true, true },
	{ "cone", { 0, -0.5, 0, 0.5, 0, 0.6, 0, -0.4 }, true, true },
	{ "torus", { 0.6, 0.25 }, true, true },
	{ "torus", { 0.7, 0.01 }, true, true },
	{ "torus", { 0.3, 0.5 }, true, false },
	{ "plane", { 0.2, 1, -0.3, 0.1 }, true, true },
	{ "quadric", { 2, 1, 3, 0.3, -0.2, 0.1, 0.2, -0.1, 0.3, -0.9 }, true, true },
	{ "quadric", { 2, -1, 1, 0.3, -0.2, 0.1, 0.2, -0.1, 0.3, -0.4 }, true, true },
	{ "superellipsoid", { 0.25, 0.5 }, true, true },
	{ "superellipsoid", { 1, 1 }, true, true },
	{ "superellipsoid", { 0.05, 1.5 }, true, true },
	{ "superellipsoid", { 3, 2.5 }, true, true },
	{ "superellipsoid", { 0.5, 3 }, true, true },
	{ "disc", { 0.1, 0.1, 0, 0.3, 1, 0.2, 0.9, 0.2 }, false, true },
	{ "triangle", { -0.8, -0.5, 0, 0.9, -0.4, 0.2, 0.1, 0.8, -0.3 }, false, false },
	{ "smooth_triangle",
		{ -0.8, -0.5, 0, 0.1, 0.2, -1, 0.9, -0.4, 0.2, -0.2, 0, -1, 0.1, 0.8, -0.3, 0, 0.1,
			-1 },
		false, false },
	{ "quadric", { 2, 5, 0, 0, 0, 0, 0.2, -0.1, 0, -0.3 }, true, true },
	{ "quadric", { 2, 0, 3, 0, 0, 0, 0, 0.7, 0.1, -0.2 }, true, true },
	{ "ovus", { 0.5, 0.2 }, true, true },
	{ "ovus", { 0.4, 0.5 }, true, true },
	{ "ovus", { 0.4, 0.75 }, true, true },
};
#define SAMPLE_COUNT (sizeof samples / sizeof samples[0])

static void unexpected(void *user, const char *message)
{
	(void)user;
	fail_msg("%s", message);
}

static struct object *make(struct arena *arena, const struct sample *sample)
{
	const struct shape_class *shape = shape_find(sample->word);
	assert_non_null(shape);
	char *self = arena_alloc(arena, shape->size);
	const double *v = sample->values;
	for (const struct field *f = shape->fields; f->type != PARAMETER_END; f++) {
		if (f->type == PARAMETER_VECTOR) {
			*(vec3 *)(void *)(self + f->offset) = vec(v[0], v[1], v[2]);
			v += 3;
		} else if (f->type != PARAMETER_FLAG) {
			*(double *)(void *)(self + f->offset) = *v++;
		}
	}
	struct shape_build build = { .arena = arena, .error = unexpected, .warning = unexpected };
	if (shape->build)
		shape->build(self, &build);
	assert_false(build.dropped);
	struct object *o = ARENA_NEW(arena, struct object);
	o->shape = shape;
	o->self = self;
	object_set_bounds(o);
	return o;
}

static transform random_place(uint64_t *state, bool rigid)
{
	const vec3 factors =
		vec(0.5 + random_unit(state), 0.5 + random_unit(state), -0.5 - random_unit(state));
	const transform a = transform_rotate(random_vector(state, 180));
	const transform b = transform_scale(rigid ? vec(1.7, 1.7, 1.7) : factors);
	const transform c = transform_rotate(random_vector(state, 180));
	const transform d = transform_translate(random_vector(state, 0.3));
	const transform ab = transform_compose(&a, &b);
	const transform abc = transform_compose(&ab, &c);
	return transform_compose(&abc, &d);
}

/* Variant 0: as written; 1: placed rigidly; 2: placed and distorted. */
static void place(struct arena *arena, struct object *o, int variant, uint64_t *state)
{
	if (variant == 0)
		return;
	const transform t = random_place(state, variant == 1);
	o->place = arena_copy(arena, &t, sizeof t);
	object_set_bounds(o);
}

/* Points of hits are rounded: to within 1e-13 of the distances at hand, which are below 10. */
static bool box_holds(box b, vec3 p)
{
	const double slack = 1e-12;
	return p.x >= b.lo.x - slack && p.x <= b.hi.x + slack && p.y >= b.lo.y - slack &&
	       p.y <= b.hi.y + slack && p.z >= b.lo.z - slack && p.z <= b.hi.z + slack;
}

static void check_nearest(const struct object *o, const ray *r, double tmin, const struct hits *all)
{
	const struct hit *first = NULL;
	for (size_t i = 0; i < all->count; i++) {
		if (all->items[i].t >= tmin && (!first || all->items[i].t <= first->t))
			first = &all->items[i];
	}
	struct hit found = { .t = -7 };
	const bool any = object_nearest(o, r, tmin, 1e4, &found);
	assert_int_equal(any, first != NULL);
	if (!any) {
		assert_true(found.t == -7);
		return;
	}
	assert_true(fabs(found.t - first->t) <= 1e-13 * (1 + found.t));
	assert_ptr_equal(found.object, first->object);
	assert_true(o->shape->is_compound || found.object == o);
}

static void check_surface(
	const struct object *o, const ray *r, const struct hit *hit, const struct sample *sample)
{
	const vec3 p = ray_at(*r, hit->t), n = object_normal(hit, p);
	assert_true(box_holds(o->bounds, p));
	assert_true(fabs(vec_length(n) - 1) < 1e-12);
	if (!sample->is_star)
		return;
	const double step = 1e-7;
	assert_false(object_inside(o, vec_mad(p, step, n)));
	assert_true(object_inside(o, vec_mad(p, -step, n)));
}

static void hits_fit_together(void **unused)
{
	(void)unused;
	uint64_t state = 11;
	struct arena *arena = arena_create(0);
	for (size_t s = 0; s < SAMPLE_COUNT; s++) {
		for (int variant = 0; variant < 3; variant++) {
			struct object *o = make(arena, &samples[s]);
			place(arena, o, variant, &state);
			size_t seen = 0;
			for (int i = 0; i < 3000; i++) {
				const ray r = random_ray(&state, i % 2 ? 1 : 6);
				struct hits hits = { 0 };
				object_hits(o, &r, 0, 1e4, &hits);
				check_nearest(o, &r, 0, &hits);
				check_nearest(o, &r, 0.8, &hits);
				for (size_t k = 0; k < hits.count; k++)
					check_surface(o, &r, &hits.items[k], &samples[s]);
				if (samples[s].is_closed && samples[s].is_star) {
					const vec3 far = ray_at(r, 1e4);
					assert_int_equal(
						hits.count % 2, object_inside(o, r.origin) !=
									object_inside(o, far));
				}
				seen += hits.count;
				hits_release(&hits);
			}
			assert_true(seen > 50);
		}
	}
	arena_destroy(arena);
}

/* Away from edges, a small step along the surface stays on it to second order. */
static void normals_are_perpendicular(void **unused)
{
	(void)unused;
	uint64_t state = 12;
	struct arena *arena = arena_create(0);
	for (size_t s = 0; s < SAMPLE_COUNT; s++) {
		if (!samples[s].is_star)
			continue;
		struct object *o = make(arena, &samples[s]);
		place(arena, o, 2, &state);
		int good = 0, bad = 0;
		for (int i = 0; i < 3000; i++) {
			const ray r = random_ray(&state, 3);
			struct hit hit;
			if (!object_nearest(o, &r, 0, 1e4, &hit))
				continue;
			const vec3 p = ray_at(r, hit.t), n = object_normal(&hit, p);
			const vec3 along = vec_normalize(vec_cross(n, random_vector(&state, 1)));
			const vec3 q = vec_mad(p, 1e-6, along);
			const bool fits = !object_inside(o, vec_mad(q, 1e-8, n)) &&
					  object_inside(o, vec_mad(q, -1e-8, n));
			good += fits;
			bad += !fits;
		}
		assert_true(good > 30 && bad * 100 <= good);
	}
	arena_destroy(arena);
}

/* A shape that takes a transformation into itself answers as one that is placed. */
static void absorbing_is_placing(void **unused)
{
	(void)unused;
	uint64_t state = 13;
	struct arena *arena = arena_create(0);
	for (size_t s = 0; s < SAMPLE_COUNT; s++) {
		for (int variant = 0; variant < 3; variant++) {
			const transform move = variant == 2 ? transform_scale(vec(0.7, 1.3, 1.1))
							    : random_place(&state, variant == 0);
			struct object *placed = make(arena, &samples[s]);
			placed->place = arena_copy(arena, &move, sizeof move);
			struct object *moved = make(arena, &samples[s]);
			if (!moved->shape->absorb ||
				!moved->shape->absorb((void *)(uintptr_t)moved->self, &move))
				continue;
			object_set_bounds(moved);
			for (int i = 0; i < 1000; i++) {
				const ray r = random_ray(&state, 4);
				struct hit a = { 0 }, b = { 0 };
				const bool hit = object_nearest(placed, &r, 0, 1e4, &a);
				assert_int_equal(hit, object_nearest(moved, &r, 0, 1e4, &b));
				if (!hit)
					continue;
				assert_true(fabs(a.t - b.t) < 1e-11 * (1 + a.t));
				const vec3 p = ray_at(r, a.t);
				assert_true(box_holds(moved->bounds, p) || a.t > 100);
				const double cosine =
					vec_dot(object_normal(&a, p), object_normal(&b, p));
				/* triangles turn over when mirrored; smooth normals are weighted */
				if (!moved->shape->is_patch)
					assert_true(cosine > 1 - 1e-9);
				assert_int_equal(object_inside(placed, vec_scale(p, 0.9)),
					object_inside(moved, vec_scale(p, 0.9)));
			}
		}
	}
	arena_destroy(arena);
}

/* Shape and ray scaled, or the ray started far away: the same hits. */
static void scale_and_distance_change_nothing(void **unused)
{
	(void)unused;
	uint64_t state = 14;
	struct arena *arena = arena_create(0);
	for (size_t s = 0; s < SAMPLE_COUNT; s++) {
		if (strcmp(samples[s].word, "plane") == 0)
			continue; /* the language ends it at 1e7 */
		struct object *o = make(arena, &samples[s]);
		for (int power = -6; power <= 6; power++) {
			const double scale = pow(10, power);
			struct object *scaled = make(arena, &samples[s]);
			const transform t = transform_scale(vec(scale, scale, scale));
			if (power % 2 == 0 || !scaled->shape->absorb ||
				!scaled->shape->absorb((void *)(uintptr_t)scaled->self, &t))
				scaled->place = arena_copy(arena, &t, sizeof t);
			const double back = power > 0 ? scale : 0;
			for (int i = 0; i < 500; i++) {
				const ray r = random_ray(&state, 3);
				const ray big = { vec_scale(r.origin, scale), r.direction };
				const ray far = { vec_mad(r.origin, -back, r.direction),
					r.direction };
				struct hit a, b, c;
				const bool hit = object_nearest(o, &r, 0, 1e5, &a);
				assert_int_equal(hit, object_nearest(scaled, &big, 0, 1e11, &b));
				if (!hit)
					continue;
				assert_true(fabs(b.t / scale - a.t) < 1e-9 * (1 + a.t));
				assert_true(object_nearest(o, &far, back, 1e11, &c));
				assert_true(fabs(c.t - back - a.t) < 1e-6);
			}
		}
	}
	arena_destroy(arena);
}

/* ---- compounds ---- */

static struct object *combine(
	struct arena *arena, enum csg_kind kind, struct object **children, size_t count)
{
	struct csg *csg = ARENA_NEW(arena, struct csg);
	csg->kind = kind;
	csg->count = count;
	csg->children = arena_copy(arena, children, count * sizeof(struct object *));
	struct object *o = ARENA_NEW(arena, struct object);
	o->shape = &shape_csg;
	o->self = csg;
	object_set_bounds(o);
	return o;
}

static const struct object_extras *clipped_by(
	struct arena *arena, const struct object *const *clips, uint32_t count)
{
	struct object_extras *extras = ARENA_NEW(arena, struct object_extras);
	extras->clips = clips;
	extras->clip_count = count;
	return extras;
}

/* (sphere and not cylinder) merged with (box and torus), the box clipped by a plane. */
static struct object *nested(struct arena *arena)
{
	struct object *sphere = make(arena, &samples[0]), *cylinder = make(arena, &samples[2]);
	struct object *block = make(arena, &samples[1]), *torus = make(arena, &samples[6]);
	cylinder->inverted = true;
	const struct object *clip = make(arena, &samples[9]);
	block->extras = clipped_by(arena, arena_copy(arena, &clip, sizeof clip), 1);
	object_set_bounds(block);
	struct object *left =
		combine(arena, CSG_INTERSECTION, (struct object *[]){ sphere, cylinder }, 2);
	struct object *right =
		combine(arena, CSG_INTERSECTION, (struct object *[]){ block, torus }, 2);
	return combine(arena, CSG_MERGE, (struct object *[]){ left, right }, 2);
}

static void compounds_are_boolean(void **unused)
{
	(void)unused;
	uint64_t state = 15;
	struct arena *arena = arena_create(0);
	const struct object *sphere = make(arena, &samples[0]), *block = make(arena, &samples[1]);
	const struct object *cylinder = make(arena, &samples[2]), *torus = make(arena, &samples[6]);
	const struct object *plane = make(arena, &samples[9]);
	const struct object *o = nested(arena);
	size_t inside = 0;
	for (int i = 0; i < 20000; i++) {
		const vec3 p = random_vector(&state, 1);
		const bool left = object_inside(sphere, p) && !object_inside(cylinder, p);
		const bool right = object_inside(block, p) && object_inside(plane, p) &&
				   object_inside(torus, p);
		assert_int_equal(object_inside(o, p), left || right);
		inside += left || right;
	}
	assert_true(inside > 100);
	arena_destroy(arena);
}

static void compound_hits_bound_the_inside(void **unused)
{
	(void)unused;
	uint64_t state = 16;
	struct arena *arena = arena_create(0);
	const struct object *o = nested(arena);
	size_t seen = 0;
	for (int i = 0; i < 20000; i++) {
		const ray r = random_ray(&state, i % 2 ? 1 : 5);
		struct hits hits = { 0 };
		object_hits(o, &r, 0, 1e4, &hits);
		check_nearest(o, &r, 0, &hits);
		check_nearest(o, &r, 0.5, &hits);
		for (size_t k = 0; k < hits.count; k++)
			assert_true(box_holds(o->bounds, ray_at(r, hits.items[k].t)));
		seen += hits.count;
		hits_release(&hits);
	}
	assert_true(seen > 1000);
	arena_destroy(arena);
}

static void clips_cut(void **unused)
{
	(void)unused;
	uint64_t state = 17;
	struct arena *arena = arena_create(0);
	struct object *o = make(arena, &samples[0]);
	const struct object *clips[2] = { make(arena, &samples[9]), make(arena, &samples[1]) };
	o->extras = clipped_by(arena, clips, 2);
	object_set_bounds(o);
	for (int i = 0; i < 5000; i++) {
		const ray r = random_ray(&state, 3);
		struct hits hits = { 0 };
		object_hits(o, &r, 0, 1e4, &hits);
		check_nearest(o, &r, 0, &hits);
		for (size_t k = 0; k < hits.count; k++) {
			const vec3 p = ray_at(r, hits.items[k].t);
			assert_true(object_inside(clips[0], p) && object_inside(clips[1], p));
			assert_true(box_holds(o->bounds, p));
		}
		hits_release(&hits);
	}
	arena_destroy(arena);
}

/* The ends of a chord are the hits, and the inside is between them. */
static void chords_are_hits(void **unused)
{
	(void)unused;
	uint64_t state = 20;
	struct arena *arena = arena_create(0);
	size_t kinds = 0, seen = 0;
	for (size_t s = 0; s < SAMPLE_COUNT; s++) {
		struct object *o = make(arena, &samples[s]);
		kinds += o->has_chord;
		for (int variant = 0; o->has_chord && variant < 3; variant++) {
			place(arena, o, variant, &state);
			for (int i = 0; i < 3000; i++) {
				const ray r = random_ray(&state, i % 2 ? 1 : 6);
				const double far = 1e3, step = 1e-6;
				struct hits hits = { 0 };
				object_hits(o, &r, -far, far, &hits);
				struct chord c;
				size_t ends = 0;
				const bool met = object_chord(o, &r, &c);
				for (int k = 0; met && k < 2; k++) {
					if (!(fabs(c.t[k]) < far))
						continue;
					ends++;
					bool known = false;
					for (size_t j = 0; j < hits.count; j++)
						known |= fabs(hits.items[j].t - c.t[k]) < 1e-11 &&
							 hits.items[j].part == c.part[k];
					assert_true(known);
				}
				assert_int_equal(ends, hits.count);
				seen += ends;
				hits_release(&hits);
				const double t = 8 * random_unit(&state) - 4;
				const bool between = met && t > c.t[0] && t < c.t[1];
				if (!met || fmin(fabs(t - c.t[0]), fabs(t - c.t[1])) > step)
					assert_int_equal(between, object_inside(o, ray_at(r, t)));
			}
		}
	}
	assert_true(kinds >= 9 && seen > 10000);
	arena_destroy(arena);
}

static int by_distance(const void *a, const void *b)
{
	const struct hit *x = a, *y = b;
	if (x->t != y->t)
		return x->t > y->t ? 1 : -1;
	return (x->object > y->object) - (x->object < y->object);
}

/* What counts of an intersection or merge, by asking each point. */
static size_t hits_by_points(const struct csg *csg, const ray *r, struct hits *out)
{
	for (size_t i = 0; i < csg->count; i++) {
		struct hits own = { 0 };
		object_hits(csg->children[i], r, 0, 1e4, &own);
		for (size_t k = 0; k < own.count; k++) {
			const vec3 p = ray_at(*r, own.items[k].t);
			bool counts = true;
			for (size_t j = 0; j < csg->count; j++)
				counts &= j == i || object_inside(csg->children[j], p) ==
							    (csg->kind == CSG_INTERSECTION);
			if (counts)
				*hits_push(out, 0) = own.items[k];
		}
		hits_release(&own);
	}
	if (out->count)
		qsort(out->items, out->count, sizeof *out->items, by_distance);
	return out->count;
}

/* Of random children, some of them twice, so that surfaces coincide. */
static struct object *random_compound(struct arena *arena, uint64_t *state)
{
	struct object *children[6];
	const size_t count = 2 + (size_t)(random_unit(state) * 5);
	for (size_t i = 0; i < count; i++) {
		/* roots of higher polynomials are not found twice to the last bit */
		if (i > 0 && children[i - 1]->has_chord && random_unit(state) < 0.2) {
			children[i] = arena_copy(arena, children[i - 1], sizeof **children);
		} else {
			size_t s; /* a disc bounds less than its inside */
			do
				s = (size_t)(random_unit(state) * SAMPLE_COUNT);
			while (!samples[s].is_closed);
			children[i] = make(arena, &samples[s]);
			place(arena, children[i],
				!children[i]->has_chord || random_unit(state) < 0.5, state);
		}
		children[i]->inverted = random_unit(state) < 0.3;
	}
	return combine(
		arena, random_unit(state) < 0.3 ? CSG_MERGE : CSG_INTERSECTION, children, count);
}

static void compounds_go_by_points(void **unused)
{
	(void)unused;
	uint64_t state = 21;
	struct arena *arena = arena_create(0);
	size_t seen = 0;
	for (int round = 0; round < 500; round++) {
		const struct object *o = random_compound(arena, &state);
		for (int i = 0; i < 100; i++) {
			const ray r = random_ray(&state, i % 2 ? 1 : 5);
			struct hits wanted = { 0 }, found = { 0 };
			seen += hits_by_points(o->self, &r, &wanted);
			object_hits(o, &r, 0, 1e4, &found);
			assert_int_equal(found.count, wanted.count);
			check_nearest(o, &r, 0, &found);
			check_nearest(o, &r, 0.5, &found);
			if (found.count)
				qsort(found.items, found.count, sizeof *found.items, by_distance);
			for (size_t k = 0; k < found.count; k++) {
				assert_true(fabs(found.items[k].t - wanted.items[k].t) < 1e-11);
				assert_ptr_equal(found.items[k].object, wanted.items[k].object);
				if (found.items[k].t < 10)
					assert_true(
						box_holds(o->bounds, ray_at(r, found.items[k].t)));
			}
			hits_release(&wanted);
			hits_release(&found);
		}
	}
	assert_true(seen > 5000);
	arena_destroy(arena);
}

static struct object *make_plane(struct arena *arena, vec3 normal, double distance)
{
	const struct sample plane = { "plane", { normal.x, normal.y, normal.z, distance }, true,
		true };
	return make(arena, &plane);
}

/* A tube cut by tilted planes, and random polyhedra, which are cut out of a ball. */
static void unbounded_children_bound_compounds(void **unused)
{
	(void)unused;
	uint64_t state = 22;
	struct arena *arena = arena_create(0);
	for (int round = 0; round < 300; round++) {
		struct object *children[12];
		size_t count = 0;
		if (round % 2) {
			const struct sample tube = { "quadric", { 1, 0.5, 0, 0, 0, 0, 0, 0, 0, -1 },
				true, true };
			children[count] = make(arena, &tube);
			const transform turn = transform_rotate(random_vector(&state, 180));
			assert_true(children[count]->shape->absorb(
				(void *)(uintptr_t)children[count]->self, &turn));
			object_set_bounds(children[count++]);
			const vec3 along = transform_direction(&turn, vec(0, 0, 1));
			const vec3 tilt = random_vector(&state, 0.2);
			children[count++] = make_plane(arena, vec_add(along, tilt), 1);
			children[count++] = make_plane(arena, vec_sub(tilt, along), 1);
			struct object clipped = *children[0];
			clipped.extras =
				clipped_by(arena, (const struct object *const *)(children + 1), 2);
			object_set_bounds(&clipped);
			assert_false(box_is_unbounded(clipped.bounds));
		} else {
			vec3 sum = vec(0, 0, 0);
			for (; count < 4; count++) {
				vec3 n = vec_normalize(random_vector(&state, 1));
				if (count == 3)
					n = vec_negate(sum); /* positively spans the space */
				sum = vec_add(sum, n);
				children[count] = make_plane(arena, n, 0.5);
			}
		}
		struct object *o = combine(arena, CSG_INTERSECTION, children, count);
		const box b = o->bounds;
		if (!box_is_unbounded(b)) /* nearly flat tetrahedra may be called unbounded */
			assert_true(fmax(b.hi.x - b.lo.x, b.hi.y - b.lo.y) < 1e7);
		else
			assert_true(round % 2 == 0);
		for (int i = 0; i < 500; i++) {
			const vec3 p = random_vector(&state, i % 2 ? 2 : 8);
			if (object_inside(o, p))
				assert_true(box_holds(b, p));
		}
	}
	/* an octahedron, all of it */
	struct object *sides[8];
	for (int i = 0; i < 8; i++)
		sides[i] = make_plane(
			arena, vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), 1 / sqrt(3));
	const box b = combine(arena, CSG_INTERSECTION, sides, 8)->bounds;
	assert_true(fabs(b.hi.x - 1) < 1e-8 && fabs(b.lo.y + 1) < 1e-8 && fabs(b.hi.z - 1) < 1e-8);
	/* with one side missing it goes on for ever, but not everywhere */
	const box open = combine(arena, CSG_INTERSECTION, sides, 4)->bounds;
	assert_true(box_is_unbounded(open) && fabs(open.hi.z - BOX_UNBOUNDED) < 1);
	arena_destroy(arena);
}

static void last_child_wins_ties(void **unused)
{
	(void)unused;
	uint64_t state = 18;
	struct arena *arena = arena_create(0);
	struct object *twins[2] = { make(arena, &samples[0]), make(arena, &samples[0]) };
	const struct object *both = combine(arena, CSG_UNION, twins, 2);
	for (int i = 0; i < 500; i++) {
		const ray r = random_ray(&state, 3);
		struct hit hit;
		if (object_nearest(both, &r, 0, 1e4, &hit))
			assert_ptr_equal(hit.object, twins[1]);
	}
	arena_destroy(arena);
}

/* ---- single shapes ---- */

static void triangles_leave_no_cracks(void **unused)
{
	(void)unused;
	uint64_t state = 19;
	struct arena *arena = arena_create(0);
	for (int i = 0; i < 20000; i++) {
		const vec3 a = random_vector(&state, 1), b = random_vector(&state, 1);
		const vec3 c = random_vector(&state, 1), d = random_vector(&state, 1);
		const vec3 between = vec_mad(a, random_unit(&state), vec_sub(b, a));
		const vec3 from = random_vector(&state, 100);
		const ray r = { from, vec_normalize(vec_sub(between, from)) };
		/* the ray must pass the edge a b between c and d */
		const vec3 edge = vec_cross(r.direction, vec_sub(b, a));
		if (vec_dot(edge, vec_sub(c, a)) * vec_dot(edge, vec_sub(d, a)) >= 0)
			continue;
		const struct object *left = make(
			arena, &(struct sample){ .word = "triangle",
				       .values = { a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z } });
		const struct object *right = make(
			arena, &(struct sample){ .word = "triangle",
				       .values = { d.x, d.y, d.z, b.x, b.y, b.z, a.x, a.y, a.z } });
		struct hit hit;
		assert_true(object_nearest(left, &r, 0, 1e4, &hit) ||
			    object_nearest(right, &r, 0, 1e4, &hit));
		arena_reset(arena);
	}
	arena_destroy(arena);
}

/* The coefficient of x^i y^j z^k of the torus' equation. */
static double torus_coefficient(int i, int j, int k)
{
	const double major = 0.6, minor = 0.25;
	const double rest = major * major - minor * minor;
	const int powers[3] = { i, j, k };
	double c = i + j + k == 0 ? rest * rest : 0;
	for (int a = 0; a < 3; a++) {
		const double square = 2 * rest - (a == 1 ? 0 : 4 * major * major);
		c += powers[a] == 4 ? 1 : 0;
		c += powers[a] == 2 && i + j + k == 2 ? square : 0;
		c += powers[a] == 2 && powers[(a + 1) % 3] == 2 ? 2 : 0;
	}
	return c;
}

static void quartic_can_be_a_torus(void **unused)
{
	(void)unused;
	double c[35];
	int n = 0;
	for (int i = 4; i >= 0; i--) {
		for (int j = 4 - i; j >= 0; j--) {
			for (int k = 4 - i - j; k >= 0; k--)
				c[n++] = torus_coefficient(i, j, k);
		}
	}
	assert_int_equal(n, 35);
	struct arena *arena = arena_create(0);
	const struct shape_class *shape = shape_find("quartic");
	void *self = arena_alloc(arena, shape->size);
	*(struct field_array *)(void *)((char *)self + shape->fields[0].offset) =
		(struct field_array){ c, 35 };
	struct shape_build build = { .arena = arena, .error = unexpected, .warning = unexpected };
	shape->build(self, &build);
	struct object quartic = { .shape = shape, .self = self };
	object_set_bounds(&quartic);
	assert_true(box_is_unbounded(quartic.bounds));
	const struct object *torus = make(arena, &samples[6]);
	uint64_t state = 21;
	for (int i = 0; i < 5000; i++) {
		ray r = random_ray(&state, 3);
		const double back = i % 2 ? 0 : 1e5;
		r.origin = vec_mad(r.origin, -back, r.direction);
		struct hits hits = { 0 }, wanted = { 0 };
		object_hits(torus, &r, 0, 1e9, &wanted);
		object_hits(&quartic, &r, 0, 1e9, &hits);
		assert_int_equal(hits.count, wanted.count);
		for (size_t k = 0; k < hits.count; k++) {
			const vec3 p = ray_at(r, hits.items[k].t);
			assert_true(fabs(hits.items[k].t - wanted.items[k].t) < 1e-7 + 1e-9 * back);
			assert_true(vec_dot(object_normal(&hits.items[k], p),
					    object_normal(&wanted.items[k], p)) > 1 - 1e-8);
		}
		struct hit first;
		assert_int_equal(object_nearest(&quartic, &r, 0, 1e9, &first), hits.count > 0);
		assert_true(hits.count == 0 || first.t == hits.items[0].t);
		hits_release(&hits);
		hits_release(&wanted);
	}
	arena_destroy(arena);
}

static void box_edges_choose_a_face(void **unused)
{
	(void)unused;
	struct arena *arena = arena_create(0);
	const struct object *o =
		make(arena, &(struct sample){ .word = "box", .values = { -1, -1, -1, 1, 1, 1 } });
	const vec3 d = vec_normalize(vec(1, 2, 0.1));
	const ray steep = { vec_mad(vec(-1, -1, 0), -3, d), d };
	struct hit hit;
	assert_true(object_nearest(o, &steep, 0, 1e4, &hit));
	assert_true(object_normal(&hit, ray_at(steep, hit.t)).y == -1);
	const vec3 even = vec_normalize(vec(1, 1, 1));
	const ray corner = { vec(-3, -3, -3), even };
	assert_true(object_nearest(o, &corner, 0, 1e4, &hit));
	assert_true(object_normal(&hit, ray_at(corner, hit.t)).x == -1);
	/* in the plane of a face counts as inside the slab */
	const ray along = { vec(1, 0, -5), vec(0, 0, 1) };
	assert_true(object_nearest(o, &along, 0, 1e4, &hit) && hit.t == 4);
	arena_destroy(arena);
}

static void polygon_has_a_hole(void **unused)
{
	(void)unused;
	static const double points[][3] = { { 0, 0, 1 }, { 4, 0, 1 }, { 4, 4, 5 }, { 0, 4, 5 },
		{ 0, 0, 1 }, { 1, 1, 2 }, { 1, 3, 4 }, { 3, 3, 4 }, { 3, 1, 2 }, { 1, 1, 2 } };
	struct arena *arena = arena_create(0);
	const struct shape_class *shape = shape_find("polygon");
	void *self = arena_alloc(arena, shape->size);
	*(struct field_array *)(void *)((char *)self + shape->fields[1].offset) =
		(struct field_array){ points[0], 30 };
	struct shape_build build = { .arena = arena, .error = unexpected, .warning = unexpected };
	shape->build(self, &build);
	assert_false(build.dropped);
	struct object polygon = { .shape = shape, .self = self };
	object_set_bounds(&polygon);
	for (double x = -0.5; x < 5; x++) {
		for (double y = -0.5; y < 5; y++) {
			const ray r = { { x, y, -3 }, { 0, 0, 1 } };
			struct hit hit = { 0 };
			const bool in = x > 0 && x < 4 && y > 0 && y < 4 &&
					!(x > 1 && x < 3 && y > 1 && y < 3);
			assert_int_equal(object_nearest(&polygon, &r, 0, 1e4, &hit), in);
			assert_true(!in || fabs(hit.t - 4 - y) < 1e-14);
		}
	}
	const ray through = { { 0.5, 0.5, -3 }, { 0, 0, 1 } };
	struct hit hit;
	assert_true(object_nearest(&polygon, &through, 0, 1e4, &hit));
	assert_true(object_normal(&hit, vec(0, 0, 0)).z > 0);
	arena_destroy(arena);
}

static void letter_has_a_hole(void **unused)
{
	(void)unused;
	/* a round ring: two contours of four curves each */
	static const double axis[4] = { 1, 0, -1, 0 };
	struct glyph_segment segments[8];
	for (int i = 0; i < 8; i++) {
		const double r = i < 4 ? 1 : 0.5;
		const double c0 = axis[i % 4], s0 = axis[(i + 3) % 4];
		const double c1 = axis[(i + 1) % 4], s1 = axis[i % 4];
		segments[i] = (struct glyph_segment){ { r * c0, r * (c0 + c1), r * c1 },
			{ r * s0, r * (s0 + s1), r * s1 }, true };
	}
	struct glyph glyph = { .segments = segments, .count = 8, .thickness = 0.3 };
	glyph_finish(&glyph);
	struct object o = { .shape = &shape_glyph, .self = &glyph };
	object_set_bounds(&o);
	assert_true(object_inside(&o, vec(0.75, 0, 0.1)));
	assert_false(object_inside(&o, vec(0.1, 0, 0.1)));
	assert_false(object_inside(&o, vec(0.75, 0, 0.31)));
	uint64_t state = 20;
	for (int i = 0; i < 20000; i++) {
		const ray r = random_ray(&state, 2);
		struct hits hits = { 0 };
		object_hits(&o, &r, 0, 1e4, &hits);
		check_nearest(&o, &r, 0, &hits);
		assert_int_equal(hits.count % 2, object_inside(&o, r.origin));
		for (size_t k = 0; k < hits.count; k++)
			assert_true(box_holds(o.bounds, ray_at(r, hits.items[k].t)));
		hits_release(&hits);
	}
}

static void lists_outgrow_the_stack(void **unused)
{
	(void)unused;
	struct hit buffer[2];
	struct hits hits;
	hits_init(&hits, buffer, 2);
	for (int i = 0; i < 100; i++)
		hits_push(&hits, i);
	assert_int_equal(hits.count, 100);
	for (int i = 0; i < 100; i++)
		assert_true(hits.items[i].t == i);
	hits_release(&hits);
	assert_null(hits.items);
}

static enum parameter_type field_type(enum parameter_type parameter)
{
	return parameter == PARAMETER_OPTIONAL ? PARAMETER_FLOAT
	       : parameter == PARAMETER_PAIR   ? PARAMETER_VECTOR
					       : parameter;
}

/* Every class has a field for each parameter of its row, of its type. */
static void test_fields_match_rows(void **state)
{
	(void)state;
	size_t classes = 0;
	for (enum keyword k = K_NONE; k < KEYWORD_COUNT; k++) {
		const struct shape_class *shape = shape_find(keyword_name(k));
		if (!shape)
			continue;
		classes++;
		const struct field *f = shape->fields;
		for (const struct parameter *p = shape_word_of(k)->parameters;
			p->type != PARAMETER_END; p++)
			if (p->type != PARAMETER_ITEM)
				assert_int_equal(f++->type, field_type(p->type));
		assert_int_equal(f->type, PARAMETER_END);
	}
	assert_true(classes >= 15);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_fields_match_rows),
		cmocka_unit_test(hits_fit_together),
		cmocka_unit_test(normals_are_perpendicular),
		cmocka_unit_test(absorbing_is_placing),
		cmocka_unit_test(scale_and_distance_change_nothing),
		cmocka_unit_test(compounds_are_boolean),
		cmocka_unit_test(compound_hits_bound_the_inside),
		cmocka_unit_test(clips_cut),
		cmocka_unit_test(chords_are_hits),
		cmocka_unit_test(compounds_go_by_points),
		cmocka_unit_test(unbounded_children_bound_compounds),
		cmocka_unit_test(last_child_wins_ties),
		cmocka_unit_test(triangles_leave_no_cracks),
		cmocka_unit_test(quartic_can_be_a_torus),
		cmocka_unit_test(box_edges_choose_a_face),
		cmocka_unit_test(polygon_has_a_hole),
		cmocka_unit_test(letter_has_a_hole),
		cmocka_unit_test(lists_outgrow_the_stack),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
