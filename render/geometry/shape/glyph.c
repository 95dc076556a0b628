/* SPDX-License-Identifier: MIT */
/*
 * A letter, see the header.
 *
 * Where the ray passes a wall, and whether a point is inside the outline, are
 * the same question in the plane: where does a straight line cross the
 * segments? It is answered from the side of the line each outline point lies on.
 * Neighbouring segments share the answer for their common point, so crossings
 * are never counted twice or lost between them.
 */
#include "geometry/glyph.h"

enum glyph_part { PART_FRONT, PART_BACK, PART_WALL /* + the segment */ };

void glyph_finish(struct glyph *g)
{
	box b = box_nothing();
	for (size_t i = 0; i < g->count; i++) {
		for (int k = 0; k < 3; k++)
			b = box_add_point(b, vec(g->segments[i].x[k], g->segments[i].y[k], 0));
	}
	b.lo.z = fmin(0, g->thickness);
	b.hi.z = fmax(0, g->thickness);
	g->outline = b;
}

/* The zeros in [0, 1] of the function that runs from e[0] to e[2] along a segment: linearly, or as
 * the quadratic with the Bernstein coefficients e. Zero counts as positive. */
static int segment_zeros(bool is_curve, const double e[3], double u[2])
{
	const bool ends_differ = (e[0] >= 0) != (e[2] >= 0);
	if (!is_curve) {
		u[0] = e[0] / (e[0] - e[2]);
		return ends_differ;
	}
	if (!ends_differ && (e[1] >= 0) == (e[0] >= 0))
		return 0;
	const double a = e[0] - 2 * e[1] + e[2], b = e[1] - e[0], c = e[0];
	const double discriminant = b * b - a * c;
	if (!ends_differ && !(discriminant > 0))
		return 0;
	const double q = -(b + copysign(sqrt(fmax(discriminant, 0)), b));
	const double first = a != 0 ? q / a : INFINITY, second = q != 0 ? c / q : first;
	if (ends_differ) { /* exactly one, the nearer to the middle */
		const bool take_first = fabs(first - 0.5) < fabs(second - 0.5);
		u[0] = fmin(fmax(take_first ? first : second, 0), 1);
		return 1;
	}
	u[0] = fmin(first, second);
	u[1] = fmax(first, second);
	return u[0] >= 0 && u[1] <= 1 ? 2 : 0;
}

static double bezier(bool is_curve, const double p[3], double u)
{
	const double v = 1 - u;
	return is_curve ? v * v * p[0] + 2 * u * v * p[1] + u * u * p[2] : v * p[0] + u * p[2];
}

/* Even-odd, by the crossings to the right of the point. */
static bool in_outline(const struct glyph *g, double x, double y)
{
	if (x < g->outline.lo.x || x > g->outline.hi.x || y < g->outline.lo.y ||
		y > g->outline.hi.y)
		return false;
	bool inside = false;
	for (size_t i = 0; i < g->count; i++) {
		const struct glyph_segment *s = &g->segments[i];
		const double e[3] = { s->y[0] - y, s->y[1] - y, s->y[2] - y };
		double u[2];
		const int zeros = segment_zeros(s->is_curve, e, u);
		for (int k = 0; k < zeros; k++)
			inside ^= bezier(s->is_curve, s->x, u[k]) > x;
	}
	return inside;
}

/* Takes crossings: into a list, or only the nearest one. */
struct sink {
	double tmin, tmax;
	struct hit *nearest;
	struct hits *list;
	bool any;
};

static void sink_put(struct sink *s, double t, size_t part, double u)
{
	struct hit *hit = s->nearest;
	if (hit) {
		if (!(t >= s->tmin && t < s->tmax))
			return;
		s->tmax = t;
	} else {
		if (!(t > s->tmin && t < s->tmax))
			return;
		hit = hits_push(s->list, t);
	}
	hit->t = t;
	hit->part = (uint32_t)part;
	hit->u = u;
	s->any = true;
}

static void cross_face(
	const struct glyph *g, const ray *r, double z, enum glyph_part part, struct sink *sink)
{
	const double t = (z - r->origin.z) / r->direction.z;
	if (t >= sink->tmin && t < sink->tmax &&
		in_outline(g, r->origin.x + t * r->direction.x, r->origin.y + t * r->direction.y))
		sink_put(sink, t, part, 0);
}

