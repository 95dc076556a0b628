/* SPDX-License-Identifier: MIT */
/* lambert check scene.pov: reads a scene and says what is wrong with it. */
#include "commands.h"
#include "names.h"
#include "progress.h"
#include "setup.h"

static void say_result(const struct options *o, const struct messages *m, bool good,
	const struct lambert_scene_stats *s)
{
	if (o->quiet || o->json)
		return;
	if (good)
		fprintf(stderr, "%s: good: %zu object%s, %zu light%s, %u warning%s\n", o->input,
			s->objects, s->objects == 1 ? "" : "s", s->lights,
			s->lights == 1 ? "" : "s", m->warnings, m->warnings == 1 ? "" : "s");
	else
		fprintf(stderr, "%s: %u error%s, %u warning%s\n", o->input, m->errors,
			m->errors == 1 ? "" : "s", m->warnings, m->warnings == 1 ? "" : "s");
}

static int check(struct options *o)
{
	struct messages messages;
	struct frames frames;
	struct lambert_scene_options options;
	struct lambert_scene_stats stats;
	bool good = false;
	frames_init(&frames, o);
	if (messages_init(&messages, o, NULL, false)) {
		messages.json = o->json ? stdout : NULL;
		setup_scene(o, &messages, &frames, frames.first, &options);
		options.progress = progress_reading;
		good = lambert_scene_check(names_scene(o), &options, &stats);
		messages_clear_line(&messages);
		say_result(o, &messages, good, &stats);
	}
	messages_finish(&messages);
	return good ? STATUS_OK : STATUS_ERROR;
}

int command_check(int argc, char **argv)
{
	struct options options;
	options_init(&options);
	int status = STATUS_ERROR;
	if (options_read(&options, argc, argv) && setup_check(&options))
		status = check(&options);
	options_finish(&options);
	return status;
}
