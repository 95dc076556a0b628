/* SPDX-License-Identifier: MIT */
/*
 * The walk for processors with AVX2.
 */
#define ACCEL_KERNEL accel_kernel_avx2
#include "accel_trace.inc"
