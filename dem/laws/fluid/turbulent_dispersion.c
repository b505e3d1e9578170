/*
 * turbulent_dispersion.c -- turbulent dispersion of particles by a discrete random walk.
 *
 *   u -> u + u',   u' = sqrt(2 k/3) g   in one eddy after the other (eddy.h)
 *
 *   u        velocity of the mean flow at the particle                                [m/s]
 *   g        three normal random numbers of an eddy, mean 0, variance 1                 [1]
 *   T        mean time in an eddy, C_t k/epsilon, less where the particle crosses it    [s]
 *
 * Drag and lift receive u + u'. Times in eddies are distributed exponentially, so u' at a particle
 * that crosses none has the integral time scale T; after a time much longer than T and the
 * relaxation time such particles are dispersed with u'^2 T per direction, whatever their mass
 * (Tchen 1947; Hinze, Turbulence (1975), chapter 5). Random numbers are a function of seed, id and
 * step: they do not depend on ranks and restarts.
 *
 * Source: Gosman, Ioannides, J. Energy 7 (1983) 482; C_t = 0.15 and exponential times as usual with
 * k-epsilon models; C_l = 0.09^(3/4).
 * Not here: drift correction where k varies in space (particles then collect where it is small, as
 * in all such walks), anisotropic turbulence, correlation between neighbours.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

struct turbulent_dispersion
{
    double lifetime, length, seed;
    int crossing;
};

static const struct dem_setting settings[] = {
    DEM_SETTING(turbulent_dispersion, lifetime, "1", 0.15, 1e-6, 1e6,
                "C_t: integral time scale of the fluid at the particle is C_t k/epsilon"),
    DEM_SETTING_SWITCH(turbulent_dispersion, crossing, "crossing", 1,
                       "particles leave an eddy also by crossing it"),
    DEM_SETTING(turbulent_dispersion, length, "1", 0.1643, 1e-6, 1e6,
                "C_l: length of an eddy that is crossed is C_l k^(3/2)/epsilon"),
    DEM_SETTING_COUNT(turbulent_dispersion, seed, "seed", 1.0, 0.0, 1e9, "of the random numbers"),
    {0},
};

static void eddies(const void *of, struct dem_eddies *e)
{
    const struct turbulent_dispersion *const own = of;

    e->lifetime = own->lifetime;
    e->length = own->crossing ? own->length : 0.0;
    e->seed = (uint64_t)own->seed;
}

/* u' is part of the fluid's velocity already */
static void apply_to_bodies(const void *of, struct dem_body_batch *restrict b)
{
    (void)of, (void)b;
}

const struct dem_effect dem_turbulent_dispersion = {
    .name = "turbulentDispersion",
    .aliases = "stochasticDispersionRAS discreteRandomWalk",
    .summary = "turbulent dispersion: drag and lift feel random eddies of the fluid's turbulence",
    .source = "Gosman, Ioannides 1983",
    .limitation = "has no drift correction: where the kinetic energy of turbulence varies in space,"
                  " particles collect where it is small",
    .stage = DEM_STAGE_FLUID,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_TURBULENCE,
    .size = sizeof(struct turbulent_dispersion),
    .settings = settings,
    .apply_to_bodies = apply_to_bodies,
    .eddies = eddies,
};
