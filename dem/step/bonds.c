/*
 * bonds.c -- rows that hold a bond are told apart by their books; where a partner is follows from the row's own geometry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/bonds.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/vec.h"
#include "step/parts.h"
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void dem_bonds_free(struct dem_bonds *b)
{
    dem_memory_free(b->broke);
    dem_memory_free(b->all);
    dem_memory_free(b->hold);
    memset(b, 0, sizeof *b);
}

/* ids of both; -1 - wall for a wall */
static void ids(const struct dem_parts *p, const struct dem_pair *q, int64_t id[2])
{
    id[0] = p->particles.record[q->i].id;
    id[1] = q->wall ? -1 - p->walls.region[p->pairs.wall_region[q->j]].wall : p->particles.record[q->j].id;
}

static const struct dem_pair *own(const struct dem_parts *p, uint32_t row)
{
    const struct dem_contacts *const c = &p->contacts;
    const struct dem_pair *const q = c->row_pair[row] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[row]];

    return q && q->i < p->particles.n ? q : NULL;
}

/* ---- those that broke ---------------------------------------------------------------------------------------- */

/* Where a particle is must not depend on when it was last brought back into the box, nor may the place beside it. */
static void place(const struct dem_parts *p, const struct dem_pair *q, const double n[3], double gap, double at[3])
{
    struct dem_particle home = p->particles.record[q->i];

    dem_domain_wrap(&p->domain, &home);
    for (int k = 0; k < 3; k++)
    {
        home.x[k] -= (home.radius + (q->wall ? gap : 0.5*gap))*n[k];
    }
    dem_domain_wrap(&p->domain, &home);
    memcpy(at, home.x, sizeof home.x);
}

int dem_bonds_note(struct dem_parts *p, const struct dem_block *b, uint32_t row, int rows)
{
    struct dem_bonds *const all = &p->bonds;

    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = b->broke[c] > 0.0 ? own(p, row + (uint32_t)c) : NULL;

        if (!q)
        {
            continue;
        }
        DEM_TRY(DEM_GROW(all->broke, all->room, all->n + 1));
        struct dem_break *const new = &all->broke[all->n++];

        *new = (struct dem_break){.time = p->time, .energy = b->lost[c], .cause = (int)b->cause[c]};
        ids(p, q, new->id);
        place(p, q, (double[]){b->nx[c], b->ny[c], b->nz[c]}, b->gap[c], new->position);
    }
    return DEM_OK;
}

static int by_time_and_ids(const void *a, const void *b)
{
    const struct dem_break *const p = a, *const q = b;

    for (int k = 0; k < 2; k++)
    {
        if (p->time != q->time || p->id[k] != q->id[k])
        {
            return p->time != q->time ? (p->time > q->time) - (p->time < q->time) : (p->id[k] > q->id[k]) - (p->id[k] < q->id[k]);
        }
    }
    return (p->position[0] > q->position[0]) - (p->position[0] < q->position[0]);    /* two bonds of a pair: through a face, too */
}

static int gather(struct dem_bonds *b, const struct dem_pieces *q)
{
    int *count, *start;
    MPI_Datatype one;

    DEM_TRY(DEM_NEW(count, q->ranks));
    DEM_TRY(DEM_NEW(start, q->ranks));
    count[q->rank] = (int)b->n;
    MPI_Allgather(MPI_IN_PLACE, 1, MPI_INT, count, 1, MPI_INT, q->comm);
    for (int k = 1; k < q->ranks; k++)
    {
        start[k] = start[k - 1] + count[k - 1];
    }
    MPI_Type_contiguous((int)sizeof *b->broke, MPI_BYTE, &one);
    MPI_Type_commit(&one);
    MPI_Allgatherv(b->broke, (int)b->n, one, b->all, count, start, one, q->comm);
    MPI_Type_free(&one);
    dem_memory_free(count);
    dem_memory_free(start);
    return DEM_OK;
}

int dem_bonds_tell(struct dem_bonds *b, const struct dem_pieces *q, int64_t *n)
{
    *n = (int64_t)b->n;
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, n, 1, MPI_INT64_T, MPI_SUM, q->comm);
    }
    if (*n == 0)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(*n <= INT_MAX, DEM_ERROR_MPI, "%lld broken bonds are too many for one message; ask more often", (long long)*n);
    DEM_TRY(DEM_GROW(b->all, b->all_room, *n));
    if (q->ranks > 1)
    {
        DEM_TRY(gather(b, q));
    }
    else
    {
        memcpy(b->all, b->broke, b->n*sizeof *b->all);
    }
    b->n = 0;
    dem_sort_by(b->all, (size_t)*n, sizeof *b->all, by_time_and_ids);
    return DEM_OK;
}

/* ---- those that hold ----------------------------------------------------------------------------------------- */

/* From j to i. Of a wall from its nearest point, also where another region has the contact. */
static void branch(const struct dem_parts *p, const struct dem_pair *q, double r[3])
{
    const struct dem_particle *const i = &p->particles.record[q->i];

    if (q->wall)
    {
        const struct dem_wall_touch *const at = &p->touches.touch[q->j];
        double from[3];

        dem_vec_minus(i->x, at->point, from);
        const double height = at->distance > DBL_MAX/2.0 ? dem_vec_dot(from, at->normal) : at->distance;

        for (int k = 0; k < 3; k++)
        {
            r[k] = height*at->normal[k];
        }
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        r[k] = i->x[k] - p->particles.record[q->j].x[k] + p->pairs.shift[q->shift][k];
    }
}

int dem_bonds_list(struct dem_parts *p, int64_t *n)
{
    const struct dem_contacts *const c = &p->contacts;
    struct dem_bonds *const b = &p->bonds;

    *n = 0;
    for (uint32_t row = 0; c->books && row < c->rows; row++)
    {
        const struct dem_pair *const q = c->books[row].bonds > 0.0 ? own(p, row) : NULL;

        if (!q)
        {
            continue;
        }
        DEM_TRY(DEM_GROW(b->hold, b->hold_room, *n + 1));
        struct dem_bond *const new = &b->hold[(*n)++];

        *new = (struct dem_bond){.stored = c->books[row].stored};
        ids(p, q, new->id);
        branch(p, q, new->branch);
        memcpy(new->position, p->particles.record[q->i].x, sizeof new->position);
        const struct dem_push push = dem_contacts_push(c, row);

        memcpy(new->force, push.f, sizeof new->force);
        memcpy(new->moment, c->moment + 3*row, sizeof new->moment);
    }
    return DEM_OK;
}
