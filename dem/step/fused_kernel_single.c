/*
 * fused_kernel_single.c -- evaluate the fused kernel in single precision, on a contact batch of its
 * own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>

#define DEM_REAL float

typedef uint32_t dem_mask;

#include "step/fused_laws.h"
#include "step/vec4.h"

static void widen_column(const float *from, int n, double *to)
{
    for (int c = 0; c < n; c++)
    {
        to[c] = from[c];
    }
}

DEM_KERNEL
static void store(const struct dem_contact_batch *restrict b,
                  struct dem_contact_force_single *restrict to)
{
    const dem_vec4_single half = {0.5F, 0.5F, 0.5F, 0.5F}, none = {0.0F, 0.0F, 0.0F, 0.0F};

    for (int c = 0; c < b->n; c += 4)
    {
        dem_vec4_single f[4] = {DEM_VEC4_SINGLE(b->fx + c), DEM_VEC4_SINGLE(b->fy + c),
                                DEM_VEC4_SINGLE(b->fz + c), half*DEM_VEC4_SINGLE(b->overlap + c)};
        dem_vec4_single t[4] = {DEM_VEC4_SINGLE(b->mx + c), DEM_VEC4_SINGLE(b->my + c),
                                DEM_VEC4_SINGLE(b->mz + c), none};

        dem_transpose4_single(f);
        dem_transpose4_single(t);
        for (int k = 0; k < 4; k++)
        {
            DEM_VEC4_SINGLE_AT(to[c + k].f) = f[k];
            DEM_VEC4_SINGLE_AT(to[c + k].t) = t[k];
        }
    }
}

int dem_fused_kernel_run_single(const struct dem_fused_constants *l,
                                const struct dem_fused_columns *rows, const struct dem_gathered *g,
                                double *const *history, struct dem_contact_force_single *to)
{
    struct dem_contact_batch b;

    b.n = rows->n;
    b.dt = (float)rows->dt;
    const int check = evaluate(l, &b, g, rows->dt, history);

    store(&b, to);
    if (check)
    {
        widen_column(b.min_radius, b.n, rows->min_radius);
        widen_column(b.overlap, b.n, rows->overlap);
        widen_column(b.fn, b.n, rows->fn);
        widen_column(b.fx, b.n, rows->fx);
        widen_column(b.fy, b.n, rows->fy);
        widen_column(b.fz, b.n, rows->fz);
    }
    return check;
}
