/*
 * wen_yu.c -- drag of Wen and Yu: single sphere times the voidage factor e^-2.65.
 *
 *   G = e^-2.65 F1(Re),   F1 = 1 + 0.15 Re^0.687 for Re < 1000, else 0.44 Re/24
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction                                             [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * G -> 1 for e -> 1, Re -> 0. F1 has a step of +0.4 % at Re = 1000, as published.
 *
 * Source: Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100.
 * Not here: packed beds, where it is too large at small Re and too small at large Re (see
 * gidaspow).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/wen_yu.h"

#define LAW dem_wen_yu
#define PREPARES DEM_SETS_VOIDAGE_FACTOR
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_wen_yu = {
    .name = "wenYu",
    .aliases = "WenYuDrag",
    .summary = "drag in a suspension, e^-2.65 times the drag on a single sphere",
    .source = "Wen and Yu 1966",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_SUSPENSION,
    .needs = DEM_NEEDS_FLUID,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
