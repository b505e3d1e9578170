/*
 * balance.c -- counting work, and what it costs that ranks have unequal shares.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/balance.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    /* in a bed of 100 000 at rest on one rank 3.3 rows of a particle take 58 % of the time, all else of it 34 % (profile) */
    PARTICLE = 4,
    ROW = 2                                               /* even: half of it belongs to either partner */
};

/* What a cut costs, in steps. Measured on a bed at rest with 100 000 and 50 000 spheres a rank, processor time: searching planes
   0.2 to 0.5, sending particles and rows to their new owners 3 to 5. Twice that, for the latency of its all-reduces on many ranks. */
static const double price = 10.0;

void dem_balance_free(struct dem_balance *b)
{
    dem_memory_free(b->weight);
    memset(b, 0, sizeof *b);
}

void dem_balance_count(struct dem_balance *b, size_t particles, const struct dem_contacts *c)
{
    b->steps++;
    b->work += PARTICLE*(int64_t)particles;
    for (int s = 0; s < c->classes; s++)
    {
        b->work += ROW*(int64_t)c->segment[s].count;
    }
}

int dem_balance_pays(struct dem_balance *b, const struct dem_pieces *p)
{
    int64_t most = b->work, sum = b->work;

    if (p->ranks == 1 || b->steps == 0)
    {
        return 0;
    }
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, p->comm);
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_INT64_T, MPI_SUM, p->comm);
    const double mean = (double)sum/p->ranks, excess = mean > 0.0 ? (double)most/mean - 1.0 : 0.0;

    b->base = b->fresh ? excess : b->base;
    b->lost = fmax(0.0, b->lost + (excess - b->base)*(double)b->steps);
    b->fresh = 0;
    b->work = b->steps = 0;
    if (b->lost <= price)
    {
        return 0;
    }
    b->lost = 0.0;
    b->fresh = 1;
    b->cuts++;
    return 1;
}

int dem_balance_weigh(struct dem_balance *b, const struct dem_particles *p, const struct dem_contacts *c)
{
    DEM_TRY(DEM_GROW(b->weight, b->weight_room, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        b->weight[i] = PARTICLE + ROW/2*(c->near_start[i + 1] - c->near_start[i]);
    }
    return DEM_OK;
}

void dem_balance_keep(struct dem_balance *b, const uint32_t *order, size_t count)
{
    for (size_t k = 0; k < count; k++)
    {
        b->weight[k] = b->weight[order[k]];
    }
}
