/* SPDX-License-Identifier: MIT */
/*
 * Loading through the public API: what is told of it, and that it stops when it is
 * told to, in the text and in each pass of the preparation, without a message.
 */
#include <lambert/lambert.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

/* Two passes: f_ridged_mf remembers its first call. */
#define RIDGED "load_first_calls.pov"
#define PLAIN  "../scenes/shape_sphere.pov"

enum { STEPS = 64 };

struct told {
	char what[STEPS][64];
	double share[STEPS];
	int steps, stop_at; /* stop_at 0: never */
	int places, messages;
	bool slow, reads_on;
};

static void count_message(void *user, const struct lambert_message *m)
{
	struct told *t = user;
	t->messages += m->severity == LAMBERT_ERROR;
}

static bool take_step(void *user, const char *what, double share_done, double seconds)
{
	struct told *t = user;
	assert_true(seconds >= 0 && share_done >= 0 && share_done <= 1);
	if (t->steps < STEPS) {
		strncpy(t->what[t->steps], what, sizeof t->what[0] - 1);
		t->share[t->steps] = share_done;
	}
	t->steps++;
	if (t->slow) /* so that the next block is worth telling of */
		nanosleep(&(struct timespec){ .tv_nsec = 260000000 }, NULL);
	return t->steps != t->stop_at;
}

static bool take_place(void *user, const struct lambert_place *place, double seconds)
{
	struct told *t = user;
	assert_true(place->line > 0 && seconds > 0);
	t->places++;
	return t->reads_on;
}

static struct lambert_scene_options options_for(struct told *t)
{
	struct lambert_scene_options o;
	lambert_scene_options_init(&o);
	o.threads = 1;
	o.message = count_message;
	o.progress = take_place;
	o.preparing = take_step;
	o.user = t;
	return o;
}

static bool loads(const char *path, struct told *t)
{
	const struct lambert_scene_options o = options_for(t);
	lambert_scene *scene = lambert_scene_load(path, &o);
	lambert_scene_destroy(scene);
	assert_int_equal(t->messages, 0);
	return scene != NULL;
}

static void tells_of_the_passes_it_needs(void **state)
{
	(void)state;
	struct told plain = { .reads_on = true }, ridged = { .reads_on = true };
	assert_true(loads(PLAIN, &plain));
	assert_int_equal(plain.steps, 1);
	assert_true(loads(RIDGED, &ridged));
	assert_in_range(ridged.steps, 2, STEPS);
	assert_string_equal(ridged.what[0], plain.what[0]);
	assert_string_not_equal(ridged.what[0], ridged.what[1]);
	assert_true(ridged.share[0] == 0 && ridged.share[1] == 0);
}

static void stops_before_each_pass(void **state)
{
	(void)state;
	for (int step = 1; step <= 2; step++) {
		struct told t = { .reads_on = true, .stop_at = step };
		assert_false(loads(RIDGED, &t));
		assert_int_equal(t.steps, step);
	}
}

static void stops_within_a_pass(void **state)
{
	(void)state;
	struct told t = { .reads_on = true, .stop_at = 3, .slow = true };
	assert_false(loads(RIDGED, &t));
	assert_int_equal(t.steps, 3);
	assert_string_equal(t.what[2], t.what[1]);
	assert_true(t.share[2] > 0);
}

static void stops_reading(void **state)
{
	(void)state;
	struct told t = { .reads_on = false };
	assert_false(loads("load_endless.pov", &t));
	assert_int_equal(t.places, 1);
	assert_int_equal(t.steps, 0);
	const struct lambert_scene_options o = options_for(&t);
	struct lambert_scene_stats stats;
	assert_false(lambert_scene_check("load_endless.pov", &o, &stats));
	assert_int_equal(t.places, 2);
	assert_int_equal(t.messages, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(tells_of_the_passes_it_needs),
		cmocka_unit_test(stops_before_each_pass),
		cmocka_unit_test(stops_within_a_pass),
		cmocka_unit_test(stops_reading),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