static void cross_walls(const struct glyph *g, const ray *r, struct sink *sink)
{
	const double dx = r->direction.x, dy = r->direction.y, square = dx * dx + dy * dy;
	if (square == 0)
		return;
	/* from the point nearest the letter, to keep the products small */
	const vec3 c = box_centre(g->outline);
	const double start = -((r->origin.x - c.x) * dx + (r->origin.y - c.y) * dy) / square;
	const vec3 o = ray_at(*r, start);
	for (size_t i = 0; i < g->count; i++) {
		const struct glyph_segment *s = &g->segments[i];
		double e[3], u[2];
		for (int k = 0; k < 3; k++)
			e[k] = dx * (s->y[k] - o.y) - dy * (s->x[k] - o.x);
		const int zeros = segment_zeros(s->is_curve, e, u);
		for (int k = 0; k < zeros; k++) {
			const double x = bezier(s->is_curve, s->x, u[k]) - o.x;
			const double y = bezier(s->is_curve, s->y, u[k]) - o.y;
			const double t = (x * dx + y * dy) / square;
			const double z = o.z + t * r->direction.z;
			if (z >= 0 && z <= g->thickness)
				sink_put(sink, start + t, PART_WALL + i, u[k]);
		}
	}
}

static void glyph_crossings(const struct glyph *g, const ray *r, struct sink *sink)
{
	const vec3 inverse = vec_reciprocal(r->direction);
	if (!box_meets_ray(&g->outline, r->origin, inverse, sink->tmin, sink->tmax))
		return;
	const bool from_front = r->direction.z > 0;
	if (from_front)
		cross_face(g, r, 0, PART_FRONT, sink);
	cross_face(g, r, g->thickness, PART_BACK, sink);
	if (!from_front)
		cross_face(g, r, 0, PART_FRONT, sink);
	cross_walls(g, r, sink);
}

static bool glyph_nearest(
	const void *self, const ray *r, double tmin, double tmax, struct hit *found)
{
	struct sink sink = { .tmin = tmin, .tmax = tmax, .nearest = found };
	glyph_crossings(self, r, &sink);
	return sink.any;
}

static void glyph_hits(const void *self, const ray *r, double tmin, double tmax, struct hits *out)
{
	struct sink sink = { .tmin = tmin, .tmax = tmax, .list = out };
	glyph_crossings(self, r, &sink);
}

static box glyph_bounds(const void *self)
{
	const struct glyph *g = self;
	return g->outline;
}

/* By as much as the letter overhangs to the left, the language counts more to the right. */
static box glyph_extent(const void *self, const transform *place)
{
	const double thin = 1e-6;
	const struct glyph *g = self;
	box b = g->outline;
	b.hi.x += g->overhang;
	b.lo.z -= thin;
	b.hi.z += thin;
	return box_placed(b, place);
}

static bool glyph_inside(const void *self, vec3 p)
{
	const struct glyph *g = self;
	return p.z >= 0 && p.z <= g->thickness && in_outline(g, p.x, p.y);
}

/* Of a wall: to the left of the outline's direction, which for the outer outlines of a TrueType
 * font is into the letter. */
static vec3 glyph_normal(const void *self, const struct hit *hit, vec3 p)
{
	const struct glyph *g = self;
	(void)p;
	if (hit->part == PART_FRONT)
		return vec(0, 0, -1);
	if (hit->part == PART_BACK)
		return vec(0, 0, 1);
	const struct glyph_segment *s = &g->segments[hit->part - PART_WALL];
	const double u = hit->u, v = 1 - u;
	double dx = s->x[2] - s->x[0], dy = s->y[2] - s->y[0];
	if (s->is_curve) {
		dx = v * (s->x[1] - s->x[0]) + u * (s->x[2] - s->x[1]);
		dy = v * (s->y[1] - s->y[0]) + u * (s->y[2] - s->y[1]);
	}
	return vec(dy, -dx, 0);
}

const struct shape_class shape_glyph = {
	.name = "text",
	.size = sizeof(struct glyph),
	.bounds = glyph_bounds,
	.extent = glyph_extent,
	.nearest = glyph_nearest,
	.hits = glyph_hits,
	.inside = glyph_inside,
	.normal = glyph_normal,
};
