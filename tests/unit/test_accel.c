/* SPDX-License-Identifier: MIT */
/*
 * The tree against asking every object: random scenes of spheres, boxes, tori
 * and planes, some of them coincident, for every instruction set this processor
 * has. These must agree bit by bit.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/arena.h"
#include "accel/accel.h"
#include "geometry/shape.h"

#include <stdlib.h>
#include <string.h>

static const char *const levels[] = { "plain", "baseline", "avx2", "avx512" };
enum { LEVELS = sizeof levels / sizeof levels[0] };

struct fixture {
	struct arena *arena;
	struct object **objects;
	size_t count;
	uint64_t seed;
};

/* In [0, 1); a linear congruential generator is random enough here. */
static double uniform(struct fixture *f)
{
	f->seed = f->seed * 6364136223846793005u + 1442695040888963407u;
	return (double)(f->seed >> 11) * 0x1p-53;
}

static double between(struct fixture *f, double lo, double hi)
{
	return lo + (hi - lo) * uniform(f);
}

static vec3 point_within(struct fixture *f, double reach)
{
	const double x = between(f, -reach, reach), y = between(f, -reach, reach);
	return vec(x, y, between(f, -reach, reach));
}

static void add_object(struct fixture *f, const char *word, const void *arguments, size_t size,
	const transform *place)
{
	const struct shape_class *shape = shape_find(word);
	struct object *o = ARENA_NEW(f->arena, struct object);
	char *self = arena_alloc(f->arena, shape->size);
	memcpy(self + shape->fields[0].offset, arguments, size);
	if (shape->build) {
		struct shape_build build = { .arena = f->arena };
		shape->build(self, &build);
	}
	o->shape = shape;
	o->self = self;
	o->place = place ? arena_copy(f->arena, place, sizeof *place) : NULL;
	o->visible_to = RAY_ALL;
	object_set_bounds(o);
	/* ranks that do not follow the order of the array */
	o->rank = (uint32_t)(f->count * 7919 % 10007);
	f->objects[f->count++] = o;
}

static void add_sphere(struct fixture *f, vec3 centre, double radius)
{
	const struct {
		vec3 centre;
		double radius;
	} s = { centre, radius };
	add_object(f, "sphere", &s, sizeof s, NULL);
}

static void add_box(struct fixture *f, vec3 corner, vec3 size)
{
	const vec3 corners[2] = { corner, vec_add(corner, size) };
	add_object(f, "box", corners, sizeof corners, NULL);
}

static void add_torus(struct fixture *f, vec3 centre, double size)
{
	const double radii[2] = { size, size / 3 };
	const transform turn = transform_rotate(point_within(f, 180));
	const transform move = transform_translate(centre);
	const transform place = transform_compose(&turn, &move);
	add_object(f, "torus", radii, sizeof radii, &place);
}

static void add_plane(struct fixture *f, vec3 normal, double distance)
{
	const struct {
		vec3 normal;
		double distance;
	} p = { normal, distance };
	add_object(f, "plane", &p, sizeof p, NULL);
}

static void fixture_init(struct fixture *f, size_t room, uint64_t seed)
{
	*f = (struct fixture){ .arena = arena_create(0), .seed = seed };
	f->objects = memory_alloc(room, sizeof(struct object *));
}

static void fixture_finish(struct fixture *f)
{
	free(f->objects);
	arena_destroy(f->arena);
}

/* `count` objects within `reach` of `centre`. */
static void fill(struct fixture *f, size_t count, vec3 centre, double reach)
{
	const double size = reach * 1.5 / cbrt((double)count);
	while (f->count < count) {
		const vec3 p = vec_add(centre, point_within(f, reach));
		const double s = between(f, 0.1, 1) * size;
		switch ((int)(uniform(f) * 8)) {
		case 0:
			add_box(f, p, vec(s, 2 * s, s / 2));
			break;
		case 1:
			add_torus(f, p, s);
			break;
		case 2: /* coincident */
			add_sphere(f, p, s);
			add_sphere(f, p, s);
			add_sphere(f, p, s);
			break;
		case 3: /* with faces in common, on round numbers */
			add_box(f, vec(floor(p.x), floor(p.y), floor(p.z)), vec(1, 1, 1));
			break;
		default:
			add_sphere(f, p, s);
		}
	}
	add_plane(f, vec(0, 1, 0), centre.y - reach);
}

