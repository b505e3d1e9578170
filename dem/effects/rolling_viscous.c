/*
 * rolling_viscous.c -- a contact resists rolling in proportion to its speed.
 *
 *   M = -A max(F_n, 0) R* w_r
 *
 *   M     moment on i, the opposite on j                           [N m]
 *   A     time of the material's dissipation, the only setting     [s]
 *   w_r   relative spin w_i - w_j without its twist about n        [1/s]
 *   R*    reduced radius, R_i R_j/(R_i + R_j); R_i at a wall       [m]
 *   F_n   total normal force, repulsion positive                   [N]
 *
 * On a plane that is a coefficient of rolling friction A v/R. A sphere that rolls there slows as e^(-t/T),
 * T = 7 R/(5 A g), and stops after v T. Nothing holds it at rest.
 *
 * In one step it takes away at most all of w_r: A F_n R* is held below 2/5 m* R*^2/dt (see rollingConstant).
 *
 * Source: Brilliantov and Poeschel, Europhys. Lett. 42 (1998) 511 (a viscoelastic sphere on a plane); type B of Ai, Chen,
 * Rotter, Ooi, Powder Technol. 206 (2011) 269. Changed: pulling (F_n < 0) does not count; pairs by w_r and R*.
 * Not here: rest on a slope (see rollingSpring); twisting (see twistingSpring).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"
#include "effects/rolling.h"

struct rolling_viscous
{
    double time;
};

static const struct dem_field settings[] = {
    DEM_FIELD(rolling_viscous, time, "s", DEM_FIELD_REQUIRED, 0.0, INFINITY, "A: torque per F_n R* and rate of rolling"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    (void)of;
    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "rollingViscous between %s and %s: there is no normal law to roll under; add one to the effects, hertz for "
                "example", pair->a->name, pair->b->name);
    return DEM_OK;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const dem_real time = ((const struct rolling_viscous *)of)->time;
    const dem_real per_step = 0.4/dem_pick(b->dt > 0.0, b->dt, 1.0);

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real hx = b->hx[c], hy = b->hy[c], hz = b->hz[c], R = b->reduced_radius[c];
        const dem_real twist = b->wx[c]*hx + b->wy[c]*hy + b->wz[c]*hz;
        const dem_real asked = dem_pick(b->fn[c] > 0.0, time*R*b->fn[c], 0.0);
        const dem_real most = per_step*b->reduced_mass[c]*R*R;
        const dem_real drag = dem_pick(asked < most, asked, most);    /* N m s */

        b->mx[c] -= drag*(b->wx[c] - twist*hx);
        b->my[c] -= drag*(b->wy[c] - twist*hy);
        b->mz[c] -= drag*(b->wz[c] - twist*hz);
    }
}

/* the moment times the spin that it resists, in the middle of the kick as far as the moment alone changes it */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)memory;
    dem_rolling_energy(b, e);
}

const struct dem_effect dem_rolling_viscous = {
    .name = "rollingViscous",
    .says = "resistance to rolling in proportion to its speed, A F_n R* w_r",
    .source = "Brilliantov and Poeschel 1998; Ai, Chen, Rotter, Ooi 2011, type B",
    .stage = DEM_STAGE_MOMENT,
    .needs = DEM_NEEDS_SPIN,
    .size = sizeof(struct rolling_viscous),
    .settings = settings,
    .prepare = prepare,
    .act = act,
    .energy = energy,
};
