/* SPDX-License-Identifier: MIT */
/*
 * cells, crackle, facets: random values and random points, one for each unit cell
 * (Worley 1996). The points of 81 cells around q are candidates for the three nearest: all
 * offsets of -2 to 2 with at most one component of magnitude 2. The 27 inner cells are looked
 * at first; an outer one only if it can hold a nearer point.
 */
#include "texture/patterns.h"

#include "base/elementary.h"
#include "base/epsilon.h"
#include "noise/noise.h"

static double cells_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)surface;
	return cell_uniforms[cell_hash(floor_index(q.x + EPSILON), floor_index(q.y + EPSILON),
		floor_index(q.z + EPSILON))];
}
const struct pattern_class pattern_cells = { .name = "cells", .value = cells_value };

/* How far a candidate is: before the root is taken. */
enum metric { METRIC_SQUARE, METRIC_ABSOLUTE, METRIC_SIGNED, METRIC_POWER };

struct search {
	enum metric metric;
	double power;
	int64_t x, y, z;   /* the cell */
	vec3 f;		   /* the point within the cell */
	double nearest[3]; /* ascending */
	vec3 delta;	   /* from the point to the nearest candidate */
	unsigned order;	   /* of the nearest candidate among the offsets */
};

static double measure(const struct search *s, vec3 d)
{
	switch (s->metric) {
	case METRIC_SQUARE:
		return vec_length2(d);
	case METRIC_ABSOLUTE:
		return fabs(d.x) + fabs(d.y) + fabs(d.z);
	case METRIC_SIGNED:
		return d.x + d.y + d.z;
	case METRIC_POWER:
		break;
	}
	return elementary_pow(fabs(d.x), s->power) + elementary_pow(fabs(d.y), s->power) +
	       elementary_pow(fabs(d.z), s->power);
}

/* Among equals the lower offset is the nearest. */
static void search_cell(struct search *s, int dx, int dy, int dz)
{
	const double *u = cell_uniforms + cell_hash(s->x + dx, s->y + dy, s->z + dz);
	const vec3 d = { dx + u[0] - s->f.x, dy + u[1] - s->f.y, dz + u[2] - s->f.z };
	const double distance = measure(s, d);
	const unsigned order = (unsigned)((dx + 2) * 25 + (dy + 2) * 5 + dz + 2);
	double *near = s->nearest;
	if (distance < near[0] || (distance == near[0] && order < s->order)) {
		near[2] = near[1];
		near[1] = near[0];
		near[0] = distance;
		s->delta = d;
		s->order = order;
	} else if (distance < near[1]) {
		near[2] = near[1];
		near[1] = distance;
	} else if (distance < near[2]) {
		near[2] = distance;
	}
}

/* Whether a cell whose nearest point is at least `gap` away along one axis can matter when `rank`
 * nearest candidates are wanted. The margin covers rounding. */
static bool can_matter(const struct search *s, double gap, int rank)
{
	const double limit = s->nearest[rank - 1] * (1 + 1e-9) + 1e-9;
	switch (s->metric) {
	case METRIC_SQUARE:
		return gap * gap <= limit;
	case METRIC_ABSOLUTE:
		return gap <= limit;
	case METRIC_SIGNED:
		return true;
	case METRIC_POWER:
		break;
	}
	return !(s->power > 0 && elementary_pow(gap, s->power) > limit);
}

/* The nine cells on one outer side: component `axis` is `side`, the others -1 to 1. */
static void search_side(struct search *s, int axis, int side)
{
	for (int a = -1; a <= 1; a++)
		for (int b = -1; b <= 1; b++)
			search_cell(s, axis == 0 ? side : a,
				axis == 1   ? side
				: axis == 0 ? a
					    : b,
				axis == 2 ? side : b);
}

static void search_all(struct search *s, vec3 q, int rank)
{
	s->x = floor_index(q.x);
	s->y = floor_index(q.y);
	s->z = floor_index(q.z);
	s->f = vec(q.x - (double)s->x, q.y - (double)s->y, q.z - (double)s->z);
	s->nearest[0] = s->nearest[1] = s->nearest[2] = INFINITY;
	s->order = 125;
	for (int dx = -1; dx <= 1; dx++)
		for (int dy = -1; dy <= 1; dy++)
			for (int dz = -1; dz <= 1; dz++)
				search_cell(s, dx, dy, dz);
	const double f[3] = { s->f.x, s->f.y, s->f.z };
	for (int axis = 0; axis < 3; axis++) {
		if (can_matter(s, 1 + f[axis], rank))
			search_side(s, axis, -2);
		if (can_matter(s, 2 - f[axis], rank))
			search_side(s, axis, 2);
	}
}

