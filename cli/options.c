/* SPDX-License-Identifier: MIT */
/*
 * The table of options and how their values are read. All peculiarities are
 * POV-Ray's: a truth value is true when it begins like one, a number ends at the
 * first character that does not belong to it, the first Declare of a name wins.
 */
#include "options.h"

#include "formats.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#define ROW(ini, letters, kind, field, sign, use, low, high)                                       \
	ini, letters, KIND_##kind, offsetof(struct options, field),                                \
		offsetof(struct options, sign), USE_##use, low, high
#define OPTION(...) { ROW(__VA_ARGS__), NULL, NULL, 0, NULL, "", NULL },
#define NAMED(ini, letters, kind, field, sign, use, low, high, name, value, shown, help)           \
	{ ROW(ini, letters, kind, field, sign, use, low, high), name, value, shown, help, "",      \
		NULL },
#define OWN(name, letter, value, shown, read, help)                                                \
	{ ROW("", "", BOOL, ignored_bool, none, QUIET, 0, 0), name, value, shown, help, letter,    \
		read },
const struct option_row option_rows[] = {
#include "options.def"
};
#undef ROW
#undef OPTION
#undef NAMED
#undef OWN
const size_t option_count = sizeof option_rows / sizeof *option_rows;
_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTION_MAX, "raise OPTION_MAX");

static const size_t NOWHERE = offsetof(struct options, none);

/* The names that file options stand for when their value is "on". */
static const char *const usual_file[STREAM_COUNT] = {
	[STREAM_ALL] = "alltext.out",
	[STREAM_DEBUG] = "debug.out",
	[STREAM_FATAL] = "fatal.out",
	[STREAM_RENDER] = "render.out",
	[STREAM_STATISTIC] = "stats.out",
	[STREAM_WARNING] = "warning.out",
};

void options_init(struct options *o)
{
	*o = (struct options){
		.width = 160,
		.height = 120,
		.output_to_file = true,
		.bits = 8,
		.dither_method = "FS",
		.quality = 9,
		.jitter = true,
		.sampling_method = 1,
		.antialias_depth = 3,
		.block_size = 32,
		.antialias_threshold = 0.3f,
		.antialias_gamma = 2.5f,
		.jitter_amount = 1,
		.loop_limit = -1,
		.frame_step = 1,
		.final_clock = 1,
		.all_console = true,
		.verbose = true,
		.display = true,
	};
	for (int i = 0; i < STREAM_COUNT; i++)
		o->console[i] = true;
}

void options_finish(struct options *o)
{
	text_pool_finish(&o->pool);
}

/* Messages */

static void complain(const struct options *o, const char *kind, const char *format, va_list args)
{
	const struct option_place *p = &o->place;
	struct text_pool pool = { 0 };
	const char *where = p->file ? text_printf(&pool, "%s:%u: %s: ", p->file, p->line, kind)
			    : p->text
				    ? text_printf(&pool, "lambert: %s: argument %d, \"%s\": ", kind,
					      p->argument, p->text)
				    : text_printf(&pool, "lambert: %s: ", kind);
	text_show(stderr, where);
	text_show(stderr, text_vprintf(&pool, format, args));
	fputc('\n', stderr);
	text_pool_finish(&pool);
}

bool option_error(const struct options *o, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	complain(o, "error", format, args);
	va_end(args);
	return false;
}

void option_warning(const struct options *o, const char *format, ...)
{
	if (o->quiet)
		return;
	va_list args;
	va_start(args, format);
	complain(o, "warning", format, args);
	va_end(args);
}

void option_note(const struct options *o, const char *format, ...)
{
	if (o->quiet)
		return;
	va_list args;
	va_start(args, format);
	complain(o, "note", format, args);
	va_end(args);
}

/* The table */

const struct option_row *option_find(const char *name, size_t length)
{
	for (size_t i = 0; i < option_count; i++)
		if (length && strlen(option_rows[i].ini) == length &&
			strncasecmp(option_rows[i].ini, name, length) == 0)
			return &option_rows[i];
	return NULL;
}

