/* SPDX-License-Identifier: MIT */
/*
 * The formulas of light: cones, falloff with distance, Fresnel, refraction, the
 * mean density of fog, and the list of interiors a ray is in.
 */
#include "camera/camera.h"
#include "light/light.h"
#include "medium/fog.h"
#include "medium/interior.h"
#include "medium/interior_stack.h"
#include "surface/specular.h"

#include "base/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define DEGREES	    0.017453292519943296
#define CLOSE(a, b) assert_true(fabs((a) - (b)) < 1e-12)

/* ---- lights ---- */

/* What arrives at p from a light at the origin. */
static double arriving(const struct light *light, vec3 p)
{
	vec3 direction;
	const double distance = light_direction(light, vec(0, 0, 0), p, &direction);
	return light_attenuation(light, &p, &direction, distance);
}

static vec3 off_axis(double degrees)
{
	return vec(sin(degrees * DEGREES), 0, cos(degrees * DEGREES));
}

static struct light spot(double radius, double falloff)
{
	return (struct light){ .kind = light_find("spotlight"),
		.point_at = { 0, 0, 1 },
		.axis = { 0, 0, 1 },
		.radius = cos(radius * DEGREES),
		.falloff = cos(falloff * DEGREES) };
}

static void spotlight_fades_between_radius_and_falloff(void **unused)
{
	(void)unused;
	struct light light = spot(20, 40);
	CLOSE(arriving(&light, off_axis(0)), 1);
	CLOSE(arriving(&light, off_axis(19.9)), 1);
	CLOSE(arriving(&light, off_axis(40.1)), 0);
	CLOSE(arriving(&light, off_axis(180)), 0);
	const double middle = acos((cos(20 * DEGREES) + cos(40 * DEGREES)) / 2) / DEGREES;
	CLOSE(arriving(&light, off_axis(middle)), 0.5); /* smooth in the cosine */
	light.tightness = 3;
	CLOSE(arriving(&light, off_axis(10)), pow(cos(10 * DEGREES), 3));
}

static void spotlight_edges(void **unused)
{
	(void)unused;
	const struct light hard = spot(30, 20); /* the radius wins */
	CLOSE(arriving(&hard, off_axis(29.9)), 1);
	CLOSE(arriving(&hard, off_axis(30.1)), 0);
	struct light wide = spot(95, 120); /* no edge at all */
	wide.tightness = 2;
	CLOSE(arriving(&wide, off_axis(80)), pow(cos(80 * DEGREES), 2));
	CLOSE(arriving(&wide, off_axis(100)), 0);
}

static void cylinder_fades_across(void **unused)
{
	(void)unused;
	const struct light light = { .kind = light_find("cylinder"),
		.parallel = true,
		.point_at = { 0, 0, 1 },
		.axis = { 0, 0, 1 },
		.radius = 1,
		.falloff = 2 };
	CLOSE(arriving(&light, vec(0.9, 0, 5)), 1);
	CLOSE(arriving(&light, vec(0, 1.5, 5)), 0.5);
	CLOSE(arriving(&light, vec(2.1, 0, 5)), 0);
	CLOSE(arriving(&light, vec(0, 0, -1)), 0);
}

static void distance_fades(void **unused)
{
	(void)unused;
	struct light light = { .kind = light_find("point"), .fade_distance = 3, .fade_power = 2 };
	CLOSE(arriving(&light, vec(0, 3, 0)), 1);
	CLOSE(arriving(&light, vec(0, 0, 6)), 0.4);
	light.fade_power = 1;
	CLOSE(arriving(&light, vec(6, 0, 0)), 2.0 / 3);
	light.fade_power = 0;
	CLOSE(arriving(&light, vec(6, 0, 0)), 1);
}

static void parallel_light_counts_along_its_axis(void **unused)
{
	(void)unused;
	const struct light light = {
		.kind = light_find("point"), .parallel = true, .axis = { 0, 0, 1 }
	};
	vec3 direction;
	CLOSE(light_direction(&light, vec(0, 0, 0), vec(7, 0, 4), &direction), 4);
	CLOSE(direction.z, -1);
	CLOSE(light_direction(&light, vec(0, 0, 0), vec(7, 0, -4), &direction), -4);
	CLOSE(direction.z, -1);
}

