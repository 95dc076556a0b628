/* SPDX-License-Identifier: MIT */
/*
 * What a surface is and what lights send, each without the other: the
 * illumination model, the rules for layers, and light arriving at a point.
 */
#include "integrate/trace.h"
#include "arriving/arriving.h"
#include "surface/transmission.h"

#include "geometry/shape.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define CLOSE(a, b) assert_true(fabs((double)(a) - (double)(b)) < 1e-6)
#define HALF_ROOT   0.70710678118654752440
#define ONE_LIGHT   0 /* its number */

/* ---- a scene: one sphere of radius 1 about the origin, one light above it ---- */

static void add_sphere(struct scene *scene)
{
	static const struct finish finish = { .brilliance = 1, .refraction = 1 };
	static const struct pigment pigment = { .is_plain = true, .is_opaque = true };
	static const struct layer layer = { .pigment = &pigment, .finish = &finish };
	static const struct texture texture = {
		.opaque = true, .layer_count = 1, .layers = &layer
	};
	const struct shape_class *shape = shape_find("sphere");
	const struct {
		vec3 centre;
		double radius;
	} sphere = { { 0, 0, 0 }, 1 };
	char *self = arena_alloc(scene->arena, shape->size);
	memcpy(self + shape->fields[0].offset, &sphere, sizeof sphere);
	struct object *o = ARENA_NEW(scene->arena, struct object);
	*o = (struct object){ .shape = shape,
		.self = self,
		.texture = &texture,
		.visible_to = RAY_ALL & ~(uint32_t)RAY_SHADOW_TINTED };
	object_set_bounds(o);
	scene->objects = memory_alloc(1, sizeof(struct object *));
	scene->objects[scene->object_count++] = o;
}

static struct light *add_light(struct scene *scene)
{
	struct light *light = ARENA_NEW(scene->arena, struct light);
	*light = (struct light){
		.kind = light_find("point"), .location = { 0, 10, 0 }, .colour = { 1, 2, 3 }
	};
	scene->lights = memory_alloc(1, sizeof(struct light *));
	scene->lights[scene->light_count++] = light;
	return light;
}

struct setting {
	struct scene *scene;
	struct light *light;
	struct worker *worker;
};

static struct setting setting_make(void)
{
	struct setting s = { .scene = scene_create() };
	s.scene->camera.kind = camera_find("perspective");
	s.scene->camera.location = vec(0, 0, -9);
	s.scene->settings = (struct settings){ .version = 370,
		.max_trace_level = 5,
		.quality = 9,
		.adc_bailout = 1 / 255.0f,
		.noise_generator = 2 };
	add_sphere(s.scene);
	s.light = add_light(s.scene);
	scene_commit(s.scene, 1);
	s.worker = worker_create(s.scene, 4, 3);
	return s;
}

static void setting_end(struct setting *s)
{
	worker_destroy(s->worker);
	scene_destroy(s->scene);
}

/* ---- light ---- */

static rgb arriving(const struct setting *s, vec3 p)
{
	const struct interior_stack none = { 0 };
	const struct light_target target = { .point = p, .interiors = &none };
	struct light_sample sample;
	assert_true(light_aim(s->worker, s->light, &p, &sample));
	light_arriving(s->worker, &target, &sample, 1);
	return sample.radiance;
}

/* No surface is at these points. */
static void light_arrives_in_space(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	CLOSE(arriving(&s, vec(3, 0, 0)).g, 2);
	CLOSE(arriving(&s, vec(0, 5, 0)).b, 3);
	CLOSE(arriving(&s, vec(0, -5, 0)).g, 0); /* behind the sphere */
	s.light->kind = light_find("shadowless");
	CLOSE(arriving(&s, vec(0, -5, 0)).g, 2);
	setting_end(&s);
}

static void light_is_aimed_at(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	struct light_sample sample;
	const vec3 p = { 0, 7, 4 };
	light_aim(s.worker, s.light, &p, &sample);
	CLOSE(sample.distance, 5);
	CLOSE(sample.direction.y, 0.6);
	CLOSE(sample.direction.z, -0.8);
	setting_end(&s);
}

/* A jittered grid seen by the samples of a pixel: points stay in their cells, each sample has others,
 * and one name gives one place. */
static void area_light_places_belong_to_the_sample(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	s.light->area_count_u = s.light->area_count_v = 3;
	s.light->area_u = vec(2, 0, 0), s.light->area_v = vec(0, 0, 2);
	s.light->jitter = s.light->area_illumination = true;
	const struct interior_stack none = { 0 };
	const struct light_target target = { .point = { 0, 9, 0 }, .interiors = &none };
	double last = 0;
	for (uint32_t i = 0; i < 16; i++) {
		s.worker->sample = sample_at(1, (struct sample_place){ 5, 6, i });
		struct light_sample whole, point, again;
		light_aim(s.worker, s.light, &target.point, &whole);
		const struct light_grid grid = light_grid_of(s.worker, &target, &whole);
		light_grid_sample(s.worker, &target, &grid, 2, 0, &point);
		light_grid_sample(s.worker, &target, &grid, 2, 0, &again);
		const double x = point.direction.x / point.direction.y;
		assert_true(x >= 0.5 && x <= 1.5);
		assert_true(x != last && x == again.direction.x / again.direction.y);
		CLOSE(point.radiance.g, 2.0 / 9);
		last = x;
	}
	setting_end(&s);
}

/* ---- lobes ---- */