enum origin options_set(const struct options *o, const char *ini_name)
{
	const struct option_row *row = option_find(ini_name, strlen(ini_name));
	return row ? (enum origin)o->set[row - option_rows] : ORIGIN_NOBODY;
}

bool option_set(struct options *o, const char *ini_name, const char *value)
{
	return option_apply(o, option_find(ini_name, strlen(ini_name)), value, false, '+');
}

/* Values */

bool option_float(const char *text, float *value)
{
	const char *p = text + strspn(text, " \t");
	const char *digits = p + (*p == '+' || *p == '-');
	if (!isdigit((unsigned char)digits[*digits == '.']))
		return false;
	*value = strtof(p, NULL);
	return true;
}

bool option_int(const char *text, int *value)
{
	char *end;
	const long v = strtol(text, &end, 10);
	*value = v > 2147483647 ? 2147483647 : v < -2147483647 ? -2147483647 : (int)v;
	return end != text;
}

/* Says that a number is not what it seems; false where that is an error. */
static bool doubt(const struct options *o, const char *text)
{
	if (o->strict)
		return option_error(o, "%s", text);
	option_warning(o, "%s", text);
	return true;
}

/* What is behind the number does not count. */
static bool check_rest(struct options *o, const struct option_row *row, const char *value)
{
	char *end;
	if (row->kind == KIND_INT)
		(void)strtol(value, &end, 10);
	else
		(void)strtof(value, &end);
	end += strspn(end, " \t");
	if (!*end)
		return true;
	return doubt(
		o, text_printf(&o->pool, "of \"%s\" only %.*s counts%s", value, (int)(end - value),
			   value, row->kind == KIND_INT ? "; it is a whole number" : ""));
}

static bool check_range(
	struct options *o, const struct option_row *row, const char *value, double number)
{
	if (row->low >= row->high || (number >= row->low && number <= row->high))
		return true;
	const double counts = number < row->low ? row->low : row->high;
	return doubt(o, text_printf(&o->pool, "%s goes from %g to %g; %s %s%g", row->ini, row->low,
				row->high, value, o->strict ? "is beyond " : "counts as ", counts));
}

/* Options that are ignored may have any value. */
static bool apply_int(struct options *o, const struct option_row *row, const char *value)
{
	int number;
	if (!option_int(value, &number))
		return option_error(o, "%s needs a number, not \"%s\"", row->ini, value);
	if (row->use == USE_USED && (number == 2147483647 || number == -2147483647))
		return option_error(o, "%s: %s is too large a number", row->ini, value);
	*(int *)((char *)o + row->field) = number;
	return check_rest(o, row, value) && check_range(o, row, value, number);
}

static bool apply_float(struct options *o, const struct option_row *row, const char *value)
{
	float number;
	if (!option_float(value, &number))
		return option_error(o, "%s needs a number, not \"%s\"", row->ini, value);
	*(float *)((char *)o + row->field) = number;
	return check_rest(o, row, value) && check_range(o, row, value, (double)number);
}

static bool apply_count(struct options *o, const struct option_row *row, const char *value)
{
	char *end;
	const double number = strtod(value, &end);
	*(double *)((char *)o + row->field) = number;
	return (end != value && !*end && number >= 0) ||
	       option_error(o, "%s needs a number of 0 or more, not \"%s\"", row->ini, value);
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

static bool apply_progress(struct options *o, const char *value)
{
	if (strcmp(value, "bar") != 0 && strcmp(value, "lines") != 0 && strcmp(value, "off") != 0)
		return option_error(o, "progress is shown as bar, lines or off, not \"%s\"", value);
	o->progress = text_copy(&o->pool, value, strlen(value));
	return true;
}

static bool is_true(const char *value)
{
	static const char *const words[] = { "on", "true", "yes", "1" };
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		const size_t n = strlen(words[i]), m = strlen(value);
		if (strncasecmp(value, words[i], n < m ? n : m) == 0)
			return true;
	}
	return false;
}

