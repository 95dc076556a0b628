/* SPDX-License-Identifier: MIT */
/*
 * What a ray finds of an object: the shape's answer, carried between its own
 * space and the world, cut by the clips. The usual object has neither clips nor
 * bounds and costs one comparison on top of its shape.
 */
#include "geometry/object.h"
#include "geometry/shape.h"

#include <stdlib.h>
#include <string.h>

/* ---- lists of hits ---- */

void hits_init(struct hits *hits, struct hit *buffer, size_t room)
{
	*hits = (struct hits){ .items = buffer, .room = room, .borrowed = true };
}

static void hits_grow(struct hits *hits)
{
	const size_t room = hits->room < HITS_ROOM ? 2 * HITS_ROOM : 2 * hits->room;
	if (hits->borrowed) {
		struct hit *items = memory_alloc(room, sizeof *items);
		memcpy(items, hits->items, hits->count * sizeof *items);
		hits->items = items;
		hits->borrowed = false;
	} else {
		hits->items = memory_grow(hits->items, room, sizeof *hits->items);
	}
	hits->room = room;
}

struct hit *hits_push(struct hits *hits, double t)
{
	if (hits->count == hits->room)
		hits_grow(hits);
	struct hit *hit = &hits->items[hits->count++];
	*hit = (struct hit){ .t = t };
	return hit;
}

void hits_release(struct hits *hits)
{
	if (!hits->borrowed)
		free(hits->items);
	*hits = (struct hits){ 0 };
}

/* ---- clips and bounds ---- */

static bool inside_all(const struct object *const *objects, uint32_t count, vec3 p)
{
	for (uint32_t i = 0; i < count; i++) {
		if (!object_inside(objects[i], p))
			return false;
	}
	return true;
}

/* Whether the ray meets the object, or starts inside. */
static bool meets(const struct object *o, const ray *r)
{
	if (o->has_chord && !o->inverted) {
		struct chord c;
		return object_chord(o, r, &c) &&
		       (c.t[0] >= T_MIN || c.t[1] >= T_MIN || (c.t[0] < 0 && c.t[1] > 0));
	}
	struct hit hit;
	return object_nearest(o, r, T_MIN, T_MISS, &hit) || object_inside(o, r->origin);
}

static bool within_bounds(const struct object_extras *e, const ray *r)
{
	for (uint32_t i = 0; i < e->bound_count; i++) {
		if (!meets(e->bounds_by[i], r))
			return false;
	}
	return true;
}

/* Cuts off what no hit inside the clips can be in; false if that is everything. Only a first cut:
 * what is near the surface of a clip is left to inside_all. */
static bool narrow_to_clips(const struct object_extras *e, const ray *r, double *tmin, double *tmax)
{
	for (uint32_t i = 0; i < e->clip_count; i++) {
		const struct object *clip = e->clips[i];
		if (!clip->has_chord || clip->inverted)
			continue;
		struct chord c;
		if (!object_chord(clip, r, &c))
			return false;
		const double from = c.t[0] - CHORD_SLACK * (1 + fabs(c.t[0]));
		const double to = c.t[1] + CHORD_SLACK * (1 + fabs(c.t[1]));
		*tmin = from > *tmin ? from : *tmin;
		*tmax = to < *tmax ? to : *tmax;
	}
	return *tmin < *tmax;
}

/* ---- rays ---- */

static void keep_clipped(
	const struct object_extras *e, const ray *r, size_t first, struct hits *out)
{
	size_t kept = first;
	for (size_t i = first; i < out->count; i++) {
		if (inside_all(e->clips, e->clip_count, ray_at(*r, out->items[i].t)))
			out->items[kept++] = out->items[i];
	}
	out->count = kept;
}

static void shape_hits(
	const struct object *o, const ray *r, double tmin, double tmax, struct hits *out)
{
	const size_t first = out->count;
	if (o->place) {
		const ray local = transform_ray_back(o->place, *r);
		o->shape->hits(o->self, &local, tmin, tmax, out);
	} else {
		o->shape->hits(o->self, r, tmin, tmax, out);
	}
	if (o->shape->is_compound)
		return;
	for (size_t i = first; i < out->count; i++)
		out->items[i].object = o;
}

void object_hits(const struct object *o, const ray *r, double tmin, double tmax, struct hits *out)
{
	const struct object_extras *e = o->extras;
	if (!e) {
		shape_hits(o, r, tmin, tmax, out);
		return;
	}
	if (e->bound_count && !within_bounds(e, r))
		return;
	if (e->clip_count && !narrow_to_clips(e, r, &tmin, &tmax))
		return;
	const size_t first = out->count;
	shape_hits(o, r, tmin, tmax, out);
	if (e->clip_count)
		keep_clipped(e, r, first, out);
}

/* The nearest of all hits; the later of equal ones. `hits` excludes tmin itself, so the interval is
 * opened by one step. */
