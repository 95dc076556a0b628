/* SPDX-License-Identifier: MIT */
/*
 * The walk without wide instructions, for other processors and as a test of the others.
 */
#define SIMD_PLAIN
#define ACCEL_KERNEL accel_kernel_plain
#include "accel_trace.inc"