/* Letter, then in switches a depth or g. */
static bool apply_type(struct options *o, const char *value, bool is_switch)
{
	const char letter = (char)toupper((unsigned char)*value);
	struct lambert_format format;
	if (!letter || !formats_find_letter(letter, &format))
		return option_error(
			o, "there is no file type \"%s\"; %s", value, formats_letters(&o->pool));
	o->output_type = letter;
	if (!is_switch || !value[1])
		return true;
	if (tolower((unsigned char)value[1]) == 'g' && !value[2]) {
		return option_set(o, "Grayscale_Output", "on");
	}
	if (value[1 + strspn(value + 1, "0123456789")])
		return option_error(o,
			"after the file type stands a number of bits or g for grayscale, not "
			"\"%s\"",
			value + 1);
	return option_set(o, "Bits_Per_Color", value + 1);
}

static bool apply_dither(struct options *o, const char *value)
{
	const char *name;
	for (size_t i = 0; (name = lambert_dither_name(i)); i++) {
		if (strcasecmp(value, name) == 0) {
			o->dither_method = name;
			return true;
		}
	}
	return option_error(
		o, "there is no dithering \"%s\"; there are %s", value, formats_dithers(&o->pool));
}

static bool apply_gamma(struct options *o, const struct option_row *row, const char *value)
{
	float gamma = 0;
	if (strcasecmp(value, "sRGB") != 0 && (!option_float(value, &gamma) || !(gamma >= 0.001f)))
		return option_error(o, "a gamma is a positive number or sRGB, not \"%s\"", value);
	*(float *)((char *)o + row->field) = gamma;
	return true;
}

static bool same_path(const char *a, const char *b)
{
	for (;;) {
		while (*a == '/' && (a[1] == '/' || !a[1]))
			a++;
		while (*b == '/' && (b[1] == '/' || !b[1]))
			b++;
		if (*a != *b || !*a)
			return *a == *b;
		a++;
		b++;
	}
}

static void add_library(struct options *o, const char *path)
{
	for (size_t i = 0; i < o->library.count; i++)
		if (same_path(o->library.items[i], path))
			return;
	text_list_add(&o->pool, &o->library, path);
}

/* Folders of the default INI file are nobody's wish of today. */
static bool check_folder(struct options *o, const char *path)
{
	struct stat s;
	if (o->origin != ORIGIN_USER || (stat(path, &s) == 0 && S_ISDIR(s.st_mode)))
		return true;
	return doubt(o, text_printf(&o->pool, "there is no folder %s", path));
}

static bool is_identifier(const char *name)
{
	if (!isalpha((unsigned char)*name) && *name != '_')
		return false;
	while (isalnum((unsigned char)*name) || *name == '_')
		name++;
	return !*name;
}

/* A number has six significant digits for the scene. */
static double six_digits(float value)
{
	char text[64];
	snprintf(text, sizeof text, "%.6g", (double)value);
	return strtod(text, NULL);
}

static void add_declaration(struct options *o, struct lambert_declaration d)
{
	for (size_t i = 0; i < o->declaration_count; i++)
		if (strcmp(o->declarations[i].name, d.name) == 0)
			return;
	struct lambert_declaration *grown =
		text_alloc(&o->pool, (o->declaration_count + 1) * sizeof *grown);
	if (o->declaration_count)
		memcpy(grown, o->declarations, o->declaration_count * sizeof *grown);
	grown[o->declaration_count++] = d;
	o->declarations = grown;
}

static bool apply_declare(struct options *o, const char *value)
{
	const char *equals = strchr(value, '=');
	if (!equals || equals == value || !equals[1])
		return option_error(o,
			"a declaration is name=number or name=\"text\" (quoted once more: "
			"'name=\"text\"'), not \"%s\"",
			value);
	struct lambert_declaration d = { .name = text_copy(
						 &o->pool, value, (size_t)(equals - value)) };
	const char *text = equals + 1;
	float number = 0;
	if (*text == '"') {
		const size_t length = strcspn(text + 1, "\"");
		d.string = text_copy(&o->pool, text + 1, length);
	} else {
		if (!option_float(text, &number))
			option_note(o, "\"%s\" is no number; %s is 0", text, d.name);
		d.number = six_digits(number);
	}
	if (!is_identifier(d.name) || strcmp(d.name, "clock") == 0)
		option_note(o, "a scene cannot see a declaration of \"%s\"", d.name);
	else
		add_declaration(o, d);
	return true;
}

