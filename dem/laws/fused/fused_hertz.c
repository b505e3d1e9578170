/*
 * fused_hertz.c -- the fused kernels with the normal law hertz.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

DEM_FUSED_HERTZ(DEM_FUSED_DEFINE)

const struct dem_fused_kernel dem_fused_hertz[] = {DEM_FUSED_HERTZ(DEM_FUSED_ROW){.apply = NULL}};
