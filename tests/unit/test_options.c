/* SPDX-License-Identifier: MIT */
/*
 * The options: how arguments and INI files are cut up, what values mean, which
 * setting wins, what the scene gets to see. Expectations were checked with
 * POV-Ray 3.7 where it has the option.
 */
#include "frames.h"
#include "formats.h"
#include "names.h"
#include "options.h"
#include "setup.h"

#include <fcntl.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
/* clang-format off: cmocka needs what stands above */
#include <cmocka.h>
/* clang-format on */

static struct options o;

/* Reads arguments (up to NULL) over the defaults; no INI file but those named. */
static bool reads(const char *first, ...)
{
	char *argv[16];
	int argc = 0;
	va_list args;
	va_start(args, first);
	for (const char *a = first; a; a = va_arg(args, const char *))
		argv[argc++] = (char *)(uintptr_t)a;
	va_end(args);
	options_finish(&o);
	options_init(&o);
	return options_read(&o, argc, argv);
}

static void write_file(const char *name, const char *text)
{
	FILE *file = fopen(name, "wb");
	assert_non_null(file);
	fputs(text, file);
	assert_int_equal(fclose(file), 0);
}

static void switches_match_by_prefix(void **state)
{
	(void)state;
	assert_true(reads("+W320", "-h240", "+KFF10", "+KF0.5", "+SF5", "+Q12", NULL));
	assert_int_equal(o.width, 320);
	assert_int_equal(o.height, 240);
	assert_int_equal(o.final_frame, 10);
	assert_true(o.final_clock == 0.5f);
	assert_true(o.subset_start == 5);
	assert_true(reads("+SF0.5", "+EF0.75", NULL));
	assert_true(o.subset_start == 0.5f && o.subset_end == 0.75f);
	assert_true(reads("+W20 +H10 scene.pov", NULL));
	assert_int_equal(o.width, 20);
	assert_int_equal(o.height, 10);
	assert_string_equal(o.input, "scene.pov");
}

static void numbers_end_where_they_end(void **state)
{
	(void)state;
	assert_true(reads("+W10x", "+H1.5", "+A0.3x", NULL));
	assert_int_equal(o.width, 10);
	assert_int_equal(o.height, 1);
	assert_true(o.antialias_threshold == 0.3f);
	assert_false(reads("+W", NULL));
	assert_false(reads("+Qabc", NULL));
	assert_false(reads("Width=", NULL));
}

static void thresholds_begin_with_zero(void **state)
{
	(void)state;
	assert_true(reads("+A0.1", NULL));
	assert_true(o.antialias && o.antialias_threshold == 0.1f);
	assert_true(reads("+A03", NULL));
	assert_true(o.antialias_threshold == 3);
	assert_true(reads("+A", NULL));
	assert_true(o.antialias && o.antialias_threshold == 0.3f);
	assert_true(reads("-A0.2", NULL));
	assert_true(!o.antialias && o.antialias_threshold == 0.2f);
	assert_false(reads("+A0", NULL));
	assert_false(reads("+A1", NULL));
	assert_false(reads("+A1.0", NULL));
	assert_false(reads("+A.3", NULL));
	assert_true(reads("Antialias_Threshold=1.0", NULL));
	assert_true(!o.antialias && o.antialias_threshold == 1);
}

static void signs_are_switches(void **state)
{
	(void)state;
	assert_true(reads("-J", NULL));
	assert_false(o.jitter);
	assert_true(reads("-J0.5", NULL));
	assert_true(!o.jitter && o.jitter_amount == 0.5f);
	assert_true(reads("-FN16", NULL));
	assert_true(!o.output_to_file && o.output_type == 'N' && o.bits == 16);
	assert_true(reads("+FPg", NULL));
	assert_true(o.output_to_file && o.output_type == 'P' && o.grayscale);
	assert_true(reads("+THB2", NULL));
	assert_true(o.dither);
	assert_string_equal(o.dither_method, "B2");
	assert_true(reads("Dither_Method=B3", NULL));
	assert_false(o.dither);
	assert_false(reads("+FX", NULL));
	assert_false(reads("+FNg16", NULL));
	assert_false(reads("+FN16g", NULL));
	assert_true(reads("+RFofoo", NULL));
	assert_string_equal(o.ignored_text, "ofoo"); /* RFO takes no value */
}

