/* SPDX-License-Identifier: MIT */
/*
 * Eight floats side by side. The same operations on every machine: one AVX
 * register, two SSE registers, or a plain loop, always with the same results.
 * Only for files compiled once per instruction set; the type never crosses a
 * function boundary.
 */
#ifndef LAMBERT_BASE_SIMD_H
#define LAMBERT_BASE_SIMD_H

#include <stdint.h>

#if !defined(SIMD_PLAIN) && defined(__AVX2__)

#include <immintrin.h>

typedef __m256 float8;

#define float8_load(p)	   _mm256_load_ps(p)
#define float8_store(p, a) _mm256_store_ps((p), (a))
#define float8_all(s)	   _mm256_set1_ps(s)
#define float8_add(a, b)   _mm256_add_ps((a), (b))
#define float8_sub(a, b)   _mm256_sub_ps((a), (b))
#define float8_mul(a, b)   _mm256_mul_ps((a), (b))
/* The second when either is not a number. */
#define float8_min(a, b) _mm256_min_ps((a), (b))
#define float8_max(a, b) _mm256_max_ps((a), (b))
/* Bit i: a[i] <= b[i]. */
#define float8_le(a, b) ((unsigned)_mm256_movemask_ps(_mm256_cmp_ps((a), (b), _CMP_LE_OQ)))

#elif !defined(SIMD_PLAIN) && defined(__SSE2__)

#include <emmintrin.h>

typedef struct {
	__m128 a, b;
} float8;

static inline float8 float8_load(const float *p)
{
	return (float8){ _mm_load_ps(p), _mm_load_ps(p + 4) };
}
static inline void float8_store(float *p, float8 v)
{
	_mm_store_ps(p, v.a);
	_mm_store_ps(p + 4, v.b);
}
static inline float8 float8_all(float s)
{
	return (float8){ _mm_set1_ps(s), _mm_set1_ps(s) };
}
static inline float8 float8_add(float8 x, float8 y)
{
	return (float8){ _mm_add_ps(x.a, y.a), _mm_add_ps(x.b, y.b) };
}
static inline float8 float8_sub(float8 x, float8 y)
{
	return (float8){ _mm_sub_ps(x.a, y.a), _mm_sub_ps(x.b, y.b) };
}
static inline float8 float8_mul(float8 x, float8 y)
{
	return (float8){ _mm_mul_ps(x.a, y.a), _mm_mul_ps(x.b, y.b) };
}
static inline float8 float8_min(float8 x, float8 y)
{
	return (float8){ _mm_min_ps(x.a, y.a), _mm_min_ps(x.b, y.b) };
}
static inline float8 float8_max(float8 x, float8 y)
{
	return (float8){ _mm_max_ps(x.a, y.a), _mm_max_ps(x.b, y.b) };
}
static inline unsigned float8_le(float8 x, float8 y)
{
	return (unsigned)_mm_movemask_ps(_mm_cmple_ps(x.a, y.a)) |
	       (unsigned)_mm_movemask_ps(_mm_cmple_ps(x.b, y.b)) << 4;
}

#else

typedef struct {
	float v[8];
} float8;

#define FLOAT8_EACH(expression)                                                                    \
	float8 out;                                                                                \
	for (int i = 0; i < 8; i++)                                                                \
		out.v[i] = (expression);                                                           \
	return out

static inline float8 float8_load(const float *p)
{
	FLOAT8_EACH(p[i]);
}
static inline void float8_store(float *p, float8 x)
{
	for (int i = 0; i < 8; i++)
		p[i] = x.v[i];
}
static inline float8 float8_all(float s)
{
	FLOAT8_EACH(s);
}
static inline float8 float8_add(float8 x, float8 y)
{
	FLOAT8_EACH(x.v[i] + y.v[i]);
}
static inline float8 float8_sub(float8 x, float8 y)
{
	FLOAT8_EACH(x.v[i] - y.v[i]);
}
static inline float8 float8_mul(float8 x, float8 y)
{
	FLOAT8_EACH(x.v[i] * y.v[i]);
}
static inline float8 float8_min(float8 x, float8 y)
{
	FLOAT8_EACH(x.v[i] < y.v[i] ? x.v[i] : y.v[i]);
}
static inline float8 float8_max(float8 x, float8 y)
{
	FLOAT8_EACH(x.v[i] > y.v[i] ? x.v[i] : y.v[i]);
}
static inline unsigned float8_le(float8 x, float8 y)
{
	unsigned mask = 0;
	for (unsigned i = 0; i < 8; i++)
		mask |= (unsigned)(x.v[i] <= y.v[i]) << i;
	return mask;
}

#undef FLOAT8_EACH
#endif

#endif
