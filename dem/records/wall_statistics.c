/*
 * wall_statistics.c -- sum forces and torques on walls over the contact rows of the wall classes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/wall_statistics.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "ranks/dem_state.h"
#include "records/energy_balance.h"
#include "walls/wall_surface.h"
#include <string.h>

void dem_wall_statistics_free(struct dem_wall_statistics *b)
{
    dem_memory_free(b->sum);
    dem_memory_free(b->saved);
    dem_memory_free(b->backup);
    dem_memory_free(b->backup_work);
    dem_memory_free(b->work);
    dem_memory_free(b->wear);
    memset(b, 0, sizeof *b);
}

int dem_wall_statistics_begin(struct dem_wall_statistics *b, int walls)
{
    DEM_TRY(b->sum ? DEM_OK : DEM_NEW(b->sum, walls + 1));
    DEM_TRY(b->work ? DEM_OK : DEM_NEW(b->work, walls + 1));
    b->walls = walls;
    for (int k = 0; k < walls; k++)
    {
        dem_binned_sum_clear(&b->sum[k]);
        dem_sum_clear(&b->work[k]);
    }
    return DEM_OK;
}

/* The force of a row on its wall and its moment about the origin, times `factor`. The contact point is
   taken inside the periodic box, so that the moment does not depend on when a particle is wrapped.
   Returns 0 for a row without force, as most rows near a wall. */
static int load_of_row(const struct dem_state *state, uint32_t r, double factor, double load[6])
{
    const double *const on_particle = dem_contacts_wall_force(&state->contacts, r)->f;
    const double *const point = state->touches.touch[dem_contacts_pair(&state->contacts, r)->j].point;
    double at[3];

    if (on_particle[0] == 0.0 && on_particle[1] == 0.0 && on_particle[2] == 0.0)
    {
        return 0;
    }
    for (int k = 0; k < 3; k++)
    {
        load[k] = -factor*on_particle[k];
        at[k] = dem_periodic_place(point[k], state->domain.min[k], state->domain.length[k]);
    }
    dem_vec_cross(at, load, load + 3);
    return 1;
}

/* The moment of a row that does not follow from its force, of rolling or of a bond. */
static void add_moment(const struct dem_state *state, uint32_t r, double factor,
                       struct dem_binned_sum *to)
{
    const double *const m = dem_contacts_wall_moment(&state->contacts, r)->m;

    if (m[0] != 0.0 || m[1] != 0.0 || m[2] != 0.0)
    {
        dem_binned_sum_add(to, (const double[6]){[3] = -factor*m[0], -factor*m[1], -factor*m[2]});
    }
}

static void sum_segment(const struct dem_state *state, const struct dem_segment *segment, int wall,
                        double factor, struct dem_binned_sum *sum)
{
    for (uint32_t r = segment->first; r < segment->first + segment->count; r++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, r);
        const int own_wall = state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall;
        struct dem_binned_sum *const to = sum + (wall < 0 ? own_wall : 0);
        double load[6];

        if (wall >= 0 && wall != own_wall)
        {
            continue;
        }
        if (load_of_row(state, r, factor, load))
        {
            dem_binned_sum_add(to, load);
        }
        if (state->contacts.forces.moments)
        {
            add_moment(state, r, factor, to);
        }
    }
}

void dem_wall_statistics_sum_forces(const struct dem_state *state, int wall, double factor,
                                    struct dem_binned_sum *sum)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;

    for (int s = 0; s < rows->classes && rows->n > 0; s++)
    {
        if (state->interaction_table.list[s].pair.with_wall)
        {
            sum_segment(state, &rows->segment[s], wall, factor, sum);
        }
    }
}

/* Power [W] of a wall on the particle of a row, with the force of the last sweep and the velocity of the
   surface in the last step; ahead = 1: after the drift that follows the sweep. */
static double power_of_row(const struct dem_state *state, uint32_t r, int ahead)
{
    const struct dem_contacts *const c = &state->contacts;
    const struct dem_pair *const q = dem_contacts_pair(c, r);
    const double *const f = dem_contacts_wall_force(c, r)->f;
    const struct dem_wall_touch *const at = &state->touches.touch[q->j];
    const int facet = dem_pairs_facet(&state->pairs, q->j);
    struct dem_wall_surface wall;

    dem_wall_surface_motion(&state->walls, facet, at, ahead, &wall);
    if (dem_wall_surface_follows_mesh(&state->walls, facet))
    {
        dem_wall_surface_add_mesh_motion(&state->walls, &state->pairs.wall_search, q->j,
                                         state->particles.record[q->i].x, at, state->dt, &wall);
    }
    const double turning =
        c->forces.moments ? dem_vec_dot(dem_contacts_wall_moment(c, r)->m, wall.spin) : 0.0;

    return dem_vec_dot(f, wall.velocity) + turning;
}