static void names_may_be_quoted(void **state)
{
	(void)state;
	assert_true(reads("+O\"a b.png\"", NULL));
	assert_string_equal(o.output, "a b.png");
	assert_true(reads("Output_File_Name='a b.png'", NULL));
	assert_string_equal(o.output, "a b.png");
	assert_true(reads("+Ia dir/my scene.pov", "+Oa dir/out put#1;2.png", "+La dir", NULL));
	assert_string_equal(o.input, "a dir/my scene.pov");
	assert_string_equal(o.output, "a dir/out put#1;2.png");
	assert_string_equal(o.library.items[0], "a dir");
	assert_true(reads("Input_File_Name=a b.pov", "Output_File_Name=c d=e.png",
		"Library_Path=f g", "+HIhead er.inc", "+GDde bug.out", NULL));
	assert_string_equal(o.input, "a b.pov");
	assert_string_equal(o.output, "c d=e.png");
	assert_string_equal(o.library.items[0], "f g");
	assert_string_equal(o.include_header, "head er.inc");
	assert_string_equal(o.stream_file[STREAM_DEBUG], "de bug.out");
	assert_true(reads("+W11 +H12 +Q3", NULL)); /* numbers hold no blanks */
	assert_true(o.width == 11 && o.height == 12 && o.quality == 3);
	assert_false(reads("+O\"a b.png", NULL));
}

static void truth_begins_like_truth(void **state)
{
	(void)state;
	static const char *const yes[] = { "on", "o", "onward", "y", "ye", "t", "1", "10", "",
		"TRUE" };
	static const char *const no[] = { "off", "0", "2", "enabled", "no", "false", "ture" };
	for (size_t i = 0; i < sizeof yes / sizeof *yes; i++) {
		char text[32];
		snprintf(text, sizeof text, "Antialias=%s", yes[i]);
		assert_true(reads(text, NULL) && o.antialias);
	}
	for (size_t i = 0; i < sizeof no / sizeof *no; i++) {
		char text[32];
		snprintf(text, sizeof text, "Jitter=%s", no[i]);
		assert_true(reads(text, NULL) && !o.jitter);
	}
}

static void file_options_are_names_or_truths(void **state)
{
	(void)state;
	assert_true(reads("Debug_File=on", "All_File=", NULL));
	assert_string_equal(o.stream_file[STREAM_DEBUG], "debug.out");
	assert_string_equal(o.stream_file[STREAM_ALL], "alltext.out");
	assert_true(reads("-GSfalse", NULL));
	assert_string_equal(o.stream_file[STREAM_STATISTIC], "false");
	assert_false(o.console[STREAM_STATISTIC]);
}

static void declarations_have_six_digits(void **state)
{
	(void)state;
	assert_true(
		reads("Declare=A=0.123456789", "Declare=B=-3.5e10", "Declare=A=7",
			"\"Declare=C=1\"", NULL) == false); /* a quoted assignment is a file name */
	assert_true(reads("Declare=A=0.123456789", "Declare=B=-3.5e10", "Declare=A=7",
		"Declare='S=\"hello\"'", "--declare", "T=a text", "Declare=clock=4", NULL));
	assert_int_equal(o.declaration_count, 4);
	assert_true(o.declarations[0].number == 0.123457);
	assert_true(o.declarations[1].number == -35000000000.0);
	assert_string_equal(o.declarations[2].string, "hello");
	assert_string_equal(o.declarations[3].string, "a text");
}

static void ini_files_have_sections(void **state)
{
	(void)state;
	write_file("t.ini", "; comment\n"
			    "Width = 11 Height=99\r\n"
			    "+H12 +Q3 # more\n"
			    "Declare=A=7,B=8\r"
			    "[Really High]\n"
			    "Width=1000\n"
			    "[other]\n"
			    "nonsense that is not looked at = 4\n"
			    "[really high]\n"
			    "Antialias=on\n");
	assert_true(reads("t.ini", NULL));
	assert_int_equal(o.width, 11);
	assert_int_equal(o.height, 12);
	assert_int_equal(o.quality, 3);
	assert_int_equal(o.declaration_count, 2);
	assert_false(o.antialias);
	assert_true(reads("\"t[really high]\"", NULL));
	assert_int_equal(o.width, 1000);
	assert_true(o.antialias);
	assert_true(reads("t.ini[none]", NULL));
	assert_int_equal(o.width, 11);
	assert_false(reads("t.ini[other]", NULL));
	assert_false(reads("t.ini[really", NULL));
	assert_false(reads("missing.ini", NULL));
	assert_true(reads("t.ini", "+W5", NULL));
	assert_int_equal(o.width, 5);
	assert_true(reads("+W5", "t.ini", NULL));
	assert_int_equal(o.width, 11);
}

