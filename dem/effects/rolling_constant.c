/*
 * rolling_constant.c -- a contact resists rolling with the same torque at any speed.
 *
 *   M = -mu_r R* max(F_n, 0) w_r/|w_r|
 *
 *   M     moment on i, the opposite on j                           [N m]
 *   w_r   relative spin w_i - w_j without its twist about n        [1/s]
 *   R*    reduced radius, R_i R_j/(R_i + R_j); R_i at a wall       [m]
 *   F_n   total normal force, repulsion positive                   [N]
 *   mu_r  rolling friction, the only setting                       [1]
 *
 * A sphere that rolls over a plane is slowed by 5/7 mu_r g and stops after 7 v^2/(10 mu_r g).
 *
 * Near rest the torque would turn round every step. It is held below 2/5 m* R*^2 |w_r|/dt, which takes away at most all
 * of w_r in one step, whatever the sizes: 2/5 m* R*^2 is the inertia of a sphere that spins at a wall, and less than
 * that of any pair. So it fades to 0 at rest and holds nothing there: on a slope below mu_r a sphere creeps, at the
 * 5/2 g sin(slope) dt that balance it.
 *
 * Source: type A of Ai, Chen, Rotter, Ooi, Powder Technol. 206 (2011) 269; Zhou, Wright, Yang, Xu, Yu, Physica A 269
 * (1999) 536. Changed: fades at rest; pulling (F_n < 0) does not count.
 * Not here: rest on a slope (see rollingSpring); twisting (see twistingSpring).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"
#include "effects/rolling.h"

struct rolling_constant
{
    double friction;
};

static const struct dem_field settings[] = {
    DEM_FIELD(rolling_constant, friction, "1", DEM_FIELD_REQUIRED, 0.0, 10.0, "torque per R* F_n"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    (void)of;
    DEM_REQUIRE(pair->exponent > 0.0, DEM_ERROR_INPUT,
                "rollingConstant between %s and %s: there is no normal law to roll under; add one to the effects, hertz for "
                "example", pair->a->name, pair->b->name);
    return DEM_OK;
}

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const dem_real friction = ((const struct rolling_constant *)of)->friction;
    const dem_real per_step = 0.4/dem_pick(b->dt > 0.0, b->dt, 1.0);

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real hx = b->hx[c], hy = b->hy[c], hz = b->hz[c], R = b->reduced_radius[c];
        const dem_real twist = b->wx[c]*hx + b->wy[c]*hy + b->wz[c]*hz;
        const dem_real wx = b->wx[c] - twist*hx;
        const dem_real wy = b->wy[c] - twist*hy;
        const dem_real wz = b->wz[c] - twist*hz;
        const dem_real size = sqrt(wx*wx + wy*wy + wz*wz);

        /* N m s: torque over rate, of friction and of stopping in this step */
        const dem_real torque = dem_pick(b->fn[c] > 0.0, friction*R*b->fn[c], 0.0);
        const dem_real most = per_step*b->reduced_mass[c]*R*R;
        const dem_real drag = dem_pick(torque < most*size, torque/dem_pick(size > 0.0, size, 1.0), dem_pick(torque > 0.0, most, 0.0));

        b->mx[c] -= drag*wx;
        b->my[c] -= drag*wy;
        b->mz[c] -= drag*wz;
    }
}

/* the moment times the spin that it resists, in the middle of the kick as far as the moment alone changes it */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)memory;
    dem_rolling_energy(b, e);
}

const struct dem_effect dem_rolling_constant = {
    .name = "rollingConstant",
    .says = "resistance to rolling: a constant torque mu_r R* F_n against it, none at rest",
    .source = "Ai, Chen, Rotter, Ooi 2011, type A; Zhou, Wright, Yang, Xu, Yu 1999",
    .stage = DEM_STAGE_MOMENT,
    .needs = DEM_NEEDS_SPIN,
    .size = sizeof(struct rolling_constant),
    .settings = settings,
    .prepare = prepare,
    .act = act,
    .energy = energy,
};
