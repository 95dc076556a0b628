/* SPDX-License-Identifier: MIT */
/*
 * text { ttf "font" "string" thickness, offset }
 *
 * Becomes one object per letter. FreeType reads outlines, metrics and kerning in
 * font units, unhinted; where letters stand follows the language, which differs
 * from plain typesetting in the first letter and in that offset.z is ignored.
 */
#include "geometry/glyph.h"
#include "lower/road.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include <string.h>
#include <strings.h>
#include <unistd.h>

/* Where fonts are looked for after the library paths. */
static const char *const font_folders[] = {
	"/usr/share/fonts/truetype/povray",
	"/usr/local/share/povray-3.7/fonts",
	"/usr/share/povray-3.7/fonts",
	"/usr/share/fonts/truetype/msttcorefonts",
	"/usr/share/fonts/truetype/liberation",
	"/usr/share/fonts/truetype/liberation2",
	"/usr/share/fonts/liberation-fonts",
	"/usr/share/fonts/truetype/dejavu",
	"/usr/share/fonts/truetype/freefont",
	"/usr/share/fonts/TTF",
	"/usr/local/share/fonts",
	"/Library/Fonts",
};

/* Free fonts with the metrics of common ones. */
static const struct substitute {
	const char *name, *instead;
} substitutes[] = {
	{ "arial", "LiberationSans-Regular" },
	{ "arialbd", "LiberationSans-Bold" },
	{ "ariali", "LiberationSans-Italic" },
	{ "arialbi", "LiberationSans-BoldItalic" },
	{ "times", "LiberationSerif-Regular" },
	{ "timesbd", "LiberationSerif-Bold" },
	{ "timesi", "LiberationSerif-Italic" },
	{ "timesbi", "LiberationSerif-BoldItalic" },
	{ "cour", "LiberationMono-Regular" },
	{ "courbd", "LiberationMono-Bold" },
	{ "verdana", "DejaVuSans" },
	{ "verdanab", "DejaVuSans-Bold" },
};

/* ---- the font ---- */

/* name, with .ttf if it has no such ending, in one of the font folders; NULL: not there. */
static const char *find_in_folders(struct lowering *l, const char *name)
{
	const size_t length = strlen(name);
	const bool has_ending = length > 4 && (strcasecmp(name + length - 4, ".ttf") == 0 ||
						      strcasecmp(name + length - 4, ".ttc") == 0);
	for (size_t i = 0; i < sizeof font_folders / sizeof font_folders[0]; i++) {
		const char *path = arena_printf(
			l->arena, "%s/%s%s", font_folders[i], name, has_ending ? "" : ".ttf");
		if (access(path, R_OK) == 0)
			return path;
	}
	return NULL;
}

static const char *file_part(const char *path)
{
	for (const char *c = path; *c; c++) {
		if (*c == '/' || *c == '\\')
			path = c + 1;
	}
	return path;
}

static const char *find_substitute(struct lowering *l, const char *name)
{
	const size_t length = strcspn(name, ".");
	for (size_t i = 0; i < sizeof substitutes / sizeof substitutes[0]; i++) {
		const struct substitute *s = &substitutes[i];
		if (strlen(s->name) == length && strncasecmp(s->name, name, length) == 0)
			return find_in_folders(l, s->instead);
	}
	return NULL;
}

static const char *find_font(struct lowering *l, const struct arg *arg)
{
	static const char *const extensions[] = { ".ttf", ".TTF", NULL };
	bool courtesy = false;
	const char *path =
		file_find(l->options->files, arg->string, extensions, &courtesy, l->arena);
	const char *refusal = path ? file_may_read(l->options->files, path, l->arena) : NULL;
	if (!path || refusal) {
		path = find_in_folders(l, file_part(arg->string));
		courtesy = false;
	}
	if (!path) {
		path = find_substitute(l, file_part(arg->string));
		courtesy = path != NULL;
	}
	if (!path && refusal)
		diag_error(l->diag, arg->span, "%s", refusal);
	else if (!path)
		diag_error(l->diag, arg->span, "the font \"%s\" was not found", arg->string);
	else if (courtesy)
		diag_warning(l->diag, arg->span,
			"the font \"%s\" was not found; %s is used instead", arg->string, path);
	return path;
}