void dem_wall_statistics_add_work(struct dem_state *state, double span, int ahead)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    struct dem_energy_balance *const balance = state->energy_balance->open ? state->energy_balance : NULL;
    struct dem_sum *const work = state->wall_statistics->sum ? state->wall_statistics->work : NULL;
    const int wanted = (work || balance) && !state->walls.all_flat_static && rows->n > 0;

    for (int s = 0; s < rows->classes && wanted; s++)
    {
        const struct dem_segment *const at = &rows->segment[s];
        const uint32_t end =
            at->first + (state->interaction_table.list[s].pair.with_wall ? at->count : 0);

        for (uint32_t r = at->first; r < end; r++)
        {
            const int facet = dem_pairs_facet(&state->pairs, dem_contacts_pair(&state->contacts, r)->j);
            const double done = span*power_of_row(state, r, ahead);

            if (work && done != 0.0)
            {
                dem_sum_add(&work[state->walls.facet[facet].wall], done);
            }
            if (balance)
            {
                dem_energy_balance_add(&balance->sum[DEM_ENERGY_BALANCE_WALLS], done);
            }
        }
    }
}

int dem_wall_statistics_save_forces(struct dem_state *state)
{
    struct dem_wall_statistics *const b = state->wall_statistics;

    if (b->sum && !b->saved)
    {
        DEM_TRY(DEM_NEW(b->saved, b->walls + 1));
        dem_wall_statistics_sum_forces(state, -1, 1.0, b->saved);
    }
    return DEM_OK;
}

void dem_wall_statistics_drop_forces(struct dem_wall_statistics *b)
{
    dem_memory_free(b->saved);
    b->saved = NULL;
}

/* The sum of each rank is rounded once here. This happens in coupled runs, where the fluid is subject to
   round-off anyway, after edits, and after a return to a backup. */
static void add_held(struct dem_wall_statistics *b, double kick)
{
    for (int w = 0; w < b->walls; w++)
    {
        dem_binned_sum_flush(&b->saved[w]);
        for (int k = 0; k < DEM_BINNED_SUMS; k++)
        {
            dem_sum_add(&b->sum[w].sum[k], kick*dem_sum_value(&b->saved[w].sum[k]));
        }
    }
    dem_wall_statistics_drop_forces(b);
}

void dem_wall_statistics_add_kick(struct dem_state *state, double kick)
{
    if (state->wall_statistics->saved)
    {
        add_held(state->wall_statistics, kick);
    }
    else if (state->wall_statistics->sum)
    {
        dem_wall_statistics_sum_forces(state, -1, kick, state->wall_statistics->sum);
    }
}

/* ---- backup ---------------------------------------------------------------------------------- */

int dem_wall_statistics_backup(struct dem_state *state, double kick)
{
    struct dem_wall_statistics *const b = state->wall_statistics;
    const size_t n = (size_t)b->walls;

    if (!b->sum)
    {
        return DEM_OK;
    }
    DEM_TRY(b->backup ? DEM_OK : DEM_NEW(b->backup, 2*n + 1));
    DEM_TRY(b->backup_work ? DEM_OK : DEM_NEW(b->backup_work, n + 1));
    memcpy(b->backup, b->sum, n*sizeof *b->backup);
    memcpy(b->backup_work, b->work, n*sizeof *b->work);
    if (kick > 0.0)
    {
        dem_wall_statistics_sum_forces(state, -1, -kick, b->backup);
    }
    for (size_t k = 0; k < n; k++)
    {
        dem_binned_sum_clear(&b->backup[n + k]);
    }
    if (b->saved)
    {
        memcpy(b->backup + n, b->saved, n*sizeof *b->saved);
    }
    else
    {
        dem_wall_statistics_sum_forces(state, -1, 1.0, b->backup + n);
    }
    return DEM_OK;
}

int dem_wall_statistics_restore(struct dem_wall_statistics *b)
{
    const size_t n = (size_t)b->walls;

    dem_wall_statistics_drop_forces(b);
    if (b->sum && !b->backup)
    {
        return dem_wall_statistics_begin(b, b->walls);
    }
    if (b->sum)
    {
        DEM_TRY(DEM_NEW(b->saved, n + 1));
        memcpy(b->sum, b->backup, n*sizeof *b->sum);
        memcpy(b->work, b->backup_work, n*sizeof *b->work);
        memcpy(b->saved, b->backup + n, n*sizeof *b->saved);
    }
    return DEM_OK;
}
