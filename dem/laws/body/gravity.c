/*
 * gravity.c -- weight: the same acceleration for all particles.
 *
 *   F = m g
 *
 *   m   mass of the particle (not its inertial mass: added mass has no weight)     [kg]
 *   g   acceleration                                                               [m/s2]
 *
 * Source: Newton, Principia (1687).
 * Not here: buoyancy, which is part of the full pressure gradient (see pressureGradient).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

struct gravity
{
    double acceleration[3];
};

static const struct dem_setting settings[] = {
    DEM_SETTING_VECTOR(gravity, acceleration, "m/s2", DEM_SETTING_REQUIRED, -INFINITY, INFINITY,
                     "(0 0 -9.81) on Earth with z up"),
    {0},
};

DEM_KERNEL
static void apply_to_bodies(const void *of, struct dem_body_batch *restrict b)
{
    const struct gravity *gravity = of;
    const double gx = gravity->acceleration[0], gy = gravity->acceleration[1],
                   gz = gravity->acceleration[2];

    for (int c = 0; c < b->n; c++)
    {
        b->fx[c] += b->mass[c]*gx;
        b->fy[c] += b->mass[c]*gy;
        b->fz[c] += b->mass[c]*gz;
    }
}

static void uniform_acceleration(const void *of, double g[3])
{
    const struct gravity *gravity = of;

    for (int k = 0; k < 3; k++)
    {
        g[k] = gravity->acceleration[k];
    }
}

const struct dem_effect dem_gravity = {
    .name = "gravity",
    .summary = "weight, m g",
    .source = "Newton 1687",
    .stage = DEM_STAGE_BODY,
    .parcels = DEM_PARCELS_SAME,
    .example = "acceleration (0 0 -9.81);",
    .size = sizeof(struct gravity),
    .settings = settings,
    .apply_to_bodies = apply_to_bodies,
    .uniform_acceleration = uniform_acceleration,
};
