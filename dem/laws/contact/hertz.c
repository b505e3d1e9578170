/*
 * hertz.c -- normal elastic force of smooth spheres (Hertz).
 *
 *   F_n = k_n d,    k_n = 4/3 E* sqrt(R* d)
 *
 *   d    overlap, R_i + R_j - |r|, positive in contact             [m]
 *   k_n  secant stiffness (the tangent stiffness is 3/2 of it)     [N/m]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   E*   reduced modulus, 1/E* = sum (1 - nu^2)/E                  [Pa]
 *
 * Largest time step: the smaller of
 *
 *   t_c/20,   t_c = 2.8683 (m*^2/(R* E*^2 v))^(1/5)                duration of an elastic impact
 *   T_R/5,    T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766)          Rayleigh time (impact_speed.h)
 *
 *   m*   reduced mass                                              [kg]
 *   v    impact speed, a setting                                   [m/s]
 *   2.8683 = 4 sqrt(pi) Gamma(2/5)/(5 Gamma(9/10)) (15/16)^(2/5)
 *
 * A stiffness may be given in place of 4/3 E*; then the Rayleigh time is not a limit.
 *
 * At t_c/20 an elastic impact keeps its speed within 0.1 %, at three times that within 0.9 %.
 *
 * Source: Hertz, J. reine angew. Math. 92 (1882) 156; duration: Johnson, Contact Mechanics (1985),
 * section 11.4. Eqs. (6), (7), (10), (11) of Kasuga, Discrete element method (in Japanese, 2012)
 * are the same law; changed: d is the positive overlap, because delta of (7) is negative in contact
 * and has no root in (10). Not here: damping (see dry, stokesDamping), friction (see mindlin),
 * plastic contact, adhesion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/contact/hertz.h"
#include "laws/contact/impact_speed.h"

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_hertz, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
                 "fastest impact to be resolved; limits the time step, not the force"),
    DEM_SETTING(dem_hertz, stiffness, "Pa", 0.0, 0.0, INFINITY, 
              "replaces 4/3 E*: F_n = stiffness sqrt(R*) d^(3/2); 0: from the materials"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_hertz *const hertz = of;

    hertz->modulus = hertz->stiffness;
    if (hertz->stiffness == 0.0)
    {
        DEM_TRY(dem_impact_require_modulus("hertz", pair));
        hertz->modulus = 4.0/3.0*pair->reduced_modulus;
    }
    return DEM_OK;
}

/* Pa: E*, or its equivalent where a stiffness is given */
static double modulus_of(const struct dem_hertz *hertz, const struct dem_pair_class *pair)
{
    return hertz->stiffness > 0.0 ? 0.75*hertz->stiffness : pair->reduced_modulus;
}

static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    const struct dem_hertz *const hertz = of;
    const double mass_per_modulus = pair->min_mass/modulus_of(hertz, pair);

    return 2.8682657*
           dem_pow(mass_per_modulus*mass_per_modulus/(pair->min_radius*hertz->impact_speed),
                   0.2);
}

/* *why is valid until the next call in this thread */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    static _Thread_local char text[160];

    const struct dem_hertz *const hertz = of;
    const double contact = contact_time(of, pair);

    const char *material;
    const double wave = dem_impact_rayleigh_limit(pair, &material);

    *why = text;
    if (hertz->stiffness > 0.0 || 0.05*contact <= wave)
    {
        snprintf(text, sizeof text, "1/20 of the Hertz contact time of %s-%s at %g m/s",
                 pair->a->name, pair->b->name, hertz->impact_speed);
        return 0.05*contact;
    }
    snprintf(text, sizeof text, "0.2 of the Rayleigh time of %s", material);
    return wave;
}

#define LAW dem_hertz
#define SETS DEM_SETS_KN | DEM_SETS_FN
#define ENERGY
#include "laws/contact_loop.h"

/* If no normal law is in use: the solid fraction. Spheres collide above 0.1 % (Elghobashi, Appl. Sci.
   Res. 52 (1994) 309). */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    (void)of;
    v->fraction = g->particles > 1.0 ? g->solid_fraction : 0.0;
    v->threshold = 1e-3;
    v->quantity = "of the domain is solid; particles collide above 0.1 % (Elghobashi 1994)";
    return g->exponent == 0.0;
}

const struct dem_effect dem_hertz = {
    .name = "hertz",
    .aliases = "hertzMindlin pairSpringSliderDashpot",
    .summary = "elastic repulsion of smooth spheres, F_n = 4/3 E* sqrt(R*) d^(3/2)",
    .source = "Hertz 1882",
    .stage = DEM_STAGE_NORMAL,
    .parcels = DEM_PARCELS_SAME,
    .exponent = 1.5,
    .size = sizeof(struct dem_hertz),
    .settings = settings,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_REPULSION,
};
