/* SPDX-License-Identifier: MIT */
/*
 * Affine transformations with row vectors, p' = p * M: rows 0 to 2 of `m` are
 * the images of the axes, row 3 the translation. The inverse is kept beside the
 * matrix and built from the exact inverse of each step (reciprocal scale,
 * transposed rotation), so going there and back loses as little as possible.
 */
#ifndef LAMBERT_BASE_TRANSFORM_H
#define LAMBERT_BASE_TRANSFORM_H

#include "base/vec3.h"

typedef struct {
	double m[4][3];
	double inverse[4][3];
} transform;

transform transform_identity(void);
transform transform_translate(vec3 by);
/* No component may be zero. */
transform transform_scale(vec3 by);
/* About x, then y, then z, in degrees, left-handed: 90 about z takes x to y. */
transform transform_rotate(vec3 degrees);
/* The shortest turn of the z axis to a unit vector. */
transform transform_turn_z(vec3 to);
/* From the twelve numbers of `matrix <...>`; false when it is singular. */
bool transform_matrix(const double m[12], transform *out);
/* First `a`, then `b`. */
transform transform_compose(const transform *a, const transform *b);
transform transform_invert(const transform *);
bool transform_is_identity(const transform *);

static inline vec3 rows_apply(const double m[4][3], vec3 p)
{
	return vec(p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
		p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
		p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]);
}
static inline vec3 rows_apply_direction(const double m[4][3], vec3 d)
{
	return vec(d.x * m[0][0] + d.y * m[1][0] + d.z * m[2][0],
		d.x * m[0][1] + d.y * m[1][1] + d.z * m[2][1],
		d.x * m[0][2] + d.y * m[1][2] + d.z * m[2][2]);
}
static inline vec3 rows_apply_transposed(const double m[4][3], vec3 n)
{
	return vec(n.x * m[0][0] + n.y * m[0][1] + n.z * m[0][2],
		n.x * m[1][0] + n.y * m[1][1] + n.z * m[1][2],
		n.x * m[2][0] + n.y * m[2][1] + n.z * m[2][2]);
}

static inline vec3 transform_point(const transform *t, vec3 p)
{
	return rows_apply(t->m, p);
}
static inline vec3 transform_direction(const transform *t, vec3 d)
{
	return rows_apply_direction(t->m, d);
}
/* Out of the transformed space, back to the space before. */
static inline vec3 transform_point_back(const transform *t, vec3 p)
{
	return rows_apply(t->inverse, p);
}
static inline vec3 transform_direction_back(const transform *t, vec3 d)
{
	return rows_apply_direction(t->inverse, d);
}
/* Surface normals go with the inverse transposed; the result is not normalised. */
static inline vec3 transform_normal(const transform *t, vec3 n)
{
	return rows_apply_transposed(t->inverse, n);
}
static inline vec3 transform_normal_back(const transform *t, vec3 n)
{
	return rows_apply_transposed(t->m, n);
}
static inline ray transform_ray_back(const transform *t, ray r)
{
	return (ray){ transform_point_back(t, r.origin), transform_direction_back(t, r.direction) };
}
/* The box of the eight transformed corners; an unbounded box stays unbounded. */
box transform_box(const transform *, box);

#endif
