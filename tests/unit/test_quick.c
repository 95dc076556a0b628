/* SPDX-License-Identifier: MIT */
/*
 * The short ways (parser/quick.c, quick_item.c) against the grammar: small scenes
 * with random expressions and objects, good ones and bad ones, are read with and
 * without them. The trees and the messages, with their places, must be the same to
 * the byte.
 */
#include "parser/parser.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SCENES = 6000, STATEMENTS = 4 };

/* -- Random text -------------------------------------------------------------------------- */

struct writer {
	FILE *out;
	uint32_t state;
	bool wild; /* vectors and errors anywhere in expressions; else mostly right */
	bool odd;  /* objects may be wrong */
};

static unsigned pick(struct writer *w, unsigned count)
{
	w->state = w->state * 1664525u + 1013904223u;
	return (w->state >> 8) % count;
}

static void put(struct writer *w, const char *text)
{
	fputs(text, w->out);
}

#define PUT_ONE_OF(w, ...)                                                                         \
	do {                                                                                       \
		static const char *const list[] = { __VA_ARGS__ };                                 \
		put((w), list[pick((w), sizeof list / sizeof *list)]);                             \
	} while (0)

/* The first `good` are right wherever they are put. */
#define PUT_GOOD_OF(w, good, ...)                                                                  \
	do {                                                                                       \
		static const char *const list[] = { __VA_ARGS__ };                                 \
		put((w), list[pick((w), (w)->odd ? sizeof list / sizeof *list : (good))]);         \
	} while (0)

static void put_full(struct writer *w, unsigned depth);
static void put_sum(struct writer *w, unsigned depth);

static void put_list(struct writer *w, unsigned depth, unsigned count)
{
	for (unsigned i = 0; i < count; i++) {
		if (i)
			put(w, w->wild && !pick(w, 5) ? " " : ", "); /* commas may be left out */
		put_sum(w, depth);
	}
}

static void put_leaf(struct writer *w)
{
	if (w->wild && !pick(w, 12))
		PUT_ONE_OF(w, "S", "Undeclared", "A[9]", "A", "Empty[0]", "A[F]");
	else if (w->wild && !pick(w, 3))
		PUT_ONE_OF(w, "V", "W4", "C", "x", "y", "u", "t");
	else
		PUT_ONE_OF(w, "0", "1", "2", "7.5", ".5", "1e-3", "3.25", "1e300", "12345678", "F",
			"F", "G", "A[1]", "B[0][1]", "R", "pi", "clock", "yes", "off", "version",
			"M(2)", "N()", "Macro()", "rand(R)", "rand(R)");
}

/* Something that is surely a float, if its arguments are. */
static void put_float(struct writer *w, unsigned depth)
{
	switch (depth ? pick(w, 8) : 0) {
	case 0:
	case 1:
	case 2:
		put_leaf(w);
		return;
	case 3:
		put(w, "(");
		put_full(w, depth - 1);
		break;
	case 4:
		PUT_ONE_OF(w, "abs(", "sin(", "int(", "floor(", "exp(", "seed(", "radians(");
		put_full(w, depth - 1);
		break;
	case 5:
		PUT_ONE_OF(w, "max(", "min(", "mod(", "vdot(", "bitwise_or(");
		put_list(w, depth - 1, 2);
		break;
	case 6:
		PUT_ONE_OF(w, "vlength(<", "(<");
		put_list(w, depth - 1, 3);
		PUT_ONE_OF(w, ">*2", ">");
		put(w, ".y");
		break;
	default:
		PUT_ONE_OF(w, "(V.x", "(C.gray", "(W4.t", "(V + 1).z + (F", "vlength(vcross(V, x)");
		break;
	}
	put(w, ")");
}

