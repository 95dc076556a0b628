/* SPDX-License-Identifier: MIT */
/*
 * Affine transformations; see transform.h for the conventions.
 */
#include "base/transform.h"
#include "base/elementary.h"

#include <string.h>

#define RADIANS_PER_DEGREE 0.017453292519943296

/* Below this a matrix column counts as empty, as in the reference. */
#define EMPTY_COLUMN 1e-10

transform transform_identity(void)
{
	return (transform){
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } },
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } },
	};
}

transform transform_translate(vec3 by)
{
	return (transform){
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { by.x, by.y, by.z } },
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -by.x, -by.y, -by.z } },
	};
}

transform transform_scale(vec3 by)
{
	return (transform){
		{ { by.x, 0, 0 }, { 0, by.y, 0 }, { 0, 0, by.z }, { 0, 0, 0 } },
		{ { 1 / by.x, 0, 0 }, { 0, 1 / by.y, 0 }, { 0, 0, 1 / by.z }, { 0, 0, 0 } },
	};
}

/* A pure rotation: its inverse is its transpose. */
static transform from_rotation(const double r[3][3])
{
	transform t = transform_identity();
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			t.m[i][j] = r[i][j];
			t.inverse[j][i] = r[i][j];
		}
	}
	return t;
}

transform transform_rotate(vec3 degrees)
{
	const vec3 a = vec_scale(degrees, RADIANS_PER_DEGREE);
	const vec3 c = vec(elementary_cos(a.x), elementary_cos(a.y), elementary_cos(a.z));
	const vec3 s = vec(elementary_sin(a.x), elementary_sin(a.y), elementary_sin(a.z));
	const double about_x[3][3] = { { 1, 0, 0 }, { 0, c.x, s.x }, { 0, -s.x, c.x } };
	const double about_y[3][3] = { { c.y, 0, -s.y }, { 0, 1, 0 }, { s.y, 0, c.y } };
	const double about_z[3][3] = { { c.z, s.z, 0 }, { -s.z, c.z, 0 }, { 0, 0, 1 } };
	const transform x = from_rotation(about_x), y = from_rotation(about_y);
	const transform z = from_rotation(about_z);
	const transform xy = transform_compose(&x, &y);
	return transform_compose(&xy, &z);
}

transform transform_turn_z(vec3 to)
{
	const double across = to.x * to.x + to.y * to.y;
	if (!(across > 0)) {
		const double half_turn[3][3] = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } };
		return to.z < 0 ? from_rotation(half_turn) : transform_identity();
	}
	/* 1 / (1 + z), without cancellation */
	const double k = to.z < 0 ? (1 - to.z) / across : 1 / (1 + to.z);
	const double turn[3][3] = { { 1 - to.x * to.x * k, -to.x * to.y * k, -to.x },
		{ -to.x * to.y * k, 1 - to.y * to.y * k, -to.y }, { to.x, to.y, to.z } };
	return from_rotation(turn);
}

/* Inverse by cofactors over the determinant. */
static bool invert_rows(double m[4][3], double out[4][3])
{
	const vec3 a = vec(m[0][0], m[0][1], m[0][2]);
	const vec3 b = vec(m[1][0], m[1][1], m[1][2]);
	const vec3 c = vec(m[2][0], m[2][1], m[2][2]);
	const vec3 bc = vec_cross(b, c), ca = vec_cross(c, a), ab = vec_cross(a, b);
	const double determinant = vec_dot(a, bc);
	if (!(fabs(determinant) > 0) || !isfinite(1 / determinant))
		return false;
	const vec3 columns[3] = { vec_scale(bc, 1 / determinant), vec_scale(ca, 1 / determinant),
		vec_scale(ab, 1 / determinant) };
	for (int j = 0; j < 3; j++) {
		out[0][j] = columns[j].x;
		out[1][j] = columns[j].y;
		out[2][j] = columns[j].z;
	}
	for (int j = 0; j < 3; j++)
		out[3][j] = -(m[3][0] * out[0][j] + m[3][1] * out[1][j] + m[3][2] * out[2][j]);
	return true;
}

bool transform_matrix(const double m[12], transform *out)
{
	memcpy(out->m, m, sizeof out->m);
	for (int j = 0; j < 3; j++) {
		if (fabs(out->m[0][j]) < EMPTY_COLUMN && fabs(out->m[1][j]) < EMPTY_COLUMN &&
			fabs(out->m[2][j]) < EMPTY_COLUMN)
			out->m[j][j] = 1;
	}
	return invert_rows(out->m, out->inverse);
}

static void rows_multiply(const double a[4][3], const double b[4][3], double out[4][3])
{
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 3; j++) {
			out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] +
				    (i == 3 ? b[3][j] : 0);
		}
	}
}

transform transform_compose(const transform *a, const transform *b)
{
	transform t;
	rows_multiply(a->m, b->m, t.m);
	rows_multiply(b->inverse, a->inverse, t.inverse);
	return t;
}

transform transform_invert(const transform *t)
{
	transform back;
	memcpy(back.m, t->inverse, sizeof back.m);
	memcpy(back.inverse, t->m, sizeof back.inverse);
	return back;
}

bool transform_is_identity(const transform *t)
{
	const transform identity = transform_identity();
	return memcmp(t->m, identity.m, sizeof t->m) == 0;
}

box transform_box(const transform *t, box b)
{
	if (box_is_unbounded(b))
		return box_everything();
	box out = box_nothing();
	for (int corner = 0; corner < 8; corner++) {
		const vec3 p = vec(corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y,
			corner & 4 ? b.hi.z : b.lo.z);
		out = box_add_point(out, transform_point(t, p));
	}
	return out;
}