static void ini_values_may_hold_blanks(void **state)
{
	(void)state;
	write_file("t.ini", "Output_File_Name=my file.png ; comment\nBuffer_Size=3\n");
	assert_true(reads("t.ini", "--quiet", NULL));
	assert_string_equal(o.output, "my file.png");
	assert_false(reads("Buffer_Size=3", NULL));
	write_file("t.ini", "t.ini\n");
	assert_false(reads("t.ini", NULL)); /* without end */
	write_file("t.ini", "\xEF\xBB\xBFWidth=3\n");
	assert_false(reads("t.ini", NULL));
	write_file("t.ini", "height : 9\n");
	assert_false(reads("t.ini", NULL));
}

static void long_options_say_the_same(void **state)
{
	(void)state;
	assert_true(reads("--size", "320x200", "--antialias=2:0.1:4", "--threads=3", "--bits", "16",
		"--alpha", "--gamma", "1.8", "--quality", "5", "--include-path", ".", NULL));
	assert_int_equal(o.width, 320);
	assert_int_equal(o.height, 200);
	assert_true(o.antialias && o.sampling_method == 2 && o.antialias_threshold == 0.1f &&
		    o.antialias_depth == 4);
	assert_int_equal(o.threads, 3);
	assert_int_equal(o.bits, 16);
	assert_true(o.output_alpha && o.file_gamma == 1.8f);
	assert_string_equal(o.library.items[0], ".");
	assert_true(reads("--gamma=srgb", NULL) && o.file_gamma == 0);
	static const char *const wrong[] = { "--size=320", "--size=0x5", "--size=3x4x", "--what",
		"--alpha=1", "--threads", "--antialias=3", "--region=1,2,3", "--gamma=0",
		"--format=gif", "--progress=fast", "--quality=11x", "--quality=12", "--bits=32",
		"--jitter=5", "--antialias=2:0.1:4:1", "--antialias=2:x", "--size=99999999999x1",
		"--loop-limit=-1" };
	for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
		assert_false(reads(wrong[i], NULL));
}

static void library_paths_accumulate(void **state)
{
	(void)state;
	assert_true(reads("+La", "b/", "+La/", "Library_Path=c", "+Lb", NULL));
	assert_int_equal(o.library.count, 5); /* a b/ c and the two standard folders */
	assert_string_equal(o.library.items[1], "b/");
	assert_string_equal(o.library.items[3], "/usr/share/povray-3.7/include");
}

/* Names of pictures */

static void named(const char *expected, const char *a, const char *b)
{
	assert_true(reads(a, b, NULL));
	assert_string_equal(names_picture(&o, 0, 0), expected);
}

static const char *help_of(const char *name)
{
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].name && strcmp(option_rows[i].name, name) == 0)
			return option_rows[i].help;
	return "";
}

/* Each format of the library is chosen by its letter, its name and its extensions. */
static void formats_are_found(void **state)
{
	(void)state;
	struct lambert_format f, found;
	size_t count = 0;
	for (; lambert_format_describe(count, &f); count++) {
		const char letter[] = { '+', 'F', f.letter, '\0' };
		assert_true(reads("s.pov", letter, NULL));
		const char *path = text_printf(&o.pool, "a.b/c%s", formats_extension(&o.pool, &f));
		assert_true(names_format(&o, &found));
		assert_string_equal(found.name, f.name);
		assert_true(lambert_format_find(f.name, &found));
		assert_int_equal(found.letter, f.letter);
		assert_true(formats_find_path(path, &found));
		assert_string_equal(found.extensions, f.extensions);
		assert_non_null(strstr(formats_names(&o.pool), f.name));
		assert_non_null(strstr(help_of("format"), f.name));
	}
	assert_true(count >= 9);
	assert_false(lambert_format_find("", &found));
	assert_false(lambert_format_find("jp", &found));
	assert_false(formats_find_path("a.png/b", &found));
	assert_true(lambert_format_find("TGA", &found) && found.letter == 'C');
}

