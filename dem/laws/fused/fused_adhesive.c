/*
 * fused_adhesive.c -- the fused kernels with an adhesive film.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

DEM_FUSED_ADHESIVE(DEM_FUSED_DEFINE_FILM)

const struct dem_fused_kernel dem_fused_adhesive[] = {DEM_FUSED_ADHESIVE(DEM_FUSED_ROW_FILM){.apply = NULL}};
