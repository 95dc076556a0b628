/* SPDX-License-Identifier: MIT */
/*
 * bozo, spotted, bumps, dents, granite, wrinkles, agate: noise, and sums of it.
 */
#include "texture/patterns.h"

#include "base/elementary.h"
#include "noise/noise.h"

static double bozo_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	return noise_scalar(q, pattern->noise_generator);
}

static double dents_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const double n = noise_scalar(q, pattern->noise_generator);
	return n * n * n;
}

static double granite_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const int generator = pattern->noise_generator;
	double sum = 0, frequency = 4, height = 1;
	for (int i = 0; i < 6; i++) {
		const double n = noise_scalar(vec_scale(q, frequency), generator);
		double a = generator < 2 ? fabs(0.5 - n) : fabs(1 - 2 * n);
		if (generator >= 2 && a > 0.5)
			a = 0.5;
		sum += a * height;
		frequency *= 2;
		height *= 0.5;
	}
	return sum;
}

static double wrinkles_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const int generator = pattern->noise_generator;
	double sum = 0, frequency = 1, height = 1;
	for (int i = 0; i < 10; i++) {
		const double n = noise_scalar(vec_scale(q, frequency), generator);
		sum += height * (generator < 2 ? n : clamp01(2 * n - 0.5));
		frequency *= 2;
		height *= 0.5;
	}
	return sum / 2;
}

static vec3 bumps_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)pattern, (void)surface;
	return vec_mad(n, amount, noise_vector(q));
}

static vec3 dents_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	return vec_mad(n, amount * dents_value(pattern, q, surface), noise_vector(q));
}

static vec3 wrinkles_perturb(
	const struct pattern *pattern, vec3 q, vec3 n, double amount, struct surface *surface)
{
	(void)pattern, (void)surface;
	vec3 sum = { 0, 0, 0 };
	double frequency = 1;
	for (int i = 0; i < 10; i++) {
		const vec3 d = noise_vector(vec_scale(q, frequency));
		sum = vec_mad(sum, 1 / frequency, vec(fabs(d.x), fabs(d.y), fabs(d.z)));
		frequency *= 2;
	}
	return vec_mad(n, amount, sum);
}

struct agate {
	float amount;
};

static double agate_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	static const struct turbulence usual = { { 0, 0, 0 }, 6, 0.5f, 2 };
	const struct agate *agate = pattern->self;
	const struct turbulence *t = pattern->turbulence ? pattern->turbulence : &usual;
	const double noise = noise_turbulence_scalar(
		q, t->octaves, t->omega, t->lambda, pattern->noise_generator);
	const double c = 0.5 * (cycloid(1.3 * (double)agate->amount * noise + 1.1 * q.z) + 1);
	return c < 0 ? 0 : c > 1 ? 1 : elementary_pow(c, 0.77);
}

static const struct pattern_param agate_params[] = {
	{ "agate_turb", PATTERN_FLOAT, offsetof(struct agate, amount) },
	{ NULL, PATTERN_END, 0 },
};

static const float bozo_values[] = { 0.4f, 0.4f, 0.6f, 0.6f, 0.8f, 0.8f };
static const colour bozo_colours[] = { { 1, 1, 1, 0, 0 }, { 0, 1, 0, 0, 0 }, { 0, 1, 0, 0, 0 },
	{ 0, 0, 1, 0, 0 }, { 0, 0, 1, 0, 0 }, { 1, 0, 0, 0, 0 } };
static const struct default_map bozo_map = { 6, bozo_values, bozo_colours };

static const float agate_values[] = { 0, 0.5f, 0.5f, 0.6f, 0.6f, 1 };
static const colour agate_colours[] = { { 1, 1, 1, 0, 0 }, { 0.95f, 0.75f, 0.5f, 0, 0 },
	{ 0.9f, 0.7f, 0.5f, 0, 0 }, { 0.9f, 0.7f, 0.4f, 0, 0 }, { 1, 0.7f, 0.4f, 0, 0 },
	{ 0.6f, 0.3f, 0, 0, 0 } };
static const struct default_map agate_map = { 6, agate_values, agate_colours };

const struct pattern_class pattern_bozo = { .name = "bozo", .value = bozo_value, .map = &bozo_map };
const struct pattern_class pattern_spotted = { .name = "spotted", .value = bozo_value };
const struct pattern_class pattern_bumps = {
	.name = "bumps", .value = bozo_value, .perturb = bumps_perturb
};
const struct pattern_class pattern_dents = {
	.name = "dents", .value = dents_value, .perturb = dents_perturb
};
const struct pattern_class pattern_granite = { .name = "granite", .value = granite_value };
const struct pattern_class pattern_wrinkles = {
	.name = "wrinkles", .value = wrinkles_value, .perturb = wrinkles_perturb
};
const struct pattern_class pattern_agate = {
	.name = "agate",
	.size = sizeof(struct agate),
	.params = agate_params,
	.defaults = &(const struct agate){ .amount = 1 },
	.value = agate_value,
	.map = &agate_map,
};
