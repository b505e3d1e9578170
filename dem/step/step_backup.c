/*
 * step_backup.c -- copy the state into the backup.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step_backup.h"
#include "step/cell_motion.h"
#include "device/device_steps.h"
#include "step/clump_batch.h"
#include "particles/domain.h"
#include "ranks/agree.h"
#include "records/energy_balance.h"
#include "records/wall_statistics.h"
#include "records/wall_wear.h"
#include "sources/flows.h"
#include "step/wall_bodies.h"
#include <math.h>
#include <string.h>

/* 1 when a position, a velocity, a spin, a force or a torque is not a number. */
static int has_invalid_number(const struct dem_particles *particles)
{
    const double *const force = dem_column(particles, DEM_COLUMN_FORCE);
    const double *const torque = dem_column(particles, DEM_COLUMN_TORQUE);
    double sum = 0.0;

    for (size_t i = 0; i < particles->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            sum += 0.0*(particles->record[i].x[k] + particles->record[i].v[k] +
                        particles->record[i].w[k] +
                          force[3*i + k] + torque[3*i + k]);
        }
    }
    return isnan(sum);
}

/* The copy's half kick, with its work in the copy of the energy balance. */
static void kick_copy(struct dem_state *state, struct dem_body_sweep half_kick)
{
    struct dem_particles *const copy = &state->backup.particles;
    struct dem_energy_balance *const l = state->energy_balance;

    if (l->open)
    {
        dem_energy_balance_swap(l);
        half_kick.scalars.heat = &l->sum[DEM_ENERGY_BALANCE_HEAT_BODIES];
    }
    if (state->walls.bodies > 0)
    {
        dem_wall_bodies_kick_backup(state, half_kick.kick);
    }
    dem_sweep_bodies(copy, &state->interaction_table.bodies, &half_kick);
    if (state->clumps.n > 0)
    {
        (void)dem_kick_clumps(state, copy, &half_kick);
        dem_clumps_store(&state->clumps, copy);
        /* the lanes are half a kick ahead of the state: take its own again */
        dem_clumps_load(&state->clumps, &state->particles);
    }
    if (l->open)
    {
        dem_energy_balance_swap(l);
    }
    dem_domain_constrain(&state->domain, copy);
}

int dem_step_backup_ahead(struct dem_state *state, int status,
                          const struct dem_body_sweep *half_kick)
{
    struct dem_backup *const backup = &state->backup;
    const int walls = state->walls.walls;
    double invalid = has_invalid_number(&state->particles);

    DEM_TRY(dem_agree_max(state, status, &invalid, 1));
    if (invalid > 0.0)
    {
        return DEM_OK;
    }
    dem_clumps_store(&state->clumps, &state->particles);
    DEM_TRY(state->device ? dem_agree(state, dem_device_save_wall_forces(state)) : DEM_OK);
    DEM_TRY(dem_wall_statistics_backup(state, half_kick ? half_kick->kick : 0.0));
    DEM_TRY(dem_energy_balance_backup(state->energy_balance, walls));
    DEM_TRY(dem_backup_save(backup, &state->particles, &state->contacts, state->pairs.wall_facet));
    if (state->device)
    {
        backup->valid = 0;
        DEM_TRY(dem_agree(state, dem_device_backup(state)));
        backup->valid = 1;
    }
    dem_flows_backup(state->flows);
    dem_wall_wear_backup(state);
    dem_cell_backup(state);
    dem_wall_bodies_backup(&state->walls);
    backup->time = state->time;
    backup->steps = state->steps;
    backup->dt = state->dt;
    backup->window = state->window;
    if (half_kick)
    {
        kick_copy(state, *half_kick);
    }
    return DEM_OK;
}

int dem_step_backup(struct dem_state *state)
{
    return dem_step_backup_ahead(state, DEM_OK, NULL);
}
