/* SPDX-License-Identifier: MIT */
/*
 * What pigments, normals and patterned textures share: the pattern with its
 * parameters, its modifiers, and the list of transformations and warps.
 */
#include "looks.h"

#include "base/epsilon.h"
#include "lower/lower_function.h"
#include "texture/patterns.h"
#include "noise/noise.h"

#include <string.h>

/* A vector this short has no direction. */

const struct pattern_state pattern_state_fresh = {
	.turbulence = { .octaves = 6, .omega = 0.5f, .lambda = 2 },
	.frequency = 1,
	.exponent = 1,
};

/* ---- parameters ---- */

/* The instance is copied before it is changed: others may share it. */
static void *own_self(struct lowering *l, struct pattern_state *s)
{
	void *copy = arena_copy(l->arena, s->self, s->class->size);
	s->self = copy;
	return copy;
}

static void set_param(struct lowering *l, void *self, const struct pattern_param *param,
	const struct node *item, uint32_t index)
{
	void *field = (char *)self + param->offset;
	switch (param->type) {
	case PATTERN_FLOAT:
		*(float *)field = (float)lower_float(l, item, index, "a number");
		break;
	case PATTERN_DOUBLE:
		*(double *)field = lower_float(l, item, index, "a number");
		break;
	case PATTERN_VECTOR:
		*(vec3 *)field = lower_vector(l, item, index, "a vector");
		break;
	case PATTERN_X:
		*(double *)field = lower_vector(l, item, index, "a number").x;
		break;
	case PATTERN_FLAG:
		*(bool *)field = true;
		break;
	case PATTERN_END:
		break;
	}
}

/* The values behind the pattern's word. */
static void name_plain(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	const struct pattern_param *param = s->class->params;
	void *self = NULL;
	for (uint32_t index = 0; param && param->type != PATTERN_END; param++) {
		if (param->word)
			continue;
		if (!self)
			self = own_self(l, s);
		set_param(l, self, param, item, index++);
	}
}

/* A modifier that is a parameter of this pattern. */
static bool modify_param(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	if (!s->class || !s->class->params)
		return false;
	const char *word = keyword_name(item->keyword);
	for (const struct pattern_param *p = s->class->params; p->type != PATTERN_END; p++)
		if (p->word && strcmp(p->word, word) == 0) {
			set_param(l, own_self(l, s), p, item, 0);
			return true;
		}
	return false;
}

/* ---- patterns with a form of their own ---- */

static int iterations(struct lowering *l, const struct node *item, uint32_t index)
{
	const double n = lower_float(l, item, index, "a number of iterations");
	return n > 0 ? n < 2e9 ? (int)n : 2000000000 : 0;
}

static void name_fractal(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct fractal *f = own_self(l, s);
	if (item->keyword == K_MAGNET) {
		f->magnet = lower_int(l, item, 0, "a type");
		if (f->magnet != 1 && f->magnet != 2) {
			diag_error(l->diag, item->span, "magnet is of type 1 or 2");
			f->magnet = 1;
		}
		item = item->children;
		if (!item)
			return;
	}
	if (item->keyword == K_MANDEL) {
		f->iterations = iterations(l, item, 0);
		return;
	}
	const vec3 c = lower_vector(l, item, 0, "a complex number");
	f->is_julia = true;
	f->real = c.x;
	f->imaginary = c.y;
	f->iterations = iterations(l, item, 1);
}

static int fractal_type(struct lowering *l, const struct node *item, int last)
{
	const double type = lower_float(l, item, 0, "a type");
	if (type >= 0 && type < last + 1)
		return (int)type;
	diag_error(l->diag, item->span, "%s is of type 0 to %d", keyword_name(item->keyword), last);
	return 0;
}

static bool modify_fractal(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct fractal *f = own_self(l, s);
	switch (item->keyword) {
	case K_EXPONENT:
		f->exponent = lower_int(l, item, 0, "a number");
		if (f->exponent < 2 || f->exponent > 33) {
			diag_warning(l->diag, item->span,
				"the exponent of a fractal is 2 to 33; 2 is used");
			f->exponent = 2;
		}
		return true;
	case K_EXTERIOR:
		f->exterior = fractal_type(l, item, 8);
		if (item->arg_count > 1)
			f->exterior_factor = lower_float(l, item, 1, "a number");
		return true;
	case K_INTERIOR:
		f->interior = fractal_type(l, item, 6);
		if (item->arg_count > 1)
			f->interior_factor = lower_float(l, item, 1, "a number");
		return true;
	default:
		return false;
	}
}

/* low and high of a range; an omitted high is 0. */
static void read_range(struct lowering *l, const struct node *item, double *low, double *range)
{
	if (item->arg_count < 2)
		return;
	*low = lower_float(l, item, 1, "a number");
	*range = (item->arg_count > 2 ? lower_float(l, item, 2, "a number") : 0) - *low;
	if (*range == 0 && *low != 0)
		diag_warning(l->diag, item->span, "a range of no width is ignored");
}

