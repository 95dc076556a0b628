/* SPDX-License-Identifier: MIT */
/*
 * From the options of the command line to those of the library: limits, the
 * identifiers that every scene sees, regions.
 */
#include "setup.h"

#include "names.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* More cannot be meant, and would not fit into memory. */
static const double PIXELS_MAX = 1e9;

/* Checks */

static bool is_switched_on(const struct options *o, const struct option_row *row)
{
	return *(const bool *)((const char *)o + row->field);
}

static bool check_refused(const struct options *o)
{
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].use == USE_REFUSED && is_switched_on(o, &option_rows[i]))
			return option_error(o, "not supported yet: %s (switch +%s)",
				option_rows[i].ini, option_rows[i].letters);
	return true;
}

static void note_ignored(struct options *o)
{
	const char *names = "";
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].use == USE_IGNORED && o->set[i] == ORIGIN_USER)
			names = text_printf(
				&o->pool, "%s%s%s", names, *names ? ", " : "", option_rows[i].ini);
	if (*names)
		option_note(o, "without effect here: %s", names);
	if (o->continue_trace)
		option_note(o, "resuming is not built yet: the picture starts from the beginning");
	for (size_t i = 0; i < o->commands.count; i++)
		option_note(o, "shell commands are not run (%s)", o->commands.items[i]);
}

static bool check_numbers(const struct options *o)
{
	if (o->width < 1 || o->height < 1)
		return option_error(o, "a picture of %d x %d has no pixels", o->width, o->height);
	if (options_set(o, "Work_Threads") && o->threads < 1)
		return option_error(
			o, "%d threads render nothing; at least 1 is needed", o->threads);
	if (o->block_size < 4)
		return option_error(
			o, "blocks of %d pixels are too small; 4 is the least", o->block_size);
	return true;
}

/* The scene */

static double six_digits(double value)
{
	char text[64];
	snprintf(text, sizeof text, "%.6g", value);
	return strtod(text, NULL);
}

static bool is_declared(const struct lambert_scene_options *s, const char *name)
{
	for (size_t i = 0; i < s->declaration_count; i++)
		if (strcmp(s->declarations[i].name, name) == 0)
			return true;
	return false;
}

/* The user's declarations, then what every scene sees unless the user declared it. */
static void declare_all(
	struct options *o, const struct frames *f, int frame, struct lambert_scene_options *s)
{
	const struct lambert_declaration built_in[] = {
		{ "image_width", NULL, six_digits(o->width) },
		{ "image_height", NULL, six_digits(o->height) },
		{ "input_file_name", names_file_part(o->input), 0 },
		{ "initial_frame", NULL, six_digits(f->initial) },
		{ "final_frame", NULL, six_digits(f->final) },
		{ "frame_number", NULL, six_digits(frame) },
		{ "initial_clock", NULL,
			f->is_animation ? six_digits((double)o->initial_clock) : 0 },
		{ "final_clock", NULL, f->is_animation ? six_digits((double)o->final_clock) : 0 },
		{ "clock_delta", NULL, six_digits(f->clock_delta) },
	};
	const size_t room = sizeof built_in / sizeof *built_in;
	struct lambert_declaration *all =
		text_alloc(&o->pool, (o->declaration_count + room) * sizeof *all);
	if (o->declaration_count)
		memcpy(all, o->declarations, o->declaration_count * sizeof *all);
	s->declarations = all;
	s->declaration_count = o->declaration_count;
	for (size_t i = 0; i < room; i++)
		if (!is_declared(s, built_in[i].name))
			all[s->declaration_count++] = built_in[i];
}

static int clamp(int v, int low, int high)
{
	return v < low ? low : v > high ? high : v;
}

static double clamp_float(float v, double low, double high)
{
	return fmin(fmax((double)v, low), high);
}

