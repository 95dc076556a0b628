/* SPDX-License-Identifier: MIT */
/*
 * global_settings { … } and what is settled at the end of the scene.
 */
#include "lower/draft.h"

#include "noise/noise.h"

enum { TRACE_LEVEL_MAX = 256 };

static void set_trace_level(struct lowering *l, const struct node *item)
{
	int level = lower_int(l, item, 0, "a number");
	if (level > TRACE_LEVEL_MAX) {
		diag_warning(l->diag, item->span,
			"max_trace_level %d is above the limit: %d is used", level,
			TRACE_LEVEL_MAX);
		level = TRACE_LEVEL_MAX;
	}
	l->scene->settings.max_trace_level = level < 1 ? 1 : level;
}

/* Items that only matter to what is refused elsewhere, are read by others, or have no effect. */
static bool is_read_elsewhere(enum keyword k)
{
	switch (k) {
	case K_ASSUMED_GAMMA:	/* the parser: it decides what srgb colours are */
	case K_NOISE_GENERATOR: /* the parser, for the language state */
	case K_CHARSET:
	case K_MM_PER_UNIT: /* of subsurface */
	case K_SUBSURFACE:  /* refused in the finish that uses it */
		return true;
	default:
		return false;
	}
}

static void set_wave_count(struct lowering *l, const struct node *item)
{
	l->wave_count = lower_float(l, item, 0, "a number");
	if (l->wave_count >= 1)
		return;
	diag_warning(l->diag, item->span, "number_of_waves must be at least 1: 1 is used");
	l->wave_count = 1;
}

void lower_setting(struct lowering *l, const struct node *item)
{
	struct settings *s = &l->scene->settings;
	switch (item->keyword) {
	case K_ADC_BAILOUT:
		s->adc_bailout = (float)lower_float(l, item, 0, "a number");
		break;
	case K_AMBIENT_LIGHT:
		s->ambient_light = lower_rgb(l, item, 0, "a colour");
		break;
	case K_IRID_WAVELENGTH:
		s->irid_wavelength = lower_rgb(l, item, 0, "a colour");
		break;
	case K_MAX_TRACE_LEVEL:
		set_trace_level(l, item);
		break;
	case K_HF_GRAY_16:
		diag_warning(l->diag, item->word,
			"hf_gray_16 has no effect: ask for grayscale output instead");
		break;
	case K_MAX_INTERSECTIONS:
		if (item->state->version >= 370)
			diag_warning(l->diag, item->word, "max_intersections has no effect");
		break;
	case K_NUMBER_OF_WAVES:
		set_wave_count(l, item);
		break;
	case K_RADIOSITY:
		l->has_radiosity = true;
		if (s->quality >= 9)
			lower_unsupported(l, item, "radiosity");
		break;
	case K_PHOTONS:
		l->photons = item->word;
		l->has_photons |= node_child(item, K_LOAD_FILE) || node_child(item, K_SAVE_FILE);
		break;
	default:
		if (!is_read_elsewhere(item->keyword))
			lower_unsupported(l, item, keyword_name(item->keyword));
	}
}

void lower_global_settings(struct lowering *l, const struct node *n)
{
	for (const struct node *item = n->children; item; item = item->next)
		lower_setting(l, item);
}

/* The curve between the numbers of the scene and linear light. */
static struct working_space working_space_of(const struct language_state *state, int option_version)
{
	if (state->assumed_gamma < 0)
		return (struct working_space){ TRANSFER_SRGB, 0 };
	if (state->assumed_gamma > 0) {
		/* a power within 1 % of 1 counts as linear */
		if (fabsf(1 - 1 / state->assumed_gamma) <= 0.01f)
			return (struct working_space){ TRANSFER_LINEAR, 1 };
		return (struct working_space){ TRANSFER_POWER, state->assumed_gamma };
	}
	const int version = state->version_set ? state->version : 362;
	if (version < 370 && option_version < 370)
		return (struct working_space){ TRANSFER_NONE, 0 };
	return (struct working_space){ TRANSFER_LINEAR, 1 };
}

void settings_begin(struct lowering *l)
{
	l->scene->settings = (struct settings){
		.max_trace_level = 5,
		.adc_bailout = 1.0f / 255,
		.ambient_light = { 1, 1, 1 },
		.irid_wavelength = { 0.70f, 0.52f, 0.48f },
		.quality = l->options->quality,
		.frame = l->options->frame,
		.output_alpha = l->options->output_alpha,
	};
	/* without a background statement: nothing, which is transparent if alpha is wanted */
	l->scene->background = (colour){ 0, 0, 0, 0, l->options->output_alpha ? 1.0f : 0.0f };
}

void lower_late_generator(struct lowering *l, int *generator)
{
	if (l->generator_count == l->generator_room) {
		l->generator_room = l->generator_room ? 2 * l->generator_room : 64;
		l->generators = memory_grow(l->generators, l->generator_room, sizeof(int *));
	}
	l->generators[l->generator_count++] = generator;
}

static void settle_waves(struct lowering *l)
{
	const double count = l->wave_count;
	if (l->wave_sources && !l->wave_sources->items)
		*l->wave_sources = wave_sources_make(
			l->arena, count >= 1 ? count < 1e6 ? (size_t)count : 1000000 : 1);
}

/* Photons are shot at targets only: without one, or a file of them, the setting changes nothing. */
void lower_photons_end(struct lowering *l)
{
	if (l->photons.source && l->has_photons && l->scene->settings.quality >= 9)
		diag_unsupported(l->diag, l->photons, "photons");
}

void lowering_settle(struct lowering *l, const struct language_state *final)
{
	struct settings *s = &l->scene->settings;
	const int version = final->version_set ? final->version : 362;
	s->version = version < 350 ? 350 : version;
	s->working = working_space_of(final, l->options->working_version);
	s->noise_generator = final->noise_generator  ? final->noise_generator
			     : final->version >= 350 ? 2
						     : 1;
	while (l->generator_count)
		*l->generators[--l->generator_count] = s->noise_generator;
	settle_waves(l);
}
