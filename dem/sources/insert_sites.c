/*
 * insert_sites.c -- sites of a lattice with jitter, and ids of a group.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/random.h"
#include <math.h>

enum
{
    USE_JITTER = 101  /* stream of random numbers */
};

void dem_insert_group_site(const struct dem_insert_group *b, int64_t m, double x[3])
{
    const int64_t *const n = b->sites, at[3] = {m%n[0], m/n[0]%n[1], m/(n[0]*n[1])};
    const struct dem_insertion_shape *const v = &b->shape;

    for (int k = 0; k < 3; k++)
    {
        const double wide = (v->max[k] - v->min[k])/(double)n[k];
        const double pitch = k == 2 && wide > b->pitch ? b->pitch : wide;
        const double jitter =
            dem_random_unit((uint64_t)b->seed, (uint64_t)m, 0, USE_JITTER + (uint64_t)k) - 0.5;

        x[k] = v->min[k] + ((double)at[k] + 0.5)*pitch
             + fmin(b->amplitude, wide - b->diameter)*jitter;
    }
}

int64_t dem_insert_group_next_id(const struct dem_insert_group *b, int64_t first)
{
    int64_t next = first + (b->ids ? 0 : b->count*dem_clump_source_ids(&b->clump));

    for (int64_t m = 0; b->ids && m < b->count; m++)
    {
        next = b->ids[m] >= next ? b->ids[m] + 1 : next;
    }
    return next;
}
