/*
 * fused_adhesive.c -- the fused kernels with an adhesive film, whose force counts in the friction
 * limit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

#define LAWS hertz, dry, mindlin, none, jkr
#include "laws/fused/fused_loop.h"

const struct dem_fused_kernel dem_fused_adhesive[] = {
    DEM_FUSED_ROW(hertz, dry, mindlin, none, jkr),
    {.apply = NULL}};
