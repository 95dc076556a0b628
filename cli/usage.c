/* SPDX-License-Identifier: MIT */
/*
 * How the program and its subcommands are used, one screen each. The options are
 * those of options.def; `lambert help markdown` prints them for docs/cli.md.
 */
#include "commands.h"
#include "options.h"

#include <stdio.h>
#include <string.h>

static const struct {
	const char *command, *text;
	unsigned shown; /* the options behind the text */
	const char *end;
} usages[] = {
	{ "",
		"lambert renders scenes written in the POV-Ray 3.7 scene language.\n"
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
		"Exit status: 0 complete, 1 error, 2 interrupted.\n",
		SHOWN_NOWHERE, "" },
	{ "render", "lambert [render] scene.pov [options]     render a scene\n\n", SHOWN_RENDER,
		"\n"
		"Without -o the picture is named after the scene. POV-Ray's switches are +I +O +W\n"
		"+H +A +AM +R +J +Q +WT +L +F +KFF and so on.\n" },
	{ "check", "lambert check scene.pov [options]     look for errors without rendering\n\n",
		SHOWN_CHECK, "\nExit status: 0 good, 1 errors.\n" },
	{ "ast", "lambert ast scene.pov [options]     print the syntax tree of a scene as JSON\n\n",
		SHOWN_AST, "" },
	{ "diff",
		"lambert diff a.png b.png [options]     compare two pictures\n"
		"\n"
		"  --tolerance T     match when every sample is within T/255 (default: 99.5 % of\n"
		"                    the pixels within 2/255 and RMSE at most 1.5/255)\n"
		"  --heatmap FILE    write a PNG of where they differ\n"
		"  --json            the figures as JSON\n"
		"  --quiet           the exit status only\n"
		"\n"
		"Exit status: 0 match, 1 no match or an error.\n",
		SHOWN_NOWHERE, "" },
};

enum { HELP_COLUMN = 25 };

/* "-o, --output FILE" */
static int print_name(const struct option_row *row)
{
	const bool has_letter = *row->letter;
	return printf("%s%s%s--%s%s", has_letter ? "-" : "", row->letter, has_letter ? ", " : "",
		row->name, row->value ? row->value : "");
}

static void print_option(const struct option_row *row)
{
	fputs("  ", stdout);
	int column = print_name(row);
	if (column >= HELP_COLUMN) {
		fputs("\n  ", stdout);
		column = 0;
	}
	printf("%*s%s\n", HELP_COLUMN - column, "", row->help);
}

static void print_escaped(const char *text)
{
	for (; *text; text++)
		printf(*text == '|' ? "\\%c" : "%c", *text);
}

/* A row of the table of docs/cli.md. */
static void print_markdown(const struct option_row *row)
{
	printf("| `%s%s", *row->letter ? "-" : "", row->letter);
	printf("%s--%s", *row->letter ? "`, `" : "", row->name);
	print_escaped(row->value ? row->value : "");
	fputs("` | ", stdout);
	print_escaped(row->help);
	fputs(" |\n", stdout);
}

static void print_options(unsigned shown, void (*print)(const struct option_row *))
{
	for (size_t i = 0; i < option_count; i++)
		if (option_rows[i].shown & shown)
			print(&option_rows[i]);
}

int usage_print(const char *command)
{
	for (size_t i = 0; i < sizeof usages / sizeof *usages; i++) {
		if (strcmp(usages[i].command, command) == 0) {
			fputs(usages[i].text, stdout);
			print_options(usages[i].shown, print_option);
			fputs(usages[i].end, stdout);
			return STATUS_OK;
		}
	}
	if (strcmp(command, "markdown") == 0) {
		print_options(SHOWN_SCENE, print_markdown);
		return STATUS_OK;
	}
	fprintf(stderr, "lambert: error: there is no command %s\n", command);
	return STATUS_ERROR;
}
