/*
 * stokes_damping.c -- normal dashpot in a fluid: restitution by the Stokes number of the impact.
 *
 *   F_n = ... - eta v_n,       eta = alpha(e) sqrt(m* k_n),  v_n in the middle of the kick
 *   ln e = ln e_max - beta/St,  St = m* v/(6 pi mu R*^2)
 *
 *   v      |normal relative velocity| in the first step of the contact, kept until the surfaces
 *          separate (history)                                      [m/s]
 *   mu     viscosity, a setting or the coupled fluid's             [Pa s]
 *   m*     reduced mass, added mass of the fluid included          [kg]
 *   R*     reduced radius                                          [m]
 *   e_max  restitution without fluid                               [1]
 *   beta   35 in Legendre et al.                                   [1]
 *   alpha  depends on e and the exponent of the normal law         [1]   see restitution.h
 *
 * For a sphere and a wall St is the usual rho_p d v/(9 mu).
 *
 * The force is computed in stokes_damping.h. alpha needs L = -ln e = A + beta/St, A = -ln e_max,
 * only as L/sqrt(pi^2 + L^2). With St = S/D, S = m* v, D = 6 pi mu R*^2, it is
 *
 *   alpha = sqrt(2 (p + 1)) T/sqrt(pi^2 S^2 + T^2),   T = A S + beta D
 *
 * which is finite for v = 0, mu = 0, e_max = 0 and e_max = 1: St -> 0 gives critical damping, mu =
 * 0 gives e_max. No logarithm is taken in the loop.
 *
 * Added mass changes St only, not the motion. Each particle counts as m_i + C_M rho_f V_i, with
 * C_M = 1/2 wherever the fluid's density is known (fluidDensity, or the run's density), as in the
 * fit of beta = 35. Where virtualMass acts, m* has it already. With f = 1 + C_M rho_f/rho_p, m*
 * becomes f_a m* at a wall and f_a f_b (rho_a + rho_b)/(f_a rho_a + f_b rho_b) m*
 * in a pair. This is exact at a wall, for two particles of equal density and any sizes, and for two
 * of equal size and any densities; for unequal sizes and densities it lies between f_a and f_b
 * times m*, as the exact value does.
 *
 * The impact speed is kept because with the instantaneous signed velocity in St, as in LIGGGHTS,
 * e = 0.48 at St = 50 comes out as 0.08. That form is an option (speed instantaneous), for
 * comparison only. The dashpot may pull while the contact opens; clamped, a small e is far too
 * large (0.15 instead of 0.001).
 *
 * Source: Legendre, Zenit, Daniel, Guiraud, Chem. Eng. Sci. 61 (2006) 3543; measured: Gondret,
 * Lance, Petit, Phys. Fluids 14 (2002) 643; Joseph, Zenit, Hunt, Rosenwinkel, J. Fluid Mech. 433
 * (2001) 329. Eq. (8) of Open DEM Japan, Hooke/Hysteresis normal contact model (in Japanese, 2025)
 * takes its ln e "by the Stokes number", without a formula. Changed from other implementations: ln
 * e_max - beta/St with St > 0 (a plus sign and a velocity that is negative on approach return too
 * much); the speed is taken at first contact, see above.
 * Not here: lubrication before contact. It cannot be combined with lubrication: e already contains
 * the loss in the film. At St < 50 this law's e is far below measured ones; lubrication is nearer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/film_loss.h"
#include "laws/contact/restitution_effect.h"
#include "laws/contact/stokes_damping.h"
#include "laws/effect.h"
#include "laws/parcels.h"
#include <stdio.h>

static const char *const speeds[] = {"impact", "instantaneous", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_stokes_damping, restitution, "1", DEM_SETTING_REQUIRED, 0.0, 1.0,
                "e_max: restitution without fluid"),
    DEM_SETTING(dem_stokes_damping, beta, "1", 35.0, 0.0, 1e6, "ln e = ln e_max - beta/St"),
    DEM_SETTING(dem_stokes_damping, viscosity, "Pa s", 0.0, 0.0, INFINITY,
                "of the fluid in the gap; 0: of the run's fluid"),
    DEM_SETTING_AS(dem_stokes_damping, added_mass, "addedMass", "1", -1.0, 0.0, 10.0,
                   "C_M: mass m + C_M rho_f V in St; 0: none; not given (-1): 0.5 if rho_f is known, "
                   "as in the fit of beta; with virtualMass its own"),
    DEM_SETTING_AS(dem_stokes_damping, fluid_density, "fluidDensity", "kg/m3", 0.0, 0.0, INFINITY,
                   "rho_f for addedMass; 0: of the run's fluid"),
    DEM_SETTING_CHOICE(
        dem_stokes_damping, speed, "speed", DEM_STOKES_IMPACT, speeds,
        "v in St: of the first contact, or instantaneous as in LIGGGHTS (restitution 0.55 for "
        "0.68 at St = 100)"),
    DEM_SETTING_CHOICE(dem_stokes_damping, attraction, "attraction", DEM_ATTRACTION_ALLOWED, dem_attractions,
                       "as for dry; clamped: restitution 0.54 for 0.48, 0.70 for 0.68"),
    {0},
};

static const char *const history_names[] = {"impact_speed", NULL};

/* C_M of an isolated sphere; Legendre et al. fitted beta with it */
static const double sphere_added_mass = 0.5;

