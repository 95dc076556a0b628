/* SPDX-License-Identifier: MIT */
/*
 * How many rays per second the acceleration structure answers, for each
 * instruction set: a flake of 66430 spheres on a plane, 1024 x 1024 camera rays,
 * four reflections, three shadow rays at every hit; no shading. The sums show
 * that every instruction set sees the same picture.
 */
#include "base/arena.h"
#include "accel/accel.h"
#include "geometry/shape.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SIZE = 1024, LEVELS = 5, CHILDREN = 9 };

struct flake {
	struct arena *arena;
	struct object **objects;
	size_t count, room;
};

struct tally {
	uint64_t nearest, any, hits, blocked;
	double depth;
};

static double now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void add_object(struct flake *f, const char *word, vec3 v, double d)
{
	const struct shape_class *shape = shape_find(word);
	struct object *o = ARENA_NEW(f->arena, struct object);
	char *self = arena_alloc(f->arena, shape->size);
	memcpy(self + shape->fields[0].offset, &v, sizeof v);
	memcpy(self + shape->fields[1].offset, &d, sizeof d);
	if (shape->build) {
		struct shape_build build = { .arena = f->arena };
		shape->build(self, &build);
	}
	o->shape = shape;
	o->self = self;
	o->visible_to = RAY_ALL & ~(uint32_t)RAY_SHADOW_TINTED;
	o->rank = (uint32_t)f->count;
	object_set_bounds(o);
	if (f->count == f->room) {
		f->room = f->room ? 2 * f->room : 1024;
		f->objects = memory_grow(f->objects, f->room, sizeof(struct object *));
	}
	f->objects[f->count++] = o;
}

/* Any two unit vectors across `up`. */
static void across(vec3 up, vec3 *u, vec3 *v)
{
	*u = vec_normalize(vec_cross(fabs(up.x) < 0.6 ? vec(1, 0, 0) : vec(0, 1, 0), up));
	*v = vec_cross(up, *u);
}

/* Six spheres around the equator and three above it, each a third as large. */
static void grow(struct flake *f, vec3 centre, double radius, vec3 up, int levels)
{
	add_object(f, "sphere", centre, radius);
	if (levels == 0)
		return;
	vec3 u, v;
	across(up, &u, &v);
	for (int i = 0; i < CHILDREN; i++) {
		const double around = i < 6 ? i * M_PI / 3 : M_PI / 6 + (i - 6) * 2 * M_PI / 3;
		const double above = i < 6 ? 0 : 55 * M_PI / 180;
		vec3 d = vec_scale(u, cos(around) * cos(above));
		d = vec_mad(d, sin(around) * cos(above), v);
		d = vec_mad(d, sin(above), up);
		grow(f, vec_mad(centre, radius * 4 / 3, d), radius / 3, d, levels - 1);
	}
}

static void shadows(const struct accel *a, vec3 p, struct tally *t)
{
	static const vec3 lights[3] = { { 4, 3, 2 }, { 1, -4, 4 }, { -3, 1, 5 } };
	for (int i = 0; i < 3; i++) {
		const vec3 to = vec_sub(lights[i], p);
		const double distance = vec_length(to);
		const ray r = { p, vec_scale(to, 1 / distance) };
		t->any++;
		t->blocked += accel_any(a, &r, T_SHADOW, distance - T_SHADOW, RAY_SHADOW_OPAQUE);
	}
}

static void follow(const struct accel *a, ray r, struct tally *t)
{
	for (int level = 0; level < LEVELS; level++) {
		struct hit hit;
		t->nearest++;
		if (!accel_nearest(a, &r, T_MIN, T_MISS, level ? RAY_REFLECTED : RAY_CAMERA, &hit))
			return;
		t->hits++;
		t->depth += hit.t;
		const vec3 p = ray_at(r, hit.t), n = object_normal(&hit, p);
		shadows(a, p, t);
		r.origin = p;
		r.direction = vec_normalize(vec_mad(r.direction, -2 * vec_dot(r.direction, n), n));
	}
}

static struct tally picture(const struct accel *a)
{
	const vec3 eye = vec(2.1, 1.3, 1.7), ahead = vec_normalize(vec_negate(eye));
	const vec3 right = vec_normalize(vec_cross(ahead, vec(0, 0, 1)));
	const vec3 up = vec_cross(right, ahead);
	const double span = 2 * tan(M_PI / 8);
	struct tally t = { 0 };
	for (int y = 0; y < SIZE; y++) {
		for (int x = 0; x < SIZE; x++) {
			const double s = (x + 0.5) / SIZE - 0.5, q = 0.5 - (y + 0.5) / SIZE;
			vec3 d = vec_mad(ahead, s * span, right);
			d = vec_normalize(vec_mad(d, q * span, up));
			follow(a, (ray){ eye, d }, &t);
		}
	}
	return t;
}

int main(int argc, char **argv)
{
	static const char *const levels[] = { "plain", "baseline", "avx2", "avx512" };
	struct flake f = { .arena = arena_create(0) };
	add_object(&f, "plane", vec(0, 0, 1), -0.5);
	grow(&f, vec(0, 0, 0), 0.5, vec(0, 0, 1), 5);
	for (int i = argc > 1 ? 0 : 1; i < 4; i++) {
		if (argc > 1 && strcmp(argv[1], levels[i]) != 0)
			continue;
		setenv("LAMBERT_ISA", levels[i], 1);
		const double start = now();
		struct accel *a = accel_build(f.objects, f.count, 1);
		const double built = now();
		const struct tally t = picture(a);
		const double traced = now() - built;
		const struct accel_stats s = accel_statistics(a);
		printf("%-8s  build %.3f s (%zu objects, %zu nodes, depth %zu, %.1f MB)  "
		       "trace %.3f s  %.2f Mrays/s  (%llu nearest, %llu shadow, %llu hits, "
		       "%llu blocked, depth %.17g)\n",
			levels[i], built - start, s.objects, s.nodes, s.depth,
			(double)s.bytes / 1e6, traced, (double)(t.nearest + t.any) / traced / 1e6,
			(unsigned long long)t.nearest, (unsigned long long)t.any,
			(unsigned long long)t.hits, (unsigned long long)t.blocked, t.depth);
		accel_destroy(a);
	}
	free(f.objects);
	arena_destroy(f.arena);
	return 0;
}
