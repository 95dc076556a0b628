/* SPDX-License-Identifier: MIT */
/* The subcommands. Each gets the arguments after its name and returns the exit status. */
#ifndef LAMBERT_CLI_COMMANDS_H
#define LAMBERT_CLI_COMMANDS_H

enum { STATUS_OK = 0, STATUS_ERROR = 1, STATUS_INTERRUPTED = 2 };

int command_render(int argc, char **argv);
int command_ast(int argc, char **argv);
int command_check(int argc, char **argv);
int command_diff(int argc, char **argv);

/* Prints how a subcommand is used ("" for the program); STATUS_ERROR when there is none of this
 * name. */
int usage_print(const char *command);

#endif
