/* SPDX-License-Identifier: MIT */
/*
 * Area lights: a grid of point lights whose shadows are averaged. The grid is
 * halved again and again; the average of the quarters is the value of the whole,
 * and a part whose corners agree is not looked at further. The result is a mean
 * with unequal weights when the count is not a power of two; scenes are tuned to
 * it. Jitter moves the points by numbers that belong to the sample.
 */
#include "shadow.h"

#include <string.h>

/* Corners that differ by more than this are looked at more closely. */
#define CONTRAST 0.1f

struct grid {
	struct worker *worker;
	const struct light *light;
	const struct light_target *target;
	struct area_axes axes;
	struct sample_family jitter;
	rgb radiance; /* of the light without shadow */
};

struct area_axes area_light_axes(const struct light *light, vec3 to_centre)
{
	if (!light->orient)
		return (struct area_axes){ light->area_u, light->area_v };
	const double size = vec_length(light->area_u);
	const bool along_z = fabs(fabs(to_centre.z) - 1) < 0.01;
	const vec3 helper = along_z ? vec(0, 1, 0) : vec(0, 0, 1);
	const vec3 u = vec_normalize(vec_cross(to_centre, helper));
	const vec3 v = vec_normalize(vec_cross(to_centre, u));
	return (struct area_axes){ vec_scale(u, size), vec_scale(v, size) };
}

struct sample_family area_light_jitter(
	const struct worker *w, const struct light_target *target, const struct light *light)
{
	if (!light->jitter)
		return (struct sample_family){ 0 };
	const uint64_t lights = sample_dimension(target->vertex, SAMPLE_AREA_LIGHT);
	return sample_family(w->sample, sample_subdimension(lights, light->index));
}

static double grid_factor(double j, int count)
{
	return count > 1 ? j / (count - 1) - 0.5 : 0;
}

/* The points move independently of each other: how finely the grid is looked at depends on some of
 * them and must say nothing of the others. */
vec3 area_light_point(const struct light *light, const struct area_axes *axes,
	const struct sample_family *jitter, int u, int v)
{
	double ju = u, jv = v;
	if (light->jitter) {
		const struct sample_pair by =
			sample_member(jitter, (uint32_t)(v * light->area_count_u + u));
		ju += by.u - 0.5;
		jv += by.v - 0.5;
	}
	double a = grid_factor(ju, light->area_count_u);
	double b = grid_factor(jv, light->area_count_v);
	if (light->circular) { /* from a square to a disc; the shift keeps the middle off zero */
		a += 0.001;
		b += 0.001;
		const double radius = sqrt(a * a + b * b);
		const double m = radius > 0 ? fmax(fabs(a), fabs(b)) / radius : 0;
		a *= m;
		b *= m;
	}
	return vec_mad(vec_mad(light->location, a, axes->u), b, axes->v);
}

/* The shadowed light of one grid point, found once. */
static rgb grid_point(const struct grid *g, int u, int v)
{
	struct worker *w = g->worker;
	const struct light_memory *m = w->light;
	struct grid_point *memo = &m->grid[(size_t)v * (size_t)g->light->area_count_u + (size_t)u];
	if (memo->round != m->grid_round) {
		const vec3 centre = area_light_point(g->light, &g->axes, &g->jitter, u, v);
		struct light_sample s;
		s.light = g->light;
		s.number = g->light->index;
		s.radiance = g->radiance;
		s.distance = light_direction(g->light, centre, g->target->point, &s.direction);
		memo->radiance = shadow_filter(w, g->target, &s);
		memo->round = m->grid_round;
	}
	return memo->radiance;
}

static bool differ(rgb a, rgb b)
{
	return fabsf(a.r - b.r) + fabsf(a.g - b.g) + fabsf(a.b - b.b) > CONTRAST;
}

/* The mean over grid points u1 to u2 and v1 to v2. */
static rgb grid_mean(const struct grid *g, int u1, int v1, int u2, int v2, int level)
{
	rgb c00 = grid_point(g, u1, v1), c10 = grid_point(g, u2, v1);
	rgb c01 = grid_point(g, u1, v2), c11 = grid_point(g, u2, v2);
	const bool can_split = u2 - u1 > 1 || v2 - v1 > 1;
	if (can_split && (level < g->light->adaptive || differ(c00, c10) || differ(c10, c11) ||
				 differ(c11, c01) || differ(c01, c00))) {
		const int u_low = (u1 + u2) / 2, u_high = (u1 + u2 + 1) / 2;
		const int v_low = (v1 + v2) / 2, v_high = (v1 + v2 + 1) / 2;
		c00 = grid_mean(g, u1, v1, u_low, v_low, level + 1);
		c10 = grid_mean(g, u_high, v1, u2, v_low, level + 1);
		c01 = grid_mean(g, u1, v_high, u_low, v2, level + 1);
		c11 = grid_mean(g, u_high, v_high, u2, v2, level + 1);
	}
	return rgb_scale(rgb_add(rgb_add(rgb_add(c00, c10), c01), c11), 0.25);
}

/* Forgets what is known of other targets: all points are of an older round. */
static void grid_begin(struct light_memory *m, size_t count)
{
	const bool grows = m->grid_room < count;
	if (grows) {
		m->grid_room = count;
		m->grid = memory_grow(m->grid, count, sizeof *m->grid);
	}
	if (grows || m->grid_round == UINT32_MAX) {
		memset(m->grid, 0, m->grid_room * sizeof *m->grid);
		m->grid_round = 0;
	}
	m->grid_round++;
}

rgb area_light_filter(
	struct worker *w, const struct light_target *target, const struct light_sample *s)
{
	const struct light *light = s->light;
	const struct grid g = { w, light, target, area_light_axes(light, s->direction),
		area_light_jitter(w, target, light), s->radiance };
	const size_t count = (size_t)light->area_count_u * (size_t)light->area_count_v;
	grid_begin(w->light, count);
	return grid_mean(&g, 0, 0, light->area_count_u - 1, light->area_count_v - 1, 0);
}
