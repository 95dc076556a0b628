/* SPDX-License-Identifier: MIT */
/* What a picture cost; times in seconds, memory in bytes. */
#include "stats.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <sys/resource.h>

static double seconds(struct timeval t)
{
	return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

static void print_scene(FILE *file, const struct lambert_scene_stats *s)
{
	fprintf(file, "\"tokens\": %zu, \"objects\": %zu, \"lights\": %zu, ", s->tokens, s->objects,
		s->lights);
	fprintf(file, "\"unbounded_objects\": %zu, \"accel_bytes\": %zu, ", s->unbounded_objects,
		s->accel_bytes);
	fprintf(file, "\"parse_cpu\": %.6f, \"lower_cpu\": %.6f, \"build_cpu\": %.6f, ",
		s->parse_cpu, s->lower_cpu, s->build_cpu);
}

static void print_render(FILE *file, const struct lambert_render_stats *r)
{
	fprintf(file, "\"trace_cpu\": %.6f, \"trace_wall\": %.6f, ", r->trace_cpu, r->trace_wall);
	fprintf(file, "\"camera_rays\": %" PRIu64 ", \"reflected_rays\": %" PRIu64 ", ",
		r->camera_rays, r->reflected_rays);
	fprintf(file, "\"refracted_rays\": %" PRIu64 ", \"transmitted_rays\": %" PRIu64 ", ",
		r->refracted_rays, r->transmitted_rays);
	fprintf(file, "\"shadow_rays\": %" PRIu64 ", \"max_level\": %" PRIu64 ", ", r->shadow_rays,
		r->max_level);
}

static void print_json(FILE *file, const struct stats *s)
{
	struct rusage usage;
	getrusage(RUSAGE_SELF, &usage);
	fputs("{\"scene\": ", file);
	lambert_print_json_string(s->scene, file);
	fputs(", \"picture\": ", file);
	lambert_print_json_string(s->picture ? s->picture : "", file);
	fprintf(file, ", \"width\": %u, \"height\": %u, \"frame\": %d, ", s->width, s->height,
		s->frame);
	print_scene(file, &s->scene_stats);
	print_render(file, &s->render_stats);
	fprintf(file, "\"total_cpu\": %.6f, \"total_wall\": %.6f, \"peak_memory\": %ld}\n",
		seconds(usage.ru_utime) + seconds(usage.ru_stime), s->total_wall,
		1024 * usage.ru_maxrss);
}

bool stats_write(const struct stats *s, const char *path, bool append)
{
	if (strcmp(path, "-") == 0) {
		print_json(stdout, s);
		return true;
	}
	FILE *file = fopen(path, append ? "a" : "w");
	if (!file) {
		fprintf(stderr, "lambert: error: the statistics %s cannot be written: %s\n", path,
			strerror(errno));
		return false;
	}
	print_json(file, s);
	if (fclose(file) == 0)
		return true;
	fprintf(stderr, "lambert: error: the statistics %s cannot be written: %s\n", path,
		strerror(errno));
	return false;
}

void stats_say(const struct stats *s, struct messages *m)
{
	const struct lambert_render_stats *r = &s->render_stats;
	const double prepare =
		s->scene_stats.parse_cpu + s->scene_stats.lower_cpu + s->scene_stats.build_cpu;
	messages_say(m, STREAM_STATISTIC,
		"%s%s%u x %u in %.2f s (CPU: %.2f s prepare, %.2f s trace), %" PRIu64
		" camera and %" PRIu64 " shadow rays",
		s->picture ? s->picture : "", s->picture ? ": " : "", s->width, s->height,
		s->total_wall, prepare, r->trace_cpu, r->camera_rays, r->shadow_rays);
}
