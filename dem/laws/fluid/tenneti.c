/*
 * tenneti.c -- drag of Tenneti et al. for equal spheres, from particle-resolved simulations.
 *
 *   G = e^2 F,   F = F1(Re)/e^3 + 5.81 s/e^3 + 0.48 s^(1/3)/e^4 + s^3 Re (0.95 + 0.61 s^3/e^2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *   F1   single sphere, 1 + 0.15 Re^0.687 below 1000               [1]
 *
 * F is as in the paper, normalised by 3 pi mu d e (u - v), of the whole force with the mean
 * pressure gradient; without that gradient, which is a separate force here, it is e F, and with the
 * interstitial slip e^2 F.
 *
 * The single-sphere term is divided by e^3, as in the paper. With e^2, as in other codes, creeping
 * flow at s = 0.5 would have 19 % less drag than in the simulations of Beetstra et al. and 17 % less
 * than in Koch and Hill's; with e^3 it is 9 % and 7 % less. The fit is for s from 0.1 to 0.5
 * and Re to 300. G -> 1 for e -> 1, Re -> 0; there it increases steeply, as 0.48 s^(1/3).
 *
 * Source: Tenneti, Garg, Subramaniam, Int. J. Multiphase Flow 37 (2011) 1072.
 * Not here: several sizes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/tenneti.h"

#define LAW dem_tenneti
#define PREPARES DEM_SETS_VOIDAGE_FACTOR
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_tenneti = {
    .name = "tenneti",
    .summary =
        "drag from packed to dilute, fitted to particle-resolved simulations of equal spheres",
    .source = "Tenneti, Garg, Subramaniam 2011",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
