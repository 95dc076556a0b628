/* SPDX-License-Identifier: MIT */
/*
 * Exposing: which pixels are written, what progress is told, how it stops, and
 * that threads change nothing. The scene is one sphere without a light before a
 * white background.
 */
#include "accel/accel.h"
#include "film/film.h"
#include "geometry/shape.h"
#include "texture/texture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { WIDTH = 50, HEIGHT = 40 };

static void add_sphere(struct scene *scene)
{
	static const struct pigment pigment = {
		.is_plain = true, .is_opaque = true, .colour = { 1, 1, 1, 0, 0 }
	};
	static const struct finish finish = { .brilliance = 1, .refraction = 1 };
	static const struct layer layer = { .pigment = &pigment, .finish = &finish };
	static const struct texture texture = {
		.opaque = true, .layer_count = 1, .layers = &layer
	};
	const struct shape_class *shape = shape_find("sphere");
	const struct {
		vec3 centre;
		double radius;
	} sphere = { { 0, 0, 5 }, 1 };
	char *self = arena_alloc(scene->arena, shape->size);
	memcpy(self + shape->fields[0].offset, &sphere, sizeof sphere);
	struct object *o = ARENA_NEW(scene->arena, struct object);
	*o = (struct object){ .shape = shape,
		.self = self,
		.texture = &texture,
		.visible_to = RAY_ALL & ~(uint32_t)RAY_SHADOW_TINTED,
		.global_lights = true };
	object_set_bounds(o);
	scene->objects = memory_alloc(1, sizeof(struct object *));
	scene->objects[scene->object_count++] = o;
}

static struct scene *make_scene(void)
{
	struct scene *scene = scene_create();
	scene->camera = (struct camera){ CAMERA_PERSPECTIVE, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
		{ 0, 0, 1 } };
	scene->settings = (struct settings){ .version = 370,
		.max_trace_level = 5,
		.quality = 9,
		.adc_bailout = 1 / 255.0f,
		.working = { TRANSFER_LINEAR, 1 },
		.noise_generator = 2 };
	scene->background = (colour){ 1, 1, 1, 0, 0 };
	scene->has_background = true;
	add_sphere(scene);
	scene_commit(scene, 1);
	return scene;
}

static struct exposure whole(void)
{
	return (struct exposure){
		.region = { 0, 0, WIDTH, HEIGHT }, .block_size = 16, .threads = 1
	};
}

struct progress {
	unsigned done, stop_at, blocks;
};

static bool count_blocks(void *user, unsigned done, unsigned blocks)
{
	struct progress *p = user;
	/* the same number again between the rows of a block */
	assert_true(done == p->done || done == p->done + 1);
	p->done = done;
	p->blocks = blocks;
	return p->stop_at == 0 || done < p->stop_at;
}

static bool is_nothing(colour c)
{
	return c.r == 0 && c.g == 0 && c.b == 0 && c.filter == 0 && c.transmit == 0;
}

static void background_and_sphere(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	struct film *film = film_create(WIDTH, HEIGHT);
	struct trace_stats stats = { 0 };
	const struct exposure e = whole();
	assert_true(film_expose(film, scene, &e, &stats));
	assert_int_equal(stats.camera_rays, WIDTH * HEIGHT);
	assert_true(film->pixels[0].r == 1);
	assert_true(film->pixels[HEIGHT / 2 * WIDTH + WIDTH / 2].r == 0);
	film_destroy(film);
	scene_destroy(scene);
}

static void only_the_region(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	const struct block region = { 7, 3, 41, 37 };
	struct film *film = film_create_part(WIDTH, HEIGHT, region);
	struct film *full = film_create(WIDTH, HEIGHT);
	struct exposure e = whole();
	assert_true(film_expose(full, scene, &e, NULL));
	struct progress p = { 0 };
	e.region = region;
	e.progress = count_blocks, e.user = &p;
	assert_true(film_expose(film, scene, &e, NULL));
	assert_int_equal(p.done, 9); /* 34 x 34 pixels in three blocks of 16 each way */
	assert_int_equal(p.blocks, 9);
	for (unsigned y = region.top; y < region.bottom; y++)
		assert_memory_equal(film_pixel(film, region.left, y),
			film_pixel(full, region.left, y), 34 * sizeof(colour));
	e.region.right = e.region.left;
	assert_true(film_expose(film, scene, &e, NULL));
	film_destroy(film);
	film_destroy(full);
	scene_destroy(scene);
}

static void stops_when_told(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	struct film *film = film_create(WIDTH, HEIGHT);
	struct progress p = { .stop_at = 2 };
	struct exposure e = whole();
	e.progress = count_blocks, e.user = &p;
	assert_false(film_expose(film, scene, &e, NULL));
	assert_int_equal(p.done, 2);
	assert_true(film->pixels[31].r == 1);
	assert_true(is_nothing(film->pixels[32]));
	film_destroy(film);
	scene_destroy(scene);
}

static void same_for_any_threads_and_blocks(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	const size_t bytes = (size_t)WIDTH * HEIGHT * sizeof(colour);
	for (int method = 0; method < 3; method++) {
		struct film *one = film_create(WIDTH, HEIGHT), *many = film_create(WIDTH, HEIGHT);
		struct exposure e = whole();
		e.antialias = (struct antialias){ method, .threshold = 0.1, .depth = 3, .jitter = 1,
			.gamma = 2.5 };
		assert_true(film_expose(one, scene, &e, NULL));
		struct progress p = { 0 };
		e.threads = 5;
		e.progress = count_blocks, e.user = &p;
		if (method != 1) /* which looks at the border of a block */
			e.block_size = 7;
		assert_true(film_expose(many, scene, &e, NULL));
		assert_int_equal(p.done, p.blocks);
		assert_memory_equal(one->pixels, many->pixels, bytes);
		film_destroy(one);
		film_destroy(many);
	}
	scene_destroy(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(background_and_sphere),
		cmocka_unit_test(only_the_region),
		cmocka_unit_test(stops_when_told),
		cmocka_unit_test(same_for_any_threads_and_blocks),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