static const char *file_name(
	const struct options *o, const struct option_row *row, const char *value)
{
	const char *const *slot = (const char *const *)(const void *)((const char *)o + row->field);
	return is_true(value) ? usual_file[slot - o->stream_file] : value;
}

static bool apply_retired(struct options *o, const struct option_row *row)
{
	if (!o->place.file)
		return option_error(o, "%s no longer exists", row->ini);
	option_note(o, "%s no longer exists and is ignored", row->ini);
	return true;
}

static bool apply_value(
	struct options *o, const struct option_row *row, const char *value, bool is_switch)
{
	void *field = (char *)o + row->field;
	switch (row->kind) {
	case KIND_BOOL:
		*(bool *)field = is_true(value);
		return true;
	case KIND_INT:
		return apply_int(o, row, value);
	case KIND_FLOAT:
		return apply_float(o, row, value);
	case KIND_COUNT:
		return apply_count(o, row, value);
	case KIND_REGION:
		return apply_region(o, value);
	case KIND_PROGRESS:
		return apply_progress(o, value);
	case KIND_TEXT:
		*(const char **)field = text_copy(&o->pool, value, strlen(value));
		return true;
	case KIND_FILE:
		value = file_name(o, row, value);
		*(const char **)field = text_copy(&o->pool, value, strlen(value));
		return true;
	case KIND_TYPE:
		return apply_type(o, value, is_switch);
	case KIND_DITHER:
		return apply_dither(o, value);
	case KIND_GAMMA:
		return apply_gamma(o, row, value);
	case KIND_LIBRARY:
		if (!check_folder(o, value))
			return false;
		add_library(o, text_copy(&o->pool, value, strlen(value)));
		return true;
	case KIND_FOLDERS:
		text_list_add(&o->pool, field, text_copy(&o->pool, value, strlen(value)));
		return true;
	case KIND_DECLARE:
		return apply_declare(o, value);
	case KIND_INI:
		return ini_read(o, value);
	case KIND_COMMAND:
		if (*value)
			text_list_add(&o->pool, &o->commands,
				text_printf(&o->pool, "%s: %s", row->ini, value));
		return true;
	case KIND_RETIRED:
		return apply_retired(o, row);
	}
	return false;
}

static void note_set(struct options *o, const struct option_row *row, const char *value)
{
	o->set[row - option_rows] = (unsigned char)o->origin;
	o->given[row - option_rows] = text_copy(&o->pool, value, strlen(value));
}

/* The option that a sign switches beside its value. */
static void apply_sign(struct options *o, size_t field, bool on)
{
	*(bool *)((char *)o + field) = on;
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].kind == KIND_BOOL && option_rows[i].field == field)
			note_set(o, &option_rows[i], on ? "On" : "Off");
}

bool option_has_sign(const struct option_row *row)
{
	return row->sign != NOWHERE;
}

bool option_apply(struct options *o, const struct option_row *row, const char *value,
	bool is_switch, char sign)
{
	if (is_switch && row->kind == KIND_BOOL) {
		apply_sign(o, row->field, sign == '+');
		return true;
	}
	if (!apply_value(o, row, value, is_switch))
		return false;
	note_set(o, row, value);
	if (is_switch && option_has_sign(row))
		apply_sign(o, row->sign, sign == '+');
	return true;
}

bool option_scene(struct options *o, const char *name)
{
	if (o->scene_named && !o->place.file)
		return option_error(o, "one scene at a time: %s was named before", o->input);
	o->scene_named = !o->place.file;
	return option_set(o, "Input_File_Name", name);
}

/* Everything */

static bool read_argument(struct options *o, int argc, char **argv, int *used)
{
	*used = 1;
	if (strcmp(argv[0], "-") == 0)
		return option_scene(o, argv[0]);
	if (!long_option_read(o, argc, argv, used))
		return false;
	if (*used)
		return true;
	*used = 1;
	return switches_read(o, argv[0], false);
}

