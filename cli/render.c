/* SPDX-License-Identifier: MIT */
/* lambert [render] scene.pov: a scene, or the frames of an animation, to pictures. */
#include "commands.h"
#include "interrupt.h"
#include "names.h"
#include "progress.h"
#include "setup.h"
#include "stats.h"

#include <errno.h>
#include <string.h>

#define INTERRUPTED "lambert: interrupted; no picture was written\n"

/* One frame on its way; everything in it is released by job_finish. */
struct job {
	struct options *options;
	struct messages messages;
	const char *scene_path, *picture; /* picture NULL: not written */
	lambert_scene *scene;
	lambert_image *image;
	struct stats stats;
};

static void job_finish(struct job *job)
{
	lambert_image_destroy(job->image);
	lambert_scene_destroy(job->scene);
	messages_finish(&job->messages);
}

static bool load(struct job *job, const struct frames *frames, int frame)
{
	struct lambert_scene_options options;
	setup_scene(job->options, &job->messages, frames, frame, &options);
	options.progress = progress_reading;
	options.preparing = progress_preparing;
	job->scene = lambert_scene_load(job->scene_path, &options);
	messages_clear_line(&job->messages);
	if (job->scene)
		lambert_scene_statistics(job->scene, &job->stats.scene_stats);
	return job->scene != NULL;
}

static int trace(struct job *job)
{
	struct lambert_render_options options;
	struct progress progress;
	if (!setup_render(job->options, &options))
		return STATUS_ERROR;
	const char *name =
		job->picture && strcmp(job->picture, "-") != 0 ? job->picture : job->options->input;
	progress_init(&progress, &job->messages, names_file_part(name));
	options.progress = progress_step;
	options.user = &progress;
	options.stats = &job->stats.render_stats;
	job->image = lambert_render(job->scene, &options);
	progress_finish(&progress);
	return job->image ? STATUS_OK : STATUS_INTERRUPTED;
}

static bool is_wanted(void *user, double share_done)
{
	(void)user;
	(void)share_done;
	return !interrupt_requested();
}

static bool write_picture(struct job *job)
{
	struct lambert_output_options options;
	if (!job->picture)
		return true;
	if (!setup_output(job->options, &options))
		return false;
	options.progress = is_wanted;
	return lambert_image_write(
		job->image, job->picture, &options, messages_take, &job->messages);
}

static bool report(struct job *job, double start, bool append)
{
	struct stats *s = &job->stats;
	s->scene = job->scene_path;
	s->picture = job->picture;
	s->width = lambert_image_width(job->image);
	s->height = lambert_image_height(job->image);
	s->total_wall = progress_clock() - start;
	if (!job->options->quiet)
		stats_say(s, &job->messages);
	return !job->options->stats_file || stats_write(s, job->options->stats_file, append);
}

static int run(struct job *job, const struct frames *frames, int frame, double start)
{
	if (!load(job, frames, frame))
		return STATUS_ERROR;
	interrupt_defer(true, job->options->quiet ? NULL : "\n" INTERRUPTED);
	const int status = trace(job);
	if (status != STATUS_OK)
		return status;
	if (!write_picture(job))
		return interrupt_requested() ? STATUS_INTERRUPTED : STATUS_ERROR;
	return report(job, start, frame > frames->first) ? STATUS_OK : STATUS_ERROR;
}

static void refuse(void *user, const struct lambert_message *m)
{
	(void)user;
	fprintf(stderr, "lambert: error: %s\n", m->text);
}

/* Names the picture and makes sure that it can be written, before anything is rendered. */
static bool choose_picture(struct job *job, const struct frames *frames, int frame)
{
	struct options *o = job->options;
	struct lambert_output_options output;
	job->picture = names_picture(o, frame, frames->digits);
	return job->picture && names_may_write(o, job->picture) && setup_output(o, &output) &&
	       lambert_output_check(job->picture, (unsigned)o->width, (unsigned)o->height, &output,
		       refuse, NULL);
}

static int render_frame(struct options *o, const struct frames *frames, int frame)
{
	const double start = progress_clock();
	struct job job = { .options = o, .stats.frame = frame };
	if (o->output_to_file && !choose_picture(&job, frames, frame))
		return STATUS_ERROR;
	job.scene_path = names_scene(o);
	interrupt_defer(false, NULL);
	int status = STATUS_ERROR;
	if (messages_init(&job.messages, o, job.picture, frame > frames->first))
		status = run(&job, frames, frame, start);
	job_finish(&job);
	return status;
}

static void warn_of_alpha(struct options *o)
{
	struct lambert_format format;
	if (!o->output_to_file || !o->output_alpha || !names_format(o, &format))
		return;
	if (!format.alpha)
		option_warning(
			o, "the format of the picture has no alpha channel: it is not stored");
	else if (format.alpha_is_rarely_read)
		option_warning(o, "few programs read the alpha channel of a %s", format.name);
}

static int render_frames(struct options *o)
{
	struct frames frames;
	frames_init(&frames, o);
	warn_of_alpha(o);
	int status = STATUS_OK;
	for (long frame = frames.first; frame <= frames.last && status == STATUS_OK;
		frame += frames.step) {
		if (frames.is_animation && !o->quiet)
			fprintf(stderr, "frame %ld of %d to %d\n", frame, frames.first,
				frames.last);
		status = render_frame(o, &frames, (int)frame);
	}
	return status;
}

static bool write_ini(struct options *o)
{
	if (!o->create_ini)
		return true;
	if (!names_may_write(o, o->create_ini))
		return false;
	if (options_write_ini(o, o->create_ini))
		return true;
	return option_error(
		o, "the INI file %s cannot be written: %s", o->create_ini, strerror(errno));
}

int command_render(int argc, char **argv)
{
	struct options options;
	options_init(&options);
	int status = STATUS_ERROR;
	if (options_read(&options, argc, argv) && setup_check(&options) && write_ini(&options) &&
		(!options.stats_file || names_may_write(&options, options.stats_file)))
		status = render_frames(&options);
	options_finish(&options);
	if (status == STATUS_INTERRUPTED && !options.quiet)
		fputs(INTERRUPTED, stderr);
	return status;
}