static void name_slope(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct slope *slope = own_self(l, s);
	slope->direction = lower_vector(l, item, 0, "a vector");
	read_range(l, item, &slope->slope_low, &slope->slope_range);
	slope->is_point = node_child(item, K_POINT_AT) != NULL;
	const struct node *altitude = node_child(item, K_ALTITUDE);
	const double slope_length = vec_length(slope->direction);
	double altitude_length = 0;
	if (altitude) {
		diag_warning(l->diag, altitude->word, "altitude is an experimental feature");
		slope->altitude = lower_vector(l, altitude, 0, "a vector");
		altitude_length = vec_length(slope->altitude);
		read_range(l, altitude, &slope->altitude_low, &slope->altitude_range);
		if (slope->is_point)
			diag_error(l->diag, altitude->word, "slope with point_at has no altitude");
	}
	if (slope->is_point)
		return;
	if (slope_length < EPSILON && altitude_length < EPSILON)
		diag_error(l->diag, item->span, "slope needs a direction: the vector is zero");
	slope->has_altitude = altitude_length >= EPSILON;
	slope->direction = vec_normalize(slope->direction);
	slope->altitude = vec_normalize(slope->altitude);
	slope->slope_weight = slope_length / (double)(float)(slope_length + altitude_length);
	slope->altitude_weight = 1 - slope->slope_weight;
}

static void name_pigment_pattern(
	struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct pigment_pattern *p = own_self(l, s);
	const struct pigment_state *start = default_spec(l, item->state)->layers->pigment;
	p->pigment = pigment_build(l, pigment_read(l, item, start));
}

static void name_object(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct object_pattern *p = own_self(l, s);
	p->object = lower_inside_object(l, item);
}

static void name_function(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	struct function_pattern *p = own_self(l, s);
	if (item->arg_count > 0 && item->args[0].kind == ARG_FUNCTION)
		p->program = lower_function(l, item->args[0].function);
	else
		diag_error(l->diag, item->span, "function needs an expression");
}

/* ---- naming ---- */

typedef void pattern_reader(struct lowering *, struct pattern_state *, const struct node *);

/* The form of each pattern's statement, from its row. */
static const struct pattern_form {
	const struct pattern_class *class;
	pattern_reader *read;
} pattern_forms[] = {
#define REFUSED(WORD)
#define PATTERN(word, file, form) { &pattern_##word, name_##form },
#include "texture/patterns.def"
#undef PATTERN
#undef REFUSED
};

static pattern_reader *form_of(const struct pattern_class *class)
{
	const struct pattern_form *form = pattern_forms;
	while (form->class != class)
		form++;
	return form->read;
}

static bool name_pattern(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	const struct pattern_class *class = pattern_find(keyword_name(item->keyword));
	if (!class)
		return false;
	if (s->class != class || !class->keeps_parameters) {
		static const char nothing[1];
		const size_t size = class->size ? class->size : sizeof nothing;
		s->self = class->defaults ? class->defaults
			  : class->size	  ? arena_alloc(l->arena, size)
					  : nothing;
	}
	s->class = class;
	s->word = item->word;
	if (class->sets_triangle_wave)
		s->wave = WAVE_TRIANGLE;
	if (class->sets_frequency_0)
		s->frequency = 0;
	form_of(class)(l, s, item);
	return true;
}

/* ---- modifiers ---- */

void pattern_state_move(struct lowering *l, struct pattern_state *s, const transform *t)
{
	struct warp_step *step = ARENA_NEW(l->arena, struct warp_step);
	transform *place = ARENA_NEW(l->arena, transform);
	if (s->steps && s->steps->place) {
		*place = transform_compose(s->steps->place, t);
		step->before = s->steps->before;
	} else {
		*place = *t;
		step->before = s->steps;
	}
	step->place = place;
	s->steps = step;
}

static void set_noise_generator(
	struct lowering *l, struct pattern_state *s, const struct node *item)
{
	const double n = lower_float(l, item, 0, "a number");
	if (n < 0 || n >= 4)
		diag_error(l->diag, item->span, "noise_generator is 0 to 3");
	else
		s->noise_generator |= (int)n;
}

/* Returns false for other words. */
static bool set_wave(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	switch (item->keyword) {
	case K_RAMP_WAVE:
		s->wave = WAVE_RAMP;
		return true;
	case K_TRIANGLE_WAVE:
		s->wave = WAVE_TRIANGLE;
		return true;
	case K_SINE_WAVE:
		s->wave = WAVE_SINE;
		return true;
	case K_SCALLOP_WAVE:
		s->wave = WAVE_SCALLOP;
		return true;
	case K_CUBIC_WAVE:
		s->wave = WAVE_CUBIC;
		return true;
	case K_POLY_WAVE:
		s->wave = WAVE_POLY;
		if (item->arg_count > 0)
			s->exponent = (float)lower_float(l, item, 0, "an exponent");
		return true;
	default:
		return false;
	}
}

