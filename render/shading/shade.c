/* SPDX-License-Identifier: MIT */
/*
 * The colour of a surface point. A plain texture is a stack of layers gone
 * through from the top; each adds its own light, tinted by those above it, until
 * hardly anything comes through. Reflections of the layers are added untinted,
 * and one ray goes on through the surface, bent by the top layer's normal. A
 * patterned texture is a blend of plain ones, each shaded fully.
 */
#include "shading.h"

#include "base/elementary.h"

/* What the layers of one plain texture amount to. */
struct stack {
	rgb light; /* their own */
	rgb tint;  /* of what comes through all of them */
	float clear;
	bool tinted; /* some layer had a colour here */
	vec3 top_normal;
};

const struct texture *surface_open(
	struct surface *s, const struct hit *hit, const ray *r, vec3 *evaluate_at)
{
	const struct object *object = hit->object;
	s->point = ray_at(*r, hit->t);
	s->direction = r->direction;
	s->hit = hit;
	s->geometric = object_normal(hit, s->point);
	const bool back = vec_dot(s->geometric, s->direction) > 0;
	if (back)
		s->geometric = vec_negate(s->geometric);
	s->current = s->geometric;

	const struct texture *texture = object->texture;
	if (back && object->extras && object->extras->interior_texture)
		texture = object->extras->interior_texture;
	*evaluate_at = s->point;
	if (texture->uses_uv) {
		double uv[2];
		object_uv(hit, s->point, uv);
		*evaluate_at = vec(uv[0], uv[1], 0);
	}
	return texture;
}

size_t parts_resolve(struct worker *w, const struct texture *texture, vec3 p, struct surface *s)
{
	const size_t first = w->part_count;
	struct texture_parts parts = { w->parts, first, w->part_room };
	texture_resolve(texture, p, s, &parts, w->scratch);
	w->parts = parts.items;
	w->part_count = parts.count;
	w->part_room = parts.room;
	return first;
}

vec3 layer_normal(const struct worker *w, const struct texture_part *part,
	const struct layer *layer, struct surface *s)
{
	if (!layer->normal || w->scene->settings.quality < 8)
		return s->geometric;
	if (part->frame)
		return texture_part_normal(part, layer, s);
	return normal_perturb(layer->normal, s->geometric, part->p, s);
}

/* ---- layers ---- */

/* Remembers the reflection of a layer; returns how much it reflects. */
static rgb reflection_push(
	struct worker *w, const struct point *at, const struct coat *coat, float clear)
{
	const struct finish *f = coat->finish;
	if (rgb_is_zero(f->reflection_max) && rgb_is_zero(f->reflection_min))
		return rgb_grey(0);
	float weight;
	const rgb amount = reflectivity(at, coat, &weight);
	if (rgb_is_zero(amount) || w->scene->settings.quality < 8)
		return amount;
	if (w->reflection_count == w->reflection_room) {
		w->reflection_room = w->reflection_room ? 2 * w->reflection_room : 64;
		w->reflections =
			memory_grow(w->reflections, w->reflection_room, sizeof *w->reflections);
	}
	w->reflections[w->reflection_count++] = (struct reflection){
		.finish = f, .normal = coat->normal, .amount = amount, .weight = clear * weight
	};
	return amount;
}

/* Ambient, emission and direct light of one layer. */
static rgb layer_light(struct worker *w, const struct point *at, const struct coat *coat)
{
	const struct settings *settings = &w->scene->settings;
	const struct finish *f = coat->finish;
	const rgb pigment = rgb_scale(coat->pigment, coat->own);
	rgb light = rgb_grey(0);
	if (!rgb_is_zero(f->ambient))
		light = rgb_mul(rgb_mul(pigment, f->ambient), settings->ambient_light);
	if (!rgb_is_zero(f->emission))
		light = rgb_add(light, rgb_mul(pigment, f->emission));
	return rgb_add(light, illuminate(w, at, coat));
}

/* Share of its own colour a layer shows. */
static float own_share(colour c, int version)
{
	if (version >= 370)
		return colour_opacity(c);
	return 1 - (c.filter * rgb_max(colour_rgb(c)) + c.transmit);
}

static rgb energy_left(rgb reflected)
{
	return (rgb){ fminf(1, 1 - reflected.r), fminf(1, 1 - reflected.g),
		fminf(1, 1 - reflected.b) };
}

