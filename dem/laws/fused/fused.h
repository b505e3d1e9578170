/*
 * fused.h -- find the kernel that computes the first laws of an effect list in one loop.
 *
 * Intermediate results stay in registers instead of columns. The operations and their
 * order are the same as in the effects' own loops, so results have the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effect.h"

enum
{
    DEM_FUSED_LAWS = 5    /* normal, damping, friction, rolling, film */
};

struct dem_fused_kernel
{
    const struct dem_effect *law[DEM_FUSED_LAWS];    /* &dem_none where there is none */
    /* settings: of the laws, in their places (not read where there is no law); history: columns of
       all laws one after the other. Sets kn, forces and moments, which need not be cleared. */
    void (*apply)(const void *const settings[DEM_FUSED_LAWS], struct dem_contact_batch *restrict,
                  double *const *history);
};

/* The kernel that takes most effects from the first on, or NULL. *taken: their number. */
const struct dem_fused_kernel *dem_fused_find(const struct dem_effect *const *effects, int count,
                                              int *taken);

/* Tables of kernels, each ended by a row without apply; the last table is NULL. */
extern const struct dem_fused_kernel dem_fused_hertz[], dem_fused_hooke[], dem_fused_adhesive[];
extern const struct dem_fused_kernel *const dem_fused_kernels[];

/* in the place of a law that a kernel does not have; no effect of a scene */
extern const struct dem_effect dem_none;