/* Seen from straight above. */
static struct interaction flat(void)
{
	return (struct interaction){ .surface = { .direction = { 0, -1, 0 },
					     .geometric = { 0, 1, 0 } } };
}

static struct brdf_value value_of(const struct finish *f, vec3 to_light, unsigned how)
{
	const struct interaction it = flat();
	const struct lobe lobe = {
		.finish = f, .normal = { 0, 1, 0 }, .pigment = { 1, 0.5f, 0 }, .own = 1
	};
	struct brdf_value value = { 0 };
	if (!brdf_eval(&it, &lobe, &to_light, how, &value))
		value = (struct brdf_value){ 0 };
	return value;
}

static void diffuse_light_follows_the_cosine(void **unused)
{
	(void)unused;
	struct finish f = { .diffuse = 0.5f, .brilliance = 1 };
	const vec3 slant = { HALF_ROOT, HALF_ROOT, 0 }, below = { 0, -1, 0 };
	CLOSE(value_of(&f, slant, 0).diffuse, 0.5 * HALF_ROOT);
	CLOSE(value_of(&f, below, 0).diffuse, 0);
	CLOSE(value_of(&f, below, BRDF_BOTH_SIDES).diffuse, 0.5);
	f.brilliance = 2;
	CLOSE(value_of(&f, slant, 0).diffuse, 0.25);
	f.diffuse_back = 0.25f;
	CLOSE(value_of(&f, below, 0).diffuse, 0.25);
}

static void highlights_need_a_light_that_makes_them(void **unused)
{
	(void)unused;
	const struct finish phong = { .phong = 0.5f, .phong_size = 2, .brilliance = 1 };
	const struct finish blinn = { .specular = 0.5f, .specular_power = 2, .brilliance = 1 };
	const vec3 slant = { HALF_ROOT, HALF_ROOT, 0 };
	CLOSE(value_of(&phong, slant, BRDF_HIGHLIGHTS).highlight, 0.25); /* 45 degrees */
	CLOSE(value_of(&phong, slant, 0).highlight, 0);
	const double half = cos(3.14159265358979 / 8);
	CLOSE(value_of(&blinn, slant, BRDF_HIGHLIGHTS).highlight, 0.5 * half * half);
}

static void reflected_light_has_the_colour_of_the_pigment(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	const struct finish f = { .diffuse = 0.5f, .brilliance = 1 };
	const struct interaction it = flat();
	const struct lobe lobe = {
		.finish = &f, .normal = { 0, 1, 0 }, .pigment = { 1, 0.5f, 0 }, .own = 0.5f
	};
	const vec3 up = { 0, 1, 0 };
	struct brdf_value value;
	assert_true(brdf_eval(&it, &lobe, &up, 0, &value));
	const rgb light =
		brdf_reflect(s.worker, &it, &lobe, &up, &value, (rgb){ 1, 1, 4 }, ONE_LIGHT);
	CLOSE(light.r, 0.25);
	CLOSE(light.g, 0.125);
	CLOSE(light.b, 0);
	setting_end(&s);
}

/* ---- layers ---- */

/* `count` layers, each letting this much through, over one that is opaque. */
static void open_layers(
	const struct setting *s, float through, size_t count, struct layers *out, rgb *shadow)
{
	static const struct finish finish = { .diffuse = 1, .brilliance = 1, .refraction = 1 };
	struct pigment clear = { .is_plain = true, .colour = { 1, 1, 1, 0, through } };
	struct layer *layers = ARENA_ARRAY(s->worker->scratch, count, struct layer);
	for (size_t i = 0; i < count; i++)
		layers[i] = (struct layer){ .pigment = &clear, .finish = &finish };
	const struct texture texture = { .layer_count = count, .layers = layers };
	struct interaction it = flat();
	it.object = s->scene->objects[0];
	it.whole = (struct texture_part){ .texture = &texture, .weight = 1 };
	it.parts = &it.whole;
	it.part_count = 1;
	layers_open(s->worker, &it, &it.whole, 0, out);
	*shadow = layers_tint(s->worker, &it);
}

static void layers_tint_those_below(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	struct layers layers;
	rgb shadow;
	open_layers(&s, 0.5f, 3, &layers, &shadow);
	assert_int_equal(layers.count, 3);
	for (size_t i = 0; i < 3; i++) {
		CLOSE(layers.lobes[i].weight.g, ldexp(1, -(int)i));
		CLOSE(layers.lobes[i].own, 0.5);
		assert_int_equal(layers.lobes[i].number, i);
	}
	CLOSE(layers.tint.g, 0.125);
	CLOSE(layers.clear, 0.125);
	CLOSE(shadow.g, 0.125);
	setting_end(&s);
}

/* A viewer does not look below 1/255; a shadow takes all layers. */
static void hidden_layers_are_left_out(void **unused)
{
	(void)unused;
	struct setting s = setting_make();
	struct layers layers;
	rgb shadow;
	open_layers(&s, 0.1f, 6, &layers, &shadow);
	assert_int_equal(layers.count, 3);
	CLOSE(shadow.g * 1e6, 1);
	setting_end(&s);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(light_arrives_in_space),
		cmocka_unit_test(light_is_aimed_at),
		cmocka_unit_test(area_light_places_belong_to_the_sample),
		cmocka_unit_test(diffuse_light_follows_the_cosine),
		cmocka_unit_test(highlights_need_a_light_that_makes_them),
		cmocka_unit_test(reflected_light_has_the_colour_of_the_pigment),
		cmocka_unit_test(layers_tint_those_below),
		cmocka_unit_test(hidden_layers_are_left_out),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