static void put_operand(struct writer *w, unsigned depth)
{
	if (!w->wild) {
		put_float(w, depth);
		return;
	}
	switch (depth ? pick(w, 12) : 0) {
	case 0:
	case 1:
	case 2:
	case 3:
		put_leaf(w);
		break;
	case 4:
		put(w, "(");
		put_full(w, depth - 1);
		put(w, ")");
		break;
	case 5:
	case 6:
		put(w, "<");
		put_list(w, depth - 1, 2 + pick(w, 4));
		put(w, ">");
		break;
	case 7:
		PUT_ONE_OF(w, "abs", "sin", "sqrt", "int", "floor", "ln", "acos", "rand", "seed",
			"radians", "strlen");
		put(w, "(");
		put_full(w, depth - 1);
		put(w, ")");
		break;
	case 8:
		PUT_ONE_OF(w, "mod", "pow", "atan2", "div", "vdot", "vcross", "bitwise_and");
		put(w, "(");
		put_list(w, depth - 1, 2);
		put(w, ")");
		break;
	case 9:
		PUT_ONE_OF(w, "max", "min", "select", "vlength", "vnormalize", "vrotate");
		put(w, "(");
		put_list(w, depth - 1, 1 + pick(w, 4));
		put(w, ")");
		break;
	case 10:
		PUT_ONE_OF(w, "V", "C", "W4", "F", "A[2]", "(V + 1)", "vcross(x, y)");
		PUT_ONE_OF(w, ".x", ".y", ".z", ".red", ".t", ".gray", ".transmit", ".u");
		break;
	default:
		put(w, "A[");
		put_sum(w, depth - 1);
		put(w, "]");
		break;
	}
}

static void put_sum(struct writer *w, unsigned depth)
{
	const unsigned count = 1 + (depth ? pick(w, 3) : 0);
	for (unsigned i = 0; i < count; i++) {
		if (i)
			PUT_ONE_OF(w, " + ", " - ", "*", "/", " -", "/*c*/+", "*-");
		if (!pick(w, 6))
			PUT_ONE_OF(w, "-", "+", "!", "--");
		put_operand(w, depth ? depth - 1 : 0);
	}
}

static void put_full(struct writer *w, unsigned depth)
{
	put_sum(w, depth);
	if (!pick(w, 3)) {
		PUT_ONE_OF(w, " < ", " > ", " = ", " != ", " <= ", " >= ", " & ", " | ");
		put_sum(w, depth);
	}
	if (!pick(w, 6)) {
		put(w, " ? ");
		put_full(w, depth ? depth - 1 : 0);
		put(w, " : ");
		put_full(w, depth ? depth - 1 : 0);
	}
}

/* Something a little out of the ordinary, now and then. */
static void put_surprise(struct writer *w)
{
	if (!pick(w, 12))
		PUT_GOOD_OF(w, 3, "#if (F > 1) no_shadow #end ", "#declare F = F + 1; ",
			"no_image ", "Macro() ", "hollow off ", "Ball ", "; ", "sturm ", "} ",
			"Members() ", "x ", "clipped_by { Ball } ", "A[0] ");
}

static void put_look(struct writer *w)
{
	switch (pick(w, 9)) {
	case 0:
		put(w, "pigment { color rgb ");
		put_float(w, 1);
		PUT_GOOD_OF(w, 2, " } ", " filter 0.5 } ", " - ");
		break;
	case 1:
		PUT_GOOD_OF(w, 6, "pigment { C } ", "pigment { P } ", "pigment { P scale 2 } ",
			"pigment { color C } ", "pigment { rgbf V } ", "pigment { checker } ",
			"pigment { V } ", "pigment { Look } ", "pigment { srgb V } ");
		break;
	case 2:
		put(w, "finish { ");
		PUT_GOOD_OF(w, 8, "ambient ", "diffuse ", "reflection ", "phong ", "emission rgb ",
			"specular albedo ", "ambient color ", "Shine ambient ", "diffuse 1, ",
			"ambient x ");
		put_float(w, 1);
		PUT_GOOD_OF(w, 4, " phong 1 } ", " } ", " metallic } ", " reflection C } ",
			" filter 1 } ", " Shine } ");
		break;
	case 3:
		put(w, "texture { ");
		PUT_GOOD_OF(w, 5, "Look ", "Looks[1] ", "", "pigment { rgb 1 } ", "P ", "Ball ");
		PUT_GOOD_OF(w, 5, "} ", "translate V } ", "finish { phong F } rotate 5*x } ",
			"finish { Shine } } ", "pigment { P } } ", "Look } ", "finish { x } } ");
		break;
	case 4:
	case 5:
		PUT_ONE_OF(w, "translate ", "rotate ", "scale ");
		put_float(w, 1);
		put(w, " ");
		break;
	case 6:
		PUT_GOOD_OF(w, 5, "no_shadow ", "inverse ", "finish { Shine } ", "rotate V ",
			"photons { target } ", "scale 0 ", "open ", "hollow ");
		break;
	default:
		break;
	}
	put_surprise(w);
}