/* ---- reflection and refraction ---- */

static void fresnel_agrees_with_the_two_polarisations(void **unused)
{
	(void)unused;
	CLOSE(fresnel_reflectance(1.5, 1), 0.04);
	CLOSE(fresnel_reflectance(1.5, 0), 1);
	CLOSE(fresnel_reflectance(1, 0.3), 0);
	CLOSE(fresnel_reflectance(1 / 1.5, 0.2), 1); /* total reflection */
	for (double degrees = 5; degrees < 90; degrees += 5) {
		const double i = degrees * DEGREES, t = asin(sin(i) / 1.5);
		const double s = sin(i - t) / sin(i + t), p = tan(i - t) / tan(i + t);
		CLOSE(fresnel_reflectance(1.5, cos(i)), (s * s + p * p) / 2);
	}
}

static void refraction_obeys_snell(void **unused)
{
	(void)unused;
	const vec3 up = { 0, 1, 0 };
	for (double degrees = 0; degrees < 90; degrees += 7) {
		const vec3 v = { sin(degrees * DEGREES), -cos(degrees * DEGREES), 0 };
		vec3 in, back;
		assert_true(refract_direction(v, up, 1 / 1.5, &in));
		CLOSE(vec_length(in), 1);
		CLOSE(in.x * 1.5, v.x);
		assert_true(in.y < 0);
		assert_true(refract_direction(in, vec_negate(up), 1.5, &back)); /* either side */
		CLOSE(back.x, v.x);
		CLOSE(back.y, v.y);
	}
	vec3 out;
	const vec3 flat = { sin(60 * DEGREES), -cos(60 * DEGREES), 0 };
	assert_false(refract_direction(flat, up, 1.5, &out));
}

static void mirror_stays_above_the_surface(void **unused)
{
	(void)unused;
	const vec3 up = { 0, 1, 0 };
	const vec3 v = vec_normalize(vec(1, -1, 0));
	const vec3 r = mirror_direction(v, up, up);
	CLOSE(r.x, v.x);
	CLOSE(r.y, -v.y);
	uint64_t key = 1;
	for (int i = 0; i < 2000; i++) {
		double n[3];
		for (int k = 0; k < 3; k++)
			n[k] = random_unit(key = random_mix(key, 1)) - 0.5;
		const vec3 bumpy = vec_normalize(vec(n[0], fabs(n[1]) + 0.01, n[2]));
		const vec3 m = mirror_direction(v, bumpy, up);
		assert_true(m.y >= -1e-12);
		CLOSE(vec_length(m), 1);
	}
}

static void interior_fades(void **unused)
{
	(void)unused;
	struct interior i = {
		.ior = 1, .fade_distance = 2, .fade_power = 1, .fade_colour = { 1, 0.5f, 0 }
	};
	rgb f = interior_fading(&i, 2);
	assert_float_equal(f.r, 1, 1e-6);
	assert_float_equal(f.g, 0.75, 1e-6);
	assert_float_equal(f.b, 0.5, 1e-6);
	i.fade_power = 1000;
	f = interior_fading(&i, 4);
	assert_float_equal(f.g, exp(-1), 1e-6);
	assert_float_equal(f.b, exp(-2), 1e-6);
}

/* ---- fog ---- */

/* 1 below 0, 1 / (1 + h^2) above. */
static double density(double h)
{
	return h <= 0 ? 1 : 1 / (1 + h * h);
}

static void fog_density_is_the_mean(void **unused)
{
	(void)unused;
	const double heights[][2] = { { -3, -1 }, { -1, 2 }, { 2, -1 }, { 0.5, 4 }, { 4, 0.5 },
		{ -1e-3, 1e-3 }, { 0, 1 } };
	for (size_t i = 0; i < sizeof heights / sizeof *heights; i++) {
		const double s = heights[i][0], e = heights[i][1];
		const int steps = 100000;
		double sum = 0;
		for (int k = 0; k < steps; k++)
			sum += density(s + (e - s) * (k + 0.5) / steps);
		assert_true(fabs(fog_mean_density(s, e) - sum / steps) < 1e-8);
	}
	CLOSE(fog_mean_density(2, 2), 0.2);
}

/* ---- interiors ---- */