struct crackle {
	vec3 form;
	double metric, offset;
	bool solid;
	int rank; /* how many of the nearest points matter */
	double offset_power;
};

static void crackle_build(void *self)
{
	struct crackle *c = self;
	c->rank = c->solid ? 1 : c->form.z != 0 ? 3 : c->form.y != 0 ? 2 : 1;
	if (c->offset == 0)
		c->offset_power = 0;
	else if (c->metric == 2)
		c->offset_power = c->offset * c->offset;
	else
		c->offset_power = c->metric == 1 ? c->offset : elementary_pow(c->offset, c->metric);
}

static double root(const struct crackle *c, double sum)
{
	sum += c->offset_power;
	return c->metric == 2	? sqrt(sum)
	       : c->metric == 1 ? sum
				: elementary_pow(sum, 1 / c->metric);
}

static double crackle_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct crackle *c = pattern->self;
	struct search s = { .power = c->metric };
	s.metric = c->metric == 2 ? METRIC_SQUARE : c->metric == 1 ? METRIC_ABSOLUTE : METRIC_POWER;
	search_all(&s, q, c->rank);
	if (c->solid)
		return noise_scalar(vec_add(q, s.delta), pattern->noise_generator);
	double v = c->form.x * root(c, s.nearest[0]);
	if (c->rank >= 2)
		v += c->form.y * root(c, s.nearest[1]);
	if (c->rank >= 3)
		v += c->form.z * root(c, s.nearest[2]);
	return clamp01(v);
}

static const struct pattern_param crackle_params[] = {
	{ "form", PATTERN_VECTOR, offsetof(struct crackle, form) },
	{ "metric", PATTERN_X, offsetof(struct crackle, metric) },
	{ "offset", PATTERN_DOUBLE, offsetof(struct crackle, offset) },
	{ "solid", PATTERN_FLAG, offsetof(struct crackle, solid) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_crackle = {
	.name = "crackle",
	.size = sizeof(struct crackle),
	.params = crackle_params,
	.defaults = &(const struct crackle){ .form = { -1, 1, 0 }, .metric = 2 },
	.build = crackle_build,
	.value = crackle_value,
};

/* facets, of normals only: the normal turns to the nearest random point around it, or is tilted by
 * the noise at the random point nearest to q. */
struct facets {
	double coords, size, metric;
};

static vec3 facets_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)amount, (void)surface;
	const struct facets *facets = pattern->self;
	n = vec_normalize(n);
	const vec3 at = vec_scale(
		facets->coords != 0 ? q : n, facets->size < 1e-6 ? 1e6 : 1 / facets->size);
	struct search s = { .power = facets->metric };
	s.metric = facets->metric == 2	 ? METRIC_SQUARE
		   : facets->metric == 1 ? METRIC_SIGNED
					 : METRIC_POWER;
	search_all(&s, vec_sub(at, vec(EPSILON, EPSILON, EPSILON)), 1);
	const vec3 nearest = vec_add(at, s.delta);
	if (facets->coords == 0)
		return nearest;
	const vec3 e = noise_vector(nearest);
	return vec_mad(n, facets->coords, vec_mad(e, -vec_dot(e, n), n));
}

/* Not a pattern of values; lowering allows it in normals alone. */
static double facets_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)pattern, (void)q, (void)surface;
	return 0;
}

static const struct pattern_param facets_params[] = {
	{ "coords", PATTERN_DOUBLE, offsetof(struct facets, coords) },
	{ "size", PATTERN_DOUBLE, offsetof(struct facets, size) },
	{ "metric", PATTERN_X, offsetof(struct facets, metric) },
	{ NULL, PATTERN_END, 0 },
};
const struct pattern_class pattern_facets = {
	.only_normals = true,
	.name = "facets",
	.size = sizeof(struct facets),
	.params = facets_params,
	.defaults = &(const struct facets){ .size = 0.1, .metric = 2 },
	.value = facets_value,
	.perturb = facets_perturb,
};
