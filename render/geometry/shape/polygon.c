/* SPDX-License-Identifier: MIT */
/*
 * polygon { count, points }
 *
 * A flat region inside closed outlines, even-odd. An outline ends where its first
 * point is repeated. The point where the ray meets the plane is compared with
 * the edges in the two coordinates in which the polygon is seen best.
 */
#include "geometry/shape.h"

struct edge {
	double x[2], y[2];
};

struct polygon {
	double count; /* as written */
	struct field_array points;
	/* built: */
	vec3 normal;
	double distance;
	box bounds;
	const struct edge *edges;
	size_t edge_count;
	int across, up; /* the coordinates of the edges: 0 x, 1 y, 2 z */
};

/* Points this close are the same point; points further from the plane are not on it. */
#define SAME 1e-10
#define FLAT 1e-10

static const struct field polygon_fields[] = { FIELD(polygon, count), FIELD(polygon, points),
	FIELD_END };

static vec3 point_at(const struct polygon *pg, size_t i)
{
	const double *v = &pg->points.values[3 * i];
	return vec(v[0], v[1], v[2]);
}

static double coordinate(vec3 p, int axis)
{
	return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/* From the first two edges at the first point that span a plane; zero when there are none. */
static vec3 plane_normal(const struct polygon *pg, size_t count)
{
	const vec3 start = point_at(pg, 0);
	vec3 u = vec(0, 0, 0);
	for (size_t i = 1; i < count; i++) {
		const vec3 v = vec_sub(point_at(pg, i), start);
		const vec3 n = vec_cross(u, v);
		if (vec_length2(u) == 0)
			u = v;
		else if (vec_length2(n) > 1e-20 * vec_length2(u) * vec_length2(v))
			return vec_normalize(n);
	}
	return vec(0, 0, 0);
}

static bool same_point(vec3 a, vec3 b)
{
	return fabs(a.x - b.x) < SAME && fabs(a.y - b.y) < SAME && fabs(a.z - b.z) < SAME;
}

static void add_edge(struct polygon *pg, struct edge *edges, vec3 a, vec3 b)
{
	edges[pg->edge_count++] = (struct edge){
		{ coordinate(a, pg->across), coordinate(b, pg->across) },
		{ coordinate(a, pg->up), coordinate(b, pg->up) },
	};
}

/* Outlines are closed exactly on their first point. */
static void build_edges(struct polygon *pg, size_t count, struct shape_build *build)
{
	struct edge *edges = ARENA_ARRAY(build->arena, count + 1, struct edge);
	size_t first = 0;
	for (size_t i = 1; i < count; i++) {
		const vec3 start = point_at(pg, first), p = point_at(pg, i);
		const bool closes = same_point(start, p);
		add_edge(pg, edges, point_at(pg, i - 1), closes ? start : p);
		if (closes)
			first = ++i;
	}
	if (first < count) {
		build->warning(build->user, "polygon is not closed; its last point is joined to "
					    "the first");
		add_edge(pg, edges, point_at(pg, count - 1), point_at(pg, first));
	}
	pg->edges = edges;
}

static void polygon_build(void *self, struct shape_build *build)
{
	struct polygon *pg = self;
	const size_t count = pg->points.count / 3;
	if (count < 3) {
		build->error(build->user, "a polygon needs at least three points");
		return;
	}
	pg->normal = plane_normal(pg, count);
	pg->distance = vec_dot(pg->normal, point_at(pg, 0));
	pg->bounds = box_nothing();
	for (size_t i = 0; i < count; i++) {
		const vec3 p = point_at(pg, i);
		pg->bounds = box_add_point(pg->bounds, p);
		build->dropped |= fabs(vec_dot(pg->normal, p) - pg->distance) >
				  FLAT * fmax(1, fabs(pg->distance));
	}
	build->dropped |= vec_length2(pg->normal) == 0;
	if (build->dropped) {
		build->warning(build->user, "polygon is left out: its points lie on a line, or "
					    "not in one plane");
		return;
	}
	const vec3 n = vec(fabs(pg->normal.x), fabs(pg->normal.y), fabs(pg->normal.z));
	const int away = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
	pg->across = (away + 1) % 3;
	pg->up = (away + 2) % 3;
	build_edges(pg, count, build);
	pg->points = (struct field_array){ 0 };
}

static box polygon_bounds(const void *self)
{
	const struct polygon *pg = self;
	return pg->bounds;
}

/* Where an edge begins. */
static vec3 edge_start(const struct polygon *pg, const struct edge *e)
{
	const double n[3] = { pg->normal.x, pg->normal.y, pg->normal.z };
	const int across = pg->across, up = pg->up, away = 3 - across - up;
	double p[3];
	p[across] = e->x[0];
	p[up] = e->y[0];
	p[away] = (pg->distance - n[across] * p[across] - n[up] * p[up]) / n[away];
	return vec(p[0], p[1], p[2]);
}

/* Of its points; where that has no thickness it is given some. */
static box polygon_extent(const void *self, const transform *place)
{
	const struct polygon *pg = self;
	const double thin = 1e-3;
	box b = box_nothing();
	for (size_t i = 0; i < pg->edge_count; i++) {
		const vec3 p = edge_start(pg, &pg->edges[i]);
		b = box_add_point(b, place ? transform_point(place, p) : p);
	}
	const vec3 size = vec_sub(b.hi, b.lo);
	const vec3 more =
		vec(size.x < thin ? thin : 0, size.y < thin ? thin : 0, size.z < thin ? thin : 0);
	return (box){ vec_sub(b.lo, more), vec_add(b.hi, more) };
}

/* Even-odd, by the edges to one side; the half-open comparison counts a shared point once. */
static bool in_outline(const struct polygon *pg, double x, double y)
{
	bool inside = false;
	for (size_t i = 0; i < pg->edge_count; i++) {
		const struct edge *e = &pg->edges[i];
		if ((e->y[0] >= y) == (e->y[1] >= y))
			continue;
		const double side = (e->x[0] - x) * (e->y[1] - y) - (e->x[1] - x) * (e->y[0] - y);
		inside ^= (side >= 0) == (e->y[1] >= y);
	}
	return inside;
}

static bool polygon_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	const struct polygon *pg = self;
	const double t =
		(pg->distance - vec_dot(pg->normal, r->origin)) / vec_dot(pg->normal, r->direction);
	if (!(t >= tmin && t < tmax))
		return false;
	const vec3 p = ray_at(*r, t);
	if (!in_outline(pg, coordinate(p, pg->across), coordinate(p, pg->up)))
		return false;
	found->t = t;
	return true;
}

static void polygon_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct hit found;
	if (polygon_nearest(self, r, tmin, tmax, &found) && found.t > tmin)
		hits_push(out, found.t);
}

static bool polygon_inside(const void *self, vec3 p)
{
	(void)self;
	(void)p;
	return false;
}

static vec3 polygon_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct polygon *pg = self;
	(void)hit;
	(void)p;
	return pg->normal;
}

const struct shape_class shape_polygon = {
	.name = "polygon",
	.size = sizeof(struct polygon),
	.fields = polygon_fields,
	.build = polygon_build,
	.bounds = polygon_bounds,
	.extent = polygon_extent,
	.nearest = polygon_nearest,
	.hits = polygon_hits,
	.inside = polygon_inside,
	.normal = polygon_normal,
};
