/*
 * losses.c -- a list that grows by one loss at a time, and its union over the ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/losses.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void dem_losses_free(struct dem_losses *l)
{
    dem_memory_free(l->loss);
    dem_memory_free(l->all);
    dem_memory_free(l->pass);
    memset(l, 0, sizeof *l);
}

int dem_losses_note(struct dem_losses *l, const struct dem_particle *p, double time, int removed, const char *cause)
{
    DEM_TRY(DEM_GROW(l->loss, l->room, l->n + 1));
    struct dem_loss *const new = &l->loss[l->n++];

    *new = (struct dem_loss){.id = p->id, .time = time, .diameter = 2.0*p->radius, .removed = removed};
    memcpy(new->position, p->x, sizeof new->position);
    memcpy(new->velocity, p->v, sizeof new->velocity);
    snprintf(new->cause, sizeof new->cause, "%s", cause);
    return DEM_OK;
}

static int by_time_and_id(const void *a, const void *b)
{
    const struct dem_loss *const p = a, *const q = b;
    const int time = (p->time > q->time) - (p->time < q->time), id = (p->id > q->id) - (p->id < q->id);

    return time ? time : id ? id : strcmp(p->cause, q->cause);
}

static int gather(struct dem_losses *l, const struct dem_pieces *q)
{
    int *count, *start;
    MPI_Datatype loss;

    DEM_TRY(DEM_NEW(count, q->ranks));
    DEM_TRY(DEM_NEW(start, q->ranks));
    count[q->rank] = (int)l->n;
    MPI_Allgather(MPI_IN_PLACE, 1, MPI_INT, count, 1, MPI_INT, q->comm);
    for (int k = 1; k < q->ranks; k++)
    {
        start[k] = start[k - 1] + count[k - 1];
    }
    MPI_Type_contiguous((int)sizeof *l->loss, MPI_BYTE, &loss);
    MPI_Type_commit(&loss);
    MPI_Allgatherv(l->loss, (int)l->n, loss, l->all, count, start, loss, q->comm);
    MPI_Type_free(&loss);
    dem_memory_free(count);
    dem_memory_free(start);
    return DEM_OK;
}

int dem_losses_tell(struct dem_losses *l, const struct dem_pieces *q, int64_t *n)
{
    *n = (int64_t)l->n;
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, n, 1, MPI_INT64_T, MPI_SUM, q->comm);
    }
    if (*n == 0)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(*n <= INT_MAX, DEM_ERROR_MPI, "%lld losses are too many for one message; ask more often", (long long)*n);
    DEM_TRY(DEM_GROW(l->all, l->all_room, *n));
    if (q->ranks > 1)
    {
        DEM_TRY(gather(l, q));
    }
    else
    {
        memcpy(l->all, l->loss, l->n*sizeof *l->all);
    }
    l->n = 0;
    dem_sort_by(l->all, (size_t)*n, sizeof *l->all, by_time_and_id);
    return DEM_OK;
}
