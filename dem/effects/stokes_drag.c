/*
 * stokes_drag.c -- drag on a lone sphere that creeps through the fluid.
 *
 *   f = 3 pi mu d (u - v),   G = 1
 *
 *   u    fluid velocity; v particle velocity                       [m/s]  see drag.h
 *   mu   viscosity of the fluid                                    [Pa s]
 *   d    diameter                                                  [m]
 *
 * Linear in the slip and blind to the void fraction: for closed forms and for Re = rho d |u - v|/mu well below 1 (at 0.1
 * it is 2 % too small).
 *
 * Source: Stokes, Trans. Camb. Philos. Soc. 9 (1851) 8.
 * Not here: inertia of the fluid (see schillerNaumann), neighbours (see wenYu, diFelice).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        dem_drag_add(b, c, 1.0);
    }
}

const struct dem_effect dem_stokes_drag = {
    .name = "stokesDrag",
    .says = "drag on a lone creeping sphere, 3 pi mu d (u - v)",
    .source = "Stokes 1851",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .act_on_bodies = act_on_bodies,
};
