/*
 * mindlin.c -- friction: a tangential spring of Mindlin's stiffness that slips at mu F_n.
 *
 *   F_t = -k_t xi - eta_t s,    k_t = 8 G* sqrt(R* d),    |F_t| <= mu max(F_n, 0)
 *
 *   xi     elongation of the spring, in the contact plane (history) [m]
 *   s      slip velocity of i over j at the contact point           [m/s]
 *   k_t    tangential stiffness                                     [N/m]
 *   G*     reduced shear modulus, 1/G* = sum 2 (2 - nu)(1 + nu)/E   [Pa]
 *   R*, d  reduced radius, overlap                                  [m]
 *   eta_t  the damping coefficient of the normal law, or 0          [kg/s]
 *   mu     coefficient of friction                                  [1]
 *   F_n    total normal force, repulsion positive                   [N]
 *   n, h   unit normal from j to i now and half a step ago          [1]
 *
 * Sliding: F_t keeps the direction of spring and dashpot together and gets the length mu max(F_n,
 * 0). How much the spring is relaxed by that, and how it is rotated into the new contact plane, is
 * in slider.h. (With the common choice -(F_t + eta_t s)/k_t the friction impulse of a sliding
 * impact is 3 to 11 % too small; with -F_t/k_t the spring holds more energy than was put in; with
 * mu |F_n| the attractive end of a damped impact adds 7 %.)
 *
 * Source: Mindlin, J. Appl. Mech. 16 (1949) 259 (stiffness without micro-slip), in the secant form
 * of Kasuga, Discrete element method (in Japanese, 2012), eqs. (15) to (23); friction: Coulomb.
 * Changed from Kasuga's note:
 *   (17)       slip is v_t - (R_i w_i + R_j w_j) x n: with n from j to i the contact point of i is
 *              at -R_i n (evaluated by the caller, in the columns s); (22), (23) need the same
 *              sign, torque -R_i n x F_t. The two errors of sign cancel in every velocity; only the
 *              spin has the wrong sign.
 *   (18)       d is the positive overlap; delta of the note is negative in contact and has no root.
 *   (20), (21) friction has the direction of the trial force, not of the slip (which
 *              reverses before the force does, and is 0/0 at rest); an attractive normal force gives
 *              no friction; the spring is relaxed.
 * The secant law returns up to 0.06 % more tangential speed than it took (elastic impact within 3
 * degrees of normal), because k_t decreases with d while xi stays; spinning pairs on linear springs
 * (hooke) gain up to 0.7 % of their energy. Any damping dissipates more than this;
 * mindlinIncremental never gains energy.
 * Not here: partial slip and its loading history; rolling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/friction_effect.h"
#include "laws/contact/mindlin.h"

static const struct dem_setting settings[] = {
    DEM_FRICTION_SETTING(dem_mindlin),
    DEM_FRICTION_SWITCHES(dem_mindlin),
    {0},
};

static const char *const history_names[] = {"shear_x", "shear_y", "shear_z", NULL};

int dem_mindlin_modulus(const char *law, const struct dem_pair_class *pair, double *modulus)
{
    DEM_REQUIRE(
        pair->reduced_shear > 0.0 && pair->reduced_shear <= DBL_MAX, DEM_ERROR_INPUT,
        "%s between %s and %s: the reduced shear modulus is %g Pa, but must be above 0 and finite; "
        "check youngsModulus and poissonsRatio of both",
        law, pair->a->name, pair->b->name, pair->reduced_shear);
    *modulus = 8.0*pair->reduced_shear;
    return DEM_OK;
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    return dem_mindlin_modulus("mindlin", pair, &((struct dem_mindlin *)of)->modulus);
}

#define LAW dem_mindlin
#define COLUMNS dem_mindlin_columns
#define SETS DEM_SETS_KT | DEM_SETS_FORCE
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_mindlin = {
    .name = "mindlin",
    .summary = "friction: a tangential spring of 8 G* sqrt(R* d) that slips at mu F_n",
    .source = "Mindlin 1949; Coulomb",
    .stage = DEM_STAGE_TANGENT,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_NORMAL_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_mindlin),
    .settings = settings,
    .history = history_names,
    .clears_history = 1,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
};
