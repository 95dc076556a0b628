/* SPDX-License-Identifier: MIT */
/*
 * Building the acceleration structure: bounded objects go into the tree, the
 * others into a list, and the copy of the walk for this processor is chosen.
 */
#include "accel/accel.h"

#include "base/cpu.h"
#include "accel_trace.h"
#include "geometry/shape.h"

#include <stdlib.h>
#include <string.h>

static const struct accel_kernel *choose_kernel(void)
{
#if defined(__x86_64__)
	static const struct accel_kernel *const kernels[CPU_LEVELS] = { &accel_kernel_plain,
		&accel_kernel_baseline, &accel_kernel_avx2, &accel_kernel_avx512 };
	return kernels[cpu_level()];
#else
	return &accel_kernel_plain;
#endif
}

static int by_rank(const void *a, const void *b)
{
	const struct object *const *x = a, *const *y = b;
	return ((*x)->rank > (*y)->rank) - ((*x)->rank < (*y)->rank);
}

static bool is_bounded(const struct object *o)
{
	const box b = o->bounds;
	return !box_is_unbounded(b) &&
	       isfinite(b.lo.x + b.lo.y + b.lo.z + b.hi.x + b.hi.y + b.hi.z);
}

/* Solid all around, like an inverted sphere: any point outside the bounds tells. Clips make the
 * bounds smaller, but not what the object surrounds. */
static bool is_solid_outside(const struct object *o)
{
	if (o->extras && o->extras->clip_count)
		return true;
	const vec3 beyond = vec_sub(vec_scale(o->bounds.hi, 2), o->bounds.lo);
	return object_inside(o, vec_add(beyond, vec(1, 1, 1)));
}

/* A sphere around the object that is much tighter than its box. */
static bool enclosing_sphere(const struct object *o, vec3 *centre, double *radius)
{
	return !o->place && o->shape->enclosing_sphere &&
	       o->shape->enclosing_sphere(o->self, centre, radius);
}

static void set_group_lane(struct sphere_group *g, size_t lane, const struct object *o)
{
	vec3 c = vec(0, 0, 0);
	double radius = NAN;
	if (o && enclosing_sphere(o, &c, &radius)) {
		const double size = fabs(c.x) + fabs(c.y) + fabs(c.z);
		radius = (radius + size * GROUP_SLACK) * (1 + GROUP_SLACK);
	}
	g->x[lane] = (float)c.x;
	g->y[lane] = (float)c.y;
	g->z[lane] = (float)c.z;
	g->radius[lane] = (float)radius;
}

/* Lays the objects out in the order of the tree. */
static void fill_slots(struct accel *a, struct object *const *objects)
{
	struct bvh *tree = &a->tree;
	a->slots = ARENA_ARRAY(a->arena, tree->slot_count, const struct object *);
	bool has_groups = false;
	for (size_t i = 0; i < tree->slot_count; i++) {
		a->slots[i] = tree->slots[i] == BVH_NOTHING ? NULL : objects[tree->slots[i]];
		vec3 c;
		double r;
		has_groups |= a->slots[i] && enclosing_sphere(a->slots[i], &c, &r);
	}
	free(tree->slots);
	tree->slots = NULL;
	if (!has_groups)
		return;
	const size_t count = (tree->slot_count + BVH_WIDTH - 1) / BVH_WIDTH;
	struct sphere_group *groups = ARENA_ARRAY(a->arena, count, struct sphere_group);
	for (size_t i = 0; i < count * BVH_WIDTH; i++) {
		const struct object *o = i < tree->slot_count ? a->slots[i] : NULL;
		set_group_lane(&groups[i / BVH_WIDTH], i % BVH_WIDTH, o);
	}
	a->groups = groups;
}

static struct bvh_item item_of(const struct object *o, uint32_t number)
{
	vec3 centre;
	double radius;
	return bvh_item(o->bounds, number, enclosing_sphere(o, &centre, &radius));
}

/* Objects on their way into lists of the arena. */
struct sorting {
	struct bvh_item *bounded;
	const struct object **unbounded, **outside;
	size_t bounded_count;
};

static void sort_object(struct accel *a, struct sorting *s, const struct object *o, uint32_t number)
{
	a->kinds |= o->visible_to;
	if (box_is_empty(o->bounds))
		return; /* nothing of it can be hit */
	if (!is_bounded(o)) {
		s->unbounded[a->unbounded_count++] = o;
		return;
	}
	s->bounded[s->bounded_count++] = item_of(o, number);
	if (is_solid_outside(o))
		s->outside[a->outside_count++] = o;
}

