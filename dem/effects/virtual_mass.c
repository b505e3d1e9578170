/*
 * virtual_mass.c -- a particle takes fluid along when it speeds up.
 *
 *   F = a (Du/Dt - dv/dt),   a = C rho V,   so   (m + a) dv/dt = a Du/Dt + all other forces
 *
 *   C      1/2 for a lone sphere; of a swarm see below             [1]
 *   rho    density of the fluid                                    [kg/m3]
 *   V, m   volume and mass of the particle                         [m3], [kg]
 *   Du/Dt  acceleration of the fluid, du/dt + u.grad u             [m/s2]
 *
 *   swarm none       C = 1/2
 *         zuber      C = 1/2 (1 + 2 s)/(1 - s)
 *         felderhof  C = 1/2 + (0.047 L + 0.13) s - (0.066 L + 0.58) s^2 + 1.42 s^3,   L = ln(rho_p/rho)
 *   s      solid's share, 1 - void fraction, at most 0.8           [1]
 *   rho_p  density of the particle                                 [kg/m3]
 *
 * The effect tells a, which joins the particle's inertia (never its weight), and a Du/Dt. v is never differentiated: that would be noise,
 * and unstable for rho_p <= C rho; like this a bubble of no weight is stable. All forces meet m + a, those of contacts
 * too, and damping counts it: impacts in liquid return what is asked. C is that of the beginning of the fluid's step; when it changes, v stays
 * and so does m v, the momentum. The fluid gets the opposite of the whole force.
 *
 * Source: Maxey, Riley, Phys. Fluids 26 (1983) 883; Auton, Hunt, Prud'homme, J. Fluid Mech. 197 (1988) 241 (Du/Dt, not the derivative
 * along the particle); Zuber, Chem. Eng. Sci. 19 (1964) 897; the fit to Felderhof, J. Phys. A 24 (1991) 4355, is that of CFDEMcoupling-PFM.
 * Not here: the history force; walls; other shapes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

struct virtual_mass
{
    double coefficient;
    int swarm;
};

enum
{
    NONE,
    ZUBER,
    FELDERHOF
};
static const char *const swarms[] = {"none", "zuber", "felderhof", NULL};

static const struct dem_field settings[] = {
    DEM_FIELD(virtual_mass, coefficient, "1", 0.5, 0.0, 10.0, "C of a lone particle, 1/2 for a sphere"),
    DEM_FIELD_CHOICE(virtual_mass, swarm, "swarm", NONE, swarms, "how C grows with the solid's share"),
    {0},
};

DEM_KERNEL
static void open_bodies(const void *of, struct dem_body_block *restrict b)
{
    const struct virtual_mass *const own = of;
    const double alone = own->coefficient;

    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]), s = 1.0 - e, there = dem_pick(b->density[c]*b->volume[c] > 0.0, 1.0, 0.0);
        const double ratio = dem_pick(there > 0.0, b->mass[c], 1.0)/dem_pick(there > 0.0, b->density[c]*b->volume[c], 1.0);
        const double L = dem_log(dem_pick(ratio > 1e-12, ratio, 1e-12));
        const double zuber = (1.0 + 2.0*s)/e;
        const double felderhof = 1.0 + 2.0*s*(0.047*L + 0.13 - s*(0.066*L + 0.58 - 1.42*s));
        const double more = dem_pick(own->swarm == ZUBER, zuber, dem_pick(own->swarm == FELDERHOF, felderhof, 1.0));

        b->added[c] += alone*dem_pick(more > 0.0, more, 0.0)*b->density[c]*b->volume[c];
    }
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        b->rx[c] += b->added[c]*b->ax[c];
        b->ry[c] += b->added[c]*b->ay[c];
        b->rz[c] += b->added[c]*b->az[c];
    }
}

const struct dem_effect dem_virtual_mass = {
    .name = "virtualMass",
    .says = "fluid that a particle takes along when it speeds up: C rho V (Du/Dt - dv/dt), in its inertia",
    .source = "Auton, Hunt, Prud'homme 1988; Zuber 1964; Felderhof 1991",
    .stage = DEM_STAGE_FLUID,
    .reacts = 1,
    .inertia = 1,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_ACCELERATION,
    .size = sizeof(struct virtual_mass),
    .settings = settings,
    .open_bodies = open_bodies,
    .act_on_bodies = act_on_bodies,
};
