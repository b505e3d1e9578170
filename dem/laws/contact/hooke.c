/*
 * hooke.c -- normal elastic force of a linear spring.
 *
 *   F_n = k d
 *
 *   d    overlap                                                   [m]
 *   k    stiffness: given, or such that an impact at the speed v has the largest overlap of Hertz's
 *        law (impact_speed.h)                                      [N/m]
 *   v    impactSpeed                                               [m/s]
 *
 * Derived from v, k depends on E*, R* and m* of each contact. Largest time step: t_c/20,
 * t_c = pi sqrt(m/k), and where k is not given also 1/5 of the Rayleigh time (impact_speed.h).
 *
 * Source: Cundall and Strack, Geotechnique 29 (1979) 47; k: eq. (1) of Open DEM Japan,
 * Hooke/Hysteresis normal contact model (in Japanese, 2025); with a wall R* = R_i, m* = m_i and E*
 * of both, which that note leaves open.
 * Not here: damping (see dry, viscous, stokesDamping), friction (see linear, mindlin), plastic contact
 * (see hookeHysteresis).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/contact/hooke.h"
#include "laws/contact/impact_speed.h"
#include "laws/parcels.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_hooke, stiffness, "N/m", 0.0, 0.0, INFINITY,
                "force per overlap; 0: from the materials and impactSpeed"),
    DEM_SETTING_AS(dem_hooke, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
                   "without stiffness: k such that an impact at this speed has the largest overlap "
                   "of hertz"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_hooke *hooke = of;

    DEM_TRY(dem_parcels_scale(pair, "hooke", "stiffness", 1, &hooke->stiffness));
    hooke->spring =
        (struct dem_impact_spring){.stiffness = hooke->stiffness, .speed = hooke->impact_speed};
    return dem_impact_prepare(&hooke->spring, "hooke", pair);
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    return dem_impact_time_limit(&((const struct dem_hooke *)of)->spring, 1.0, pair, why);
}

static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    return dem_impact_contact_time(&((const struct dem_hooke *)of)->spring, 1.0, pair);
}

#define LAW dem_hooke
#define BEFORE(settings, batch) dem_impact_stiffnesses(&(settings)->spring, batch)
#define ROW dem_hooke_force_row
#define SETS DEM_SETS_FN
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_hooke = {
    .name = "hooke",
    .aliases = "lsd LSD linearSpringDashpot springDashpot",
    .summary = "elastic repulsion by a linear spring, F_n = k d",
    .source = "Cundall and Strack 1979",
    .stage = DEM_STAGE_NORMAL,
    .parcels = DEM_PARCELS_SETTINGS,
    .exponent = 1.0,
    .size = sizeof(struct dem_hooke),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .apply = apply,
    .energy = energy,
};
