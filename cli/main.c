/* SPDX-License-Identifier: MIT */
/* The command line: chooses the subcommand; without one, it is render. */
#include "commands.h"
#include "interrupt.h"
#include "nearest.h"

#include "lambert/lambert.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const struct {
	const char *name;
	int (*run)(int argc, char **argv);
} commands[] = {
	{ "render", command_render },
	{ "check", command_check },
	{ "ast", command_ast },
	{ "diff", command_diff },
};

/* POV-Ray's spellings too; -h alone is help, -h240 a height. */
static bool is_help(const char *argument)
{
	return strcmp(argument, "--help") == 0 || strcmp(argument, "-help") == 0 ||
	       strcmp(argument, "-h") == 0 || strcmp(argument, "-?") == 0;
}

static bool is_version(const char *argument)
{
	return strcmp(argument, "--version") == 0 || strcmp(argument, "-version") == 0 ||
	       strcmp(argument, "--V") == 0;
}

static bool asks_for_help(int argc, char **argv)
{
	for (int i = 0; i < argc; i++)
		if (is_help(argv[i]))
			return true;
	return false;
}

static int run(const char *name, int (*command)(int argc, char **argv), int argc, char **argv)
{
	return asks_for_help(argc, argv) ? usage_print(name) : command(argc, argv);
}

/* The command that a first argument is nearly, if it names no file; NULL: none. */
static const char *command_meant(const char *word)
{
	const char *best = NULL;
	const size_t length = strlen(word);
	char ini[32];
	if (snprintf(ini, sizeof ini, "%s.ini", word) >= (int)sizeof ini)
		return NULL;
	if (access(word, F_OK) == 0 || access(ini, F_OK) == 0)
		return NULL;
	for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
		if (nearest_is_near(nearest_distance(word, length, commands[i].name), length))
			best = commands[i].name;
	return best;
}

static int dispatch(int argc, char **argv)
{
	if (argc == 0 || is_help(argv[0]))
		return usage_print("");
	if (strcmp(argv[0], "help") == 0)
		return usage_print(argc > 1 ? argv[1] : "");
	if (is_version(argv[0])) {
		puts("lambert " LAMBERT_VERSION);
		return STATUS_OK;
	}
	for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
		if (strcmp(argv[0], commands[i].name) == 0)
			return run(commands[i].name, commands[i].run, argc - 1, argv + 1);
	const char *meant = command_meant(argv[0]);
	if (meant) {
		fprintf(stderr, "lambert: error: there is no command \"%s\"; perhaps %s is meant\n",
			argv[0], meant);
		return STATUS_ERROR;
	}
	return run("render", command_render, argc, argv);
}

/* Whether everything that was printed has arrived. */
static bool output_complete(void)
{
	errno = 0;
	if (fflush(stdout) == 0 && !ferror(stdout))
		return true;
	fprintf(stderr, "lambert: error: standard output cannot be written%s%s\n",
		errno ? ": " : "", errno ? strerror(errno) : "");
	return false;
}

int main(int argc, char **argv)
{
	interrupt_init();
	const int status = dispatch(argc - 1, argv + 1);
	return output_complete() || status != STATUS_OK ? status : STATUS_ERROR;
}
