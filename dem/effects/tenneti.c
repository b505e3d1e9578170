/*
 * tenneti.c -- drag in a swarm of equal spheres, fitted to simulations that resolve the flow around each.
 *
 *   G = e^2 F,   F = F1(Re)/e^3 + 5.81 s/e^3 + 0.48 s^(1/3)/e^4 + s^3 Re (0.95 + 0.61 s^3/e^2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *   F1   single sphere, 1 + 0.15 Re^0.687 below 1000               [1]
 *
 * F is the paper's, on 3 pi mu d e (u - v), the whole force with the mean pressure gradient in it; without that gradient, which
 * is a force of its own here, it is e F, and with the slip between the grains e^2 F.
 *
 * The lone sphere's term is divided by e^3, as in the paper. With e^2, which other programs have, a creeping swarm of s = 0.5
 * would feel 19 % less than Beetstra's simulations say and 17 % less than Koch and Hill's; with e^3 it is 9 % and 7 % less.
 * The fit is for s from 0.1 to 0.5 and Re to 300. G -> 1 for e -> 1, Re -> 0; there it rises with 0.48 s^(1/3), that is steeply.
 *
 * Source: Tenneti, Garg, Subramaniam, Int. J. Multiphase Flow 37 (2011) 1072.
 * Not here: several sizes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

/* e^2 F without the lone sphere, which goes with 1/e: what stands for itself, and what is multiplied by Re */
DEM_KERNEL
static void open_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]), s = 1.0 - e, s3 = s*s*s;

        b->swarm[0][c] = 5.81*s/e + 0.48*dem_pow(s, 1.0/3.0)/(e*e);
        b->swarm[1][c] = s3*(0.95*e*e + 0.61*s3);
    }
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]), re = dem_drag_reynolds(b, c, e);

        dem_drag_add(b, c, dem_drag_single_sphere(re)/e + b->swarm[0][c] + b->swarm[1][c]*re);
    }
}

const struct dem_effect dem_tenneti = {
    .name = "tenneti",
    .says = "drag from packed to dilute, fitted to simulations that resolve the flow around equal spheres",
    .source = "Tenneti, Garg, Subramaniam 2011",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .open_bodies = open_bodies,
    .act_on_bodies = act_on_bodies,
};