static const char *internal_font(struct lowering *l, const struct node *n)
{
	const int number = lower_int(l, n, 0, "a font number");
	const char *name = number == 1	 ? "timrom.ttf"
			   : number == 2 ? "cyrvetic.ttf"
			   : number == 3 ? "crystal.ttf"
					 : "povlogo.ttf";
	const char *path = find_in_folders(l, name);
	if (!path)
		diag_error(l->diag, n->span, "the font %s is not installed (Debian: fonts-povray)",
			name);
	return path;
}

/* Platforms of character maps, in the order in which the language asks for them. */
static const unsigned short plain_platforms[] = { 1, 3, 0 };
static const unsigned short unicode_platforms[] = { 0, 3, 1 };

static void choose_character_map(FT_Face face, const char *string)
{
	bool plain = true;
	for (const char *c = string; *c; c++)
		plain &= (unsigned char)*c < 0x80;
	const unsigned short *platforms = plain ? plain_platforms : unicode_platforms;
	for (int i = 0; i < 3; i++) {
		for (int k = 0; k < face->num_charmaps; k++) {
			const FT_CharMap map = face->charmaps[k];
			const FT_Long format = FT_Get_CMap_Format(map);
			if (map->platform_id == platforms[i] &&
				(format == 0 || format == 4 || format == 6) &&
				FT_Set_Charmap(face, map) == 0)
				return;
		}
	}
}

/* The code at *text, which moves on. The parser hands over valid UTF-8 only. */
static unsigned next_code(const char **text)
{
	const unsigned char first = (unsigned char)*(*text)++;
	if (first < 0xC0)
		return first;
	unsigned code = first >= 0xF0 ? first & 7u : first >= 0xE0 ? first & 15u : first & 31u;
	while (((unsigned char)**text & 0xC0) == 0x80)
		code = code << 6 | ((unsigned char)*(*text)++ & 63u);
	return code;
}

static FT_UInt glyph_index(FT_Face face, unsigned code)
{
	const FT_UInt index = FT_Get_Char_Index(face, code);
	return index == 0 && code < 256 ? FT_Get_Char_Index(face, code + 0xF000) : index;
}

/* ---- outlines ---- */

/* Collects the segments of one letter; first counted, then stored. */
struct pen {
	struct glyph_segment *segments; /* NULL: count only */
	size_t count;
	double scale, dx, dy;
	double x, y;	       /* where the pen is */
	double from_x, from_y; /* where the contour began */
	bool has_cubics;
};

static void pen_segment(struct pen *p, const FT_Vector *control, double x, double y)
{
	const bool moves = x != p->x || y != p->y;
	if (p->segments && (moves || control)) {
		struct glyph_segment *s = &p->segments[p->count];
		const double cx =
			control ? p->dx + (double)control->x * p->scale : 0.5 * (p->x + x);
		const double cy =
			control ? p->dy + (double)control->y * p->scale : 0.5 * (p->y + y);
		*s = (struct glyph_segment){ { p->x, cx, x }, { p->y, cy, y }, control != NULL };
	}
	p->count += moves || control;
	p->x = x;
	p->y = y;
}

static void pen_close(struct pen *p)
{
	pen_segment(p, NULL, p->from_x, p->from_y);
}

static int pen_move(const FT_Vector *to, void *user)
{
	struct pen *p = user;
	if (p->count)
		pen_close(p);
	p->x = p->from_x = p->dx + (double)to->x * p->scale;
	p->y = p->from_y = p->dy + (double)to->y * p->scale;
	return 0;
}