static void interiors_toggle(void **unused)
{
	(void)unused;
	struct arena *arena = arena_create(0);
	struct interior many[12];
	struct interior_stack c = { 0 };
	for (size_t i = 0; i < 12; i++) {
		many[i] = (struct interior){ .ior = 1 + 0.1 * (double)i, .hollow = i != 5 };
		interior_stack_toggle(&c, &many[i], arena);
		assert_int_equal(c.count, i + 1);
	}
	assert_false(interior_stack_is_hollow(&c));
	const struct interior_stack kept = c;
	interior_stack_borrow(&c, &kept);
	for (size_t i = 0; i < 12; i += 2)
		interior_stack_toggle(&c, &many[i], arena);
	for (size_t i = 0; i < 12; i++) {
		assert_int_equal(interior_stack_has(&c, &many[i]), i % 2 == 1);
		assert_true(interior_stack_has(&kept, &many[i])); /* copies are values */
	}
	for (size_t i = 1; i < 12; i += 2)
		interior_stack_toggle(&c, &many[i], arena);
	assert_int_equal(c.count, 0);
	assert_true(interior_stack_is_hollow(&c));
	arena_destroy(arena);
}

static void index_ratio_follows_the_list(void **unused)
{
	(void)unused;
	const struct interior water = { .ior = 1.33 }, glass = { .ior = 1.5 };
	struct arena *arena = arena_create(0);
	struct interior_stack c = { 0 };
	CLOSE(interior_stack_ratio(&c, &water), 1 / 1.33);
	CLOSE(interior_stack_fresnel_ratio(&c, &water), 1.33);
	interior_stack_toggle(&c, &water, arena);
	CLOSE(interior_stack_ratio(&c, &glass), 1.33 / 1.5);
	CLOSE(interior_stack_ratio(&c, &water), 1.33);
	CLOSE(interior_stack_fresnel_ratio(&c, &glass), 1.5 / 1.33);
	CLOSE(interior_stack_fresnel_ratio(&c, &water), 1 / 1.33);
	interior_stack_toggle(&c, &glass, arena);
	CLOSE(interior_stack_ratio(&c, &glass), 1.5 / 1.33);
	CLOSE(interior_stack_ratio(&c, &water), 1);	    /* not the last: overlapping objects */
	CLOSE(interior_stack_fresnel_ratio(&c, &glass), 1); /* as the language has it */
	arena_destroy(arena);
}

/* ---- camera ---- */

static void camera_sees_pixel_centres(void **unused)
{
	(void)unused;
	const struct camera c = { .kind = camera_find("perspective"),
		.right = { 2, 0, 0 },
		.up = { 0, 1, 0 },
		.direction = { 0, 0, 1 } };
	ray r;
	assert_true(camera_ray(&c, 0, 0, 4, 2, &r)); /* s = -3/8, t = 1/4 */
	const vec3 wanted = vec_normalize(vec(-0.75, 0.25, 1));
	CLOSE(r.direction.x, wanted.x);
	CLOSE(r.direction.y, wanted.y);
	struct camera o = c;
	o.kind = camera_find("orthographic");
	assert_true(camera_ray(&o, 3, 1, 4, 2, &r));
	CLOSE(r.origin.x, 0.75);
	CLOSE(r.origin.y, -0.25);
	CLOSE(r.direction.z, 1);
	const struct camera degenerate = { .kind = camera_find("perspective") };
	assert_false(camera_ray(&degenerate, 0, 0, 4, 2, &r));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(spotlight_fades_between_radius_and_falloff),
		cmocka_unit_test(spotlight_edges),
		cmocka_unit_test(cylinder_fades_across),
		cmocka_unit_test(distance_fades),
		cmocka_unit_test(parallel_light_counts_along_its_axis),
		cmocka_unit_test(fresnel_agrees_with_the_two_polarisations),
		cmocka_unit_test(refraction_obeys_snell),
		cmocka_unit_test(mirror_stays_above_the_surface),
		cmocka_unit_test(interior_fades),
		cmocka_unit_test(fog_density_is_the_mean),
		cmocka_unit_test(interiors_toggle),
		cmocka_unit_test(index_ratio_follows_the_list),
		cmocka_unit_test(camera_sees_pixel_centres),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
