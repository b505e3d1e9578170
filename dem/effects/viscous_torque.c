/*
 * viscous_torque.c -- the fluid turns a sphere towards half its vorticity.
 *
 *   T = t (o/2 - W),   t = pi mu d^3 max(1, (128.4 + 12.9 sqrt Re_r)/(64 pi)),   Re_r = rho d^2 |o/2 - W|/mu
 *
 *   W    spin of the sphere                                        [1/s]
 *   o    vorticity of the fluid, curl u; o/2 is its rate of turning                                [1/s]
 *   mu, rho, d   viscosity, density, diameter                      [Pa s], [kg/m3], [m]
 *
 * Creeping it is Stokes' pi mu d^3. Above Re_r = 31.7, where the fit of Dennis and others meets that (there is no step), more; their
 * fit is for Re_r up to 4000. The effect gives t and t o/2, and the step integrates them exactly: however viscous the fluid is, the sphere
 * turns with it and never past it.
 *
 * The fluid gets nothing of this torque: averaged over a volume it has no place for a couple (see coupling/README.md, section 5).
 *
 * Source: Stokes, Trans. Camb. Phil. Soc. 8 (1845) 287; Dennis, Singh, Ingham, J. Fluid Mech. 101 (1980) 257, as Crowe, Schwarzkopf,
 * Sommerfeld, Tsuji, Multiphase Flows with Droplets and Particles (2011), section 4.3, write it.
 * Not here: neighbours; history of the spin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

struct viscous_torque
{
    int correction;
};

static const struct dem_field settings[] = {
    DEM_FIELD_SWITCH(viscous_torque, correction, "correction", 1, "more than Stokes' torque where the spin's Reynolds number is above 31.7"),
    {0},
};

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    const int corrects = ((const struct viscous_torque *)of)->correction;
    const double pi = 3.14159265358979324;

    for (int c = 0; c < b->n; c++)
    {
        const double d = 2.0*b->radius[c], mu = b->viscosity[c];
        const double x = 0.5*b->ox[c], y = 0.5*b->oy[c], z = 0.5*b->oz[c];
        const double dx = x - b->wx[c], dy = y - b->wy[c], dz = z - b->wz[c];
        const double re = dem_pick(mu > 0.0, b->density[c]*d*d*sqrt(dx*dx + dy*dy + dz*dz)/dem_pick(mu > 0.0, mu, 1.0), 0.0);
        const double fit = (128.4 + 12.9*sqrt(re))/(64.0*pi);
        const double t = pi*mu*d*d*d*dem_pick(corrects & (fit > 1.0), fit, 1.0);

        b->t[c] += t;
        b->tx[c] += t*x;
        b->ty[c] += t*y;
        b->tz[c] += t*z;
    }
}

const struct dem_effect dem_viscous_torque = {
    .name = "viscousTorque",
    .says = "torque of the fluid on a sphere that does not turn with it, pi mu d^3 (curl u/2 - spin)",
    .source = "Stokes 1845; Dennis, Singh, Ingham 1980",
    .stage = DEM_STAGE_FLUID,
    .turns = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_SPIN | DEM_NEEDS_VORTICITY,
    .size = sizeof(struct viscous_torque),
    .settings = settings,
    .act_on_bodies = act_on_bodies,
};