/* Rays of all kinds: from anywhere, along axes, from round numbers, from very far. */
static ray random_ray(struct fixture *f, vec3 centre, double reach)
{
	ray r = { vec_add(centre, point_within(f, 2 * reach)), vec_normalize(point_within(f, 1)) };
	const int kind = (int)(uniform(f) * 8);
	if (kind == 1 || kind == 2) {
		const double sign = uniform(f) < 0.5 ? -1 : 1;
		const int axis = (int)(uniform(f) * 3);
		r.direction = vec(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
	}
	if (kind == 2)
		r.origin = vec(floor(r.origin.x), floor(r.origin.y), floor(r.origin.z));
	if (kind == 3) {
		const vec3 aim = vec_add(centre, point_within(f, reach));
		r.origin = vec_mad(aim, -1e4 * reach, r.direction);
	}
	return r;
}

static bool brute_nearest(const struct fixture *f, const ray *r, double tmin, double tmax,
	uint32_t kinds, struct hit *found)
{
	const struct object *winner = NULL;
	for (size_t i = 0; i < f->count; i++) {
		const struct object *o = f->objects[i];
		struct hit hit;
		if (!(o->visible_to & kinds) || !object_nearest(o, r, tmin, tmax, &hit))
			continue;
		if (!winner || hit.t < found->t || (hit.t == found->t && o->rank < winner->rank)) {
			*found = hit;
			winner = o;
		}
	}
	return winner != NULL;
}

static bool brute_any(
	const struct fixture *f, const ray *r, double tmin, double tmax, uint32_t kinds)
{
	for (size_t i = 0; i < f->count; i++) {
		const struct object *o = f->objects[i];
		struct hit hit;
		if ((o->visible_to & kinds) &&
			object_nearest(o, r, nextafter(tmin, INFINITY), tmax, &hit))
			return true;
	}
	return false;
}

/* A torus isolates its roots in the interval it is asked about, which moves them by a unit in the
 * last place; other answers are exact. */
static bool same_answer(const struct hit *a, const struct hit *b)
{
	const bool exact = strcmp(a->object->shape->name, "torus") != 0;
	return a->object == b->object && fabs(a->t - b->t) <= (exact ? 0 : 1e-14 * b->t);
}

/* Returns how many rays hit something. */
static size_t compare(struct fixture *f, vec3 centre, double reach, size_t rays, uint32_t kinds)
{
	struct accel *accels[LEVELS];
	for (int i = 0; i < LEVELS; i++) {
		setenv("LAMBERT_ISA", levels[i], 1);
		accels[i] = accel_build(f->objects, f->count, 1 + (unsigned)i % 2);
	}
	size_t hits = 0;
	for (size_t k = 0; k < rays; k++) {
		const ray r = random_ray(f, centre, reach);
		struct hit expected = { 0 }, found[LEVELS];
		const bool hit = brute_nearest(f, &r, T_MIN, T_MISS, kinds, &expected);
		/* also just short of the hit, and starting there */
		const double at = hit ? expected.t : 1;
		const double ranges[4][2] = { { T_MIN, T_MISS }, { T_MIN, at },
			{ T_MIN, nextafter(at, INFINITY) }, { at, T_MISS } };
		hits += hit;
		for (int i = 0; i < LEVELS; i++) {
			assert_int_equal(
				hit, accel_nearest(accels[i], &r, T_MIN, T_MISS, kinds, &found[i]));
			assert_true(!hit || same_answer(&found[i], &expected));
			assert_true(!hit || found[i].t == found[0].t);
		}
		for (int j = 0; j < 4; j++) {
			const double tmin = ranges[j][0], tmax = ranges[j][1];
			const bool any = brute_any(f, &r, tmin, tmax, kinds);
			for (int i = 0; i < LEVELS; i++)
				assert_int_equal(any, accel_any(accels[i], &r, tmin, tmax, kinds));
		}
	}
	for (int i = 0; i < LEVELS; i++)
		accel_destroy(accels[i]);
	return hits;
}

static void same_as_brute_force(void **state)
{
	(void)state;
	static const size_t counts[] = { 1, 2, 3, 9, 50, 600 };
	for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
		struct fixture f;
		fixture_init(&f, counts[i] + 8, 1 + i);
		fill(&f, counts[i], vec(0, 0, 0), 10);
		assert_true(compare(&f, vec(0, 0, 0), 10, 2000, RAY_CAMERA) > 200);
		fixture_finish(&f);
	}
}

/* Where single precision resolves less than the size of the objects. */
static void far_from_the_origin(void **state)
{
	(void)state;
	struct fixture f;
	const vec3 centre = vec(3e6, -7e6, 1e6);
	fixture_init(&f, 308, 77);
	fill(&f, 300, centre, 5);
	assert_true(compare(&f, centre, 5, 2000, RAY_CAMERA) > 200);
	fixture_finish(&f);
}