static const struct object **kept(struct arena *arena, const struct object **list, size_t count)
{
	const struct object **copy = arena_copy(arena, list, count * sizeof *list);
	free(list);
	return copy;
}

/* The box that the inside of an object stays within, clips left aside. */
static box reach_of(const struct object *o)
{
	const box b = o->shape->bounds(o->self);
	if (o->inverted || o->shape->reaches_out || box_is_unbounded(b))
		return box_everything();
	return box_placed(b, o->place);
}

static const box *reaches(struct arena *arena, const struct object *const *objects, size_t count)
{
	box *boxes = ARENA_ARRAY(arena, count, box);
	for (size_t i = 0; i < count; i++)
		boxes[i] = reach_of(objects[i]);
	return boxes;
}

struct accel *accel_build(struct object *const *objects, size_t count, unsigned threads)
{
	struct arena *arena = arena_create(0);
	struct accel *a = ARENA_NEW(arena, struct accel);
	a->arena = arena;
	a->kernel = choose_kernel();
	a->object_count = count;
	struct sorting s = {
		.bounded = memory_alloc(count, sizeof *s.bounded),
		.unbounded = memory_alloc(count, sizeof *s.unbounded),
		.outside = memory_alloc(count, sizeof *s.outside),
	};
	for (size_t i = 0; i < count; i++)
		sort_object(a, &s, objects[i], (uint32_t)i);
	a->unbounded = kept(arena, s.unbounded, a->unbounded_count);
	a->outside = kept(arena, s.outside, a->outside_count);
	a->outside_reach = reaches(arena, a->outside, a->outside_count);
	qsort(a->unbounded, a->unbounded_count, sizeof *a->unbounded, by_rank);
	if (s.bounded_count)
		a->tree = bvh_build(arena, s.bounded, s.bounded_count, threads);
	free(s.bounded);
	a->has_tree = s.bounded_count != 0;
	fill_slots(a, objects);
	return a;
}

void accel_destroy(struct accel *a)
{
	if (a)
		arena_destroy(a->arena);
}

bool accel_nearest(const struct accel *a, const ray *r, double tmin, double tmax, uint32_t kinds,
	struct hit *found)
{
	return (a->kinds & kinds) && a->kernel->nearest(a, r, tmin, tmax, kinds, found);
}

bool accel_any(const struct accel *a, const ray *r, double tmin, double tmax, uint32_t kinds)
{
	return accel_blocker(a, r, tmin, tmax, kinds, NULL) != NULL;
}

const struct object *accel_blocker(const struct accel *a, const ray *r, double tmin, double tmax,
	uint32_t kinds, const struct object *guess)
{
	return a->kinds & kinds ? a->kernel->any(a, r, tmin, tmax, kinds, guess) : NULL;
}

/* Bounded objects that may contain p, by rank, each once. */
static size_t candidates(const struct accel *a, vec3 p, const struct object **out, size_t room)
{
	size_t count = a->kernel->around(a, p, out, room);
	for (size_t i = 0; i < a->outside_count; i++) {
		if (!box_has(&a->outside_reach[i], p))
			continue;
		if (count < room)
			out[count] = a->outside[i];
		count++;
	}
	if (count > room)
		return count;
	qsort(out, count, sizeof *out, by_rank);
	size_t kept = 0;
	for (size_t i = 0; i < count; i++) {
		if (kept == 0 || out[kept - 1] != out[i])
			out[kept++] = out[i];
	}
	return kept;
}

static size_t keep_containing(const struct object *const *objects, size_t count, vec3 p,
	const struct object **out, size_t room)
{
	size_t kept = 0;
	for (size_t i = 0; i < count && kept < room; i++) {
		if (object_surrounds(objects[i], p))
			out[kept++] = objects[i];
	}
	return kept;
}

size_t accel_containing(const struct accel *a, vec3 p, const struct object **found, size_t room)
{
	enum { USUAL = 128 };
	const struct object *few[USUAL], **near = few;
	size_t near_count = candidates(a, p, near, USUAL);
	if (near_count > USUAL) {
		near = memory_alloc(near_count, sizeof *near);
		near_count = candidates(a, p, near, near_count);
	}
	const size_t count = keep_containing(near, near_count, p, found, room);
	if (near != few)
		free(near);
	return count +
	       keep_containing(a->unbounded, a->unbounded_count, p, found + count, room - count);
}

struct accel_stats accel_statistics(const struct accel *a)
{
	return (struct accel_stats){
		.objects = a->object_count,
		.unbounded = a->unbounded_count,
		.nodes = a->tree.node_count,
		.depth = a->tree.depth,
		.bytes = arena_used(a->arena),
	};
}