static void put_looks(struct writer *w)
{
	for (unsigned i = pick(w, 4); i > 0; i--)
		put_look(w);
}

static void put_primitive(struct writer *w)
{
	PUT_GOOD_OF(w, 6, "sphere { V, ", "sphere { <1, 2, 3> ", "cylinder { 0, y, ", "torus { 2, ",
		"plane { y ", "disc { 0, y, 2, ", "cone { 0, 1, y, ", "Ball ", "sphere { Ball ");
	put_float(w, 1);
	put(w, " ");
	put_looks(w);
	put(w, "} ");
}

static void put_object(struct writer *w, unsigned depth);

static void put_members(struct writer *w, unsigned depth)
{
	put_object(w, depth);
	for (unsigned i = pick(w, 4); i > 0; i--) {
		if (w->odd && !pick(w, 6))
			put_look(w); /* behind it no more members may come */
		else if (pick(w, 4))
			put_object(w, depth);
		else
			PUT_GOOD_OF(w, 5, "Ball ", "object { Ball } ", "Balls[1] ",
				"#local L = 1; ", "Members() ", "Look ", "no_shadow ");
	}
}

static void put_object(struct writer *w, unsigned depth)
{
	if (!depth || !pick(w, 3)) {
		put_primitive(w);
		return;
	}
	if (!pick(w, 3)) {
		PUT_GOOD_OF(w, 3, "object { Ball ", "object { Balls[0] ", "object { Member(V) ",
			"object { Balls[F] ", "object { Look ", "object { Ball Ball ", "object { ");
	} else {
		PUT_ONE_OF(w, "union { ", "union { ", "difference { ", "intersection { ",
			"merge { ", "composite { ");
		if (pick(w, 9))
			put_members(w, depth - 1);
	}
	put_looks(w);
	put(w, "} ");
}

static void put_statement(struct writer *w)
{
	switch (pick(w, 14)) {
	case 11:
	case 12:
		put_object(w, 4);
		break;
	case 13:
		PUT_ONE_OF(w, "#declare Ball = ", "#for (I, 0, 2) ");
		put_object(w, 3);
		PUT_ONE_OF(w, "", "", "#end");
		break;
	case 0:
		put(w, "#declare F = ");
		put_sum(w, 3);
		put(w, ";");
		break;
	case 1:
		PUT_ONE_OF(
			w, "#declare V = ", "#local G = ", "#declare A[1] = ", "#declare Other = ");
		put_sum(w, 3);
		PUT_ONE_OF(w, ";", ";", ";;", "");
		break;
	case 2:
		put(w, "#if (");
		put_full(w, 3);
		put(w, ") #declare F = F + 1; #else #declare G = G*2; #end");
		break;
	case 3:
		PUT_ONE_OF(w, "Show(", "Change(", "Give(");
		put_sum(w, 2);
		put(w, ", ");
		put_sum(w, 1);
		put(w, ")");
		break;
	case 4:
		put(w, "#for (I, 0, ");
		put_sum(w, 1);
		put(w, " , 1) #if (I > 3) #break #end #end");
		break;
	case 5:
		put(w, "#while (F < 3 & ");
		put_full(w, 1);
		put(w, ") #declare F = F + 1; #end");
		break;
	case 6:
		put(w, "box { ");
		put_list(w, 2, 2);
		put(w, " translate ");
		put_sum(w, 2);
		PUT_ONE_OF(w, " pigment { rgb V }", " pigment { C }", " rotate x*F",
			" scale 2 no_shadow");
		put(w, " }");
		break;
	case 7:
		put(w, "prism { linear_spline -1, 1, 3, <0, 0>, <1, 0>, ");
		put_sum(w, 2);
		put(w, " pigment { color_map { [");
		put_sum(w, 1);
		put(w, " rgb 1] [1 C] } } }");
		break;
	case 8:
		put(w, "#declare Q = array[2] { ");
		put_sum(w, 2);
		put(w, ", ");
		put_sum(w, 2);
		put(w, " }");
		break;
	case 9:
		put(w, "#debug concat(str(");
		put_sum(w, 2);
		put(w, ", 0, 6), vstr(3, ");
		put_sum(w, 2);
		put(w, ", \",\", 0, 3), \"\\n\")");
		break;
	default:
		put(w, "Show(Macro(), ");
		put_leaf(w);
		put(w, ") #switch (");
		put_full(w, 1);
		put(w, ") #case (1) #range (F, 3) #declare G = 1; #break #else #end");
		break;
	}
	put(w, "\n");
}

