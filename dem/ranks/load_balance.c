/*
 * load_balance.c -- counts the work of ranks and the loss by imbalance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/load_balance.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

enum
{
    /* in a settled bed of 100 000 on one rank the 3.3 rows per particle take 58 % of the time, all other work per
       particle 34 % (profile) */
    PARTICLE_WORK = 4,
    ROW_WORK = 2  /* even, because each partner gets half of it */
};

/* Cost of a decomposition, in steps. Measured on a settled bed with 100 000 and 50 000 spheres per
   rank, processor time: search of planes 0.2 to 0.5, migration of particles and contacts 3 to 5.
   Doubled for the latency of the all-reduces on many ranks. */
static const double decomposition_cost = 10.0;

void dem_load_balance_free(struct dem_load_balance *b)
{
    dem_memory_free(b->weight);
    memset(b, 0, sizeof *b);
}

void dem_load_balance_count(struct dem_load_balance *b, size_t particles,
                            const struct dem_contacts *c)
{
    b->steps++;
    b->work += PARTICLE_WORK*(int64_t)particles;
    for (int s = 0; s < c->rows.classes; s++)
    {
        b->work += ROW_WORK*(int64_t)c->rows.segment[s].count;
    }
}

int dem_load_balance_pays(struct dem_load_balance *b, const struct dem_decomposition *p)
{
    int64_t largest = b->work, sum = b->work;

    if (p->ranks == 1 || b->steps == 0)
    {
        return 0;
    }
    dem_collect_max_int64(p, &largest, 1);
    dem_collect_sum_int64(p, &sum, 1);
    const double mean = (double)sum/p->ranks,
                 excess = mean > 0.0 ? (double)largest/mean - 1.0 : 0.0;

    b->base = b->fresh ? excess : b->base;
    b->lost = fmax(0.0, b->lost + (excess - b->base)*(double)b->steps);
    b->fresh = 0;
    b->work = b->steps = 0;
    if (b->lost <= decomposition_cost)
    {
        return 0;
    }
    b->lost = 0.0;
    b->fresh = 1;
    b->cuts++;
    return 1;
}

int dem_load_balance_set_weights(struct dem_load_balance *b, const struct dem_particles *p,
                                 const struct dem_contacts *c)
{
    DEM_TRY(DEM_GROW(b->weight, b->weight_capacity, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        b->weight[i] = PARTICLE_WORK + ROW_WORK/2*(c->rows.start[i + 1] - c->rows.start[i]);
    }
    return DEM_OK;
}

void dem_load_balance_keep_weights(struct dem_load_balance *b, const uint32_t *order, size_t count)
{
    for (size_t k = 0; k < count; k++)
    {
        b->weight[k] = b->weight[order[k]];
    }
}
