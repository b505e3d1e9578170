/*
 * radiation.c -- thermal radiation between near spheres, and from walls of given temperature.
 *
 *   Q = sigma (T_j^4 - T_i^4)/(s_i/A_i + 1/(A_i F_ij) + s_j/A_j),    s = (1 - e)/e
 *   A_i F_ij = 4 pi R_i^2 R_j^2/(l^2 (1 + sqrt(1 - R_i^2/l^2)) (1 + sqrt(1 - R_j^2/l^2)))
 *
 *   Q, sigma   heat rate into i; 5.670374419e-8, of Stefan and Boltzmann    [W], [W/(m2 K4)]
 *   A, R, e    surface 4 pi R^2, radius; `emissivity` of the material       [m2], [m], [1]
 *   F_ij       view factor, to spheres nearer than l = `reach` (R_i + R_j)  [1]
 *   l          distance of the centres                                      [m]
 *   wall       F = (1 - h/L)/2: the part of the plane within L = 2 `reach` R of the centre, which is at
 *              the height h; s_j/A_j = 0
 *
 * The sum over the neighbours is an exchange between a particle and the mean of T^4 around it, weighted by view
 * factors: the local mean of Zhou, Yu and Zulli, within their distance, in a form in which what one
 * sphere loses another one receives. Farther spheres are shadowed; a bed sees 0.6 to 0.8 of its
 * surroundings so. The view factor is exact for one small sphere and 5 % low for two equal ones that
 * touch, 1 % at l = 1.5 (R_i + R_j). For unlike materials s is their mean, which is exact for equal
 * radii and small beside 1/F.
 *
 * The limit of the time step counts on particles of at most `maxTemperature`.
 *
 * Source: Zhou, Yu, Zulli, AIChE J. 55 (2009) 868; grey pair: Cheng, Yu, Ind. Eng. Chem. Res. 52 (2013)
 * 12202. Not here: shadows, gas that radiates, surroundings beyond the reach.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/heat/heat.h"
#include "laws/heat/radiation.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_radiation, reach, "1", 1.5, 1.0, 10.0,
                "largest distance of the centres over the sum of the radii"),
    DEM_SETTING_AS(dem_radiation, max_temperature, "maxTemperature", "K", 2000.0, DEM_ABOVE_ZERO,
                   1e5, "of the particles; for the limit of the time step only"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_radiation *const s = of;
    const struct dem_material *const lacks = pair->a->thermal.emissivity > 0.0 ? pair->b : pair->a;
    const double a = pair->a->thermal.emissivity, b = pair->b->thermal.emissivity;

    DEM_REQUIRE(lacks->thermal.emissivity > 0.0, DEM_ERROR_INPUT,
                "radiation between %s and %s: materials/%s has no emissivity; give it, 0 to 1",
                pair->a->name, pair->b->name, lacks->name);
    s->wall = pair->with_wall;
    s->resistance[0] = pair->with_wall ? (1.0 - a)/a : 0.5*((1.0 - a)/a + (1.0 - b)/b);
    s->resistance[1] = pair->with_wall ? 0.0 : s->resistance[0];
    return DEM_OK;
}

static double reach(const void *of, const struct dem_pair_class *pair)
{
    const double times = ((const struct dem_radiation *)of)->reach;

    return (pair->with_wall ? 2.0*times - 1.0 : times - 1.0)*pair->max_radius_sum;
}

/* An explicit step is stable up to C/(4 sigma T^3 A); half of that, as other heat adds to it. */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const double T = ((const struct dem_radiation *)of)->max_temperature;
    const double R = pair->with_wall ? pair->min_radius : 2.0*pair->min_radius;

    *why = "half the heat capacity over the radiation at maxTemperature (radiation)";
    return 0.5*pair->min_mass*dem_heat_min_capacity(pair)/
           (4.0*DEM_RADIATION_SIGMA*T*T*T*DEM_RADIATION_FOUR_PI*R*R);
}

#define LAW dem_radiation
#define SCALARS 1
#define SETS DEM_SETS_RATE
#include "laws/contact_loop.h"

const struct dem_effect dem_radiation = {
    .name = "radiation",
    .aliases = "heat/radiation thermalRadiation",
    .summary = "thermal radiation between near spheres and from walls: the local mean of T^4",
    .source = "Zhou, Yu, Zulli 2009; Cheng, Yu 2013",
    .stage = DEM_STAGE_SCALAR,
    .scalars = dem_temperature_only,
    .size = sizeof(struct dem_radiation),
    .settings = settings,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .apply = apply,
};
