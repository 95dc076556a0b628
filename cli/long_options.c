/* SPDX-License-Identifier: MIT */
/*
 * lambert's own options: --name, --name=value or --name value, and -o file. Most
 * are another spelling of a POV-Ray option and go through its row of the table.
 */
#include "options.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum takes { TAKES_NOTHING, TAKES_VALUE, MAY_TAKE_VALUE };

struct long_option {
	const char *name;
	enum takes takes;
	const char *ini; /* with `apply` NULL: the POV-Ray option it stands for */
	bool (*apply)(struct options *, const char *value); /* value NULL: none given */
};

static bool set(struct options *o, const char *ini, const char *value)
{
	return option_apply(o, option_find(ini, strlen(ini)), value, false, '+');
}

static bool apply_output(struct options *o, const char *value)
{
	if (!*value)
		return option_error(o, "the name of the picture is empty");
	o->output_is_exact = true;
	return set(o, "Output_File_Name", value) && set(o, "Output_To_File", "on");
}

static bool apply_size(struct options *o, const char *value)
{
	int end = 0;
	if (sscanf(value, "%d%*1[xX]%d%n", &o->width, &o->height, &end) != 2 || value[end] ||
		o->width < 1 || o->height < 1)
		return option_error(o, "a size is like 640x480, not \"%s\"", value);
	char width[16], height[16];
	snprintf(width, sizeof width, "%d", o->width);
	snprintf(height, sizeof height, "%d", o->height);
	return set(o, "Width", width) && set(o, "Height", height);
}

static bool apply_region(struct options *o, const char *value)
{
	int *r = o->region, end = 0;
	if (sscanf(value, "%d,%d,%d,%d%n", &r[0], &r[1], &r[2], &r[3], &end) != 4 || value[end])
		return option_error(o,
			"a region is LEFT,TOP,RIGHT,BOTTOM in pixels from 0, right and bottom one "
			"past the last, not \"%s\"",
			value);
	o->has_region = true;
	return true;
}

/* METHOD[:THRESHOLD[:DEPTH]] */
static bool apply_antialias(struct options *o, const char *value)
{
	o->antialias = true;
	if (!value)
		return true;
	int method = 0, depth = 3, end = 0;
	float threshold = 0.3f;
	const int n =
		sscanf(value, "%d%n:%f%n:%d%n", &method, &end, &threshold, &end, &depth, &end);
	if (n < 1 || value[end] || method < 0 || method > 2)
		return option_error(o,
			"antialiasing is METHOD[:THRESHOLD[:DEPTH]], method 1 or 2, like 2:0.1:4, "
			"not "
			"\"%s\"",
			value);
	o->sampling_method = method;
	if (n > 1)
		o->antialias_threshold = threshold;
	if (n > 2)
		o->antialias_depth = depth;
	return true;
}

static bool apply_jitter(struct options *o, const char *value)
{
	o->jitter = true;
	return set(o, "Jitter_Amount", value);
}

static bool apply_format(struct options *o, const char *value)
{
	static const struct {
		const char *name, *letter;
	} formats[] = {
		{ "png", "N" },
		{ "ppm", "P" },
		{ "tga", "C" },
		{ "bmp", "B" },
		{ "jpeg", "J" },
		{ "jpg", "J" },
		{ "exr", "E" },
		{ "hdr", "H" },
		{ "tiff", "F" },
		{ "tif", "F" },
	};
	for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
		if (strcasecmp(value, formats[i].name) == 0)
			return set(o, "Output_File_Type", formats[i].letter);
	return option_error(o,
		"the formats are png, ppm, tga, bmp, jpeg, exr, hdr and tiff, not \"%s\"", value);
}

static bool apply_dither(struct options *o, const char *value)
{
	o->dither = true;
	return set(o, "Dither", "on") && (!value || set(o, "Dither_Method", value));
}

static bool apply_progress(struct options *o, const char *value)
{
	if (strcmp(value, "bar") != 0 && strcmp(value, "lines") != 0 && strcmp(value, "off") != 0)
		return option_error(o, "progress is shown as bar, lines or off, not \"%s\"", value);
	o->progress = value;
	return true;
}

static bool apply_stats(struct options *o, const char *value)
{
	o->stats_file = value;
	return true;
}

static bool apply_quiet(struct options *o, const char *value)
{
	(void)value;
	o->quiet = true;
	return true;
}

static bool apply_json(struct options *o, const char *value)
{
	(void)value;
	o->json = true;
	return true;
}

static bool apply_no_file_io(struct options *o, const char *value)
{
	(void)value;
	o->no_file_io = true;
	return true;
}

