/*
 * mindlin_incremental.c -- friction as in mindlin.c, with a spring loaded in increments.
 *
 *   F_t = -k_t xi - eta_t s,    k_t = 8 G* sqrt(R* d),    |F_t| <= mu max(F_n, 0)
 *   d(k_t xi) = k_t s dt while d grows,     d xi = s dt while it decreases
 *
 *   xi     elongation of the spring at its present stiffness (history) [m]
 *   k_t    tangential stiffness; its value of the last step is history [N/m]
 *   s      slip velocity of i over j at the contact point           [m/s]
 *   G*     reduced shear modulus, 1/G* = sum 2 (2 - nu)(1 + nu)/E   [Pa]
 *   R*, d  reduced radius, overlap                                  [m]
 *   eta_t  the damping coefficient of the normal law, or 0          [kg/s]
 *   mu     coefficient of friction                                  [1]
 *   F_n    total normal force, repulsion positive                   [N]
 *
 * Loading: new contact area is made without slip and carries no tangential force; the force stays,
 * xi becomes xi k_old/k_t. Unloading: contact area that carried force is lost; the force decreases
 * with k_t, xi stays. In both cases the energy k_t xi^2/2 decreases or stays, so the law never
 * produces energy. mindlin keeps xi in both cases, which returns energy that was never put in where
 * slip precedes normal load: with the set of Kharaz et al. its e_t is 1.0006 near normal incidence,
 * here it is 0.878 (measured 0.79 to 0.67 at 2 to 10 degrees). From 17.5 degrees on both laws
 * agree.
 *
 * Source: Mindlin and Deresiewicz, J. Appl. Mech. 20 (1953) 327, without micro-slip; the correction
 * during unloading: Thornton, Cummins, Cleary, Powder Technol. 233 (2013) 30. All else as in
 * mindlin.c and slider.h.
 * Not here: micro-slip and its loading history; rolling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/friction_effect.h"
#include "laws/contact/mindlin_incremental.h"

static const struct dem_setting settings[] = {
    DEM_FRICTION_SETTING(dem_mindlin_incremental),
    DEM_FRICTION_SWITCHES(dem_mindlin_incremental),
    {0},
};

static const char *const history_names[] = {"stretch_x", "stretch_y", "stretch_z",
                                            "tangential_stiffness", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    return dem_mindlin_modulus("mindlinIncremental", pair,
                               &((struct dem_mindlin_incremental *)of)->modulus);
}

#define LAW dem_mindlin_incremental
#define COLUMNS dem_mindlin_incremental_columns
#define SETS DEM_SETS_KT | DEM_SETS_FORCE
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_mindlin_incremental = {
    .name = "mindlinIncremental",
    .aliases = "mindlin_rescale mindlin/rescale",
    .summary =
        "friction as mindlin, with a spring loaded in increments that never returns more energy than it took",
    .limitation =
        "creeps where the normal force changes in cycles, as in vibration: a fifth of the slip "
        "length a cycle; mindlin does not",
    .source = "Mindlin and Deresiewicz 1953; Thornton, Cummins, Cleary 2013; Coulomb",
    .stage = DEM_STAGE_TANGENT,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_NORMAL_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_mindlin_incremental),
    .settings = settings,
    .history = history_names,
    .clears_history = 1,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
};