static void put_scene(struct writer *w)
{
	put(w, "#declare F = 2; #declare G = 0.5; #declare V = <1, 2, 3>; #declare W4 = <1, 2, 3, "
	       "4>;\n"
	       "#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>; #declare S = \"text\";\n"
	       "#declare R = seed(1); #declare A = array[3] { 3, 1, 2 }; #declare Empty = "
	       "array[2];\n"
	       "#declare B = array[2][2] { { 1, 2 }, { 3, 4 } };\n"
	       "#macro M(X) (X*2) #end #macro N() #local L = 3; L #end #macro Macro() F #end\n"
	       "#macro Show(X, Y) #ifdef (X) #debug str(X*1, 0, 3) #end sphere { <X, 1, Y>, Y/2 } "
	       "#end\n"
	       "#macro Change(X, Y) #declare X = Y + 1; #end\n"
	       "#macro Give(X, Y) #declare F = M(Y); #end\n"
	       "#macro Member(P) sphere { P, 1 } #end #macro Members() Ball union { sphere { 0, 1 "
	       "} } "
	       "#end\n"
	       "#declare Ball = sphere { 0, 1 } #declare Balls = array[2] { Ball, Ball };\n"
	       "#declare P = pigment { rgb 1 } #declare Shine = finish { phong 1 }\n"
	       "#declare Look = texture { P } #declare Looks = array[2] { Look, Look };\n");
	for (unsigned i = 0; i < STATEMENTS; i++)
		put_statement(w);
}

/* -- Reading ------------------------------------------------------------------------------ */

static void note_message(void *user, const struct message *m)
{
	fprintf(user, "%d %u:%u+%u %s (%zu)\n", (int)m->severity, m->place.line, m->place.column,
		m->place.length, m->text, m->chain_length);
}

static void note_text(void *user, enum keyword stream, const char *line)
{
	fprintf(user, "%s: %s\n", keyword_name(stream), line);
}

/* All that comes of a scene, as text. */
static char *read_scene(const char *text, size_t size, bool no_short_ways)
{
	char *said;
	size_t length;
	FILE *out = open_memstream(&said, &length);
	const struct parse_options options = {
		.no_file_io = true,
		.no_short_ways = no_short_ways,
		.max_loop_tokens = 20000,
		.text = note_text,
		.text_user = out,
	};
	struct arena *arena = arena_create(0);
	struct diag *diag = diag_create(note_message, out);
	const struct ast *ast = parse_scene("test.pov", text, size, &options, diag, arena);
	if (ast)
		ast_print_json(ast, diag, out);
	fclose(out);
	diag_destroy(diag);
	arena_destroy(arena);
	return said;
}

static void test_same(void **state)
{
	(void)state;
	unsigned good = 0;
	for (uint32_t i = 0; i < SCENES; i++) {
		char *text;
		size_t size;
		struct writer w = { open_memstream(&text, &size), 2654435761u * (i + 1), i % 3 == 1,
			i % 3 == 2 };
		put_scene(&w);
		fclose(w.out);
		char *quick = read_scene(text, size, false), *slow = read_scene(text, size, true);
		good += strstr(slow, "\n2 ") == NULL && slow[0] != '2';
		if (strcmp(quick, slow) != 0) {
			print_error("scene %u:\n%s\n", i, text);
			print_error("--- the short way:\n%.500s\n", quick);
			print_error("--- the grammar:\n%.500s\n", slow);
			fail();
		}
		free(quick);
		free(slow);
		free(text);
	}
	print_message("%u of %d scenes without an error\n", good, SCENES);
	assert_true(good > SCENES / 10);
}

int main(void)
{
	const struct CMUnitTest tests[] = { cmocka_unit_test(test_same) };
	return cmocka_run_group_tests(tests, NULL, NULL);
}
