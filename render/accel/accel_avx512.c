/* SPDX-License-Identifier: MIT */
/*
 * The walk for processors with AVX-512.
 */
#define ACCEL_KERNEL accel_kernel_avx512
#include "accel_trace.inc"