static void pictures_are_named_by_rules(void **state)
{
	struct lambert_format format;
	(void)state;
	named("dir/s.png", "dir/s.pov", NULL);
	named("foo.png", "dir/s.pov", "+Ofoo.png");
	named("foo.png", "dir/s.pov", "+Ofoo");
	named("foo.png", "dir/s.pov", "+Ofoo.");
	named("foo.tga.png", "s.pov", "+Ofoo.tga");
	named("foo.PNG.png", "s.pov", "+Ofoo.PNG");
	named("out/s.png", "dir/s.pov", "+Oout/");
	named("dir/s.png", "dir/s.pov", "+O.png");
	named("-", "s.pov", "+O-");
	named("-", "s.pov", "+Ostdout");
	named("x.tga", "s.pov", "--output=x.tga");
	named("x", "s.pov", "--output=x");
	assert_true(reads("s.pov", "+Oxyz.jpeg", "+FJ", NULL));
	assert_string_equal(names_picture(&o, 0, 0), "xyz.jpeg.jpg");
	assert_true(reads("s.pov", "+Oa", NULL));
	assert_string_equal(names_picture(&o, 7, 3), "a007.png");
	assert_true(reads("s.pov", "-o", "x.EXR", NULL));
	assert_true(names_format(&o, &format));
	assert_string_equal(format.name, "exr");
	assert_true(reads("s.pov", "-o", "x.exr", "+FN", NULL));
	assert_true(names_format(&o, &format));
	assert_string_equal(format.name, "png");
	assert_true(reads("s.pov", "-o", "x.what", NULL));
	assert_false(names_format(&o, &format));
}

/* Frames */

static struct frames frames(const char *a, const char *b, const char *c, const char *d)
{
	struct frames f;
	assert_true(reads("s.pov", a, b, c, d, NULL));
	frames_init(&f, &o);
	return f;
}

static void frames_follow_the_clock(void **state)
{
	(void)state;
	assert_false(frames("+K0.5", NULL, NULL, NULL).is_animation);
	assert_false(frames("+KFI1", "+KFF1", NULL, NULL).is_animation);
	struct frames f = frames("+KFF1", NULL, NULL, NULL);
	assert_true(f.is_animation && f.first == 1 && f.last == 1 && f.clock_delta == 0);
	assert_true(frames_clock(&f, &o, 1) == 0);
	f = frames("+KFF11", "+KI1", "+KF2", NULL);
	assert_true(f.digits == 2 && f.last == 11);
	assert_true(frames_clock(&f, &o, 6) == 1.5f);
	f = frames("+KFF9", "+KC", NULL, NULL);
	assert_true(f.digits == 2 && f.last == 9 && f.final == 10);
	f = frames("+KFF10", "+SF0.5", NULL, NULL);
	assert_true(f.first == 5 && f.last == 10);
	f = frames("+KFF9", "+SF12", "+EF12", NULL);
	assert_true(f.first == 12 && f.last == 12 && f.digits == 1);
	f = frames("+KFI-4", "+KFF3", "+STP2", NULL);
	assert_true(f.first == 0 && f.step == 2);
}

/* Worked out in double and rounded once: rounding the step as well would miss every second frame. */
static void clocks_are_rounded_once(void **state)
{
	(void)state;
	struct frames f = frames("+KFI1", "+KFF61", NULL, NULL);
	for (int i = 0; i <= 60; i++)
		assert_true(frames_clock(&f, &o, 1 + i) == (float)(1.0 / 60 * i));
	f = frames("+KFI1", "+KFF37", "+KI0.1", "+KF0.7");
	const double step = (double)(0.7f - 0.1f) / 36;
	for (int i = 0; i <= 36; i++)
		assert_true(frames_clock(&f, &o, 1 + i) == (float)((double)0.1f + step * i));
}

/* What the library is told */

static double declared(const struct lambert_scene_options *s, const char *name)
{
	for (size_t i = 0; i < s->declaration_count; i++)
		if (strcmp(s->declarations[i].name, name) == 0)
			return s->declarations[i].number;
	return NAN;
}

static void scenes_see_identifiers(void **state)
{
	(void)state;
	struct frames f = frames("+W1234567", "+H7", "Declare=final_clock=9", "+K0.1");
	struct lambert_scene_options s;
	setup_scene(&o, NULL, &f, 0, &s);
	assert_true(declared(&s, "image_width") == 1234570); /* six digits */
	assert_true(declared(&s, "image_height") == 7);
	assert_true(declared(&s, "final_clock") == 9);
	assert_true(declared(&s, "frame_number") == 0);
	assert_true(s.clock == 0.100000001490116119384765625 && s.clock_on);
	assert_int_equal(s.version, 0);
	assert_true(reads("s.pov", "+MV3.7", "+Q99", NULL));
	setup_scene(&o, NULL, &f, 0, &s);
	assert_int_equal(s.version, 370);
	assert_int_equal(s.quality, 9);
	assert_false(s.clock_on);
}

