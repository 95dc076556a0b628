/* SPDX-License-Identifier: MIT */
/*
 * Exposing: which pixels are written, what progress is told, how it stops, and
 * that threads change nothing; also for a strategy of sampling that spends its
 * samples where earlier passes have found the error large. The scene is one sphere
 * without a light before a white background.
 */
#include "accel/accel.h"
#include "base/random.h"
#include "film/film.h"
#include "film/sums.h"
#include "geometry/shape.h"
#include "light/light.h"
#include "sampling.h"
#include "texture/texture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { WIDTH = 50, HEIGHT = 40 };

static const struct finish black = { .brilliance = 1, .refraction = 1 };
static const struct finish grainy = {
	.diffuse = 1, .brilliance = 1, .refraction = 1, .crand = 0.5f
};

static void add_sphere(struct scene *scene, const struct finish *finish)
{
	static const struct pigment pigment = {
		.is_plain = true, .is_opaque = true, .colour = { 1, 1, 1, 0, 0 }
	};
	struct layer *layer = ARENA_NEW(scene->arena, struct layer);
	*layer = (struct layer){ .pigment = &pigment, .finish = finish };
	struct texture *texture = ARENA_NEW(scene->arena, struct texture);
	*texture = (struct texture){ .opaque = true, .layer_count = 1, .layers = layer };
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
		.texture = texture,
		.visible_to = RAY_ALL & ~(uint32_t)RAY_SHADOW_TINTED,
		.global_lights = true };
	object_set_bounds(o);
	scene->objects = memory_alloc(1, sizeof(struct object *));
	scene->objects[scene->object_count++] = o;
}

static void add_light(struct scene *scene)
{
	struct light *light = ARENA_NEW(scene->arena, struct light);
	*light = (struct light){ .kind = light_find("point"), .colour = { 1, 1, 1 } };
	scene->lights = memory_alloc(1, sizeof(struct light *));
	scene->lights[scene->light_count++] = light;
}

static struct scene *make_scene_of(const struct finish *finish, uint32_t frame)
{
	struct scene *scene = scene_create();
	scene->camera = (struct camera){ camera_find("perspective"), { 0, 0, 0 }, { 1, 0, 0 },
		{ 0, 1, 0 }, { 0, 0, 1 } };
	scene->settings = (struct settings){ .version = 370,
		.max_trace_level = 5,
		.quality = 9,
		.adc_bailout = 1 / 255.0f,
		.working = { TRANSFER_LINEAR, 1 },
		.noise_generator = 2 };
	scene->background = (colour){ 1, 1, 1, 0, 0 };
	scene->has_background = true;
	scene->settings.frame = frame;
	add_sphere(scene, finish);
	add_light(scene);
	scene_commit(scene, 1);
	return scene;
}

static struct scene *make_scene(void)
{
	return make_scene_of(&black, 0);
}

