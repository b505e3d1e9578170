/*
 * ergun.c -- drag in a packed bed (Ergun).
 *
 *   G = (150 s/e + 1.75 Re/e)/18
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * In a fixed bed the balance e grad p = n f gives the Ergun equation,
 * 150 mu s^2 U/(e^3 d^2) + 1.75 rho s U^2/(e^3 d), with U = e u and n = s/V. For packings, e from
 * 0.35 to 0.5: for a single creeping sphere it goes to 0, not to 1.
 *
 * Source: Ergun, Chem. Eng. Prog. 48 (1952) 89.
 * Not here: expanded beds and dilute flow (see gidaspow, which changes to Wen and Yu).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/ergun.h"

#define LAW dem_ergun
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_ergun = {
    .name = "ergun",
    .aliases = "ErgunDrag",
    .summary = "drag in a packed bed, Ergun's pressure drop; not for dilute flow",
    .source = "Ergun 1952",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_PACKED,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
};