static int pen_line(const FT_Vector *to, void *user)
{
	struct pen *p = user;
	pen_segment(p, NULL, p->dx + (double)to->x * p->scale, p->dy + (double)to->y * p->scale);
	return 0;
}

static int pen_conic(const FT_Vector *control, const FT_Vector *to, void *user)
{
	struct pen *p = user;
	pen_segment(p, control, p->dx + (double)to->x * p->scale, p->dy + (double)to->y * p->scale);
	return 0;
}

static int pen_cubic(
	const FT_Vector *control1, const FT_Vector *control2, const FT_Vector *to, void *user)
{
	struct pen *p = user;
	(void)control1;
	(void)control2;
	(void)to;
	p->has_cubics = true;
	return 0;
}

/* Runs the pen along the outline, whose origin goes to dx, dy. */
static void trace_outline(FT_Outline *outline, struct pen *p)
{
	static const FT_Outline_Funcs funcs = { pen_move, pen_line, pen_conic, pen_cubic, 0, 0 };
	p->count = 0;
	p->x = p->y = p->from_x = p->from_y = 0;
	if (FT_Outline_Decompose(outline, &funcs, p) != 0)
		p->count = 0;
	else if (p->count)
		pen_close(p);
}

/* ---- the text ---- */

/* A text being set. */
struct setting {
	struct lowering *lowering;
	const struct node *node;
	FT_Face face;
	double unit; /* of the font, in ems */
	double thickness;
	vec3 offset;
	double x, y; /* where the next letter stands */
	const transform *place;
	void (*emit)(void *user, struct object *);
	void (*emit_blank)(void *user, struct object *); /* NULL: blanks do not matter */
	void *user;
};

static struct object *glyph_object(
	struct setting *s, const struct glyph_segment *segments, size_t count, double overhang)
{
	struct lowering *l = s->lowering;
	struct glyph *g = ARENA_NEW(l->arena, struct glyph);
	g->segments = segments;
	g->count = count;
	g->thickness = s->thickness;
	g->overhang = overhang;
	glyph_finish(g);
	struct object *o = arena_pack(l->arena, sizeof *o);
	o->shape = &shape_glyph;
	o->self = g;
	o->place = s->place;
	return o;
}

/* A blank is a letter whose outline is the point where it stands. */
static void set_blank(struct setting *s, double x, double y)
{
	struct glyph_segment *point = ARENA_NEW(s->lowering->arena, struct glyph_segment);
	*point = (struct glyph_segment){ { x, x, x }, { y, y, y }, false };
	if (s->emit_blank)
		s->emit_blank(s->user, glyph_object(s, point, 1, 0));
}

static void set_outline(struct setting *s, double dx, double dy, double overhang)
{
	struct lowering *l = s->lowering;
	FT_Outline *outline = &s->face->glyph->outline;
	/* in half units, or FreeType would round the points between two control points */
	for (int i = 0; i < outline->n_points; i++) {
		outline->points[i].x *= 2;
		outline->points[i].y *= 2;
	}
	struct pen pen = { .scale = 0.5 * s->unit, .dx = dx, .dy = dy };
	trace_outline(outline, &pen);
	if (pen.has_cubics) {
		lower_unsupported(l, s->node, "a font with cubic outlines");
		return;
	}
	if (pen.count == 0)
		return;
	pen.segments = ARENA_ARRAY(l->arena, pen.count, struct glyph_segment);
	trace_outline(outline, &pen);
	s->emit(s->user, glyph_object(s, pen.segments, pen.count, overhang));
}

static double kerning(const struct setting *s, FT_UInt left, FT_UInt right)
{
	FT_Vector k;
	if (FT_Get_Kerning(s->face, left, right, FT_KERNING_UNSCALED, &k) != 0)
		return 0;
	return (double)k.x * s->unit;
}

/* Where the language takes the ink of the letter to begin, whose left side bearing is given. Of
 * letters composed of others (accents) it is at most 0, so that they move to the right. */
