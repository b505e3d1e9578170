/*
 * fused_hooke.c -- the fused kernels with the normal laws hooke and hookeHysteresis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

DEM_FUSED_HOOKE(DEM_FUSED_DEFINE)

const struct dem_fused_kernel dem_fused_hooke[] = {DEM_FUSED_HOOKE(DEM_FUSED_ROW){.apply = NULL}};
