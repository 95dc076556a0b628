/* SPDX-License-Identifier: MIT */
/*
 * Curves through points: linear, quadratic, cubic (Catmull-Rom, standing still
 * in the first and last interval) and natural, as the language defines them.
 */
#include "base/spline.h"

#include <stdlib.h>
#include <string.h>

/* One component of a spline. */
struct curve {
	const double *t;
	const double (*v)[5];
	size_t n; /* index of the last entry */
	unsigned k;
};

static double value_at(const struct curve *c, size_t i)
{
	return c->v[i][c->k];
}

static double linear(const struct curve *c, size_t i, double p)
{
	const double a = value_at(c, i - 1), b = value_at(c, i);
	return a + (p - c->t[i - 1]) * (b - a) / (c->t[i] - c->t[i - 1]);
}

static double quadratic(const struct curve *c, size_t i, double p)
{
	if (c->n == 1)
		return linear(c, i, p);
	const size_t first = i >= 2 ? i - 2 : 0;
	const double t1 = c->t[first], t2 = c->t[first + 1], t3 = c->t[first + 2];
	const double v1 = value_at(c, first), v2 = value_at(c, first + 1),
		     v3 = value_at(c, first + 2);
	const double d = (t2 - t1) * (t3 - t1) * (t3 - t2);
	const double a = (v1 * (t3 - t2) + v2 * (t1 - t3) + v3 * (t2 - t1)) / d;
	const double b =
		(v1 * (t2 * t2 - t3 * t3) + v2 * (t3 * t3 - t1 * t1) + v3 * (t1 * t1 - t2 * t2)) /
		d;
	const double e =
		(v1 * t2 * t3 * (t3 - t2) + v2 * t1 * t3 * (t1 - t3) + v3 * t1 * t2 * (t2 - t1)) /
		d;
	return (a * p + b) * p + e;
}

static double cubic(const struct curve *c, size_t i, double p)
{
	if (c->n == 1)
		return (value_at(c, 0) + value_at(c, 1)) / 2;
	if (i < 2)
		return value_at(c, 1);
	if (i >= c->n)
		return value_at(c, c->n - 1);
	const double *t = c->t;
	const size_t a = i - 1, b = i;
	const double d = t[b] - t[a], u = (p - t[a]) / d;
	const double va = value_at(c, a), vb = value_at(c, b), slope = (vb - va) / d;
	const double ma = 0.5 * ((va - value_at(c, a - 1)) / (t[a] - t[a - 1]) + slope) * d;
	const double mb = 0.5 * ((value_at(c, b + 1) - vb) / (t[b + 1] - t[b]) + slope) * d;
	const double u2 = u * u, u3 = u2 * u;
	return va * (2 * u3 - 3 * u2 + 1) + vb * (3 * u2 - 2 * u3) + ma * (u3 - 2 * u2 + u) +
	       mb * (u3 - u2);
}

/* The second derivatives of a component at the keys, zero at both ends. `work` holds 2 (n + 1)
 * numbers. */
static void second_derivatives(const struct curve *c, double *work, double (*m)[5])
{
	const size_t n = c->n;
	double *u = work, *w = work + n + 1;
	m[0][c->k] = m[n][c->k] = 0;
	for (size_t j = 1; j < n; j++) {
		const double h = c->t[j + 1] - c->t[j], before = c->t[j] - c->t[j - 1];
		const double b = (value_at(c, j + 1) - value_at(c, j)) / h;
		const double b0 = (value_at(c, j) - value_at(c, j - 1)) / before;
		u[j] = 2 * (h + before);
		w[j] = 6 * (b - b0);
		if (j > 1) {
			u[j] -= before * before / u[j - 1];
			w[j] -= before * w[j - 1] / u[j - 1];
		}
	}
	for (size_t j = n; j-- > 1;)
		m[j][c->k] = (w[j] - (c->t[j + 1] - c->t[j]) * m[j + 1][c->k]) / u[j];
}

const double (*spline_curvature(struct arena *arena, const struct spline *s))[5]
{
	double(*m)[5] = arena_array(arena, s->count + 1, sizeof(double[5]));
	double *work = memory_alloc(2 * (s->count + 1), sizeof *work);
	for (unsigned k = 0; s->count && k < s->terms; k++) {
		const struct curve c = { s->keys, s->values, s->count - 1, k };
		second_derivatives(&c, work, m);
	}
	free(work);
	return (const double(*)[5])m;
}

static double natural(const struct curve *c, size_t i, double p, const double (*m)[5])
{
	const size_t a = i - 1;
	const double h = c->t[i] - c->t[a], d = p - c->t[a], ma = m[a][c->k], mb = m[i][c->k];
	const double va = value_at(c, a), vb = value_at(c, i);
	return va + d * (-(h / 6) * (mb + 2 * ma) + (vb - va) / h +
				d * (ma / 2 + d * (mb - ma) / (6 * h)));
}

/* The smallest index whose key is at least p; count if there is none. */
static size_t find(const struct spline *s, double p)
{
	size_t lo = 0, hi = s->count;
	while (lo < hi) {
		const size_t middle = (lo + hi) / 2;
		if (s->keys[middle] >= p)
			hi = middle;
		else
			lo = middle + 1;
	}
	return lo;
}

static double component(const struct spline *s, const struct curve *c, size_t i, double p)
{
	if (c->n == 0)
		return value_at(c, 0);
	if (s->type == SPLINE_CUBIC)
		return cubic(c, i, p);
	if (i == 0)
		return value_at(c, 0);
	if (i > c->n || p >= c->t[c->n])
		return value_at(c, c->n);
	switch (s->type) {
	case SPLINE_QUADRATIC:
		return quadratic(c, i, p);
	case SPLINE_NATURAL:
		return natural(c, i, p, s->curvature);
	default:
		return linear(c, i, p);
	}
}

void spline_value(const struct spline *s, double at, double result[5])
{
	memset(result, 0, 5 * sizeof *result);
	if (!s->count)
		return;
	const size_t i = find(s, at);
	for (unsigned k = 0; k < s->terms; k++) {
		const struct curve c = { s->keys, s->values, s->count - 1, k };
		result[k] = component(s, &c, i, at);
	}
}

struct spline *spline_copy(struct arena *arena, const struct spline *s)
{
	struct spline *out = arena_copy(arena, s, sizeof *s);
	out->keys = arena_copy(arena, s->keys, s->count * sizeof *s->keys);
	out->values = arena_copy(arena, s->values, s->count * sizeof *s->values);
	if (s->type == SPLINE_NATURAL)
		out->curvature = spline_curvature(arena, s);
	return out;
}
