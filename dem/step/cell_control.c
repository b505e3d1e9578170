/*
 * cell_control.c -- hold stresses of a periodic cell by its rates.
 *
 *   D = 2 (target - stress + H)/(L sqrt(rho M))      at most maxRate
 *   dH/dt = error/tau,   tau = 4 L sqrt(rho/M)       once the error is below a tenth of the target
 *
 *   M     modulus of the contacts along the axis, sum k l^2 n^4/V, k = 1.5 |f.n|/overlap      [Pa]
 *   rho   mass of the particles over the volume of the cell                                   [kg/m3]
 *
 * L sqrt(rho/M) is the time of sound across the cell, so no gain has to be chosen. H removes the error
 * that a cell has which goes on to deform. Without contacts D = +-maxRate, towards the target. The
 * stress is measured every DEM_CELL_STEPS steps, counted over the whole run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/cell_motion.h"
#include "records/cell_stress.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include <math.h>

static const double gain = 2.0, memory = 4.0, near = 0.1;

int dem_cell_control_due(const struct dem_state *state)
{
    int held = 0;

    for (int k = 0; k < 3; k++)
    {
        held |= state->cell.axis[k].held;
    }
    return held && state->steps%DEM_CELL_STEPS == 0;
}

static void control_axis(struct dem_state *state, const struct dem_cell_measured *m, int k)
{
    struct dem_cell *const c = &state->cell;
    const struct dem_cell_axis *const a = &c->axis[k];
    const double error = a->target - m->stress[k], length = state->domain.length[k];
    const double rho = m->mass/m->volume, dt = DEM_CELL_STEPS*state->dt;

    if (!(m->modulus[k] > 0.0))
    {
        c->integral[k] = 0.0;
        c->rate[k] = copysign(c->max_rate, error);
        return;
    }
    if (fabs(error) < near*fabs(a->target))
    {
        c->integral[k] += error*fmin(dt/(memory*length*sqrt(rho/m->modulus[k])), 1.0);
    }
    const double rate = gain*(error + c->integral[k])/(length*sqrt(rho*m->modulus[k]));

    c->rate[k] = fmax(-c->max_rate, fmin(rate, c->max_rate));
}

int dem_cell_control(struct dem_state *state)
{
    struct dem_cell_measured m;

    dem_cell_measure(state, &m);
    for (int k = 0; k < 3; k++)
    {
        const struct dem_cell_axis *const a = &state->cell.axis[k];

        if (a->held && state->time >= a->start && state->time <= a->end)
        {
            control_axis(state, &m, k);
        }
    }
    return dem_collect_status(&state->decomposition);
}
