/* SPDX-License-Identifier: MIT */
/*
 * Built-in functions made of noise: the scalar noise itself and the multifractal
 * landscapes (after Musgrave, in "Texturing and Modeling").
 */
#include "function/internal.h"

#include "base/elementary.h"
#include "function/ridged.h"
#include "noise/noise.h"

#include <math.h>

#define UNUSED(name) (void)(name)

static int generator_of(double number, const struct function_world *w)
{
	const int g = whole(number) & 3;
	return g ? g : w->noise_generator;
}

static double noise(vec3 p, int generator)
{
	return noise_scalar(p, generator);
}

static double signed_noise(vec3 p, int generator)
{
	return 2 * noise(p, generator) - 1;
}

double f_noise3d(double x, double y, double z, const double *p, const struct function_world *w)
{
	UNUSED(p);
	return noise(vec(x, y, z), w->noise_generator);
}

double f_noise_generator(
	double x, double y, double z, const double *p, const struct function_world *w)
{
	return noise(vec(x, y, z), generator_of(p[0], w));
}

double f_hetero_mf(double x, double y, double z, const double *p, const struct function_world *w)
{
	const double lacunarity = p[1], octaves = repeats_of(p[2]), offset = p[3];
	const int generator = generator_of(p[5], w), repeats = whole(repeats_of(p[4]));
	vec3 q = vec(x, y, z);
	double s = signed_noise(q, generator) + offset;
	q = vec_scale(q, lacunarity);
	const double step = elementary_pow(lacunarity, -p[0]);
	double weight = step;
	int i = 1;
	for (; i < octaves; i++) {
		double d = (signed_noise(q, generator) + offset) * weight;
		for (int k = 0; k < repeats; k++)
			d *= s;
		s += d;
		q = vec_scale(q, lacunarity);
		weight *= step;
	}
	const double rest = octaves - whole(octaves);
	if (rest != 0)
		s += rest * (signed_noise(q, generator) + offset) * weight * s;
	return s;
}

struct ridge {
	double edge, scale;
	int generator;
};

static double ridge_value(const struct ridge *r, vec3 q)
{
	return fabs(noise(q, r->generator) - r->edge) * r->scale;
}

double f_ridge(double x, double y, double z, const double *p, const struct function_world *w)
{
	const vec3 q = vec(x, y, z);
	const double offset = p[3];
	const struct ridge ridge = { p[4], 1 / fmax(p[4], 1 - p[4]), generator_of(p[5], w) };
	const double octaves = repeats_of(p[1]);
	double value = ridge_value(&ridge, q) - offset, total = 1, l = p[0], o = p[2];
	for (int i = 2; i <= whole(octaves); i++) {
		value += o * (ridge_value(&ridge, vec_scale(q, l)) - offset);
		total += o;
		l *= p[0];
		o *= p[2];
	}
	const double rest = octaves - whole(octaves);
	if (rest != 0) {
		value += o * (ridge_value(&ridge, vec_scale(q, l)) - offset) * rest;
		total += o * rest;
	}
	return value * (1 / fmax(offset, 1 - offset)) / total;
}

static double square_of(double v)
{
	return v * v;
}

/* The weight of an octave, of that frequency; octave 0 is the second one. */
static double ridged_weight(const struct ridged_table *t, int octave, double frequency)
{
	return octave < RIDGED_WEIGHTS ? t->weights[octave] : elementary_pow(frequency, -t->h);
}

double f_ridged_mf(double x, double y, double z, const double *p, const struct function_world *w)
{
	const double lacunarity = p[1], octaves = repeats_of(p[2]), offset = p[3], gain = p[4];
	const int generator = generator_of(p[5], w);
	struct ridged_table own;
	const struct ridged_table *table = w->ridged;
	if (ridged_is_open(table)) {
		ridged_settle(w->ridged, p[0], lacunarity);
	} else if (table->state == RIDGED_UNSEEN) {
		ridged_settle(&own, p[0], lacunarity);
		table = &own;
	}
	vec3 q = vec(x, y, z);
	double s = square_of(offset - fabs(signed_noise(q, generator)));
	double result = s, frequency = table->lacunarity;
	for (int i = 1; i < octaves; i++) {
		q = vec_scale(q, lacunarity);
		const double weight = fmin(1, fmax(0, s * gain));
		s = square_of(offset - fabs(signed_noise(q, generator))) * weight;
		result += s * ridged_weight(table, i - 1, frequency);
		frequency *= table->lacunarity;
	}
	return result;
}
