/*
 * wen_yu.c -- drag in a dilute to dense swarm of spheres: the single sphere's, raised by e^-2.65.
 *
 *   G = e^-2.65 F1(Re),   F1 = 1 + 0.15 Re^0.687 for Re < 1000, else 0.44 Re/24
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction                                             [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * G -> 1 for e -> 1, Re -> 0. F1 steps up by 0.4 % at Re = 1000, as published.
 *
 * Source: Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100.
 * Not here: packed beds, where it gives too much at small Re and too little at large (see gidaspow).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

DEM_KERNEL
static void open_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        b->swarm[0][c] = dem_drag_swarm(dem_drag_void(b->void_fraction[c]));
    }
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]);

        dem_drag_add(b, c, b->swarm[0][c]*dem_drag_single_sphere(dem_drag_reynolds(b, c, e)));
    }
}

const struct dem_effect dem_wen_yu = {
    .name = "wenYu",
    .says = "drag on a swarm of spheres, Wen and Yu's e^-2.65 times the single sphere's",
    .source = "Wen and Yu 1966",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .open_bodies = open_bodies,
    .act_on_bodies = act_on_bodies,
};
