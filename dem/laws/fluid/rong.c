/*
 * rong.c -- drag of Rong et al., from lattice-Boltzmann simulations of packings.
 *
 *   G = Cd Re/24 e^(1 - chi),   Cd = (0.63 + 4.8/sqrt Re)^2
 *   chi = 2.65 (e + 1) - (5.3 - 3.5 e) e^2 exp(-(1.5 - log10 Re)^2/2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction                                             [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * The form of Di Felice with an exponent that also depends on e. A single creeping sphere has 0.96
 * of the Stokes drag, see diFelice.
 *
 * Source: Rong, Dong, Yu, Chem. Eng. Sci. 99 (2013) 44.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/rong.h"

#define LAW dem_rong
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_rong = {
    .name = "rong",
    .aliases = "RongDrag",
    .summary =
        "drag from packed to dilute, the form of Di Felice fitted to lattice-Boltzmann simulations of packings",
    .source = "Rong, Dong, Yu 2013",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
};
