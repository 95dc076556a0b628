/* SPDX-License-Identifier: MIT */
/*
 * Roots between the roots of the derivative, see the header.
 */
#include "shape/polynomial.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

double polynomial_value(const double *c, unsigned degree, double x)
{
	double value = c[degree];
	for (unsigned i = degree; i-- > 0;)
		value = value * x + c[i];
	return value;
}

static inline double value_and_slope(const double *c, unsigned degree, double x, double *slope)
{
	double value = c[degree], derivative = 0;
	for (unsigned i = degree; i-- > 0;) {
		derivative = derivative * x + value;
		value = value * x + c[i];
	}
	*slope = derivative;
	return value;
}

/* The root between lo and hi, at which the signs differ, searched from `guess` on; `enough` is an
 * error that does no harm, 0 for none. Newton's step is taken where it stays between the nearest
 * points of either sign known so far, else the interval is halved. */
static double bracketed_root(const double *c, unsigned degree, double lo, double hi,
	bool positive_at_lo, double guess, double enough)
{
	double x = guess > lo && guess < hi ? guess : 0.5 * (lo + hi), before = hi - lo;
	bool halved = true;
	/* halving alone ends after as many steps as there are bits between lo and hi */
	for (int step = 0; step < 2200; step++) {
		double slope;
		const double value = value_and_slope(c, degree, x, &slope);
		if (value == 0)
			return x;
		if ((value > 0) == positive_at_lo)
			lo = x;
		else
			hi = x;
		double next = x - value / slope, moved = fabs(next - x);
		const double last_place = DBL_EPSILON * fabs(x);
		const double lost = last_place > enough ? last_place : enough;
		/* written so that no number (slope 0) also halves */
		if (next > lo && next < hi && moved < 0.5 * before) {
			/* Newton's steps shrink like squares: what the next would be */
			if (!halved && moved * moved * moved <= lost * before * before)
				return next;
			halved = false;
		} else {
			next = 0.5 * (lo + hi);
			moved = fabs(next - x);
			halved = true;
		}
		if (moved <= last_place || next == x)
			return next;
		before = moved;
		x = next;
	}
	return x;
}

/* b² - ac with the rounding errors of both products added back. */
static double discriminant(double a, double b, double c)
{
	const double bb = b * b, ac = a * c;
	if (fabs(bb - ac) > 1e-3 * bb) /* no cancellation to speak of */
		return bb - ac;
	return (bb - ac) + (fma(b, b, -bb) - fma(a, c, -ac));
}

static unsigned put_if_inside(double x, double lo, double hi, double *roots, unsigned count)
{
	if (x >= lo && x <= hi)
		roots[count++] = x;
	return count;
}

static unsigned quadratic_crossings(const double *k, double lo, double hi, double *roots)
{
	const double a = k[2], b = 0.5 * k[1], c = k[0];
	const double d = discriminant(a, b, c);
	if (!(d > 0))
		return 0;
	const double q = -(b + copysign(sqrt(d), b));
	const double x1 = q / a, x2 = c / q;
	const unsigned count = put_if_inside(fmin(x1, x2), lo, hi, roots, 0);
	return put_if_inside(fmax(x1, x2), lo, hi, roots, count);
}

/* ---- brackets ---- */

/* Where a sign changes: one root lies between `from` and `to`. */
struct bracket {
	double from, to;
	bool positive_at_from;
	bool from_turns, to_turns; /* whether these are turning points */
};

/* A polynomial on its way from lo to hi. */
struct level {
	double c[POLYNOMIAL_MAX_DEGREE + 1];
	double at;     /* how far it has come, with no change of sign to come before */
	bool positive; /* its sign there */
	bool turns;    /* `at` is a turning point */
	bool done;
};

/* The derivatives of a polynomial down to the quadratic one, whose roots are known. */
struct search {
	struct level level[POLYNOMIAL_MAX_DEGREE + 1]; /* by degree; from 3 */
	double quadratic[2];
	unsigned quadratic_count, quadratic_next;
	bool quadratic_positive; /* before the next root */
	double hi;
	double enough; /* error of turning points that does no harm */
};

static double curvature(const double *c, unsigned degree, double x)
{
	double value = 0;
	for (unsigned i = degree; i >= 2; i--)
		value = value * x + i * (i - 1) * c[i];
	return value;
}

/* A parabola through a turning point tells about where the root is; else no number. */
static double bracket_guess(const double *c, unsigned degree, const struct bracket *b)
{
	if (!b->to_turns && !b->from_turns)
		return NAN;
	const double turn = b->to_turns ? b->to : b->from;
	const double away =
		sqrt(-2 * polynomial_value(c, degree, turn) / curvature(c, degree, turn));
	return b->to_turns ? turn - away : turn + away;
}

