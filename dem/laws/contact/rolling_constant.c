/*
 * rolling_constant.c -- rolling resistance: a torque of constant magnitude.
 *
 *   M = -mu_r R* max(F_n, 0) w_r/|w_r|
 *
 *   M     moment on i, the opposite on j                           [N m]
 *   w_r   relative spin w_i - w_j without its component along n    [1/s]
 *   R*    reduced radius, R_i R_j/(R_i + R_j); R_i at a wall       [m]
 *   F_n   total normal force, repulsion positive                   [N]
 *   mu_r  coefficient of rolling friction, the only setting        [1]
 *
 * A sphere that rolls on a plane is decelerated by 5/7 mu_r g and stops after 7 v^2/(10 mu_r g).
 *
 * Near rest the torque would change its sign in every step. It is limited to 2/5 m* R*^2 |w_r|/dt,
 * which removes at most all of w_r in one step for any pair of sizes: 2/5 m* R*^2 is the inertia of
 * a sphere spinning at a wall, and smaller than for any pair. The torque therefore vanishes at
 * rest and holds nothing there: on a slope below mu_r a sphere creeps at 5/2 g sin(slope) dt, where
 * both balance.
 *
 * Source: type A of Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269; Zhou, Wright, Yang, Xu,
 * Yu, Physica A 269 (1999) 536. Changed: vanishes at rest; attraction (F_n < 0) does not count.
 * Not here: rest on a slope (see rollingSpring); twisting (see twistingSpring).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/rolling_constant.h"
#include "laws/contact/rolling_effect.h"
#include "laws/effect.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_rolling_constant, friction, "1", DEM_SETTING_REQUIRED, 0.0, 10.0,
              "mu_r: torque over R* F_n"),
    {0},
};

#define LAW dem_rolling_constant
#define SETS DEM_SETS_MOMENT
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_rolling_constant = {
    .name = "rollingConstant",
    .aliases = "cdt",
    .summary = "rolling resistance: a constant torque mu_r R* F_n, zero at rest",
    .limitation = "holds nothing at rest: on a slope a sphere creeps at 5/2 g sin(slope) dt; where a "
                  "heap must rest take rollingSpring",
    .source = "Ai, Chen, Rotter, Ooi 2011, type A; Zhou, Wright, Yang, Xu, Yu 1999",
    .stage = DEM_STAGE_MOMENT,
    .parcels = DEM_PARCELS_SAME,
    .needs = DEM_NEEDS_SPIN,
    .example = "friction 0.1;",
    .size = sizeof(struct dem_rolling_constant),
    .settings = settings,
    .apply = apply,
    .energy = energy,
    .relevance = dem_rolling_relevance,
    .mechanism = DEM_MECHANISM_ROLLING,
};
