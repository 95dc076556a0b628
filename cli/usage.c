/* SPDX-License-Identifier: MIT */
/* How the program and its subcommands are used, one screen each. */
#include "commands.h"

#include <stdio.h>
#include <string.h>

static const struct {
	const char *command, *text;
} usages[] = {
	{ "", "lambert renders scenes written in the POV-Ray 3.7 scene language.\n"
	      "\n"
	      "  lambert scene.pov -o picture.png --size 640x480     render a scene\n"
	      "  lambert check scene.pov                             look for errors only\n"
	      "  lambert ast scene.pov                               print the syntax tree as "
	      "JSON\n"
	      "  lambert diff a.png b.png                            compare two pictures\n"
	      "\n"
	      "  lambert COMMAND --help    more about render, check, ast or diff\n"
	      "  lambert --version         the version\n"
	      "\n"
	      "POV-Ray's switches and INI files work too: lambert +Iscene.pov +W640 +H480 +A0.3\n"
	      "\n"
	      "Exit status: 0 complete, 1 error, 2 interrupted.\n" },
	{ "render",
		"lambert [render] scene.pov [options]     render a scene\n"
		"\n"
		"  -o, --output FILE        the picture; its extension chooses the format; - is\n"
		"                           standard output (default: named after the scene)\n"
		"  --size WxH               size in pixels\n"
		"  --antialias[=METHOD[:THRESHOLD[:DEPTH]]]\n"
		"                           method 1 or 2 (1), threshold 0 to 1 (0.3), depth 1 to "
		"9 (3)\n"
		"  --jitter AMOUNT          of antialiasing, 0 to 1 (1)\n"
		"  --quality N              0 to 9 (9)\n"
		"  --region L,T,R,B         only these pixels; R and B one past the last\n"
		"  --declare NAME=VALUE     an identifier for the scene, a number or a text\n"
		"  --include-path DIR       one more folder to search for files\n"
		"  --clock VALUE            the clock of a still picture\n"
		"  --language-version V     for scenes without #version\n"
		"  --threads N              (as many as processors)\n"
		"  --format F               png ppm tga bmp jpeg exr hdr tiff\n"
		"  --bits N                 5 to 16 per channel (8)\n"
		"  --gamma G                of the file: a number or sRGB (sRGB)\n"
		"  --alpha, --grayscale, --dither[=B2|B3|B4|D1|D2|FS]\n"
		"  --ini FILE[SECTION]      read POV-Ray options from a file\n"
		"  --no-file-io, --allow-read DIR, --allow-write DIR\n"
		"                           limit what a scene may read and write\n"
		"  --loop-limit TOKENS      after which loops are taken for endless (2e10; 0: "
		"never)\n"
		"  --progress bar|lines|off, --quiet\n"
		"  --stats FILE             times, rays and memory as JSON (- is standard output)\n"
		"\n"
		"POV-Ray's switches are +I +O +W +H +A +AM +R +J +Q +WT +L +F +KFF and so on.\n" },
	{ "check",
		"lambert check scene.pov [options]     look for errors without rendering\n"
		"\n"
		"  --json     messages as JSON, one a line, on standard output\n"
		"  --quiet    errors only\n"
		"\n"
		"and the options of lambert render that a scene can see: --size, --declare,\n"
		"--include-path, --clock, --language-version, --loop-limit. Exit status 0: good,\n"
		"1: errors.\n" },
	{ "ast",
		"lambert ast scene.pov [options]     print the syntax tree of a scene as JSON\n"
		"\n"
		"The options are those of lambert render that a scene can see: --size, --declare,\n"
		"--include-path, --clock, --language-version, --loop-limit.\n" },
	{ "diff",
		"lambert diff a.png b.png [options]     compare two pictures\n"
		"\n"
		"  --tolerance T     match when every sample is within T/255 (default: 99.5 % of\n"
		"                    the pixels within 2/255 and RMSE at most 1.5/255)\n"
		"  --heatmap FILE    write a PNG of where they differ\n"
		"  --json            the figures as JSON\n"
		"  --quiet           the exit status only\n"
		"\n"
		"Exit status: 0 match, 1 no match or an error.\n" },
};

int usage_print(const char *command)
{
	for (size_t i = 0; i < sizeof usages / sizeof *usages; i++) {
		if (strcmp(usages[i].command, command) == 0) {
			fputs(usages[i].text, stdout);
			return STATUS_OK;
		}
	}
	fprintf(stderr, "lambert: error: there is no command %s\n", command);
	return STATUS_ERROR;
}