/* 1: C_M in St */
static double coefficient(const struct dem_stokes_damping *stokes, const struct dem_pair_class *pair)
{
    if (stokes->added_mass >= 0.0)
    {
        return stokes->added_mass;
    }
    return stokes->density > 0.0 && !pair->inertia_has_added_mass ? sphere_added_mass : 0.0;
}

/* 1: reduced mass with added mass over that without; the header comment says where it is exact */
static double more_mass(const struct dem_stokes_damping *stokes, const struct dem_pair_class *pair)
{
    const double added = coefficient(stokes, pair)*stokes->density;    /* kg/m3 */
    const double rho_a = pair->a->density, rho_b = pair->b->density;
    const double with_a = rho_a + added, with_b = rho_b + added;

    if (pair->with_wall)
    {
        return with_a/rho_a;
    }
    return with_a/rho_a*(with_b/rho_b)*((rho_a + rho_b)/(with_a + with_b));
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_stokes_damping *stokes = of;

    DEM_REQUIRE(
        stokes->fluid_density == 0.0 || pair->fluid_density == 0.0
            || fabs(stokes->fluid_density - pair->fluid_density) <= 1e-9*pair->fluid_density,
        DEM_ERROR_INPUT,
        "stokesDamping: fluidDensity %g kg/m3, but the fluid of the run has %g kg/m3; remove fluidDensity from stokesDamping",
        stokes->fluid_density, pair->fluid_density);
    /* St of a parcel is l times the grain's */
    DEM_TRY(dem_parcels_scale(pair, "stokesDamping", "beta", 1, &stokes->beta));
    stokes->density = stokes->fluid_density > 0.0 ? stokes->fluid_density : pair->fluid_density;
    DEM_REQUIRE(
        stokes->added_mass <= 0.0 || stokes->density > 0.0, DEM_ERROR_INPUT,
        "stokesDamping: addedMass %g has no effect without fluidDensity, which is %g kg/m3; give the fluid's density, "
        "or addedMass 0",
        stokes->added_mass, stokes->fluid_density);
    stokes->critical = dem_restitution_critical(pair->exponent);
    stokes->loss = dem_restitution_loss(stokes->restitution);
    stokes->more_mass = more_mass(stokes, pair);
    return DEM_OK;
}

#define LAW dem_stokes_damping
#define COLUMNS dem_stokes_damping_columns
#define SETS DEM_SETS_ETA | DEM_SETS_FN | DEM_SETS_ADHESIVE_FORCE
#define ENERGY
#include "laws/contact_loop.h"

static double own_added_mass(const void *of)
{
    return fmax(((const struct dem_stokes_damping *)of)->added_mass, 0.0);
}

static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    (void)of;
    v->missing_setting = g->has_restitution ? NULL : "restitution of an impact without fluid";
    return dem_film_loss(g, v);
}

/* beta was fitted to St with added mass */
static int describe(const void *of, const struct dem_regime *g, char *line, size_t size)
{
    const struct dem_stokes_damping *const stokes = of;

    (void)g;
    snprintf(line, size,
             "stokesDamping counts no added mass, which is in the fit of beta: give "
             "effects/stokesDamping/fluidDensity, or addedMass 0 to do without");
    return stokes->viscosity > 0.0 && stokes->fluid_density == 0.0 && stokes->added_mass < 0.0;
}

const struct dem_effect dem_stokes_damping = {
    .name = "stokesDamping",
    .short_name = "stokes",
    .summary =
        "viscous damping in a fluid: restitution e_max exp(-beta/St), St the impact's Stokes number (short: stokes)",
    .source = "Legendre, Zenit, Daniel, Guiraud 2006",
    .stage = DEM_STAGE_DAMP,
    .parcels = DEM_PARCELS_SETTINGS,
    .needs = DEM_NEEDS_VISCOSITY,
    .example = "restitution 0.9;",
    .size = sizeof(struct dem_stokes_damping),
    .settings = settings,
    .history = history_names,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
    .own_added_mass = own_added_mass,
    .relevance = relevance,
    .describe = describe,
    .mechanism = DEM_MECHANISM_FILM,
};