static double ink_start(FT_Face face, FT_UInt index, double bearing)
{
	if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_RECURSE) != 0 ||
		face->glyph->format != FT_GLYPH_FORMAT_COMPOSITE)
		return bearing;
	return fmin(bearing, trunc(bearing));
}

/* The first letter begins with its ink at x = 0, the others where the pen is. */
static void set_letter(struct setting *s, unsigned code, bool first, FT_UInt before, FT_UInt index)
{
	if (FT_Load_Glyph(s->face, index, FT_LOAD_NO_SCALE) != 0)
		return;
	const FT_GlyphSlot slot = s->face->glyph;
	const bool has_ink = slot->outline.n_points > 0;
	FT_BBox ink;
	FT_Outline_Get_CBox(&slot->outline, &ink);
	/* FreeType has moved the outline so that the ink begins at the left side bearing */
	const double bearing = (double)(has_ink ? ink.xMin : slot->metrics.horiBearingX) * s->unit;
	const double advance = (double)slot->metrics.horiAdvance * s->unit;
	const double start = ink_start(s->face, index, bearing);
	const double kern = first ? 0 : kerning(s, before, index);
	if (code == ' ')
		set_blank(s, first ? 0 : s->x + kern, s->y);
	else if (has_ink && FT_Load_Glyph(s->face, index, FT_LOAD_NO_SCALE) == 0)
		set_outline(
			s, first ? -start : s->x + bearing - start + kern, s->y, fmax(0, -start));
	s->x += advance + (first ? -bearing : kern) + s->offset.x;
	s->y += s->offset.y;
}

static void set_string(struct setting *s, const char *text)
{
	choose_character_map(s->face, text);
	FT_UInt before = 0;
	for (bool first = true; *text; first = false) {
		const unsigned code = next_code(&text);
		const FT_UInt index = glyph_index(s->face, code);
		set_letter(s, code, first, before, index);
		before = index;
	}
}

static bool set_text(struct setting *s, const char *path, const char *text)
{
	struct diag *diag = s->lowering->diag;
	FT_Library library;
	if (FT_Init_FreeType(&library) != 0) {
		diag_error(diag, s->node->span, "FreeType does not start");
		return false;
	}
	const bool opened = FT_New_Face(library, path, 0, &s->face) == 0;
	if (opened && FT_IS_SCALABLE(s->face) && s->face->units_per_EM > 0) {
		s->unit = 1.0 / s->face->units_per_EM;
		set_string(s, text);
	} else {
		diag_error(diag, s->node->span, "%s is not a font with outlines", path);
	}
	FT_Done_FreeType(library); /* the face goes with it */
	return opened;
}

/* The road of the word `text`. */
shape_road shape_road_text;

bool shape_road_text(struct lowering *l, const struct node *n, const transform *place,
	void (*emit)(void *user, struct object *), void (*emit_blank)(void *user, struct object *),
	void *user)
{
	if (n->arg_count < 4 || n->args[1].kind != ARG_STRING) {
		diag_error(
			l->diag, n->span, "text needs a font, a string, a thickness and an offset");
		return false;
	}
	const bool is_file = n->args[0].kind == ARG_STRING;
	const char *path = is_file ? find_font(l, &n->args[0]) : internal_font(l, n);
	if (!path)
		return false;
	/* the language tilts every text by a thousandth of a degree before anything else */
	const transform tilt = transform_rotate(vec(0.001, 0.001, 0.001));
	const transform tilted = place ? transform_compose(&tilt, place) : tilt;
	struct setting s = {
		.lowering = l,
		.node = n,
		.thickness = lower_float(l, n, 2, "a thickness"),
		.offset = lower_vector(l, n, 3, "an offset"),
		.place = arena_copy(l->arena, &tilted, sizeof tilted),
		.emit = emit,
		.emit_blank = emit_blank,
		.user = user,
	};
	return set_text(&s, path, n->args[1].string);
}
