/*
 * gravity.c -- everything falls alike.
 *
 *   F = m g
 *
 *   m   mass of the particle (not its inertial mass: added mass weighs nothing)    [kg]
 *   g   acceleration                                                               [m/s2]
 *
 * Source: Newton, Principia (1687).
 * Not here: buoyancy, which is part of the full pressure gradient (see pressureGradient).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

struct gravity
{
    double acceleration[3];
};

static const struct dem_field settings[] = {
    DEM_FIELD_VECTOR(gravity, acceleration, "m/s2", DEM_FIELD_REQUIRED, -INFINITY, INFINITY,
                     "(0 0 -9.81) on Earth with z up"),
    {0},
};

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    const struct gravity *gravity = of;
    const dem_real gx = gravity->acceleration[0], gy = gravity->acceleration[1], gz = gravity->acceleration[2];

    for (int c = 0; c < b->n; c++)
    {
        b->fx[c] += b->mass[c]*gx;
        b->fy[c] += b->mass[c]*gy;
        b->fz[c] += b->mass[c]*gz;
    }
}

const struct dem_effect dem_gravity = {
    .name = "gravity",
    .says = "weight, m g",
    .source = "Newton 1687",
    .stage = DEM_STAGE_BODY,
    .size = sizeof(struct gravity),
    .settings = settings,
    .act_on_bodies = act_on_bodies,
};
