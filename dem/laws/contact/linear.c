/*
 * linear.c -- friction: a linear tangential spring that slips at mu F_n.
 *
 *   F_t = -k_t xi - eta_t s,    |F_t| <= mu max(F_n, 0)
 *
 *   xi     elongation of the spring, in the contact plane (history) [m]
 *   s      slip velocity of i over j at the contact point           [m/s]
 *   k_t    tangential stiffness: given, or a fraction of the secant stiffness k_n of the normal law
 *                                                                   [N/m]
 *   eta_t  the damping coefficient of the normal law, or 0          [kg/s]
 *   mu     coefficient of friction                                  [1]
 *   F_n    total normal force, repulsion positive                   [N]
 *
 * Rotation of the spring with the pair and the slip rule (along spring and dashpot together) are in
 * slider.h. Two spheres that stick during a whole impact on linear springs return
 * -cos(pi sqrt(7 k_t/2 k_n)) of their tangential velocity: zero for k_t/k_n = 1/14, all of it
 * (reversed) for 2/7, where both springs have the same period; 2/7 is the default.
 *
 * Largest time step for a given k_t: 1/20 of half a period, pi sqrt(2 m/(7 k_t))/20, at which the
 * oscillation of a sphere that sticks is 0.10 % too fast (0.95 % at three times that). A ratio has
 * no limit of its own: at the limit of hooke the error is 0.10 % for 2/7, and 0.73 % for the largest, 2.
 *
 * Source: Cundall and Strack, Geotechnique 29 (1979) 47; friction: Coulomb; eqs. (15) to (17) and
 * (20) to (23) of Kasuga, Discrete element method (in Japanese, 2012). Changed from the note: as in
 * mindlin.c, for the reasons given there.
 * Not here: a stiffness derived from materials (see mindlin); rolling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/friction_effect.h"
#include "laws/contact/linear.h"
#include "laws/parcels.h"

static const struct dem_setting settings[] = {
    DEM_FRICTION_SETTING(dem_linear),
    DEM_SETTING(dem_linear, stiffness, "N/m", 0.0, 0.0, INFINITY,
              "k_t; 0: ratio times k_n of the normal law"),
    DEM_SETTING(dem_linear, ratio, "1", 2.0/7.0, 0.0, 2.0,
              "without stiffness: k_t over k_n of the normal law"),
    DEM_FRICTION_SWITCHES(dem_linear),
    {0},
};

static const char *const history_names[] = {"slip_x", "slip_y", "slip_z", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_linear *linear = of;

    DEM_TRY(dem_parcels_scale(pair, "linear", "stiffness", 1, &linear->stiffness));
    linear->ratio = linear->stiffness > 0.0 ? 0.0 : linear->ratio;
    return DEM_OK;
}

/* the tangential oscillation of a sphere in contact has the frequency sqrt(7/2 k_t/m) */
static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const double stiffness = ((const struct dem_linear *)of)->stiffness;

    *why = "1/20 of half a period of the tangential spring (linear)";
    return stiffness > 0.0 ? 0.05*3.14159265358979324*sqrt(pair->min_mass/(3.5*stiffness))
                           : DBL_MAX;
}

#define LAW dem_linear
#define COLUMNS dem_linear_columns
#define SETS DEM_SETS_KT | DEM_SETS_FORCE
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_linear = {
    .name = "linear",
    .aliases = "linear_history linearHistory",
    .summary = "friction: a linear spring in the contact plane that slips at mu F_n",
    .source = "Cundall and Strack 1979; Coulomb",
    .stage = DEM_STAGE_TANGENT,
    .parcels = DEM_PARCELS_SETTINGS,
    .needs = DEM_NEEDS_NORMAL_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_linear),
    .settings = settings,
    .history = history_names,
    .clears_history = 1,
    .prepare = prepare,
    .time_limit = time_limit,
    .apply = apply,
    .energy = energy,
};
