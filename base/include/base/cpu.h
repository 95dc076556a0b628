/* SPDX-License-Identifier: MIT */
/*
 * Which of the compiled instruction sets to run.
 */
#ifndef LAMBERT_BASE_CPU_H
#define LAMBERT_BASE_CPU_H

enum cpu_level {
	CPU_PLAIN,    /* no wide instructions at all: the twin that the others are tested with */
	CPU_BASELINE, /* what the architecture always has: SSE2 on x86-64 */
	CPU_AVX2,
	CPU_AVX512,
	CPU_LEVELS
};

/* The best this processor can run, or less when the environment variable LAMBERT_ISA names one:
 * plain, baseline, avx2 or avx512. */
enum cpu_level cpu_level(void);

#endif
