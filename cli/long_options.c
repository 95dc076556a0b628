/* SPDX-License-Identifier: MIT */
/*
 * lambert's own options: --name, --name=value or --name value, and -o file. Most
 * are another spelling of a POV-Ray option and go through its row of the table.
 */
#include "formats.h"
#include "nearest.h"
#include "options.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum takes { TAKES_NOTHING, TAKES_VALUE, MAY_TAKE_VALUE };

struct long_option {
	const char *name;
	enum takes takes;
	const char *ini; /* with `apply` NULL: the POV-Ray option it stands for */
	bool (*apply)(struct options *, const char *value); /* value NULL: none given */
};

static bool apply_output(struct options *o, const char *value)
{
	if (!*value)
		return option_error(o, "the name of the picture is empty");
	return option_set(o, "Exact_Output_Name", "on") &&
	       option_set(o, "Output_File_Name", value) && option_set(o, "Output_To_File", "on");
}

static bool apply_size(struct options *o, const char *value)
{
	const size_t width = strspn(value, "0123456789");
	const char *height = value + width + 1;
	if (strspn(value, "0") == width || !value[width] || !strchr("xX", value[width]) ||
		!height[strspn(height, "0")] || height[strspn(height, "0123456789")])
		return option_error(o, "a size is like 640x480, not \"%s\"", value);
	return option_set(o, "Width", text_copy(&o->pool, value, width)) &&
	       option_set(o, "Height", height);
}

/* METHOD[:THRESHOLD[:DEPTH]] */
static bool apply_antialias(struct options *o, const char *value)
{
	static const char *const names[] = { "Sampling_Method", "Antialias_Threshold",
		"Antialias_Depth" };
	const char *part = value;
	for (size_t i = 0; part; i++) {
		const size_t length = strcspn(part, ":");
		if (i == 3 || !length || strspn(part, "0123456789.") != length)
			return option_error(o,
				"antialiasing is METHOD[:THRESHOLD[:DEPTH]], method 1 or 2, like "
				"2:0.1:4, not \"%s\"",
				value);
		if (!option_set(o, names[i], text_copy(&o->pool, part, length)))
			return false;
		part = part[length] ? part + length + 1 : NULL;
	}
	return option_set(o, "Antialias", "on");
}

static bool apply_jitter(struct options *o, const char *value)
{
	return option_set(o, "Jitter", "on") && option_set(o, "Jitter_Amount", value);
}

static bool apply_format(struct options *o, const char *value)
{
	struct lambert_format format;
	if (!lambert_format_find(value, &format))
		return option_error(
			o, "the formats are %s, not \"%s\"", formats_names(&o->pool), value);
	return option_set(o, "Output_File_Type", (const char[]){ format.letter, '\0' });
}

static bool apply_dither(struct options *o, const char *value)
{
	return option_set(o, "Dither", "on") && (!value || option_set(o, "Dither_Method", value));
}

/* A number, or a text without quotes of its own: the shell has taken them. */
static bool apply_declare(struct options *o, const char *value)
{
	const char *equals = strchr(value, '=');
	float number;
	if (!equals || equals[1] == '"' || option_float(equals + 1, &number))
		return option_set(o, "Declare", value);
	return option_set(o, "Declare",
		text_printf(&o->pool, "%.*s=\"%s\"", (int)(equals - value), value, equals + 1));
}

// clang-format off
static const struct long_option long_options[] = {
	{ "allow-read",       TAKES_VALUE,    "Allow_Read",        NULL },
	{ "allow-write",      TAKES_VALUE,    "Allow_Write",       NULL },
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
	{ "json",             TAKES_NOTHING,  "Json_Messages",     NULL },
	{ "language-version", TAKES_VALUE,    "Version",           NULL },
	{ "loop-limit",       TAKES_VALUE,    "Loop_Limit",        NULL },
	{ "no-file-io",       TAKES_NOTHING,  "No_File_IO",        NULL },
	{ "output",           TAKES_VALUE,    NULL,                apply_output },
	{ "progress",         TAKES_VALUE,    "Progress",          NULL },
	{ "quality",          TAKES_VALUE,    "Quality",           NULL },
	{ "quiet",            TAKES_NOTHING,  "Quiet",             NULL },
	{ "region",           TAKES_VALUE,    "Region",            NULL },
	{ "size",             TAKES_VALUE,    NULL,                apply_size },
	{ "stats",            TAKES_VALUE,    "Statistics_To",     NULL },
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

static bool unknown(const struct options *o, const char *name, size_t length)
{
	const struct long_option *best = NULL;
	size_t least = length;
	for (size_t i = 0; i < sizeof long_options / sizeof *long_options; i++) {
		const size_t distance = nearest_distance(name, length, long_options[i].name);
		if (nearest_is_near(distance, length) && distance < least) {
			best = &long_options[i];
			least = distance;
		}
	}
	return option_error(o, "there is no such option%s%s; see lambert --help",
		best ? "; perhaps --" : "", best ? best->name : "");
}

static bool apply(struct options *o, const struct long_option *option, const char *value)
{
	if (option->apply)
		return option->apply(o, value);
	return option_set(o, option->ini, option->takes == TAKES_NOTHING ? "on" : value);
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
		return unknown(o, name, length);
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
	o->strict = true;
	const bool ok = apply(o, option, value);
	o->strict = false;
	return ok;
}
