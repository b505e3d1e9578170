/*
 * schiller_naumann.c -- drag of Schiller and Naumann on a single sphere.
 *
 *   G = 1 + 0.15 Re^0.687 for Re < 1000, else 0.44 Re/24
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   Re   rho d |u - v|/mu, u interstitial, without the void fraction   [1]
 *
 * Independent of the void fraction. G -> 1 for Re -> 0. It has a step of +0.4 % at Re = 1000, as
 * published. Equal to wenYu at void fraction 1 only: Re contains the interstitial slip here, and
 * the superficial slip there.
 *
 * Source: Schiller and Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318; above 1000 Newton's constant
 * coefficient.
 * Not here: neighbours (see wenYu, diFelice, beetstra), the drag crisis above Re = 2e5.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/schiller_naumann.h"

#define LAW dem_schiller_naumann
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_schiller_naumann = {
    .name = "schillerNaumann",
    .aliases = "sphereDrag SphereDrag",
    .summary = "drag on a single sphere, 1 + 0.15 Re^0.687 times the Stokes drag, for dilute flow",
    .source = "Schiller and Naumann 1933",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_SINGLE,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
};