static double bracket_root(
	const struct search *s, unsigned degree, const struct bracket *b, double enough)
{
	if (degree == 2)
		return b->to;
	const double *c = s->level[degree].c;
	return bracketed_root(c, degree, b->from, b->to, b->positive_at_from,
		bracket_guess(c, degree, b), enough);
}

/* The next change of sign of the derivative of the given degree. Turning points between which it
 * cannot change sign, maxima of what is positive, are not even computed. */
static bool next_bracket(struct search *s, unsigned degree, struct bracket *b)
{
	if (degree == 2) {
		if (s->quadratic_next == s->quadratic_count)
			return false;
		b->to = s->quadratic[s->quadratic_next++];
		b->positive_at_from = s->quadratic_positive;
		s->quadratic_positive = !s->quadratic_positive;
		return true;
	}
	struct level *l = &s->level[degree];
	while (!l->done) {
		struct bracket turn;
		const bool turns = next_bracket(s, degree - 1, &turn);
		if (turns && turn.positive_at_from == l->positive)
			continue;
		const double to = turns ? bracket_root(s, degree - 1, &turn, s->enough) : s->hi;
		*b = (struct bracket){ l->at, to, l->positive, l->turns, turns };
		l->at = to;
		l->turns = turns;
		l->positive = polynomial_value(l->c, degree, to) >= 0;
		l->done = !turns;
		if (l->positive != b->positive_at_from)
			return true;
	}
	return false;
}

/* The exponent of x: |x| < 2^(exponent + 1), and >= 2^exponent unless x is subnormal. */
static int exponent(double x)
{
	uint64_t bits;
	memcpy(&bits, &x, sizeof bits);
	return (int)(bits >> 52 & 0x7ff) - 1023;
}

/* All roots are nearer to 0: twice the greatest |c[n - k] / c[n]|^(1/k) (Fujiwara 1916), with
 * the quotients rounded up to powers of two. */
static double root_bound(const double *c, unsigned degree)
{
	const int top = exponent(c[degree]);
	if (top == -1023)
		return INFINITY;
	int most = -1023;
	for (unsigned k = 1; k <= degree; k++) {
		const int quotient = exponent(c[degree - k]) + 1 - top, n = (int)k;
		const int root = quotient >= 0 ? (quotient + n - 1) / n : -(-quotient / n);
		if (c[degree - k] != 0 && root > most)
			most = root;
	}
	return ldexp(2, most);
}

/* Prepares the search for roots of c, degree 3 or more, between lo and hi. */
static void search_set(struct search *s, const double *c, unsigned degree, double lo, double hi)
{
	for (unsigned i = 0; i <= degree; i++)
		s->level[degree].c[i] = c[i];
	for (unsigned n = degree; n > 2; n--) {
		for (unsigned i = 1; i <= n; i++)
			s->level[n - 1].c[i - 1] = i * s->level[n].c[i];
		s->level[n].at = lo;
		s->level[n].positive = polynomial_value(s->level[n].c, n, lo) >= 0;
		s->level[n].turns = s->level[n].done = false;
	}
	const double *quadratic = s->level[2].c;
	s->quadratic_count = quadratic_crossings(quadratic, lo, hi, s->quadratic);
	s->quadratic_next = 0;
	s->quadratic_positive = polynomial_value(quadratic, 2, lo) >= 0;
	s->hi = hi;
	s->enough = 1e-10 * (hi - lo);
}

static unsigned crossings(
	const double *c, unsigned degree, double lo, double hi, bool first_only, double *roots)
{
	while (degree > 0 && c[degree] == 0)
		degree--;
	if (degree == 0)
		return 0;
	if (degree == 1)
		return put_if_inside(-c[0] / c[1], lo, hi, roots, 0);
	if (degree == 2)
		return quadratic_crossings(c, lo, hi, roots);
	const double bound = root_bound(c, degree);
	lo = lo > -bound ? lo : -bound;
	hi = hi < bound ? hi : bound;
	if (!(lo < hi))
		return 0;
	struct search s;
	struct bracket b;
	unsigned found = 0;
	search_set(&s, c, degree, lo, hi);
	while (next_bracket(&s, degree, &b)) {
		roots[found++] = bracket_root(&s, degree, &b, 0);
		if (first_only)
			break;
	}
	return found;
}

unsigned polynomial_crossings(const double *c, unsigned degree, double lo, double hi, double *roots)
{
	return lo < hi ? crossings(c, degree, lo, hi, false, roots) : 0;
}

bool polynomial_first_crossing(const double *c, unsigned degree, double lo, double hi, double *root)
{
	double roots[POLYNOMIAL_MAX_DEGREE];
	if (!(lo < hi) || crossings(c, degree, lo, hi, true, roots) == 0)
		return false;
	*root = roots[0];
	return true;
}