static void region_is(int left, int top, int right, int bottom)
{
	struct lambert_render_options r;
	assert_true(setup_render(&o, &r));
	assert_int_equal(r.left, left);
	assert_int_equal(r.top, top);
	assert_int_equal(r.right, right);
	assert_int_equal(r.bottom, bottom);
}

static void regions_are_shares_or_numbers(void **state)
{
	(void)state;
	struct lambert_render_options r;
	assert_true(reads("s.pov", "+W100", "+H50", NULL));
	region_is(0, 0, 100, 50);
	assert_true(reads("s.pov", "+W100", "+H50", "+SC0.25", "+EC0.75", "+SR2.7", "+ER10", NULL));
	region_is(25, 1, 75, 10);
	assert_true(reads("s.pov", "+W100", "+H50", "+SC1", "+EC1", NULL));
	region_is(0, 0, 100, 50);
	assert_true(reads("s.pov", "+W100", "+H50", "--region=3,4,5,6", NULL));
	region_is(3, 4, 5, 6);
	static const char *const wrong[] = { "+EC0", "+SC-3", "+SC101", "+EC101", "+ER51",
		"--region=5,5,5,6", "--region=0,0,101,5", "--region=-1,0,5,5" };
	for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
		assert_true(reads("s.pov", "+W100", "+H50", wrong[i], NULL));
		assert_false(setup_render(&o, &r));
	}
}

static void impossible_settings_are_refused(void **state)
{
	(void)state;
	static const char *const wrong[] = { "+W0", "+H-5", "+WT0", "+WT-1", "+BS3", "+RFI", "+RFO",
		"+RTR", "+KLA", "--size=100000x100000" };
	for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
		assert_false(reads("s.pov", wrong[i], NULL) && setup_check(&o));
	assert_true(reads("s.pov", "+C", "-RFI", NULL) && setup_check(&o));
	assert_false(reads("+W5", NULL) && setup_check(&o));
}

static void options_are_written_down(void **state)
{
	(void)state;
	assert_true(reads("s.pov", "+W320", "+A0.1", "-J", "Declare=A=3", NULL));
	assert_true(options_write_ini(&o, "t.ini"));
	assert_true(reads("t.ini", NULL));
	assert_int_equal(o.width, 320);
	assert_false(o.jitter);
	assert_true(o.antialias_threshold == 0.1f);
	assert_string_equal(o.input, "s.pov");
	assert_int_equal(o.declaration_count, 1);
}

/* Whether two rows hold the same. */
static bool same_value(
	const struct option_row *row, const struct options *a, const struct options *b)
{
	const void *x = (const char *)a + row->field, *y = (const char *)b + row->field;
	const char *s, *t;
	switch (row->kind) {
	case KIND_BOOL:
		return *(const bool *)x == *(const bool *)y;
	case KIND_INT:
	case KIND_FLOAT:
	case KIND_GAMMA:
		return memcmp(x, y, 4) == 0;
	case KIND_COUNT:
		return memcmp(x, y, sizeof(double)) == 0;
	case KIND_REGION:
		return memcmp(x, y, sizeof a->region) == 0 && a->has_region == b->has_region;
	case KIND_TYPE:
		return a->output_type == b->output_type;
	case KIND_TEXT:
	case KIND_FILE:
	case KIND_DITHER:
	case KIND_PROGRESS:
		s = *(const char *const *)x;
		t = *(const char *const *)y;
		return s == t || (s && t && strcmp(s, t) == 0);
	case KIND_FOLDERS:
		return ((const struct text_list *)x)->count == ((const struct text_list *)y)->count;
	case KIND_LIBRARY:
		return a->library.count == b->library.count;
	case KIND_DECLARE:
		return a->declaration_count == b->declaration_count;
	default:
		return true;
	}
}

