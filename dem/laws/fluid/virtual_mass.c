/*
 * virtual_mass.c -- virtual (added) mass: the fluid accelerated together with a particle.
 *
 *   F = a (Du/Dt - dv/dt),   a = C rho V,   so   (m + a) dv/dt = a Du/Dt + all other forces
 *
 *   C      1/2 for a single sphere; in a suspension see below      [1]
 *   rho    density of the fluid                                    [kg/m3]
 *   V, m   volume and mass of the particle                         [m3], [kg]
 *   Du/Dt  acceleration of the fluid, du/dt + u.grad u             [m/s2]
 *
 *   swarm none       C = 1/2
 *         zuber      C = 1/2 (1 + 2 s)/(1 - s)
 *         felderhof  C = 1/2 + (0.047 L + 0.13) s - (0.066 L + 0.58) s^2 + 1.42 s^3
 *                    L = ln(rho_p/rho)
 *   s      solid fraction, 1 - void fraction, at most 0.8          [1]
 *   rho_p  density of the particle                                 [kg/m3]
 *
 * The effect sets a, which is added to the inertial mass of the particle (not to its weight), and
 * the force a Du/Dt. dv/dt is never computed by differences: this would be noisy, and unstable for
 * rho_p <= C rho; in the present form even a bubble without mass is stable. All forces, contact
 * forces included, act on m + a, and contact damping takes it into account: restitution in a liquid
 * is as set. C is taken at the beginning of the fluid step; when it changes, v stays the same and so
 * does the momentum m v. The opposite of the whole force acts on the fluid.
 *
 * Source: Maxey, Riley, Phys. Fluids 26 (1983) 883; Auton, Hunt, Prud'homme, J. Fluid Mech. 197
 * (1988) 241 (Du/Dt, not the derivative along the particle); Zuber, Chem. Eng. Sci. 19 (1964) 897;
 * the fit to Felderhof, J. Phys. A 24 (1991) 4355, is from CFDEMcoupling-PFM.
 * Not here: the history force; walls; other shapes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/virtual_mass.h"

static const char *const correlations[] = {"none", "zuber", "felderhof", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_virtual_mass, coefficient, "1", 0.5, 0.0, 10.0,
              "C of a single particle, 1/2 for a sphere"),
    DEM_SETTING_CHOICE(dem_virtual_mass, correlation, "swarm", DEM_SWARM_NONE, correlations,
                     "dependence of C on the solid fraction: none, or the correlation of Zuber or "
                     "Felderhof"),
    {0},
};

#define LAW dem_virtual_mass
#define PREPARES DEM_SETS_ADDED_MASS
#define SETS DEM_SETS_REACTION
#include "laws/body_loop.h"

/* Zuber's factor is 1 or more. Felderhof's is less for bubbles and is not counted on. */
static double least_added_mass(const void *of)
{
    const struct dem_virtual_mass *const own = of;

    return own->correlation == DEM_SWARM_FELDERHOF ? 0.0 : own->coefficient;
}

/* added mass of a single sphere over mass, rho_f/(2 rho_p) */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    (void)of;
    v->fraction = 0.5*g->suspension.fluid_density/g->suspension.density;
    v->quantity = "of the inertia is added mass (Auton, Hunt, Prud'homme 1988)";
    return 1;
}

const struct dem_effect dem_virtual_mass = {
    .name = "virtualMass",
    .summary =
        "virtual (added) mass: C rho V (Du/Dt - dv/dt), as part of the inertia of the particle",
    .source = "Auton, Hunt, Prud'homme 1988; Zuber 1964; Felderhof 1991",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_SAME,
    .has_reaction = 1,
    .has_added_mass = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_ACCELERATION,
    .size = sizeof(struct dem_virtual_mass),
    .settings = settings,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
    .least_added_mass = least_added_mass,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_INERTIA,
};
