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
#include <string.h>

void dem_wall_statistics_free(struct dem_wall_statistics *b)
{
    dem_memory_free(b->sum);
    dem_memory_free(b->saved);
    memset(b, 0, sizeof *b);
}

int dem_wall_statistics_begin(struct dem_wall_statistics *b, int walls)
{
    if (!b->sum)
    {
        DEM_TRY(DEM_NEW(b->sum, 6*walls + 1));
        b->walls = walls;
    }
    for (int k = 0; k < 6*walls; k++)
    {
        dem_sum_clear(&b->sum[k]);
    }
    return DEM_OK;
}

/* 0 for a row without force or moment, as most rows near a wall: zeros do not change an exact
   sum. */
static int has_force(const struct dem_contacts *c, uint32_t r)
{
    const double *const f = dem_contacts_wall_force(c, r)->f;
    int any = 0;

    for (uint32_t k = 0; k < 3; k++)
    {
        any |= f[k] != 0.0 || (c->forces.moments && dem_contacts_wall_moment(c, r)->m[k] != 0.0);
    }
    return any;
}

void dem_wall_statistics_sum_forces(const struct dem_state *p, int wall, double factor,
                                    struct dem_sum *sum)
{
    const struct dem_contacts *const c = &p->contacts;

    for (int s = 0; s < c->rows.classes && c->rows.n > 0; s++)
    {
        const uint32_t end =
            c->rows.segment[s].first +
            (p->interaction_table.list[s].pair.with_wall ? c->rows.segment[s].count : 0);

        for (uint32_t r = c->rows.segment[s].first; r < end; r++)
        {
            const struct dem_pair *const q = dem_contacts_pair(c, r);
            const int own_wall = p->walls.facet[dem_pairs_facet(&p->pairs, q->j)].wall;
            const double *const on_particle = dem_contacts_wall_force(c, r)->f;
            const double f[3] = {-factor*on_particle[0], -factor*on_particle[1],
                                 -factor*on_particle[2]};
            struct dem_sum *const to = sum + (wall < 0 ? 6*own_wall : 0);
            double moment[3];

            if (!has_force(c, r))
            {
                continue;
            }
            dem_vec_cross(p->touches.touch[q->j].point, f, moment);
            for (uint32_t k = 0; k < 3 && (wall < 0 || wall == own_wall); k++)
            {
                dem_sum_add(&to[k], f[k]);
                dem_sum_add(&to[3 + k], moment[k]);
                dem_sum_add(&to[3 + k],
                            c->forces.moments ? -factor*dem_contacts_wall_moment(c, r)->m[k] : 0.0);
            }
        }
    }
}

int dem_wall_statistics_save_forces(struct dem_state *p)
{
    struct dem_wall_statistics *const b = p->wall_statistics;

    if (b->sum && !b->saved)
    {
        DEM_TRY(DEM_NEW(b->saved, 6*b->walls + 1));
        for (int k = 0; k < 6*b->walls; k++)
        {
            dem_sum_clear(&b->saved[k]);
        }
        dem_wall_statistics_sum_forces(p, -1, 1.0, b->saved);
    }
    return DEM_OK;
}

void dem_wall_statistics_drop_forces(struct dem_wall_statistics *b)
{
    dem_memory_free(b->saved);
    b->saved = NULL;
}

/* The sum of each rank is rounded once here. This happens only in coupled runs, where the fluid is
   subject to round-off anyway. */
static void add_held(struct dem_wall_statistics *b, double kick)
{
    for (int k = 0; k < 6*b->walls; k++)
    {
        dem_sum_add(&b->sum[k], kick*dem_sum_value(&b->saved[k]));
    }
    dem_wall_statistics_drop_forces(b);
}

void dem_wall_statistics_add_kick(struct dem_state *p, double kick)
{
    if (p->wall_statistics->saved)
    {
        add_held(p->wall_statistics, kick);
    }
    else if (p->wall_statistics->sum)
    {
        dem_wall_statistics_sum_forces(p, -1, kick, p->wall_statistics->sum);
    }
}
