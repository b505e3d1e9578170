/*
 * bonds.c -- record bonds that broke, list bonds that are intact.
 *
 * Rows with a bond are recognised by the energies that bonds and films keep per row. The position
 * of a partner follows from the geometry of the row itself, which is the same on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/bonds.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "core/vec.h"
#include "ranks/dem_state.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

void dem_bonds_free(struct dem_bonds *b)
{
    dem_memory_free(b->broken);
    dem_memory_free(b->all);
    dem_memory_free(b->intact);
    memset(b, 0, sizeof *b);
}

/* Ids of both partners; -1 - wall for a wall. */
static void partner_ids(const struct dem_state *state, const struct dem_pair *q, int64_t id[2])
{
    id[0] = state->particles.record[q->i].id;
    id[1] = q->wall ? -1 - state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall
                    : state->particles.record[q->j].id;
}

/* The pair of a row if this rank owns its lower particle, else NULL. */
static const struct dem_pair *owned_pair(const struct dem_state *state, uint32_t row)
{
    const struct dem_contacts *const c = &state->contacts;
    const struct dem_pair *const q =
        c->rows.pair[row] == DEM_ROW_NONE ? NULL : dem_contacts_pair(c, row);

    return q && q->i < state->particles.n ? q : NULL;
}

/* ---- broken bonds ---------------------------------------------------------------------------- */

/* Middle of the bond. Both the centre and the result are wrapped into the box, so that the result
   does not depend on when the particle was last wrapped. */
static void bond_position(const struct dem_state *state, const struct dem_pair *q, const double n[3],
                          double gap, double at[3])
{
    struct dem_particle home = state->particles.record[q->i];

    dem_domain_wrap(&state->domain, &home);
    for (int k = 0; k < 3; k++)
    {
        home.x[k] -= (home.radius + (q->wall ? gap : 0.5*gap))*n[k];
    }
    dem_domain_wrap(&state->domain, &home);
    memcpy(at, home.x, sizeof home.x);
}

int dem_bonds_record(struct dem_state *state, const struct dem_contact_batch *b, uint32_t row, int rows)
{
    struct dem_bonds *const all = state->bonds;

    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q =
            b->broke[c] > 0.0 ? owned_pair(state, row + (uint32_t)c) : NULL;

        if (!q)
        {
            continue;
        }
        DEM_TRY(DEM_GROW(all->broken, all->capacity, all->n + 1));
        struct dem_broken_bond *const new = &all->broken[all->n++];

        *new = (struct dem_broken_bond){.time = state->time,
                                        .energy = b->lost[c],
                                        .cause = (int)b->cause[c]};
        partner_ids(state, q, new->id);
        bond_position(state, q, (double[]){b->nx[c], b->ny[c], b->nz[c]}, b->gap[c], new->position);
    }
    return DEM_OK;
}

static int by_time_and_ids(const void *a, const void *b)
{
    const struct dem_broken_bond *const p = a, *const q = b;

    for (int k = 0; k < 2; k++)
    {
        if (p->time != q->time || p->id[k] != q->id[k])
        {
            return p->time != q->time ? (p->time > q->time) - (p->time < q->time)
                                      : (p->id[k] > q->id[k]) - (p->id[k] < q->id[k]);
        }
    }
    /* two bonds of one pair: one of them across a periodic face */
    return (p->position[0] > q->position[0]) - (p->position[0] < q->position[0]);
}

int dem_bonds_collect(struct dem_bonds *b, const struct dem_decomposition *q, int64_t *n)
{
    const struct dem_collect_items own =
        {"broken bonds since the last output (write bonds more often)", b->broken, b->n,
         sizeof *b->broken};
    void *all = b->all;

    DEM_TRY(dem_collect_records(q, &own, by_time_and_ids, &all, n));
    b->all = all;
    b->n = 0;
    return DEM_OK;
}

/* ---- intact bonds ---------------------------------------------------------------------------- */

/* From j to i. At a wall from its nearest point, also where another facet has taken over the
   contact. */
static void branch(const struct dem_state *state, const struct dem_pair *q, double r[3])
{
    const struct dem_particle *const i = &state->particles.record[q->i];

    if (q->wall)
    {
        const struct dem_wall_touch *const at = &state->touches.touch[q->j];
        double from[3];

        dem_vec_minus(i->x, at->point, from);
        const double height =
            at->distance > DBL_MAX/2.0 ? dem_vec_dot(from, at->normal) : at->distance;

        for (int k = 0; k < 3; k++)
        {
            r[k] = height*at->normal[k];
        }
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        r[k] = i->x[k] - state->particles.record[q->j].x[k] + state->pairs.shift[q->shift][k];
    }
}

int dem_bonds_list(struct dem_state *state, int64_t *n)
{
    const struct dem_contacts *const c = &state->contacts;
    struct dem_bonds *const b = state->bonds;

    *n = 0;
    for (uint32_t row = 0; c->forces.energy && row < c->rows.n; row++)
    {
        const struct dem_pair *const q =
            c->forces.energy[row].bonds > 0.0 ? owned_pair(state, row) : NULL;

        if (!q)
        {
            continue;
        }
        DEM_TRY(DEM_GROW(b->intact, b->intact_capacity, *n + 1));
        struct dem_bond *const new = &b->intact[(*n)++];

        *new = (struct dem_bond){.stored = c->forces.energy[row].stored};
        partner_ids(state, q, new->id);
        branch(state, q, new->branch);
        memcpy(new->position, state->particles.record[q->i].x, sizeof new->position);
        memcpy(new->force, dem_contact_forces_of_row(&c->forces, row)->f, sizeof new->force);
        memcpy(new->moment, dem_contact_moments_of_row(&c->forces, row)->m, sizeof new->moment);
    }
    return DEM_OK;
}
