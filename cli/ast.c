/* SPDX-License-Identifier: MIT */
/* lambert ast scene.pov: the syntax tree of a scene as JSON on standard output. */
#include "commands.h"
#include "names.h"
#include "setup.h"

static int print_ast(struct options *o)
{
	struct messages messages;
	struct frames frames;
	struct lambert_scene_options options;
	frames_init(&frames, o);
	bool ok = messages_init(&messages, o, NULL, false);
	if (ok) {
		setup_scene(o, &messages, &frames, frames.first, &options);
		ok = lambert_scene_print_ast(names_scene(o), &options, stdout);
	}
	messages_finish(&messages);
	return ok ? STATUS_OK : STATUS_ERROR;
}

int command_ast(int argc, char **argv)
{
	struct options options;
	options_init(&options);
	int status = STATUS_ERROR;
	if (options_read(&options, argc, argv) && setup_check(&options))
		status = print_ast(&options);
	options_finish(&options);
	return status;
}
