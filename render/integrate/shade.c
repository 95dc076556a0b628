/* SPDX-License-Identifier: MIT */
/*
 * The light of a surface point. Each part of its texture sends on direct light,
 * adds what it reflects like a mirror, and lets one ray through, bent by the top
 * layer's normal. Parts are blended by weight, each shaded fully.
 */
#include "integrate.h"

#include "base/elementary.h"
#include "medium/interior.h"
#include "surface/specular.h"

/* Numbers of rays: lobes count their reflections upwards, parts their transmissions downwards. */
#define TRANSMISSION_VERTEX UINT32_MAX

/* ---- mirrors ---- */

static bool same_direction(vec3 a, vec3 b)
{
	return fabs(a.x - b.x) < NEARLY_ZERO && fabs(a.y - b.y) < NEARLY_ZERO &&
	       fabs(a.z - b.z) < NEARLY_ZERO;
}

static float raise(float base, float exponent)
{
	return base > 0 ? (float)elementary_pow(base, exponent) : 0;
}

/* What a lobe reflects like a mirror. */
static rgb reflection_trace(struct worker *w, const struct path *arriving,
	const struct interaction *it, const struct lobe *lobe)
{
	const struct finish *f = lobe->finish;
	struct path path;
	interior_stack_borrow(&path.inside, it->interiors);
	path.level = arriving->level;
	path.weight = arriving->weight * lobe->importance;
	path.kind = RAY_REFLECTED;
	path.vertex = sample_vertex(it->vertex, lobe->number);
	path.straight = false;
	path.ray.origin = it->surface.point;
	path.ray.direction =
		mirror_direction(it->surface.direction, lobe->normal, it->surface.geometric);
	rgb factor = lobe->mirror;
	if (f->irid > 0)
		factor = rgb_mul(factor, irid_factor(w, it, lobe, path.ray.direction));
	w->stats.reflected_rays++;

	rgb light = trace_path(w, &path).light;
	if (f->reflection_exponent != 1)
		light = (rgb){ raise(light.r, f->reflection_exponent),
			raise(light.g, f->reflection_exponent),
			raise(light.b, f->reflection_exponent) };
	return rgb_mul(light, factor);
}

static rgb reflections_trace(struct worker *w, const struct path *path,
	const struct interaction *it, const struct layers *layers,
	const struct transmission *transmission)
{
	rgb sum = rgb_grey(0);
	for (size_t i = 0; i < layers->count; i++) {
		const struct lobe *lobe = &layers->lobes[i];
		if (!lobe_is_mirror(lobe))
			continue;
		/* total reflection has traced this one already */
		if (transmission->present && transmission->total &&
			same_direction(lobe->normal, layers->lobes[0].normal))
			continue;
		sum = rgb_add(sum, reflection_trace(w, path, it, lobe));
	}
	return sum;
}

/* ---- parts ---- */

/* The light and the reflections of a part; *transmission is what comes through. */
static rgb part_shade(struct worker *w, const struct path *path, struct interaction *it,
	const struct texture_part *part, uint32_t *numbered, struct transmission *transmission)
{
	struct layers layers;
	layers_open(w, it, part, *numbered, &layers);
	*numbered += (uint32_t)layers.count;
	transmission_find(w, it, &layers, transmission);
	if (w->scene->settings.quality < 2) /* colours only */
		return layers.count > 0 ? layers.lobes[layers.count - 1].pigment : rgb_grey(0);
	const rgb light = direct_light(w, path, it, &layers);
	return rgb_add(light, reflections_trace(w, path, it, &layers, transmission));
}

/* The ray that goes on, `number` among those of the interaction. `path` may be the arriving one. */
static void transmission_follow(struct worker *w, const struct path *arriving,
	const struct interaction *it, const struct transmission *t, uint32_t number,
	struct path *path)
{
	struct path next = *arriving;
	if (path != arriving)
		next.inside.borrowed = true;
	next.ray = (ray){ it->surface.point, t->direction };
	next.weight *= t->weight;
	next.straight = t->straight;
	next.vertex = sample_vertex(it->vertex, number);
	if (t->total)
		next.kind = RAY_REFLECTED;
	else
		interior_stack_toggle(&next.inside, object_interior(it->object), w->scratch);
	if (next.kind == RAY_CAMERA)
		next.kind = RAY_SECONDARY;

	if (t->straight)
		w->stats.transmitted_rays++;
	else if (t->total)
		w->stats.reflected_rays++;
	else
		w->stats.refracted_rays++;
	*path = next;
}

/* ---- blends ---- */

/* Rays that go straight on are one and the same ray for all parts. */
static void transmission_merge(struct transmission *sum, const struct transmission *t, float weight)
{
	if (!sum->present)
		*sum = (struct transmission){
			.present = true, .straight = true, .direction = t->direction
		};
	sum->factor = rgb_add(sum->factor, rgb_scale(t->factor, weight));
	sum->transmit += t->transmit * weight;
	sum->weight = fmaxf(sum->weight, t->weight);
}

static void transmission_trace(struct worker *w, const struct path *arriving,
	const struct interaction *it, const struct transmission *t, uint32_t number, float weight,
	struct radiance *sum)
{
	struct path path;
	transmission_follow(w, arriving, it, t, number, &path);
	const struct radiance behind = trace_path(w, &path);
	sum->light = rgb_add(sum->light, rgb_scale(rgb_mul(behind.light, t->factor), weight));
	sum->transmit += behind.transmit * t->transmit * weight;
}

/* The parts of a patterned texture. */
static struct radiance blend_shade(struct worker *w, const struct path *path,
	struct interaction *it, struct transmission *onward)
{
	struct radiance sum = { 0 };
	uint32_t numbered = 0;
	interaction_keep(w, it);
	onward->present = false;
	for (size_t i = 0; i < it->part_count; i++) {
		const struct texture_part *part = &it->parts[i];
		struct transmission t;
		const rgb light = part_shade(w, path, it, part, &numbered, &t);
		sum.light = rgb_add(sum.light, rgb_scale(light, part->weight));
		if (!t.present)
			continue;
		if (it->part_count == 1 && part->weight == 1)
			*onward = t;
		else if (t.straight)
			transmission_merge(onward, &t, part->weight);
		else
			transmission_trace(w, path, it, &t, TRANSMISSION_VERTEX - numbered,
				part->weight, &sum);
	}
	return sum;
}

struct radiance shade_hit(
	struct worker *w, struct path *path, const struct hit *hit, struct transmission *onward)
{
	struct interaction it;
	interaction_make(w, &it, hit, &path->ray, &path->inside, path->vertex);
	struct radiance sum = { 0 };
	uint32_t numbered = 0;
	if (it.parts == &it.whole)
		sum.light = part_shade(w, path, &it, &it.whole, &numbered, onward);
	else
		sum = blend_shade(w, path, &it, onward);
	if (onward->present)
		transmission_follow(w, path, &it, onward, TRANSMISSION_VERTEX, path);
	return sum;
}
