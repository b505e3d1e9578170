/*
 * hot_chain_single.c -- the laws of the hot chain in single precision, on a tray of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>

#define DEM_REAL float

typedef uint32_t dem_mask;

#include "step/hot_laws.h"
#include "step/quad.h"

static void put_column(const float *from, int n, double *to)
{
    for (int c = 0; c < n; c++)
    {
        to[c] = from[c];
    }
}

DEM_KERNEL
static void put(const struct dem_block *restrict b, struct dem_push_single *restrict push)
{
    const dem_quad_single half = {0.5F, 0.5F, 0.5F, 0.5F}, none = {0.0F, 0.0F, 0.0F, 0.0F};

    for (int c = 0; c < b->n; c += 4)
    {
        dem_quad_single f[4] = {DEM_QUAD_SINGLE(b->fx + c), DEM_QUAD_SINGLE(b->fy + c), DEM_QUAD_SINGLE(b->fz + c),
                                half*DEM_QUAD_SINGLE(b->overlap + c)};
        dem_quad_single t[4] = {DEM_QUAD_SINGLE(b->mx + c), DEM_QUAD_SINGLE(b->my + c), DEM_QUAD_SINGLE(b->mz + c), none};

        dem_quad_turn_single(f);
        dem_quad_turn_single(t);
        for (int k = 0; k < 4; k++)
        {
            DEM_QUAD_SINGLE_AT(push[c + k].f) = f[k];
            DEM_QUAD_SINGLE_AT(push[c + k].t) = t[k];
        }
    }
}

int dem_hot_chain_act_single(const struct dem_hot_laws *l, const struct dem_hot_rows *rows, const struct dem_gathered *g,
                             double *const *memory, struct dem_push_single *push)
{
    struct dem_block b;

    b.n = rows->n;
    b.dt = (float)rows->dt;
    const int look = act(l, &b, g, rows->dt, memory);

    put(&b, push);
    if (look)
    {
        put_column(b.least_radius, b.n, rows->least_radius);
        put_column(b.overlap, b.n, rows->overlap);
        put_column(b.fn, b.n, rows->fn);
        put_column(b.fx, b.n, rows->fx);
        put_column(b.fy, b.n, rows->fy);
        put_column(b.fz, b.n, rows->fz);
    }
    return look;
}