void setup_scene(struct options *o, struct messages *messages, const struct frames *f, int frame,
	struct lambert_scene_options *s)
{
	lambert_scene_options_init(s);
	s->width = (unsigned)o->width;
	s->height = (unsigned)o->height;
	s->library_paths = o->library.items;
	s->library_path_count = o->library.count;
	declare_all(o, f, frame, s);
	s->include_header = o->include_header && *o->include_header ? o->include_header : NULL;
	s->clock = (double)frames_clock(f, o, frame);
	s->clock_on = f->is_animation || options_set(o, "Clock");
	if (options_set(o, "Version"))
		s->version = (unsigned)lround(clamp_float(100 * o->version, 100, 10000));
	s->quality = clamp(o->quality, 0, 9);
	s->frame = (unsigned)frame;
	s->output_alpha = o->output_alpha;
	s->threads = (unsigned)o->threads;
	s->no_file_io = o->no_file_io;
	if (o->loop_limit >= 0)
		s->loop_limit = o->loop_limit;
	s->read_paths = o->read_paths.items;
	s->read_path_count = o->read_paths.count;
	s->write_paths = o->write_paths.items;
	s->write_path_count = o->write_paths.count;
	s->kept_paths = o->ini_files.items;
	s->kept_path_count = o->ini_files.count;
	s->message = messages_take;
	s->text = messages_take_text;
	s->user = messages;
}

/* The region */

/* The first column or row: a share of the size below 1, else a number from 1. */
static double region_start(float v, int size)
{
	return v >= 0 && v < 1 ? floor((double)(v * (float)size)) : trunc((double)v) - 1;
}

/* One past the last: a share up to 1, else a number from 1. */
static double region_end(float v, int size)
{
	return v >= 0 && v <= 1 ? floor((double)(v * (float)size)) : trunc((double)v);
}

static bool check_region(const struct options *o, const double r[4])
{
	static const char *const names[4] = { "left", "top", "right", "bottom" };
	for (int i = 0; i < 4; i++) {
		const int size = i % 2 ? o->height : o->width;
		const bool is_inside = i < 2 ? r[i] >= 0 && r[i] < size : r[i] >= 1 && r[i] <= size;
		if (!is_inside)
			return option_error(o,
				"the %s edge of the region does not lie in the picture of %d x %d",
				names[i], o->width, o->height);
	}
	return true;
}

static bool setup_region(const struct options *o, struct lambert_render_options *render)
{
	const double r[4] = {
		o->has_region ? o->region[0] : region_start(o->start_column, o->width),
		o->has_region ? o->region[1] : region_start(o->start_row, o->height),
		o->has_region		       ? o->region[2]
		: options_set(o, "End_Column") ? region_end(o->end_column, o->width)
					       : o->width,
		o->has_region		    ? o->region[3]
		: options_set(o, "End_Row") ? region_end(o->end_row, o->height)
					    : o->height,
	};
	if (!check_region(o, r))
		return false;
	if (r[0] >= r[2] || r[1] >= r[3])
		return option_error(o, "the region ends before it starts");
	if ((r[2] - r[0]) * (r[3] - r[1]) > PIXELS_MAX)
		return option_error(o, "a picture of %.0f x %.0f pixels is too large", r[2] - r[0],
			r[3] - r[1]);
	render->left = (unsigned)r[0];
	render->top = (unsigned)r[1];
	render->right = (unsigned)r[2];
	render->bottom = (unsigned)r[3];
	return true;
}

bool setup_render(const struct options *o, struct lambert_render_options *render)
{
	lambert_render_options_init(render);
	render->antialias_method = o->antialias ? clamp(o->sampling_method, 0, 2) : 0;
	render->antialias_threshold = clamp_float(o->antialias_threshold, 0, 1);
	render->antialias_depth = clamp(o->antialias_depth, 1, 9);
	render->antialias_jitter = o->jitter ? clamp_float(o->jitter_amount, 0, 1) : 0;
	render->antialias_gamma = (double)o->antialias_gamma;
	render->block_size = (unsigned)o->block_size;
	render->threads = (unsigned)o->threads;
	return setup_region(o, render);
}

bool setup_check(struct options *o)
{
	if (!o->input)
		return option_error(o, "no scene is given; try: lambert scene.pov -o picture.png "
				       "(see lambert --help)");
	struct lambert_render_options unused;
	if (!check_numbers(o) || !check_refused(o) || !setup_render(o, &unused))
		return false;
	note_ignored(o);
	return true;
}

bool setup_output(struct options *o, struct lambert_output_options *output)
{
	lambert_output_options_init(output);
	struct lambert_format format;
	if (!names_format(o, &format))
		return false;
	output->format = format.name;
	output->bits = clamp(o->bits, 5, 16);
	output->grayscale = o->grayscale;
	output->alpha = o->output_alpha;
	output->file_gamma = (double)o->file_gamma;
	if (o->dither)
		output->dither = o->dither_method;
	output->quality = o->compression < 2 ? 0 : clamp(o->compression, 2, 100);
	return true;
}
