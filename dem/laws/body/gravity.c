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
#include "laws/body/gravity.h"
#include "laws/effect.h"

static const struct dem_setting settings[] = {
    DEM_SETTING_VECTOR(dem_gravity, acceleration, "m/s2", DEM_SETTING_REQUIRED, -INFINITY, INFINITY,
                     "(0 0 -9.81) on Earth with z up"),
    {0},
};

#define LAW dem_gravity
#define SETS DEM_SETS_FORCE
#include "laws/body_loop.h"

static void uniform_acceleration(const void *of, double g[3])
{
    const struct dem_gravity *gravity = of;

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
    .size = sizeof(struct dem_gravity),
    .settings = settings,
    .apply_to_bodies = apply_to_bodies,
    .uniform_acceleration = uniform_acceleration,
};
