/*
 * stokes_drag.c -- Stokes drag on a single sphere in creeping flow.
 *
 *   f = 3 pi mu d (u - v),   G = 1
 *
 *   u    fluid velocity; v particle velocity                       [m/s]  see drag.h
 *   mu   viscosity of the fluid                                    [Pa s]
 *   d    diameter                                                  [m]
 *
 * Linear in the slip and independent of the void fraction: for comparison with closed forms and for
 * Re = rho d |u - v|/mu well below 1 (at 0.1 it is 2 % too small).
 *
 * Source: Stokes, Trans. Camb. Philos. Soc. 9 (1851) 8.
 * Not here: inertia of the fluid (see schillerNaumann), neighbours (see wenYu, diFelice).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/stokes_drag.h"

#define LAW dem_stokes_drag
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_stokes_drag = {
    .name = "stokesDrag",
    .summary = "Stokes drag on a single sphere in creeping flow, 3 pi mu d (u - v)",
    .source = "Stokes 1851",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_CREEPING,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
};