static bool nearest_of_hits(
	const struct object *o, const ray *r, double tmin, double tmax, struct hit *found)
{
	struct hit buffer[HITS_ROOM];
	struct hits hits;
	hits_init(&hits, buffer, HITS_ROOM);
	object_hits(o, r, double_before(tmin), tmax, &hits);
	const struct hit *best = NULL;
	for (size_t i = 0; i < hits.count; i++) {
		if (!best || hits.items[i].t <= best->t)
			best = &hits.items[i];
	}
	if (best)
		*found = *best;
	hits_release(&hits);
	return best != NULL;
}

/* The nearest hit of the shape itself. */
static inline bool nearest_on_shape(
	const struct object *o, const ray *r, double tmin, double tmax, struct hit *found)
{
	if (o->place) {
		const ray local = transform_ray_back(o->place, *r);
		if (!o->shape->nearest(o->self, &local, tmin, tmax, found))
			return false;
	} else if (!o->shape->nearest(o->self, r, tmin, tmax, found)) {
		return false;
	}
	if (!o->shape->is_compound)
		found->object = o;
	return true;
}

/* From the front, so that the first hit that survives ends the search. Hits at the same t are at
 * the same point, which a clip treats alike: any of them may be asked. */
static bool nearest_clipped(
	const struct object *o, const ray *r, double tmin, double tmax, struct hit *found)
{
	const struct object_extras *e = o->extras;
	if (e->bound_count && !within_bounds(e, r))
		return false;
	if (!narrow_to_clips(e, r, &tmin, &tmax))
		return false;
	struct hit hit;
	while (nearest_on_shape(o, r, tmin, tmax, &hit)) {
		if (inside_all(e->clips, e->clip_count, ray_at(*r, hit.t))) {
			*found = hit;
			return true;
		}
		tmin = double_after(hit.t);
	}
	return false;
}

bool object_nearest(
	const struct object *o, const ray *r, double tmin, double tmax, struct hit *found)
{
	if (!o->shape->nearest)
		return nearest_of_hits(o, r, tmin, tmax, found);
	if (o->extras && (o->extras->clip_count | o->extras->bound_count))
		return nearest_clipped(o, r, tmin, tmax, found);
	return nearest_on_shape(o, r, tmin, tmax, found);
}

/* ---- points ---- */

static bool inside_shape(const struct object *o, vec3 p)
{
	if (!o->shape->inside)
		return false;
	const vec3 local = o->place ? transform_point_back(o->place, p) : p;
	return o->shape->inside(o->self, local) != o->inverted;
}

bool object_inside(const struct object *o, vec3 p)
{
	return inside_shape(o, p) &&
	       (!o->extras || inside_all(o->extras->clips, o->extras->clip_count, p));
}

bool object_surrounds(const struct object *o, vec3 p)
{
	if (!inside_shape(o, p))
		return false;
	if (!o->extras || !o->extras->clip_count)
		return true;
	return !box_is_unbounded(o->shape->bounds(o->self)) || object_inside(o, p);
}

bool object_chord(const struct object *o, const ray *r, struct chord *chord)
{
	if (!o->place)
		return o->shape->chord(o->self, r, chord);
	const ray local = transform_ray_back(o->place, *r);
	return o->shape->chord(o->self, &local, chord);
}

bool object_is_solid(const struct object *o)
{
	if (o->shape != &shape_csg)
		return o->shape->inside != NULL;
	const struct csg *csg = o->self;
	const size_t count = csg->count + csg->unseen;
	for (size_t i = 0; i < count; i++) {
		if (object_is_solid(csg->children[i]))
			return true;
	}
	return count == 0;
}

vec3 object_normal(const struct hit *hit, vec3 p)
{
	const struct object *o = hit->object;
	vec3 n;
	if (o->place) {
		n = o->shape->normal(o->self, hit, transform_point_back(o->place, p));
		n = transform_normal(o->place, n);
	} else {
		n = o->shape->normal(o->self, hit, p);
	}
	n = vec_normalize(n);
	return o->inverted && !o->normal_stays ? vec_negate(n) : n;
}

void object_uv(const struct hit *hit, vec3 p, double uv[2])
{
	const struct object *o = hit->object;
	if (!o->shape->uv) {
		uv[0] = p.x;
		uv[1] = p.y;
		return;
	}
	const vec3 local = o->place ? transform_point_back(o->place, p) : p;
	const transform *uv_place = o->extras ? o->extras->uv_place : NULL;
	if (!uv_place || !o->shape->absorb) {
		o->shape->uv(o->self, hit, local, NULL, uv);
	} else if (!o->place) {
		o->shape->uv(o->self, hit, local, uv_place, uv);
	} else {
		const transform out_of_place = transform_invert(o->place);
		const transform absorbed = transform_compose(uv_place, &out_of_place);
		o->shape->uv(o->self, hit, local, &absorbed, uv);
	}
}