static struct exposure whole(void)
{
	return (struct exposure){
		.sampling = sampling_of_method(0),
		.region = { 0, 0, WIDTH, HEIGHT },
		.block_size = 16,
		.threads = 1,
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
		e.sampling = sampling_of_method(method);
		e.antialias = (struct antialias){
			.threshold = 0.1, .depth = 3, .jitter = 1, .gamma = 2.5
		};
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

static struct film *expose_grain(const struct exposure *e, uint32_t frame)
{
	struct scene *scene = make_scene_of(&grainy, frame);
	struct film *film = film_create(WIDTH, HEIGHT);
	assert_true(film_expose(film, scene, e, NULL));
	scene_destroy(scene);
	return film;
}

/* Neither threads nor blocks nor regions move the noise; another frame has another. */
static void noise_belongs_to_pixel_and_frame(void **state)
{
	(void)state;
	const size_t bytes = (size_t)WIDTH * HEIGHT * sizeof(colour);
	const size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
	for (int method = 0; method < 3; method++) {
		struct exposure e = whole();
		e.sampling = sampling_of_method(method);
		e.antialias = (struct antialias){
			.threshold = 0.1, .depth = 3, .jitter = 1, .gamma = 2.5
		};
		struct film *one = expose_grain(&e, 1), *next = expose_grain(&e, 2);
		assert_true(
			memcmp(&one->pixels[middle], &next->pixels[middle], sizeof(colour)) != 0);
		e.threads = 5;
		if (method != 1) /* which looks at the border of a block */
			e.block_size = 7;
		struct film *many = expose_grain(&e, 1);
		assert_memory_equal(one->pixels, many->pixels, bytes);
		e.block_size = 32;
		e.region = (struct block){ WIDTH / 2, HEIGHT / 2, WIDTH / 2 + 1, HEIGHT / 2 + 1 };
		struct film *part = expose_grain(&e, 1);
		assert_memory_equal(&one->pixels[middle], &part->pixels[middle], sizeof(colour));
		film_destroy(one), film_destroy(next), film_destroy(many), film_destroy(part);
	}
}

/* ---- a strategy of two passes ---- */

enum { FIRST = 4, MORE = 12 };

/* Whether a pixel or one of its neighbours is uncertain. */
static bool is_uncertain(const struct film_sums *sums, unsigned x, unsigned y)
{
	const struct block around = block_common(
		sums->part, (struct block){ x ? x - 1 : 0, y ? y - 1 : 0, x + 2, y + 2 });
	for (unsigned v = around.top; v < around.bottom; v++) {
		for (unsigned u = around.left; u < around.right; u++) {
			if (pixel_sum_error(film_sum(sums, u, v)) > 0.05)
				return true;
		}
	}
	return false;
}

static uint32_t toy_wanted(
	const void *self, const struct film_sums *sums, unsigned pass, unsigned x, unsigned y)
{
	(void)self;
	if (pass == 0)
		return FIRST;
	return pass == 1 && is_uncertain(sums, x, y) ? MORE : 0;
}

/* Sample `number` of a pixel is a function of the two. */
static struct position toy_position(unsigned x, unsigned y, uint32_t number)
{
	const uint64_t key = random_mix((uint64_t)x << 32 | y, number);
	return (struct position){ x - 0.5 + random_unit(random_mix(key, 0)),
		y - 0.5 + random_unit(random_mix(key, 1)), { (int32_t)x, (int32_t)y, number } };
}

static void toy_take(
	void *self, struct sampler *s, struct film *film, struct block block, struct block inner)
{
	(void)self, (void)block;
	for (unsigned y = inner.top; y < inner.bottom; y++) {
		for (unsigned x = inner.left; x < inner.right; x++) {
			struct pixel_sum *sum = film_sum(film->sums, x, y);
			const uint32_t count = sum->wanted, first = sum->count;
			struct position at[MORE];
			colour seen[MORE];
			for (uint32_t i = 0; i < count; i++)
				at[i] = toy_position(x, y, first + i);
			s->source(s->user, count, at, seen);
			for (uint32_t i = 0; i < count; i++)
				pixel_sum_add(sum, seen[i]);
		}
	}
}

/* It could make a third pass, but wants none. */
static const struct sampling_class toy = {
	.name = "toy", .take = toy_take, .wanted = toy_wanted, .passes = 3, .reach = 1
};

static struct exposure toy_exposure(unsigned block_size, unsigned threads)
{
	struct exposure e = whole();
	e.sampling = &toy;
	e.block_size = block_size;
	e.threads = threads;
	return e;
}

static void worker_source(void *worker, size_t count, const struct position *at, colour *out)
{
	for (size_t i = 0; i < count; i++)
		out[i] = trace_sample(worker, at[i].x, at[i].y, at[i].place);
}

/* What film_expose should come to, with blocks in an order of its own. */
static struct film *toy_shuffled(const struct scene *scene)
{
	enum { SIZE = 10, COLUMNS = WIDTH / SIZE, BLOCKS = COLUMNS * (HEIGHT / SIZE) };
	struct film *film = film_create(WIDTH, HEIGHT);
	film->sums = film_sums_create(film->part);
	struct worker *worker = worker_create(scene, WIDTH, HEIGHT);
	struct sampler s;
	sampler_init(&s, &toy, &(struct antialias){ .depth = 1 }, &scene->settings.working,
		worker_source, worker);
	for (unsigned pass = 0; pass < 2; pass++) {
		for (unsigned step = 0; step < 2 * BLOCKS; step++) {
			const unsigned b = step % BLOCKS * 7 % BLOCKS;
			const unsigned left = b % COLUMNS * SIZE, top = b / COLUMNS * SIZE;
			const struct block block = { left, top, left + SIZE, top + SIZE };
			if (step < BLOCKS)
				sampler_plan(&s, film, pass, block, film->part);
			else
				sampler_take(&s, film, block, film->part);
		}
	}
	sampler_finish(&s);
	worker_destroy(worker);
	return film;
}

static void assert_same_sums(const struct film *a, const struct film *b, struct block part)
{
	for (unsigned y = part.top; y < part.bottom; y++) {
		for (unsigned x = part.left; x < part.right; x++) {
			const struct pixel_sum *s = film_sum(a->sums, x, y);
			const struct pixel_sum *t = film_sum(b->sums, x, y);
			assert_int_equal(s->count, t->count);
			assert_memory_equal(s->sum, t->sum, sizeof s->sum);
			assert_memory_equal(s->square, t->square, sizeof s->square);
		}
	}
}

static void passes_decide_from_finished_ones(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	struct film *expected = toy_shuffled(scene);
	static const unsigned sizes[] = { 1, 7, 16, 64 };
	for (size_t i = 0; i < 4; i++) {
		for (unsigned threads = 1; threads <= 5; threads += 2) {
			struct film *film = film_create(WIDTH, HEIGHT);
			const struct exposure e = toy_exposure(sizes[i], threads);
			assert_true(film_expose(film, scene, &e, NULL));
			assert_same_sums(film, expected, film->part);
			film_destroy(film);
		}
	}
	film_destroy(expected);
	scene_destroy(scene);
}

/* Pixels near the sphere's edge, and no others, have the samples of both passes. */
static void samples_go_where_the_error_is(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	struct film *film = film_create(WIDTH, HEIGHT);
	struct trace_stats stats = { 0 };
	struct progress p = { 0 };
	struct exposure e = toy_exposure(16, 2);
	e.progress = count_blocks, e.user = &p;
	assert_true(film_expose(film, scene, &e, &stats));
	assert_int_equal(p.blocks, 3 * 4 * 3);
	assert_int_equal(p.done, 2 * 4 * 3); /* nobody wants the third pass */
	uint64_t samples = 0;
	unsigned refined = 0;
	for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
		const struct pixel_sum *sum = &film->sums->pixels[i];
		const bool mixed = sum->sum[0] > 0 && sum->sum[0] < sum->count;
		assert_true(sum->count == FIRST || sum->count == FIRST + MORE);
		assert_true(!mixed || sum->count == FIRST + MORE);
		assert_true(film->pixels[i].r == (float)(sum->sum[0] / sum->count));
		samples += sum->count;
		refined += sum->count > FIRST;
	}
	assert_int_equal(stats.camera_rays, samples);
	assert_in_range(refined, 1, WIDTH * HEIGHT / 2);
	film_destroy(film);
	scene_destroy(scene);
}

/* Decisions at its border look outside the region. */
static void a_region_is_its_part_of_the_picture(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	const struct block region = { 17, 11, 26, 22 };
	struct film *full = film_create(WIDTH, HEIGHT);
	struct film *film = film_create_part(WIDTH, HEIGHT, region);
	struct exposure e = toy_exposure(8, 3);
	assert_true(film_expose(full, scene, &e, NULL));
	e.region = region;
	assert_true(film_expose(film, scene, &e, NULL));
	assert_same_sums(film, full, region);
	for (unsigned y = region.top; y < region.bottom; y++)
		assert_memory_equal(film_pixel(film, region.left, y),
			film_pixel(full, region.left, y), 9 * sizeof(colour));
	film_destroy(film);
	film_destroy(full);
	scene_destroy(scene);
}

/* Plain rendering pays for none of it. */
static void plain_films_keep_colours_only(void **state)
{
	(void)state;
	struct scene *scene = make_scene();
	for (int method = 0; method < 3; method++) {
		struct film *film = film_create(WIDTH, HEIGHT);
		struct exposure e = whole();
		e.sampling = sampling_of_method(method);
		e.antialias = (struct antialias){ .threshold = 0.3, .depth = 2, .gamma = 2.5 };
		assert_true(film_expose(film, scene, &e, NULL));
		assert_null(film->sums);
		film_destroy(film);
	}
	scene_destroy(scene);
}

static void errors_of_means(void **state)
{
	(void)state;
	struct pixel_sum sum = { .count = 0 };
	assert_true(isinf(pixel_sum_error(&sum)));
	assert_true(pixel_sum_mean(&sum).r == 0);
	for (int i = 1; i <= 4; i++)
		pixel_sum_add(&sum, (colour){ (float)i, 0.5f, 0, 0, 0 });
	assert_true(pixel_sum_mean(&sum).r == 2.5f && pixel_sum_mean(&sum).g == 0.5f);
	/* variance 5/3, of the mean of four 5/12 */
	assert_true(fabs(pixel_sum_error(&sum) - sqrt(5.0 / 12)) < 1e-15);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(background_and_sphere),
		cmocka_unit_test(only_the_region),
		cmocka_unit_test(stops_when_told),
		cmocka_unit_test(same_for_any_threads_and_blocks),
		cmocka_unit_test(noise_belongs_to_pixel_and_frame),
		cmocka_unit_test(passes_decide_from_finished_ones),
		cmocka_unit_test(samples_go_where_the_error_is),
		cmocka_unit_test(a_region_is_its_part_of_the_picture),
		cmocka_unit_test(plain_films_keep_colours_only),
		cmocka_unit_test(errors_of_means),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