/* Goes through the layers; their reflections are left on the worker's stack. */
static void layers_shade(
	struct worker *w, struct point *at, const struct texture_part *part, struct stack *out)
{
	const struct settings *settings = &w->scene->settings;
	const struct texture *texture = part->texture;
	out->light = rgb_grey(0);
	out->tint = rgb_grey(1);
	out->clear = 1;
	out->tinted = false;

	for (size_t i = 0; i < texture->layer_count && out->clear > settings->adc_bailout; i++) {
		const struct layer *layer = &texture->layers[i];
		colour c = { 1, 1, 1, 0, 1 };
		struct coat coat = { .finish = layer->finish };
		coat.normal = layer_normal(w, part, layer, &at->surface);
		if (i == 0)
			out->top_normal = coat.normal;
		const bool found = pigment_colour(layer->pigment, part->p, &at->surface, &c);
		coat.pigment = colour_rgb(c);
		coat.own = own_share(c, settings->version);

		if (settings->quality < 2) { /* colours only */
			out->light = coat.pigment;
		} else {
			const rgb reflected = reflection_push(w, at, &coat, out->clear);
			out->light =
				rgb_add(out->light, rgb_mul(out->tint, layer_light(w, at, &coat)));
			if (found && layer->finish->conserve_energy)
				out->tint = rgb_mul(out->tint, energy_left(reflected));
		}
		if (found) {
			out->tint = rgb_mul(out->tint, colour_tint(c));
			out->tinted = true;
		}
		const float clear = fabsf(rgb_luminance(out->tint));
		out->clear = clear < 1 ? clear : 1;
	}
}

/* ---- what goes on behind ---- */

/* The ray through the surface; its factors hold the fading of the interior it leaves. */
static void passage_find(const struct worker *w, const struct point *at,
	const struct texture *texture, const struct stack *stack, struct passage *out)
{
	const struct settings *settings = &w->scene->settings;
	const struct containment *inside = &at->path->inside;
	out->present = settings->quality >= 6 && stack->clear > settings->adc_bailout;
	if (!out->present)
		return;

	const struct interior *interior = object_interior(at->object);
	const vec3 v = at->surface.direction;
	const double eta = containment_ratio(inside, interior);
	out->straight = fabs(eta - 1) < NEARLY_ZERO;
	out->total = false;
	out->direction = v;
	if (!out->straight && !refract_direction(v, stack->top_normal, eta, &out->direction)) {
		out->total = true;
		out->direction = mirror_direction(v, stack->top_normal, at->surface.geometric);
	}

	const struct finish *f = texture->layers[0].finish;
	rgb factor = rgb_grey(f->refraction);
	if (out->total && f->irid > 0)
		factor = rgb_mul(factor, irid_factor(w, at, f, stack->top_normal, out->direction));
	if (containment_has(inside, interior))
		factor = rgb_mul(factor, interior_fading(interior, at->depth));
	out->weight = rgb_max_abs(stack->tint);
	out->transmit = out->total ? 0 : rgb_luminance(factor);
	if (!out->total && stack->tinted) {
		out->transmit *= stack->clear;
		factor = rgb_mul(factor, stack->tint);
	}
	out->factor = factor;
}

static bool same_direction(vec3 a, vec3 b)
{
	return fabs(a.x - b.x) < NEARLY_ZERO && fabs(a.y - b.y) < NEARLY_ZERO &&
	       fabs(a.z - b.z) < NEARLY_ZERO;
}

static float raise(float base, float exponent)
{
	return base > 0 ? (float)elementary_pow(base, exponent) : 0;
}

static rgb reflection_trace(struct worker *w, const struct point *at, const struct reflection *r)
{
	const struct finish *f = r->finish;
	struct path path;
	containment_borrow(&path.inside, &at->path->inside);
	path.level = at->path->level;
	path.weight = at->path->weight * r->weight;
	path.kind = RAY_REFLECTED;
	path.straight = false;
	path.ray.origin = at->surface.point;
	path.ray.direction =
		mirror_direction(at->surface.direction, r->normal, at->surface.geometric);
	rgb factor = r->amount;
	if (f->irid > 0)
		factor = rgb_mul(factor, irid_factor(w, at, f, r->normal, path.ray.direction));
	w->stats.reflected_rays++;

	rgb light = trace_path(w, &path).light;
	if (f->reflection_exponent != 1)
		light = (rgb){ raise(light.r, f->reflection_exponent),
			raise(light.g, f->reflection_exponent),
			raise(light.b, f->reflection_exponent) };
	return rgb_mul(light, factor);
}