static bool apply_allow_read(struct options *o, const char *value)
{
	text_list_add(&o->pool, &o->read_paths, value);
	return true;
}

static bool apply_allow_write(struct options *o, const char *value)
{
	text_list_add(&o->pool, &o->write_paths, value);
	return true;
}

static bool apply_loop_limit(struct options *o, const char *value)
{
	char *end;
	o->loop_limit = strtod(value, &end);
	if (end == value || *end || !(o->loop_limit >= 0))
		return option_error(o, "--loop-limit takes a number of tokens, not \"%s\"", value);
	return true;
}

/* A number, or a text without quotes of its own: the shell has taken them. */
static bool apply_declare(struct options *o, const char *value)
{
	const char *equals = strchr(value, '=');
	float number;
	if (!equals || equals[1] == '"' || option_float(equals + 1, &number))
		return set(o, "Declare", value);
	return set(o, "Declare",
		text_printf(&o->pool, "%.*s=\"%s\"", (int)(equals - value), value, equals + 1));
}

// clang-format off
static const struct long_option long_options[] = {
	{ "allow-read",       TAKES_VALUE,    NULL,                apply_allow_read },
	{ "allow-write",      TAKES_VALUE,    NULL,                apply_allow_write },
	{ "alpha",            TAKES_NOTHING,  "Output_Alpha",      NULL },
	{ "antialias",        MAY_TAKE_VALUE, NULL,                apply_antialias },
	{ "bits",             TAKES_VALUE,    "Bits_Per_Color",    NULL },
	{ "clock",            TAKES_VALUE,    "Clock",             NULL },
	{ "declare",          TAKES_VALUE,    NULL,                apply_declare },
	{ "dither",           MAY_TAKE_VALUE, NULL,                apply_dither },
	{ "format",           TAKES_VALUE,    NULL,                apply_format },
	{ "gamma",            TAKES_VALUE,    "File_Gamma",        NULL },
	{ "grayscale",        TAKES_NOTHING,  "Grayscale_Output",  NULL },
	{ "include-path",     TAKES_VALUE,    "Library_Path",      NULL },
	{ "ini",              TAKES_VALUE,    "Include_Ini",       NULL },
	{ "input",            TAKES_VALUE,    "Input_File_Name",   NULL },
	{ "jitter",           TAKES_VALUE,    NULL,                apply_jitter },
	{ "json",             TAKES_NOTHING,  NULL,                apply_json },
	{ "language-version", TAKES_VALUE,    "Version",           NULL },
	{ "loop-limit",       TAKES_VALUE,    NULL,                apply_loop_limit },
	{ "no-file-io",       TAKES_NOTHING,  NULL,                apply_no_file_io },
	{ "output",           TAKES_VALUE,    NULL,                apply_output },
	{ "progress",         TAKES_VALUE,    NULL,                apply_progress },
	{ "quality",          TAKES_VALUE,    "Quality",           NULL },
	{ "quiet",            TAKES_NOTHING,  NULL,                apply_quiet },
	{ "region",           TAKES_VALUE,    NULL,                apply_region },
	{ "size",             TAKES_VALUE,    NULL,                apply_size },
	{ "stats",            TAKES_VALUE,    NULL,                apply_stats },
	{ "threads",          TAKES_VALUE,    "Work_Threads",      NULL },
};
// clang-format on

static const struct long_option *find(const char *name, size_t length)
{
	for (size_t i = 0; i < sizeof long_options / sizeof *long_options; i++)
		if (strlen(long_options[i].name) == length &&
			strncmp(long_options[i].name, name, length) == 0)
			return &long_options[i];
	return NULL;
}

static bool apply(struct options *o, const struct long_option *option, const char *value)
{
	if (option->apply)
		return option->apply(o, value);
	return set(o, option->ini, option->takes == TAKES_NOTHING ? "on" : value);
}

bool long_option_read(struct options *o, int argc, char **argv, int *used)
{
	const char *argument = argv[0];
	const bool is_short = strcmp(argument, "-o") == 0;
	*used = 0;
	if (!is_short && strncmp(argument, "--", 2) != 0)
		return true;
	const char *name = is_short ? "output" : argument + 2;
	const size_t length = strcspn(name, "=");
	const struct long_option *option = find(name, length);
	if (!option)
		return option_error(o, "there is no such option; see lambert --help");
	const char *value = name[length] ? name + length + 1 : NULL;
	if (value && option->takes == TAKES_NOTHING)
		return option_error(o, "--%s takes no value", option->name);
	*used = 1;
	if (!value && option->takes == TAKES_VALUE) {
		if (argc < 2)
			return option_error(o, "a value is missing after it");
		value = argv[1];
		*used = 2;
	}
	return apply(o, option, value);
}
