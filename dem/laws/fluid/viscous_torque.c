/*
 * viscous_torque.c -- viscous torque of the fluid, which drives the spin to half the vorticity.
 *
 *   T = t (o/2 - W),   t = pi mu d^3 max(1, (128.4 + 12.9 sqrt Re_r)/(64 pi))
 *   Re_r = rho d^2 |o/2 - W|/mu
 *
 *   W    spin of the sphere                                        [1/s]
 *   o    vorticity of the fluid, curl u; o/2 is its rotation rate  [1/s]
 *   mu, rho, d   viscosity, density, diameter                      [Pa s], [kg/m3], [m]
 *
 * In creeping flow t is pi mu d^3 (Stokes). It is larger above Re_r = 31.7, where the fit of Dennis
 * et al. meets that value (without a step); the fit is for Re_r up to 4000. The effect sets t and t
 * o/2, and the time step integrates them exactly: at any viscosity the sphere approaches the
 * rotation of the fluid without overshoot.
 *
 * The opposite torque does not act on the fluid: the volume-averaged equations have no term for a
 * couple (docs/theory-coupling.md, other forces).
 *
 * Source: Stokes, Trans. Camb. Phil. Soc. 8 (1845) 287; Dennis, Singh, Ingham, J. Fluid Mech. 101
 * (1980) 257, as written in Crowe, Schwarzkopf, Sommerfeld, Tsuji, Multiphase Flows with Droplets
 * and Particles (2011), section 4.3.
 * Not here: neighbours; history of the spin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/viscous_torque.h"

static const struct dem_setting settings[] = {
    DEM_SETTING_SWITCH(dem_viscous_torque, correction, "correction", 1,
                     "correction to the Stokes torque for rotational Reynolds numbers above 31.7"),
    {0},
};

#define LAW dem_viscous_torque
#define SETS DEM_SETS_SPIN_DRAG
#include "laws/body_loop.h"

/* Spin lost between collisions, 1 - exp(-t/(rho_p d^2/(60 mu))). Not known without friction or in an
   open domain. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const struct dem_suspension *const b = &g->suspension;
    const double decay_time = b->density*b->diameter*b->diameter/(60.0*b->viscosity);

    (void)of;
    v->fraction = -expm1(-g->collision_time/decay_time);
    v->quantity = "of a spin is lost to the fluid between collisions (Dennis, Singh, Ingham 1980)";
    return g->friction > 0.0 && g->collision_time > 0.0 && g->slip > 0.0;
}

const struct dem_effect dem_viscous_torque = {
    .name = "viscousTorque",
    .summary = "viscous torque of the fluid on a sphere, pi mu d^3 (curl u/2 - spin)",
    .source = "Stokes 1845; Dennis, Singh, Ingham 1980",
    .stage = DEM_STAGE_FLUID,
    .has_rotational_drag = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_SPIN | DEM_NEEDS_VORTICITY,
    .size = sizeof(struct dem_viscous_torque),
    .settings = settings,
    .apply_to_bodies = apply_to_bodies,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_TORQUE,
};
