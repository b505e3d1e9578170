/*
 * schiller_naumann.c -- drag on a lone sphere, whatever the void fraction around it.
 *
 *   G = 1 + 0.15 Re^0.687 for Re < 1000, else 0.44 Re/24
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   Re   rho d |u - v|/mu, with the fluid velocity between grains and without a void fraction      [1]
 *
 * G -> 1 for Re -> 0. As published it steps up by 0.4 % at Re = 1000. The same as wenYu at void fraction 1, and only
 * there: Re here is that of the interstitial slip, wenYu's that of the superficial one.
 *
 * Source: Schiller and Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318; above 1000 Newton's constant coefficient.
 * Not here: neighbours (see wenYu, diFelice, beetstra), the fall of the coefficient above Re = 2e5.
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
        dem_drag_add(b, c, dem_drag_single_sphere(dem_drag_reynolds(b, c, 1.0)));
    }
}

const struct dem_effect dem_schiller_naumann = {
    .name = "schillerNaumann",
    .says = "drag on a lone sphere, 1 + 0.15 Re^0.687 times Stokes', for dilute flow",
    .source = "Schiller and Naumann 1933",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .act_on_bodies = act_on_bodies,
};
