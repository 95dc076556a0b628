/* SPDX-License-Identifier: MIT */
/*
 * The processor's instruction sets, and the environment's wish.
 */
#include "base/cpu.h"

#include <stdlib.h>
#include <string.h>

static enum cpu_level available(void)
{
#if defined(__x86_64__)
	__builtin_cpu_init();
	if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
		__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
		return CPU_AVX512;
	if (__builtin_cpu_supports("avx2"))
		return CPU_AVX2;
#endif
	return CPU_BASELINE;
}

enum cpu_level cpu_level(void)
{
	static const char *const names[CPU_LEVELS] = { "plain", "baseline", "avx2", "avx512" };
	const enum cpu_level best = available();
	const char *wish = getenv("LAMBERT_ISA");
	if (!wish)
		return best;
	for (int i = 0; i < CPU_LEVELS; i++) {
		if (strcmp(wish, names[i]) == 0)
			return (enum cpu_level)i < best ? (enum cpu_level)i : best;
	}
	return best;
}