/* What arguments set is the same after it has been written down and read. */
static void survives(const char *a, const char *b)
{
	assert_true(reads("s.pov", a, b, NULL));
	assert_true(options_write_ini(&o, "t.ini"));
	struct options first = o;
	o.pool = (struct text_pool){ 0 };
	assert_true(reads("t.ini", NULL));
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].use == USE_USED && !same_value(&option_rows[i], &first, &o))
			fail_msg("%s %s: %s is not what it was", a, b ? b : "", option_rows[i].ini);
	options_finish(&first);
}

static const char *sample_value(enum option_kind kind)
{
	switch (kind) {
	case KIND_BOOL:
		return "on";
	case KIND_TYPE:
		return "J";
	case KIND_DITHER:
		return "D2";
	case KIND_GAMMA:
		return "1.2345678";
	case KIND_FLOAT:
		return "0.123456789";
	case KIND_REGION:
		return "\"1,2,3,4\"";
	case KIND_PROGRESS:
		return "lines";
	case KIND_DECLARE:
		return "'A=\"it; # one\"'";
	case KIND_TEXT:
	case KIND_FILE:
	case KIND_LIBRARY:
	case KIND_FOLDERS:
		return "o'b c#;d";
	default:
		return "7";
	}
}

static void every_option_survives(void **state)
{
	(void)state;
	char argument[100];
	for (size_t i = 0; i < option_count; i++) {
		const struct option_row *row = &option_rows[i];
		if (!*row->ini || row->use != USE_USED || row->kind == KIND_INI ||
			row->kind == KIND_COMMAND || row->kind == KIND_RETIRED)
			continue;
		snprintf(argument, sizeof argument, "%s=%s", row->ini, sample_value(row->kind));
		survives(argument, NULL);
	}
	static const char *const arguments[] = { "--antialias", "--antialias=2",
		"--antialias=2:0.123456789", "--antialias=2:0.3:4", "--jitter=0.25", "--dither",
		"--dither=B2", "--size=7x8", "--region=1,2,3,4", "--output=a b.tga", "--no-file-io",
		"--allow-read=a b", "--allow-write=c", "--loop-limit=1e5", "--progress=bar",
		"--stats=s.json", "--quiet", "--json", "--declare=A=b'c", "--alpha", "--grayscale",
		"--clock=0.3", "--language-version=3.1", "--format=tga", "+A0.2", "-A0.2", "+J0.5",
		"-J0.5", "+FN16", "-F", "+THD1", "+GDx y", "-GA", "+K0.1", "+KFI2", "+SC0.25",
		"+WT3" };
	for (size_t i = 0; i < sizeof arguments / sizeof *arguments; i++)
		survives(arguments[i], NULL);
	survives("+A0.2", "+FJ16");
}

/* The tests run in a folder of their own, without the user's INI files. */
static char folder[] = "/tmp/lambert-test-XXXXXX";

static int enter(void **state)
{
	(void)state;
	if (!mkdtemp(folder) || chdir(folder) != 0)
		return -1;
	write_file("empty.ini", "");
	unsetenv("POVINC");
	return setenv("POVINI", "empty.ini", 1);
}

static int leave(void **state)
{
	(void)state;
	options_finish(&o);
	unlink("t.ini");
	unlink("empty.ini");
	return chdir("/") | rmdir(folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(switches_match_by_prefix),
		cmocka_unit_test(numbers_end_where_they_end),
		cmocka_unit_test(thresholds_begin_with_zero),
		cmocka_unit_test(signs_are_switches),
		cmocka_unit_test(names_may_be_quoted),
		cmocka_unit_test(truth_begins_like_truth),
		cmocka_unit_test(file_options_are_names_or_truths),
		cmocka_unit_test(declarations_have_six_digits),
		cmocka_unit_test(ini_files_have_sections),
		cmocka_unit_test(ini_values_may_hold_blanks),
		cmocka_unit_test(long_options_say_the_same),
		cmocka_unit_test(library_paths_accumulate),
		cmocka_unit_test(formats_are_found),
		cmocka_unit_test(pictures_are_named_by_rules),
		cmocka_unit_test(frames_follow_the_clock),
		cmocka_unit_test(clocks_are_rounded_once),
		cmocka_unit_test(scenes_see_identifiers),
		cmocka_unit_test(regions_are_shares_or_numbers),
		cmocka_unit_test(impossible_settings_are_refused),
		cmocka_unit_test(options_are_written_down),
		cmocka_unit_test(every_option_survives),
	};
	return cmocka_run_group_tests(tests, enter, leave);
}
