/*
 * friction_heat.c -- heat of friction and damping: what contacts dissipate heats the two partners.
 *
 *   Q_i = Q_j = D/(2 h);    at a wall Q_i = (1 - w) D/h, and the wall receives w D/h
 *
 *   Q    heat rate into a particle                                                [W]
 *   D    dissipated by the contact in the step: the sum of what all its effects count as lost in the
 *        energy balance: damping, friction, rolling, plastic work, jumps of adhesion, films, broken
 *        bonds                                                                    [J]
 *   h    time step                                                                [s]
 *   w    fraction that a wall receives, `wallFraction`                            [1]
 *
 * Half each is the fraction of effusivities sqrt(k rho c) of like materials, by which two bodies of
 * one surface temperature divide the heat (Jaeger). Unlike materials divide it otherwise; in a bed of
 * both, conduction evens that out.
 *
 * The run computes the energy balance in each step, whether it is written or not: contacts take about
 * three times the processor time. The heat of a step belongs to its drift, so mechanical and thermal
 * energy are at the same time.
 *
 * Source: Jaeger, Proc. R. Soc. N. S. W. 76 (1942) 203. Not here: the share of drag, which heats the
 * fluid; a hot spot at the contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/friction_heat.h"
#include "laws/heat/heat.h"

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_friction_heat, wall_fraction, "wallFraction", "1", 0.5, 0.0, 1.0,
                   "of the heat of a contact with a wall, what the wall receives; 0: insulated"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_friction_heat *const s = of;

    s->fraction = pair->with_wall ? 1.0 - s->wall_fraction : 0.5;
    return DEM_OK;
}

#define LAW dem_friction_heat
#define SCALARS 1
#define SETS DEM_SETS_RATE
#include "laws/contact_loop.h"

const struct dem_effect dem_friction_heat = {
    .name = "frictionHeat",
    .aliases = "frictionalHeating dissipationHeat heatGeneration",
    .summary = "heat of friction and damping: what contacts dissipate heats the two partners",
    .source = "energy balance; half each: Jaeger 1942",
    .stage = DEM_STAGE_SCALAR,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_DISSIPATION,
    .scalars = dem_temperature_only,
    .size = sizeof(struct dem_friction_heat),
    .settings = settings,
    .prepare = prepare,
    .apply = apply,
};
