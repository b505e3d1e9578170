/*
 * gather_partners.c -- gather particle records into columns, four pairs at a time, transposed in
 * registers.
 *
 * The i of consecutive rows are close together in memory, the j are not. With more particles than a
 * cache holds, most of the time is spent waiting for them. They are therefore prefetched
 * DEM_ROWS_AHEAD rows ahead, for the next batch while this one is worked on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/gather_partners.h"
#include "core/vec4.h"
#include <stddef.h>

__attribute__((always_inline)) static inline void
to_columns(dem_vec4 row[4], double *x, double *y, double *z, double *w)
{
    dem_transpose4(row);
    DEM_VEC4_AT(x) = row[0];
    DEM_VEC4_AT(y) = row[1];
    DEM_VEC4_AT(z) = row[2];
    if (w)
    {
        DEM_VEC4_AT(w) = row[3];
    }
}

/* `spin`: 1 when the relative spin is needed; a compile-time constant at every call. */
__attribute__((always_inline)) static inline void
gather(struct dem_contact_workspace *restrict t, const struct dem_particle *record,
       const double (*shift)[4], const struct dem_row_partners *restrict partners, const int spin)
{
    const dem_vec4 sign = {-1.0, -1.0, -1.0, 1.0};
    struct dem_gathered *const g = &t->gathered;

    for (int c = 0; c < t->batch.n; c += 4)
    {
        const struct dem_row_partners *const ahead = partners + c + DEM_ROWS_AHEAD;
        dem_vec4 r[4], v[4], a[4], b[4], w[4];

        for (int k = 0; k < 4; k++)
        {
            const struct dem_particle *const i = &record[partners[c + k].i],
                                             *const j = &record[partners[c + k].j & DEM_RECORD_OF_J];
            const struct dem_particle *const next = &record[ahead[k].j & DEM_RECORD_OF_J];
            const dem_vec4 wi = DEM_VEC4(i->w), wj = DEM_VEC4(j->w);
            const dem_vec4 ri = {i->radius, i->radius, i->radius, i->radius},
                           rj = {j->radius, j->radius, j->radius, j->radius};

            __builtin_prefetch(next->x);
            __builtin_prefetch(next->w);    /* second cache line */
            /* x_i - x_j + shift, R_i + R_j */
            r[k] = DEM_VEC4(i->x) + sign*DEM_VEC4(j->x) +
                   DEM_VEC4(shift[partners[c + k].j >> DEM_PARTNER_SHIFT]);
            v[k] = DEM_VEC4(i->v) + sign*DEM_VEC4(j->v);    /* v_i - v_j, 1/m_i + 1/m_j */
            a[k] = ri*wi + rj*wj;
            b[k] = wi + wj;
            g->radius[c + k] = i->radius;
            g->other[c + k] = j->radius;
            if (spin)
            {
                w[k] = wi - wj;
            }
        }
        to_columns(r, g->rx + c, g->ry + c, g->rz + c, g->radii + c);
        to_columns(v, g->vx + c, g->vy + c, g->vz + c, g->inverse_mass + c);
        to_columns(a, g->ax + c, g->ay + c, g->az + c, NULL);
        to_columns(b, g->bx + c, g->by + c, g->bz + c, NULL);
        if (spin)
        {
            to_columns(w, t->batch.wx + c, t->batch.wy + c, t->batch.wz + c, NULL);
        }
    }
}

DEM_KERNEL
static void gather_basic(struct dem_contact_workspace *restrict t,
                         const struct dem_particle *record, const double (*shift)[4],
                         const struct dem_row_partners *partners)
{
    gather(t, record, shift, partners, 0);
}

DEM_KERNEL
static void gather_with_spin(struct dem_contact_workspace *restrict t, const struct dem_particle *record,
                       const double (*shift)[4], const struct dem_row_partners *partners)
{
    gather(t, record, shift, partners, 1);
}

/* The mean of both partners. */
static void gather_mean(int n, double *restrict to, const double *restrict value,
                        const struct dem_row_partners *restrict partners)
{
    for (int c = 0; c < n; c++)
    {
        to[c] = 0.5*(value[partners[c].i] + value[partners[c].j & DEM_RECORD_OF_J]);
    }
}

void dem_gather_pairs(struct dem_contact_workspace *t, const struct dem_state *state,
                      unsigned needs, const struct dem_row_partners *partners)
{
    double *to;

    (needs & DEM_NEEDS_SPIN ? gather_with_spin : gather_basic)(t, state->particles.record,
                                                               state->pairs.shift, partners);
    for (int k = 0; k < state->particles.batch.n; k++)
    {
        if ((to = dem_contact_batch_column(&t->batch, &state->particles, k, needs)) != NULL)
        {
            gather_mean(t->batch.n, to, dem_batch_column_values(&state->particles, k), partners);
        }
    }
}