/* Traces and takes off the stack all reflections from `first` on. */
static rgb reflections_trace(struct worker *w, const struct point *at, size_t first,
	const struct stack *stack, const struct passage *passage)
{
	const size_t end = w->reflection_count;
	rgb sum = rgb_grey(0);
	for (size_t i = first; i < end; i++) {
		const struct reflection r = w->reflections[i];
		/* total reflection has traced this one already */
		if (passage->present && passage->total &&
			same_direction(r.normal, stack->top_normal))
			continue;
		sum = rgb_add(sum, reflection_trace(w, at, &r));
	}
	w->reflection_count = first;
	return sum;
}

/* A plain texture: its light and reflections; *passage is what comes through. */
static rgb part_shade(struct worker *w, struct point *at, const struct texture_part *part,
	struct passage *passage)
{
	const size_t first = w->reflection_count;
	struct stack stack;
	layers_shade(w, at, part, &stack);
	passage_find(w, at, part->texture, &stack, passage);
	if (w->reflection_count == first)
		return stack.light;
	return rgb_add(stack.light, reflections_trace(w, at, first, &stack, passage));
}

/* ---- blends ---- */

/* Rays that go straight on are one and the same ray for all parts. */
static void passage_merge(struct passage *sum, const struct passage *p, float weight)
{
	if (!sum->present)
		*sum = (struct passage){
			.present = true, .straight = true, .direction = p->direction
		};
	sum->factor = rgb_add(sum->factor, rgb_scale(p->factor, weight));
	sum->transmit += p->transmit * weight;
	sum->weight = fmaxf(sum->weight, p->weight);
}

static void passage_trace(struct worker *w, const struct point *at, const struct passage *passage,
	float weight, struct seen *sum)
{
	struct path path;
	passage_follow(w, at, passage, &path);
	const struct seen behind = trace_path(w, &path);
	sum->light = rgb_add(sum->light, rgb_scale(rgb_mul(behind.light, passage->factor), weight));
	sum->transmit += behind.transmit * passage->transmit * weight;
}

static struct seen blend_shade(struct worker *w, struct point *at, const struct texture *texture,
	vec3 p, struct passage *onward)
{
	const size_t first = parts_resolve(w, texture, p, &at->surface);
	const size_t end = w->part_count;
	struct seen sum = { 0 };
	onward->present = false;
	for (size_t i = first; i < end; i++) {
		const struct texture_part part = w->parts[i]; /* deeper levels may move the list */
		struct passage passage;
		at->surface.current = at->surface.geometric;
		const rgb light = part_shade(w, at, &part, &passage);
		sum.light = rgb_add(sum.light, rgb_scale(light, part.weight));
		if (!passage.present)
			continue;
		if (end - first == 1 && part.weight == 1)
			*onward = passage;
		else if (passage.straight)
			passage_merge(onward, &passage, part.weight);
		else
			passage_trace(w, at, &passage, part.weight, &sum);
	}
	w->part_count = first;
	return sum;
}

/* Room for the shadows of all lights at this point, to be found once for all layers. */
static void share_lights(struct worker *w, struct point *at)
{
	const size_t need = w->incidence_count + w->light_count;
	if (w->incidence_room < need) {
		w->incidence_room = 2 * need;
		w->incidences =
			memory_grow(w->incidences, w->incidence_room, sizeof *w->incidences);
	}
	at->shares_lights = true;
	at->shared = w->incidence_count;
	for (size_t i = w->incidence_count; i < need; i++)
		w->incidences[i].known = w->incidences[i].shadowed = false;
	w->incidence_count = need;
}

struct seen shade_hit(
	struct worker *w, struct path *path, const struct hit *hit, struct passage *onward)
{
	struct point at; /* field by field: clearing all of it first takes longer than the rest */
	at.path = path;
	at.object = hit->object;
	at.depth = hit->t;
	at.shares_lights = false;
	vec3 p;
	const struct texture *texture = surface_open(&at.surface, hit, &path->ray, &p);
	const size_t shared = w->incidence_count;
	struct seen seen = { 0 };
	if (texture->layer_count != 1)
		share_lights(w, &at);
	if (texture->layer_count > 0) {
		const struct texture_part whole = { .texture = texture, .weight = 1, .p = p };
		seen.light = part_shade(w, &at, &whole, onward);
	} else {
		seen = blend_shade(w, &at, texture, p, onward);
	}
	w->incidence_count = shared;
	if (onward->present)
		passage_follow(w, &at, onward, path);
	return seen;
}
