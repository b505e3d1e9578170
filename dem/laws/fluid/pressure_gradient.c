/*
 * pressure_gradient.c -- force of the fluid pressure gradient on a particle, buoyancy included.
 *
 *   F = -V grad p
 *
 *   V   volume of the particle                                     [m3]
 *   p   full pressure, hydrostatic part included                   [Pa]
 *
 * In a fluid at rest grad p = rho g, so F = -rho V g: this is buoyancy, and no other effect may add
 * it. In a moving fluid it also contains the force that accelerates the displaced fluid.
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, sets I and II.
 * Not here: the viscous part V div tau (see viscousStress).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/pressure_gradient.h"

#define LAW dem_pressure_gradient
#define SETS DEM_SETS_FORCE
#include "laws/body_loop.h"

/* Buoyancy over weight, rho_f/rho_p (Archimedes); in coupled runs also the solid fraction, the ratio
   of the force of the pressure gradient to the drag on a bed (Gidaspow 1994, 2.5). In a coupled bed
   of unknown void fraction it may be essential: not known. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double buoyancy = g->suspension.fluid_density/g->suspension.density,
                 shared = g->uniform ? 0.0 : g->solid_fraction;

    (void)of;
    v->fraction = fmax(buoyancy, shared);
    v->quantity =
        buoyancy >= shared
            ? "of the weight is buoyancy (Archimedes)"
            : "of the support of a sphere is the pressure gradient caused by the drag on all (set II; Gidaspow 1994)";
    return g->suspension.gravity > 0.0 && (buoyancy > v->threshold || shared > 0.0 || g->uniform);
}

const struct dem_effect dem_pressure_gradient = {
    .name = "pressureGradient",
    .aliases = "buoyancy archimedes pressureGradientForce",
    .summary = "force of the full pressure gradient of the fluid, -V grad p; contains buoyancy",
    .source = "Zhou, Kuang, Chu, Yu 2010",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_SAME,
    .has_pressure_gradient = 1,
    .needs = DEM_NEEDS_FLUID,
    .apply_to_bodies = apply_to_bodies,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_PRESSURE,
};
