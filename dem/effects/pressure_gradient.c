/*
 * pressure_gradient.c -- a pressure that varies in space pushes a particle towards where it is low.
 *
 *   F = -V grad p
 *
 *   V   volume of the particle                                     [m3]
 *   p   full pressure, hydrostatic part included                   [Pa]
 *
 * In a fluid at rest grad p = rho g, so F = -rho V g: buoyancy is inside, and there must be no other effect for it.
 * In a moving one it also holds what accelerates the displaced fluid.
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, sets I and II.
 * Not here: the viscous part V div tau (see viscousStress).
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
        b->fx[c] -= b->volume[c]*b->gx[c];
        b->fy[c] -= b->volume[c]*b->gy[c];
        b->fz[c] -= b->volume[c]*b->gz[c];
    }
}

const struct dem_effect dem_pressure_gradient = {
    .name = "pressureGradient",
    .says = "force of the full pressure gradient of the fluid, -V grad p; contains buoyancy",
    .source = "Zhou, Kuang, Chu, Yu 2010",
    .stage = DEM_STAGE_FLUID,
    .needs = DEM_NEEDS_FLUID,
    .act_on_bodies = act_on_bodies,
};
