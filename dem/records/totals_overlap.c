/*
 * totals_overlap.c -- the largest overlap of two particles and of a particle with a wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/totals.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

/* The wall of a contact. */
static int wall_of(const struct dem_state *state, const struct dem_pair *q)
{
    return state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall;
}

/* 1 when a partner has one of these flags. */
static int has_flags(const struct dem_state *state, const struct dem_pair *q, unsigned flags)
{
    return (state->particles.record[q->i].flags & flags)
        || (!q->wall && (state->particles.record[q->j].flags & flags));
}

void dem_totals_max_overlap(struct dem_state *state, unsigned flags, const char *walls, struct dem_overlap *pair,
                            struct dem_overlap *wall)
{
    *pair = *wall = (struct dem_overlap){.fraction = 0.0};
    dem_wall_touches_update(&state->touches, &state->pairs.wall_search, &state->walls, &state->particles);
    for (uint32_t r = 0; r < state->contacts.rows.n; r++)
    {
        const struct dem_pair *const any = state->contacts.rows.pair[r] == DEM_ROW_NONE
                                               ? NULL
                                               : dem_contacts_pair(&state->contacts, r);
        const int counts = any && (!flags || has_flags(state, any, flags))
                        && (!any->wall || !walls || walls[wall_of(state, any)]);
        const struct dem_pair *const q = counts ? any : NULL;
        const struct dem_particle *const a = q ? &state->particles.record[q->i] : NULL;
        struct dem_overlap *const worst = q && q->wall ? wall : pair;
        double overlap = 0.0, radius = 1.0;

        if (q && q->wall)
        {
            overlap = a->radius - state->touches.touch[q->j].distance;
            radius = a->radius;
        }
        else if (q)
        {
            const struct dem_particle *const b = &state->particles.record[q->j];
            const double *const s = state->pairs.shift[q->shift];
            const double d[3] = {a->x[0] - b->x[0] + s[0], a->x[1] - b->x[1] + s[1],
                                 a->x[2] - b->x[2] + s[2]};

            overlap = a->radius + b->radius - dem_vec_norm(d);
            radius = fmin(a->radius, b->radius);
        }
        if (q && 0.5*overlap/radius > worst->fraction)
        {
            worst->fraction = 0.5*overlap/radius;
            worst->id = a->id;
            worst->partner = q->wall ? wall_of(state, q) : state->particles.record[q->j].id;
            memcpy(worst->x, a->x, sizeof a->x);
        }
    }
}

/* Each rank gives its own; returns the largest of all ranks, of equal ones the lowest id. */
static int max_over_ranks(const struct dem_decomposition *q, struct dem_overlap *worst)
{
    const struct dem_collect_items own = {"overlaps", worst, 1, sizeof *worst};
    struct dem_overlap *each;
    void *all;
    size_t n;

    DEM_TRY(dem_collect_gather(q, DEM_OK, &own, &all, &n));
    each = all;
    for (size_t k = 0; k < n; k++)
    {
        if (each[k].fraction > worst->fraction
            || (each[k].fraction >= worst->fraction && each[k].id < worst->id))
        {
            *worst = each[k];
        }
    }
    dem_memory_free(all);
    return DEM_OK;
}

int dem_totals_max_overlap_over_ranks(struct dem_state *state, const char *walls, struct dem_overlap *pair,
                                      struct dem_overlap *wall)
{
    dem_totals_max_overlap(state, 0, walls, pair, wall);
    DEM_TRY(max_over_ranks(&state->decomposition, pair));
    return max_over_ranks(&state->decomposition, wall);
}