static void only_visible_objects(void **state)
{
	(void)state;
	struct fixture f;
	fixture_init(&f, 208, 5);
	fill(&f, 200, vec(0, 0, 0), 10);
	for (size_t i = 0; i < f.count; i++)
		f.objects[i]->visible_to = i % 3 ? RAY_CAMERA : RAY_REFLECTED | RAY_SHADOW_TINTED;
	assert_true(compare(&f, vec(0, 0, 0), 10, 500, RAY_CAMERA) > 50);
	assert_true(compare(&f, vec(0, 0, 0), 10, 500, RAY_REFLECTED) > 50);
	assert_int_equal(compare(&f, vec(0, 0, 0), 10, 100, RAY_SHADOW_OPAQUE), 0);
	fixture_finish(&f);
}

/* Many boxes with one centre leave nothing to split by. */
static void coincident_objects(void **state)
{
	(void)state;
	struct fixture f;
	fixture_init(&f, 3000, 9);
	for (int i = 0; i < 1500; i++)
		add_sphere(&f, vec(1, 2, 3), 1);
	for (int i = 0; i < 1000; i++)
		add_box(&f, vec(0.5, 1.5, 2.5), vec(1, 1, 1));
	assert_true(compare(&f, vec(1, 2, 3), 1, 30, RAY_CAMERA) > 5);
	fixture_finish(&f);
}

static void same_tree_for_any_thread_count(void **state)
{
	(void)state;
	struct fixture f;
	fixture_init(&f, 30000, 11);
	fill(&f, 20000, vec(0, 0, 0), 10);
	struct accel *one = accel_build(f.objects, f.count, 1);
	struct accel *four = accel_build(f.objects, f.count, 4);
	const struct accel_stats a = accel_statistics(one), b = accel_statistics(four);
	assert_int_equal(a.nodes, b.nodes);
	assert_int_equal(a.depth, b.depth);
	assert_int_equal(a.bytes, b.bytes);
	assert_int_equal(a.unbounded, 1);
	for (int i = 0; i < 2000; i++) {
		const ray r = random_ray(&f, vec(0, 0, 0), 10);
		struct hit x, y;
		const bool hit = accel_nearest(one, &r, T_MIN, T_MISS, RAY_CAMERA, &x);
		assert_int_equal(hit, accel_nearest(four, &r, T_MIN, T_MISS, RAY_CAMERA, &y));
		assert_true(!hit || (x.t == y.t && x.object == y.object));
	}
	accel_destroy(one);
	accel_destroy(four);
	fixture_finish(&f);
}

static void what_contains_a_point(void **state)
{
	(void)state;
	struct fixture f;
	fixture_init(&f, 508, 13);
	fill(&f, 500, vec(0, 0, 0), 4);
	for (size_t i = 0; i < f.count; i++) {
		f.objects[i]->rank = (uint32_t)i;
		f.objects[i]->inverted = i % 50 == 7; /* contains nearly everything */
	}
	struct accel *accel = accel_build(f.objects, f.count, 1);
	for (int k = 0; k < 1000; k++) {
		const vec3 p = point_within(&f, 8);
		const struct object *found[600];
		const size_t count = accel_containing(accel, p, found, 600);
		size_t expected = 0;
		for (size_t i = 0; i < f.count; i++) {
			if (object_inside(f.objects[i], p)) {
				assert_true(expected < count);
				assert_ptr_equal(found[expected], f.objects[i]);
				expected++;
			}
		}
		assert_int_equal(count, expected);
		assert_int_equal(accel_containing(accel, p, found, 2), expected < 2 ? expected : 2);
	}
	accel_destroy(accel);
	fixture_finish(&f);
}

static void an_empty_scene(void **state)
{
	(void)state;
	struct accel *accel = accel_build(NULL, 0, 2);
	const ray r = { { 0, 0, 0 }, { 0, 0, 1 } };
	struct hit hit;
	const struct object *found[1];
	assert_false(accel_nearest(accel, &r, T_MIN, T_MISS, RAY_ALL, &hit));
	assert_false(accel_any(accel, &r, T_MIN, T_MISS, RAY_ALL));
	assert_int_equal(accel_containing(accel, r.origin, found, 1), 0);
	accel_destroy(accel);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(same_as_brute_force),
		cmocka_unit_test(far_from_the_origin),
		cmocka_unit_test(only_visible_objects),
		cmocka_unit_test(coincident_objects),
		cmocka_unit_test(same_tree_for_any_thread_count),
		cmocka_unit_test(what_contains_a_point),
		cmocka_unit_test(an_empty_scene),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
