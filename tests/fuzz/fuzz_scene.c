/* SPDX-License-Identifier: MIT */
/*
 * Any bytes as a scene: it is read, lowered, asked what its text asks, and
 * rendered at 8 x 8 pixels. All must end, with a picture or with messages.
 *
 * Files cannot be written, endless loops are cut short, and a picture that takes
 * long is given up between two rows. Texts that ask for endless work in a single
 * pixel are left out. Includes are not found, for there is no library path. The
 * preset `fuzz` builds it; tests/fuzz/run runs it.
 */
#include "lambert/lambert.h"

#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#define LOOP_TOKENS    20000
#define RENDER_SECONDS 2.0

static void note_error(void *user, const struct lambert_message *message)
{
	bool *has_error = user;
	*has_error = *has_error || message->severity == LAMBERT_ERROR;
}

static double seconds_now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool is_in_time(void *end, double share_done)
{
	(void)share_done;
	return seconds_now() < *(const double *)end;
}

static void render(const lambert_scene *scene)
{
	double end = seconds_now() + RENDER_SECONDS;
	struct lambert_render_options options;
	lambert_render_options_init(&options);
	options.threads = 1;
	options.progress = is_in_time;
	options.user = &end;
	lambert_image_destroy(lambert_render(scene, &options));
}

static void load_and_render(const char *path)
{
	bool has_error = false;
	struct lambert_scene_options options;
	lambert_scene_options_init(&options);
	options.width = options.height = 8;
	options.threads = 1;
	options.loop_limit = LOOP_TOKENS;
	options.no_file_io = true;
	options.message = note_error;
	options.user = &has_error;
	lambert_scene *scene = lambert_scene_load(path, &options);
	if (!scene && !has_error)
		__builtin_trap(); /* failing without a word is a fault, too */
	if (scene)
		render(scene);
	lambert_scene_destroy(scene);
}

/* Whether the text has `word`. */
static bool has(const uint8_t *bytes, size_t size, const char *word)
{
	return memmem(bytes, size, word, strlen(word)) != NULL;
}

/* Work that a scene may ask for, for each point: iterations of fractals, levels of mirrors, octaves. */
static bool may_ask_without_end(const uint8_t *bytes, size_t size)
{
	static const char *const words[] = { "mandel", "julia", "max_trace_level", "_mf",
		"internal", "area_light" };
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		if (has(bytes, size, words[i]))
			return true;
	}
	return false;
}

/* Whether a number is written in the text that has more than four digits before its point or an exponent. */
static bool has_large_number(const uint8_t *bytes, size_t size)
{
	size_t digits = 0;
	for (size_t i = 0; i < size; i++) {
		const bool is_digit = bytes[i] >= '0' && bytes[i] <= '9';
		if (digits > 4 || (digits > 0 && (bytes[i] == 'e' || bytes[i] == 'E')))
			return true;
		digits = is_digit ? digits + 1 : 0;
	}
	return digits > 4;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	if (may_ask_without_end(bytes, size) && has_large_number(bytes, size))
		return -1;
	const int file = memfd_create("fuzz.pov", 0);
	char path[32];
	snprintf(path, sizeof path, "/proc/self/fd/%d", file);
	if (write(file, bytes, size) == (ssize_t)size)
		load_and_render(path);
	close(file);
	return 0;
}
