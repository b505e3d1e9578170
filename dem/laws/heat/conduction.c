/*
 * conduction.c -- heat conduction through the contact of two spheres.
 *
 *   Q = H (T_j - T_i),    H = 2 k a,    a = c sqrt(R* d)
 *
 *   Q    heat rate into i                                          [W]
 *   H    conductance of the contact                                [W/K]
 *   k    harmonic mean of the conductivities, 2 k_i k_j/(k_i + k_j)    [W/(m K)]
 *   a    radius of the contact, of Hertz                           [m]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   d    overlap                                                   [m]
 *   c    correction of the radius where youngsModulus is softer than realModulus    [1]
 *
 * With s the ratio of E* of the scene to E* of the real materials: `area force`, the default, is
 * c = s^(1/3), so that a contact under a given force has the radius of the real material: exact for
 * Hertz' law at rest. `area impact` is c = s^(1/5), the largest radius in an impact at a given speed
 * (Zhou, Yu, Zulli). `area overlap` is c = 1.
 *
 * Valid for a contact much smaller than the sphere and a medium that conducts much less than it. The
 * wall is a half space of given temperature; without one it is insulated.
 *
 * Source: Batchelor and O'Brien, Proc. R. Soc. Lond. A 355 (1977) 313; correction: Zhou, Yu, Zulli,
 * Powder Technol. 197 (2010) 102. Not here: resistance of rough surfaces and oxide layers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/conduction.h"
#include "laws/heat/heat.h"

enum
{
    AREA_FORCE,
    AREA_IMPACT,
    AREA_OVERLAP
};
static const char *const areas[] = {"force", "impact", "overlap", NULL};

/* overlap over diameter, and contacts of a sphere, that the limit of the time step counts on */
static const double max_overlap = 0.01, max_contacts = 12.0;

static const struct dem_setting settings[] = {
    DEM_SETTING_CHOICE(dem_conduction, area, "area", AREA_FORCE, areas,
                       "with realModulus, contact radius of the real material: under the same "
                       "force, in an impact at the same speed, or uncorrected"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_conduction *const s = of;
    const double soft = pair->reduced_modulus/dem_heat_real_modulus(pair);
    const struct dem_material *const lacks = pair->a->thermal.conductivity > 0.0 ? pair->b : pair->a;

    DEM_REQUIRE(lacks->thermal.conductivity > 0.0, DEM_ERROR_INPUT,
                "conduction between %s and %s: materials/%s has no conductivity; give it in W/(m K)",
                pair->a->name, pair->b->name, lacks->name);
    s->per_radius = 2.0*dem_heat_conductivity(pair)*
                    (s->area == AREA_OVERLAP
                         ? 1.0
                         : dem_pow(soft, s->area == AREA_FORCE ? 1.0/3.0 : 0.2));
    return DEM_OK;
}

/* An explicit step is stable up to C/(sum of H). */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_conduction *const s = of;
    const double diameter = 4.0*pair->min_radius,
                 conductance = s->per_radius*sqrt(pair->min_radius*max_overlap*diameter);

    *why = "heat capacity over the conductance of twelve contacts (conduction)";
    return pair->min_mass*dem_heat_min_capacity(pair)/(max_contacts*conductance);
}

#define LAW dem_conduction
#define SCALARS 1
#define SETS DEM_SETS_RATE
#include "laws/contact_loop.h"

const struct dem_effect dem_conduction = {
    .name = "conduction",
    .aliases = "heat/gran/conduction HeatConduction",
    .summary = "heat through contacts: Q = 2 k a (T_j - T_i)",
    .source = "Batchelor and O'Brien 1977; area: Zhou, Yu, Zulli 2010",
    .stage = DEM_STAGE_SCALAR,
    .parcels = DEM_PARCELS_SAME,
    .scalars = dem_temperature_only,
    .size = sizeof(struct dem_conduction),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .apply = apply,
};
