/* SPDX-License-Identifier: MIT */
/* lambert check scene.pov: reads and prepares a scene without rendering it. */
#include "commands.h"
#include "names.h"
#include "setup.h"

static void say_result(const struct options *o, const struct messages *m, lambert_scene *scene)
{
	if (o->quiet || o->json)
		return;
	struct lambert_scene_stats s = { 0 };
	if (scene)
		lambert_scene_statistics(scene, &s);
	if (scene)
		fprintf(stderr, "%s: good: %zu object%s, %zu light%s, %u warning%s\n", o->input,
			s.objects, s.objects == 1 ? "" : "s", s.lights, s.lights == 1 ? "" : "s",
			m->warnings, m->warnings == 1 ? "" : "s");
	else
		fprintf(stderr, "%s: %u error%s, %u warning%s\n", o->input, m->errors,
			m->errors == 1 ? "" : "s", m->warnings, m->warnings == 1 ? "" : "s");
}

static int check(struct options *o)
{
	struct messages messages;
	struct frames frames;
	struct lambert_scene_options options;
	lambert_scene *scene = NULL;
	frames_init(&frames, o);
	if (messages_init(&messages, o, NULL, false)) {
		messages.json = o->json ? stdout : NULL;
		setup_scene(o, &messages, &frames, frames.first, &options);
		scene = lambert_scene_load(names_scene(o), &options);
		say_result(o, &messages, scene);
	}
	messages_finish(&messages);
	lambert_scene_destroy(scene);
	return scene ? STATUS_OK : STATUS_ERROR;
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
