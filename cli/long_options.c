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

bool read_output(struct options *o, const char *value)
{
	if (!*value)
		return option_error(o, "the name of the picture is empty");
	return option_set(o, "Exact_Output_Name", "on") &&
	       option_set(o, "Output_File_Name", value) && option_set(o, "Output_To_File", "on");
}

bool read_size(struct options *o, const char *value)
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
bool read_antialias(struct options *o, const char *value)
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

bool read_format(struct options *o, const char *value)
{
	struct lambert_format format;
	if (!lambert_format_find(value, &format))
		return option_error(
			o, "the formats are %s, not \"%s\"", formats_names(&o->pool), value);
	return option_set(o, "Output_File_Type", (const char[]){ format.letter, '\0' });
}

bool read_dither(struct options *o, const char *value)
{
	return option_set(o, "Dither", "on") && (!value || option_set(o, "Dither_Method", value));
}

/* A number, or a text without quotes of its own: the shell has taken them. */
bool read_declare(struct options *o, const char *value)
{
	const char *equals = strchr(value, '=');
	float number;
	if (!equals || equals[1] == '"' || option_float(equals + 1, &number))
		return option_set(o, "Declare", value);
	return option_set(o, "Declare",
		text_printf(&o->pool, "%.*s=\"%s\"", (int)(equals - value), value, equals + 1));
}

static const struct option_row *find(const char *name, size_t length)
{
	for (size_t i = 0; i < option_count; i++) {
		const char *own = option_rows[i].name;
		if (own && strlen(own) == length && strncmp(own, name, length) == 0)
			return &option_rows[i];
	}
	return NULL;
}

static bool unknown(const struct options *o, const char *name, size_t length)
{
	const char *best = NULL;
	size_t least = length;
	for (size_t i = 0; i < option_count; i++) {
		const char *own = option_rows[i].name;
		const size_t distance = own ? nearest_distance(name, length, own) : least;
		if (distance < least && nearest_is_near(distance, length)) {
			best = own;
			least = distance;
		}
	}
	return option_error(o, "there is no such option%s%s; see lambert --help",
		best ? "; perhaps --" : "", best ? best : "");
}

/* An option with a sign beside its value is switched on by it. */
static bool apply(struct options *o, const struct option_row *row, const char *value)
{
	if (row->read)
		return row->read(o, value);
	return option_apply(o, row, value ? value : "on", option_has_sign(row), '+');
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
	const struct option_row *option = find(name, length);
	if (!option)
		return unknown(o, name, length);
	const char *value = name[length] ? name + length + 1 : NULL;
	if (value && !option->value)
		return option_error(o, "--%s takes no value", option->name);
	*used = 1;
	if (!value && option->value && *option->value != '[') {
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
