/* SPDX-License-Identifier: MIT */
/*
 * mandel, julia, magnet: how the iteration z = f(z) ends for the point x + iy. Points
 * that escape are coloured by the exterior rule, the others by the interior rule.
 */
#include "texture/patterns.h"

typedef struct {
	double re, im;
} complex_number;

static complex_number multiply(complex_number a, complex_number b)
{
	return (complex_number){ a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re };
}
static complex_number add(complex_number a, complex_number b)
{
	return (complex_number){ a.re + b.re, a.im + b.im };
}
static complex_number scale(complex_number a, double s)
{
	return (complex_number){ a.re * s, a.im * s };
}
static complex_number plus(complex_number a, double real)
{
	return (complex_number){ a.re + real, a.im };
}
static double norm(complex_number a)
{
	return a.re * a.re + a.im * a.im;
}
static complex_number divide(complex_number a, complex_number b)
{
	return scale(multiply(a, (complex_number){ b.re, -b.im }), 1 / norm(b));
}
static complex_number power(complex_number z, int exponent)
{
	complex_number result = z;
	for (int i = 1; i < exponent; i++)
		result = multiply(result, z);
	return result;
}

/* The two models of magnetic phase transitions. */
static complex_number magnet_step(int type, complex_number z, complex_number c)
{
	const complex_number z2 = multiply(z, z), c1 = plus(c, -1), c2 = plus(c, -2);
	complex_number above, below;
	if (type == 1) {
		above = add(z2, c1);
		below = add(scale(z, 2), c2);
	} else {
		const complex_number c12 = multiply(c1, c2);
		above = add(add(multiply(z2, z), scale(multiply(c1, z), 3)), c12);
		below = plus(add(add(scale(z2, 3), scale(multiply(c2, z), 3)), c12), 1);
	}
	const complex_number root = divide(above, below);
	return multiply(root, root);
}

static bool escaped(const struct fractal *f, complex_number z)
{
	if (!f->magnet)
		return norm(z) > 4;
	return norm(z) > 10000 || norm(plus(z, -1)) < 1e-4;
}

/* k modulo an integer, which a factor below 1 does not have. */
static double modulo_part(int k, double divisor, double factor)
{
	const int m = fabs(divisor) < 1e9 ? (int)divisor : 0;
	return m ? (k % m) / factor : 0;
}

static double exterior_value(const struct fractal *f, complex_number z, int k)
{
	const double factor = f->exterior_factor;
	switch (f->exterior) {
	case 0:
		return factor;
	case 1:
		return (double)k / f->iterations;
	case 2:
		return z.re * factor;
	case 3:
		return z.im * factor;
	case 4:
		return z.re * z.re * factor;
	case 5:
		return z.im * z.im * factor;
	case 6:
		return factor * sqrt(norm(z));
	case 7:
		return modulo_part(k, factor, factor);
	default:
		return modulo_part(k, 1 + factor, factor);
	}
}

static double interior_value(const struct fractal *f, complex_number z, double smallest)
{
	const double factor = f->interior_factor;
	switch (f->interior) {
	case 0:
		return factor;
	case 1:
		return factor * sqrt(smallest);
	case 2:
		return z.re * factor;
	case 3:
		return z.im * factor;
	case 4:
		return z.re * z.re * factor;
	case 5:
		return z.im * z.im * factor;
	default:
		return z.re * z.re + z.im * z.im * factor;
	}
}

static double fractal_value(const struct pattern *pattern, vec3 q, struct surface *surface)
{
	(void)surface;
	const struct fractal *f = pattern->self;
	const complex_number z0 = { q.x, q.y };
	const bool from_zero = f->magnet && !f->is_julia;
	complex_number z = from_zero ? (complex_number){ 0, 0 } : z0;
	const complex_number c = f->is_julia ? (complex_number){ f->real, f->imaginary } : z0;
	double smallest = from_zero ? 10000 : norm(z0);
	for (int k = 0; k < f->iterations; k++) {
		z = f->magnet ? magnet_step(f->magnet, z, c) : add(power(z, f->exponent), c);
		const double size = norm(z);
		if (size < smallest)
			smallest = size;
		if (escaped(f, z))
			return exterior_value(f, z, k);
	}
	return interior_value(f, z, smallest);
}

static const float mandel_values[] = { 0.001f, 0.001f, 0.012f, 0.015f, 0.1f };
static const colour mandel_colours[] = { { 0, 0, 0, 0, 0 }, { 0, 1, 1, 0, 0 }, { 1, 1, 0, 0, 0 },
	{ 1, 0, 1, 0, 0 }, { 0, 1, 1, 0, 0 } };
const struct default_map default_map_mandel = { 5, mandel_values, mandel_colours };

static const struct fractal defaults = {
	.exponent = 2, .exterior = 1, .exterior_factor = 1, .interior = 0, .interior_factor = 1
};
#define FRACTAL(word)                                                                              \
	{                                                                                          \
		.name = word, .size = sizeof(struct fractal), .defaults = &defaults,               \
		.value = fractal_value                                                             \
	}
const struct pattern_class pattern_mandel = FRACTAL("mandel");
const struct pattern_class pattern_julia = FRACTAL("julia");
const struct pattern_class pattern_magnet = FRACTAL("magnet");
