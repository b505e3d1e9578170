/*
 * rolling_viscous.c -- rolling resistance: a torque proportional to the rolling velocity.
 *
 *   M = -A max(F_n, 0) R* w_r
 *
 *   M     moment on i, the opposite on j                           [N m]
 *   A     dissipation time of the material, the only setting       [s]
 *   w_r   relative spin w_i - w_j without its component along n    [1/s]
 *   R*    reduced radius, R_i R_j/(R_i + R_j); R_i at a wall       [m]
 *   F_n   total normal force, repulsion positive                   [N]
 *
 * On a plane this is a coefficient of rolling friction A v/R. A sphere that rolls there slows down
 * as e^(-t/T), T = 7 R/(5 A g), and stops after v T. Nothing holds it at rest.
 *
 * In one step it removes at most all of w_r: A F_n R* is limited to 2/5 m* R*^2/dt (see
 * rollingConstant).
 *
 * Source: Brilliantov and Poeschel, Europhys. Lett. 42 (1998) 511 (a viscoelastic sphere on a
 * plane); type B of Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269. Changed: attraction (F_n
 * < 0) does not count; pairs by w_r and R*.
 * Not here: rest on a slope (see rollingSpring); twisting (see twistingSpring).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/rolling_effect.h"
#include "laws/contact/rolling_viscous.h"
#include "laws/effect.h"
#include "laws/parcels.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_rolling_viscous, time, "s", DEM_SETTING_REQUIRED, 0.0, INFINITY,
              "A: torque over F_n R* and relative spin"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    return dem_parcels_scale(pair, "rollingViscous", "time", 1,
                             &((struct dem_rolling_viscous *)of)->time);
}

#define LAW dem_rolling_viscous
#define SETS DEM_SETS_MOMENT
#define ENERGY
#include "laws/contact_loop.h"

/* In use: A v/(R mu), fraction of the largest moment of friction on a sphere that rolls at v. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double time = of ? ((const struct dem_rolling_viscous *)of)->time : 0.0;

    v->fraction = g->friction > 0.0 ? time*g->speed/(2.0*g->radius*g->friction) : 0.0;
    v->quantity = "of the moment of friction resists rolling (Brilliantov and Poeschel 1998)";
    return of != NULL;
}

const struct dem_effect dem_rolling_viscous = {
    .name = "rollingViscous",
    .summary = "rolling resistance proportional to the rolling velocity, A F_n R* w_r",
    .limitation = "holds nothing at rest: heaps flow out slowly; where a heap must rest take "
                  "rollingSpring",
    .source = "Brilliantov and Poeschel 1998; Ai, Chen, Rotter, Ooi 2011, type B",
    .stage = DEM_STAGE_MOMENT,
    .parcels = DEM_PARCELS_SETTINGS,
    .needs = DEM_NEEDS_SPIN,
    .example = "time 1e-3;",
    .size = sizeof(struct dem_rolling_viscous),
    .settings = settings,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .mechanism = DEM_MECHANISM_ROLLING,
};
