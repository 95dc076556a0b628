/* SPDX-License-Identifier: MIT */
/*
 * The walk for any x86-64 processor.
 */
#define ACCEL_KERNEL accel_kernel_baseline
#include "accel_trace.inc"
