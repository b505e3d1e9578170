/*
 * viscous.c -- normal dashpot of a given coefficient.
 *
 *   F_n = ... - c v_n
 *
 *   v_n  normal relative velocity, negative on approach            [m/s]
 *   c    damping coefficient, a setting                            [kg/s]
 *
 * With hooke an impact on a spring k lasts pi/sqrt(k/m* - c^2/4 m*^2) and has the restitution
 * e = exp(-pi z/sqrt(1 - z^2)), z = c/(2 sqrt(k m*)), at any speed; with hertz e decreases with the
 * speed, because the spring is softer. This holds if the force may be attractive at the end of the
 * contact, which is the default. Clamped, e is larger: see dry.
 *
 * Largest time step: 1/5 of m/c, the time in which the dashpot alone stops the lightest pair. There
 * a step takes 1/5 of the speed and not 1 - exp(-1/5): the decay is 12 % too fast (53 % at three
 * times that). The limit is the smallest one, with hooke, for z > 0.64 only, where e < 0.08.
 *
 * Source: Cundall and Strack, Geotechnique 29 (1979) 47.
 * Not here: a coefficient for a given restitution (see dry).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/restitution_effect.h"
#include "laws/contact/viscous.h"
#include "laws/effect.h"
#include "laws/parcels.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_viscous, coefficient, "kg/s", DEM_SETTING_REQUIRED, 0.0, INFINITY,
              "c: force over normal relative velocity"),
    DEM_SETTING_CHOICE(dem_viscous, attraction, "attraction", DEM_ATTRACTION_ALLOWED, dem_attractions,
                     "as for dry"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    return dem_parcels_scale(pair, "viscous", "coefficient", 2,
                             &((struct dem_viscous *)of)->coefficient);
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const double c = ((const struct dem_viscous *)of)->coefficient;

    *why = "1/5 of mass over coefficient (viscous)";
    return c > 0.0 ? 0.2*pair->min_mass/c : DBL_MAX;
}

#define LAW dem_viscous
#define SETS DEM_SETS_ETA | DEM_SETS_FN | DEM_SETS_ADHESIVE_FORCE
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_viscous = {
    .name = "viscous",
    .summary = "viscous damping with a given coefficient, -c v_n",
    .source = "Cundall and Strack 1979",
    .stage = DEM_STAGE_DAMP,
    .parcels = DEM_PARCELS_SETTINGS,
    .example = "coefficient 1e-4;",
    .size = sizeof(struct dem_viscous),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .apply = apply,
    .energy = energy,
};
