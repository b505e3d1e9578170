/*
 * koch_hill.c -- drag of Hill, Koch and Ladd, from lattice-Boltzmann simulations of random arrays.
 *
 *   G = e^2 (F0 + F3 Re/2)
 *   F0 = (1 + 3 sqrt(s/2) + 135/64 s ln s + 16.14 s)/(1 + 0.681 s - 8.48 s^2 + 8.16 s^3)
 *        for s < 0.4, otherwise 10 s/e^3
 *   F3 = 0.0673 + 0.212 s + 0.0232/e^5
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * G -> 1 for e -> 1, Re -> 0. F0 has a step of 1 % at s = 0.4, as published.
 *
 * Source: Hill, Koch, Ladd, J. Fluid Mech. 448 (2001) 213 and 243; Koch and Hill, Annu. Rev. Fluid
 * Mech. 33 (2001) 619. Changed: Re/2, because their Reynolds number is formed with the radius.
 * Not here: their other formula, quadratic in Re, for Re below 20; at Re -> 0 both are F0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/koch_hill.h"

#define LAW dem_koch_hill
#define PREPARES DEM_SETS_VOIDAGE_FACTOR
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_koch_hill = {
    .name = "kochHill",
    .aliases = "KochHill KochHillDrag HillKochLadd",
    .summary =
        "drag from packed to dilute, fitted to lattice-Boltzmann simulations of random arrays",
    .source = "Hill, Koch, Ladd 2001; Koch and Hill 2001",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
