/*
 * rolling_spring.c -- rolling resistance: a rotational spring (and dashpot) that slips.
 *
 *   M = -k_r theta - c_r w_r,   |M| <= mu_r R* max(F_n, 0),   k_r = K k_n R*^2
 *   c_r = 2 zeta sqrt(k_r I),   I = 7/5 m* R*^2
 *
 *   M      moment on i, the opposite on j                          [N m]
 *   theta  rolling angle, normal to n (history)                    [rad]
 *   w_r    relative spin w_i - w_j without its component along n   [1/s]
 *   R*     reduced radius, R_i R_j/(R_i + R_j); R_i at a wall      [m]
 *   F_n    total normal force, repulsion positive                  [N]
 *   k_n    secant stiffness, set by the normal law                 [N/m]
 *   K      stiffness, a setting; 0: 6 G* / E*, which makes k_r = k_t R*^2 with
 *          k_t = 8 G* sqrt(R* d) of mindlin                        [1]
 *   m*     reduced mass                                            [kg]
 *   mu_r   coefficient of rolling friction, a setting              [1]
 *   zeta   damping ratio, a setting                                [1]
 *
 * It holds a sphere on a slope up to tan(slope) = mu_r; on a steeper one the sphere rolls with
 * 5/7 g (sin - mu_r cos). Without a dashpot a sphere that came to rest oscillates, with the
 * frequency sqrt(k_r/I) on a plane that it does not slip on.
 *
 * I is the inertia of a sphere that rolls on a plane, for which zeta = 1 is critical; two equal
 * spheres rolling on each other have 8/5 m* R*^2 and are damped by 0.94 zeta. The dashpot is part
 * of the limited moment, as with friction: see slider.h, also for the rotation of theta with the
 * pair.
 *
 * Source: type C of Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269; stiffness: Iwashita and
 * Oda, J. Eng. Mech. 124 (1998) 285. Changed from Ai et al.:
 *   k_r        theirs, 2.25 k_n mu_r^2 R*^2, is the setting 2.25 mu_r^2; the default is from
 *              Iwashita and Oda.
 *   the angle  is the history variable, not the moment: a moment kept while k_n decreases returns
 *              more energy than it took.
 *   3D         theirs is a plane model; here theta is a vector that rotates with the contact.
 *   the limit  holds for spring and dashpot together; attraction (F_n < 0) does not count.
 *   I          theirs, 1/(1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)), is 4 times as large for equal
 *              spheres, and the same at a wall.
 * Not here: twisting about the normal (see twistingSpring); rolling under adhesive attraction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/rolling_effect.h"
#include "laws/contact/rolling_spring.h"
#include "laws/effect.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_rolling_spring, friction, "1", DEM_SETTING_REQUIRED, 0.0, 10.0,
              "mu_r: largest moment over R* F_n; tangent of the largest slope at which a sphere "
              "rests"),
    DEM_SETTING(dem_rolling_spring, stiffness, "1", 0.0, 0.0, 3.0,
              "K: k_r over k_n R*^2; 0: such that k_r = k_t R*^2 with k_t of mindlin. Ai et al.: "
              "2.25 friction^2"),
    DEM_SETTING(dem_rolling_spring, damping, "1", 0.3, 0.0, 1.0,
              "zeta: damping ratio of rolling oscillations on a plane, 1 is critical; with 0 "
              "grains rock for long"),
    {0},
};

static const char *const history_names[] = {"rolling_x", "rolling_y", "rolling_z", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_rolling_spring *rolling = of;

    rolling->ratio = rolling->stiffness > 0.0 ? rolling->stiffness
                                              : 6.0*pair->reduced_shear/pair->reduced_modulus;
    return DEM_OK;
}

#define LAW dem_rolling_spring
#define COLUMNS dem_rolling_spring_columns
#define SETS DEM_SETS_MOMENT
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_rolling_spring = {
    .name = "rollingSpring",
    .aliases = "rolling rollingFriction epsd epsd2",
    .summary =
        "rolling resistance: a rotational spring that slips at mu_r R* F_n, with an optional dashpot",
    .source = "Ai, Chen, Rotter, Ooi 2011, type C; Iwashita and Oda 1998",
    .stage = DEM_STAGE_MOMENT,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_SPIN | DEM_NEEDS_NORMAL_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_rolling_spring),
    .settings = settings,
    .history = history_names,
    .clears_history = 1,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
    .relevance = dem_rolling_relevance,
    .mechanism = DEM_MECHANISM_ROLLING,
};
