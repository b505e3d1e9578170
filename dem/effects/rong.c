/*
 * rong.c -- drag in a swarm from fixed bed to lone sphere, after lattice-Boltzmann simulations of packings.
 *
 *   G = Cd Re/24 e^(1 - chi),   Cd = (0.63 + 4.8/sqrt Re)^2
 *   chi = 2.65 (e + 1) - (5.3 - 3.5 e) e^2 exp(-(1.5 - log10 Re)^2/2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction                                             [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *
 * Di Felice's form with a power that depends on e as well. A lone creeping sphere feels 0.96 of Stokes' drag, see
 * diFelice.
 *
 * Source: Rong, Dong, Yu, Chem. Eng. Sci. 99 (2013) 44.
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
        const double e = dem_drag_void(b->void_fraction[c]);
        const double re = dem_drag_reynolds(b, c, e);
        const double chi = 2.65*(e + 1.0) - (5.3 - 3.5*e)*e*e*dem_drag_bell(re);

        dem_drag_add(b, c, dem_drag_dallavalle(re)*dem_pow(e, 1.0 - chi));
    }
}

const struct dem_effect dem_rong = {
    .name = "rong",
    .says = "drag from packed to dilute, Di Felice's form fitted to simulations of packings",
    .source = "Rong, Dong, Yu 2013",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .act_on_bodies = act_on_bodies,
};