/* Behind "--" there are only scenes, whatever they look like. */
static bool read_arguments(struct options *o, int argc, char **argv)
{
	bool only_scenes = false;
	for (int i = 0, used = 1; i < argc; i += used) {
		o->place = (struct option_place){ .argument = i + 1, .text = argv[i] };
		if (!only_scenes && strcmp(argv[i], "--") == 0) {
			only_scenes = true;
			used = 1;
		} else if (!(only_scenes ? option_scene(o, argv[i])
					 : read_argument(o, argc - i, argv + i, &used))) {
			return false;
		}
	}
	o->place = (struct option_place){ 0 };
	return true;
}

/* --quiet counts from the start, wherever it stands. */
static bool is_quiet(int argc, char **argv)
{
	for (int i = 0; i < argc; i++)
		if (strcmp(argv[i], "--quiet") == 0)
			return true;
	return false;
}

bool options_read(struct options *o, int argc, char **argv)
{
	o->quiet = is_quiet(argc, argv);
	o->origin = ORIGIN_DEFAULT_INI;
	if (!ini_read_default(o))
		return false;
	o->origin = ORIGIN_USER;
	if (!read_arguments(o, argc, argv))
		return false;
	o->library_named = o->library.count;
	const char *last = getenv("POVINC");
	if (last && *last)
		add_library(o, last);
	/* The standard includes are found even when a user's INI file does not name them. */
	add_library(o, "/usr/share/povray-3.7/include");
	add_library(o, "/usr/local/share/povray-3.7/include");
	return true;
}

/* Writing them down */

/* In quotes that the text does not hold itself. */
static void write_text(FILE *file, const char *ini, const char *text)
{
	const char quote = strchr(text, '"') ? '\'' : '"';
	fprintf(file, "%s=%c%s%c\n", ini, quote, text, quote);
}

static void write_texts(FILE *file, const char *ini, const struct text_list *list, size_t count)
{
	for (size_t i = 0; i < count; i++)
		write_text(file, ini, list->items[i]);
}

static void write_declarations(FILE *file, const struct options *o, const char *ini)
{
	for (size_t i = 0; i < o->declaration_count; i++) {
		const struct lambert_declaration *d = &o->declarations[i];
		if (d->string)
			fprintf(file, "%s='%s=\"%s\"'\n", ini, d->name, d->string);
		else
			fprintf(file, "%s=%s=%g\n", ini, d->name, d->number);
	}
}

static void write_value(FILE *file, const struct options *o, const struct option_row *row)
{
	const struct text_list *list = (const void *)((const char *)o + row->field);
	switch (row->kind) {
	case KIND_TYPE:
		fprintf(file, "%s=%c\n", row->ini, o->output_type);
		break;
	case KIND_DECLARE:
		write_declarations(file, o, row->ini);
		break;
	case KIND_LIBRARY:
		write_texts(file, row->ini, &o->library, o->library_named);
		break;
	case KIND_FOLDERS:
		write_texts(file, row->ini, list, list->count);
		break;
	case KIND_INI:
	case KIND_COMMAND:
	case KIND_RETIRED:
		break;
	case KIND_REGION: /* a comma would begin another value */
	case KIND_TEXT:
	case KIND_FILE:
		write_text(file, row->ini, o->given[row - option_rows]);
		break;
	default:
		fprintf(file, "%s=%s\n", row->ini, o->given[row - option_rows]);
	}
}

static int by_name(const void *a, const void *b)
{
	const struct option_row *const *p = a, *const *q = b;
	return strcasecmp((*p)->ini, (*q)->ini);
}

bool options_write_ini(const struct options *o, const char *path)
{
	const struct option_row *rows[OPTION_MAX];
	size_t count = 0;
	for (size_t i = 0; i < option_count; i++)
		if (o->set[i] && *option_rows[i].ini)
			rows[count++] = &option_rows[i];
	qsort(rows, count, sizeof *rows, by_name);
	FILE *file = fopen(path, "w");
	if (!file)
		return false;
	for (size_t i = 0; i < count; i++)
		write_value(file, o, rows[i]);
	return fclose(file) == 0;
}
