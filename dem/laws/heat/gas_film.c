/*
 * gas_film.c -- heat conduction through the gas between two near or touching spheres.
 *
 *   Q = H (T_j - T_i),    H = k int 2 pi r/max(s(r), s_0) dr    from r_a to r_b
 *   s(r) = l - sqrt(R_i^2 - r^2) - sqrt(R_j^2 - r^2)
 *
 *   Q, H     heat rate into i; conductance                                  [W], [W/K]
 *   k        conductivity of the gas, `conductivity`                        [W/(m K)]
 *   s        gap at the distance r from the line through the centres; l - sqrt(R_i^2 - r^2) at a wall
 *                                                                           [m]
 *   s_0      `minGap`: heat jumps no shorter distance                       [m]
 *   l        distance of the centres, in contact R_i + R_j less the overlap of the real material;
 *            height over a wall                                             [m]
 *   r_a      where the spheres intersect: edge of the contact; 0 apart      [m]
 *   r_b      where the film of the larger sphere, t R thick, meets the surface of the smaller; of a
 *            wall, its plane; at most the radius of the smaller             [m]
 *   t        `thickness`                                                    [1]
 *
 * With m = l - s the sum of the two roots and D = R_i^2 - R_j^2, their product over their sum is
 * (m - D^2/m^3)/4, and r dr is this times ds. So the integral has a closed form in s:
 *
 *   int r/s dr = 1/4 [l ln s - s - D^2 ((ln(s/m)/l + 1/m)/l^2 + 1/(2 l m^2))]
 *   int r dr   = 1/8 [-m^2 - D^2/m^2]
 *
 * and four times the first with D = 0 at a wall. H begins at zero where the film begins to meet the
 * surface, so the rate is continuous.
 *
 * The published s_0 is molecular, 4e-10 m. The temperature jump of a rarefied gas is longer:
 * 4e-7 m for steel in air (four mean free paths over the accommodation); H depends on ln s_0. The
 * spheres must conduct much better than the gas. In contact that is softer than real the overlap is
 * corrected as `area force` of conduction.
 *
 * Source: Rong and Horio, Proc. 2nd Int. Conf. on CFD in the Minerals and Process Industries (1999)
 * 65; film of the larger sphere, walls: Musser, PhD thesis, West Virginia University (2011), as in
 * MFIX. Not here: resistance of the spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/gas_film.h"
#include "laws/heat/heat.h"

/* neighbours of a sphere that the limit of the time step counts on; twice the contacts, as
   conduction adds to it */
static const double max_films = 24.0;

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_gas_film, conductivity, "W/(m K)", DEM_SETTING_REQUIRED, DEM_ABOVE_ZERO,
                INFINITY, "of the gas"),
    DEM_SETTING_AS(dem_gas_film, min_gap, "minGap", "m", 4e-10, DEM_ABOVE_ZERO, INFINITY,
                   "gap at smaller ones: about the temperature jump of the gas, or the roughness"),
    DEM_SETTING(dem_gas_film, thickness, "1", 0.2, DEM_ABOVE_ZERO, 1.0,
                "of the film around a sphere over its radius: the largest gap across which it acts"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_gas_film *const s = of;

    /* a_real = a s^(1/3) under a given force, and a^2 = R* d */
    s->real_overlap = dem_pow(pair->reduced_modulus/dem_heat_real_modulus(pair), 2.0/3.0);
    s->wall = pair->with_wall;
    return DEM_OK;
}

/* The largest radius present has at most this sum, and at least this reduced radius. */
static double reach(const void *of, const struct dem_pair_class *pair)
{
    const double sum = pair->max_radius_sum, ratio = 1.0 - 4.0*pair->min_radius/sum;
    const double largest =
        pair->with_wall ? sum : 0.5*sum*(1.0 + sqrt(ratio > 0.0 ? ratio : 0.0));

    return ((const struct dem_gas_film *)of)->thickness*largest;
}

/* An explicit step is stable up to C/(sum of H); H <= k 2 pi R* (1 + ln(s_b/s_0)) in contact. */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_gas_film *const s = of;
    const double largest_gap = 2.0*s->thickness*pair->max_radius_sum,
                 ratio = largest_gap > s->min_gap ? largest_gap/s->min_gap : 1.0;
    const double conductance =
        DEM_GAS_FILM_TWO_PI*s->conductivity*pair->min_radius*(1.0 + dem_log(ratio));

    *why = "half the heat capacity over the conductance of twelve films (gasFilm)";
    return pair->min_mass*dem_heat_min_capacity(pair)/(max_films*conductance);
}

#define LAW dem_gas_film
#define SCALARS 1
#define SETS DEM_SETS_RATE
#include "laws/contact_loop.h"

const struct dem_effect dem_gas_film = {
    .name = "gasFilm",
    .aliases = "particleFluidParticle pfp conductionGas fluidConduction",
    .summary = "heat through the gas between near or touching spheres",
    .source = "Rong and Horio 1999; Musser 2011",
    .stage = DEM_STAGE_SCALAR,
    .example = "conductivity 0.026;",
    .scalars = dem_temperature_only,
    .size = sizeof(struct dem_gas_film),
    .settings = settings,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .apply = apply,
};
