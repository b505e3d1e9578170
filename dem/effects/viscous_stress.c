/*
 * viscous_stress.c -- viscous stress of the mean flow that varies in space pushes a particle like the fluid in its place.
 *
 *   F = V div tau
 *
 *   V     volume of the particle                                   [m3]
 *   tau   viscous and turbulent stress of the fluid                [Pa]
 *
 * It stands beside the pressure gradient: with both a particle feels what would have moved the fluid in its place, and the fluid
 * keeps the share e of each. The fluid gets the opposite of this force, so with this effect its equation has the whole div tau, of which
 * e div tau is left, and without it div(e tau).
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, sets I and II.
 * Not here: the stress that particles add to the mixture (Einstein's viscosity).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        b->rx[c] += b->volume[c]*b->sx[c];
        b->ry[c] += b->volume[c]*b->sy[c];
        b->rz[c] += b->volume[c]*b->sz[c];
    }
}

const struct dem_effect dem_viscous_stress = {
    .name = "viscousStress",
    .says = "force of the viscous stress of the mean flow, V div tau",
    .source = "Zhou, Kuang, Chu, Yu 2010",
    .stage = DEM_STAGE_FLUID,
    .reacts = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_STRESS,
    .act_on_bodies = act_on_bodies,
};
