/*
 * di_felice.c -- drag of Di Felice: single sphere times a power of the void fraction.
 *
 *   G = Cd Re/24 e^(1 - chi),   Cd = (0.63 + 4.8/sqrt Re)^2
 *   chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction                                             [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * The same as f = (pi/8) d^2 rho Cd e^(2 - chi) |u - v| (u - v). Computed from
 * Cd Re = (0.63 sqrt Re + 4.8)^2, which is 23.04 and not 24 at rest: a single creeping sphere has
 * 0.96 of the Stokes drag. chi is 3.7 for small and large Re, and 3.05 at Re = 32.
 *
 * Source: Di Felice, Int. J. Multiph. Flow 20 (1994) 153; Cd: Dallavalle, Micromeritics (1948).
 * Misprints: e^-chi with the interstitial slip but without e^2, found in tables of other codes, is
 * the law for the squared superficial slip U = e (u - v); Re is superficial, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/di_felice.h"

#define LAW dem_di_felice
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_di_felice = {
    .name = "diFelice",
    .aliases = "DiFelice DiFeliceDrag",
    .summary =
        "drag from packed to dilute, single sphere times a power of the void fraction that "
        "depends on Re",
    .source = "Di Felice 1994; Dallavalle 1948",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
};