static bool modify(struct lowering *l, struct pattern_state *s, const struct node *item)
{
	if (node_is_transform(item)) {
		const transform t = lower_transform(l, item);
		pattern_state_move(l, s, &t);
		return true;
	}
	switch (item->keyword) {
	case K_TURBULENCE:
		s->turbulence.amount = lower_vector(l, item, 0, "a vector");
		s->has_turbulence = true;
		return true;
	case K_OCTAVES:
		s->turbulence.octaves = lower_octaves(l, item);
		s->has_turbulence = true;
		return true;
	case K_OMEGA:
		s->turbulence.omega = (float)lower_float(l, item, 0, "a number");
		s->has_turbulence = true;
		return true;
	case K_LAMBDA:
		s->turbulence.lambda = (float)lower_float(l, item, 0, "a number");
		s->has_turbulence = true;
		return true;
	case K_FREQUENCY:
		s->frequency = (float)lower_float(l, item, 0, "a number");
		return true;
	case K_PHASE:
		s->phase = (float)lower_float(l, item, 0, "a number");
		return true;
	case K_WARP:
		s->steps = lower_warp(l, item, s->steps);
		return true;
	case K_NOISE_GENERATOR:
		set_noise_generator(l, s, item);
		return true;
	default:
		if (set_wave(l, s, item) || modify_param(l, s, item))
			return true;
		return s->class && form_of(s->class) == name_fractal && modify_fractal(l, s, item);
	}
}

static bool is_refused(enum keyword word)
{
	switch (word) {
#define PATTERN(word, file, form)
#define REFUSED(WORD) case K_##WORD:
#include "texture/patterns.def"
#undef PATTERN
#undef REFUSED
		return true;
	default:
		return false;
	}
}

bool pattern_state_item(struct lowering *l, struct pattern_state *s, const struct node *item,
	const char *block, enum look_form *form)
{
	if (is_refused(item->keyword)) {
		lower_unsupported(l, item, keyword_name(item->keyword));
		*form = FORM_REFUSED;
		return false;
	}
	if (modify(l, s, item))
		return false;
	if (name_pattern(l, s, item))
		return true;
	diag_error(l->diag, item->word, "unexpected %s in %s", keyword_name(item->keyword), block);
	return false;
}

/* ---- building ---- */

/* The sources of all ripples and waves. */
static const struct wave_sources *wave_sources(struct lowering *l)
{
	if (!l->wave_sources)
		l->wave_sources = ARENA_NEW(l->arena, struct wave_sources);
	return l->wave_sources;
}

/* Steps are applied from the newest to the oldest, which is how the chain is linked. */
static void build_steps(struct lowering *l, const struct warp_step *steps, struct pattern *out)
{
	size_t count = 0, transforms = 0;
	transform frame = transform_identity();
	for (const struct warp_step *s = steps; s; s = s->before) {
		count++;
		if (s->place) {
			transforms++;
			frame = transforms == 1 ? *s->place : transform_compose(s->place, &frame);
		}
	}
	if (transforms > 0)
		out->frame = arena_copy(l->arena, &frame, sizeof frame);
	if (count == transforms) {
		out->place = out->frame;
		return;
	}
	struct warp *warps = ARENA_ARRAY(l->arena, count, struct warp);
	size_t i = 0;
	for (const struct warp_step *s = steps; s; s = s->before)
		warps[i++] = s->place ? (struct warp){ warp_transform, s->place } : s->warp;
	out->warps = warps;
	out->warp_count = count;
}

static const void *build_self(struct lowering *l, const struct pattern_state *s)
{
	const char *complaint =
		s->class && s->class->complaint ? s->class->complaint(s->self) : NULL;
	if (complaint)
		diag_error(l->diag, s->word, "%s", complaint);
	if (!s->class || !s->class->build || complaint)
		return s->self;
	void *self = arena_copy(l->arena, s->self, s->class->size);
	s->class->build(self);
	return self;
}

void pattern_build(struct lowering *l, const struct pattern_state *s, struct pattern *out)
{
	*out = (struct pattern){
		.class = s->class,
		.self = build_self(l, s),
		.wave = s->wave,
		.frequency = s->frequency,
		.phase = s->phase,
		.exponent = s->exponent,
		.noise_generator = s->noise_generator,
	};
	if (!s->noise_generator)
		lower_late_generator(l, &out->noise_generator);
	const vec3 amount = s->turbulence.amount;
	if (s->has_turbulence) {
		out->turbulence = arena_copy(l->arena, &s->turbulence, sizeof s->turbulence);
		out->displaces = (amount.x != 0 || amount.y != 0 || amount.z != 0) &&
				 !(s->class && s->class->own_turbulence);
	}
	if (s->class && s->class->needs_wave_sources)
		out->wave_sources = wave_sources(l);
	build_steps(l, s->steps, out);
}
