/*
 * gather_pairs.c -- records in, columns out, four pairs at a time.
 *
 * The i of the rows follow each other in memory and the j do not: where particles are more than a cache holds most time
 * goes into waiting for them, so they are asked for some rows before they are needed, those of the next block while this one
 * is worked on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/gather_pairs.h"
#include "step/quad.h"
#include <stddef.h>

enum
{
    JUST_J = DEM_NEAR_RECORDS - 1
};

__attribute__((always_inline)) static inline void columns(dem_quad row[4], double *x, double *y, double *z, double *w)
{
    dem_quad_turn(row);
    DEM_QUAD_AT(x) = row[0];
    DEM_QUAD_AT(y) = row[1];
    DEM_QUAD_AT(z) = row[2];
    if (w)
    {
        DEM_QUAD_AT(w) = row[3];
    }
}

/* `spin` and `film`: an effect needs the relative spin, the viscosity. Constants for the compiler. */
__attribute__((always_inline)) static inline void gather(struct dem_tray *restrict t, const struct dem_particle *record,
                                                         const double (*shift)[4], const struct dem_near *restrict near,
                                                         const int spin, const int film)
{
    const dem_quad less = {-1.0, -1.0, -1.0, 1.0};
    struct dem_gathered *const g = &t->g;

    for (int c = 0; c < t->block.n; c += 4)
    {
        const struct dem_near *const soon = near + c + DEM_NEAR_AHEAD;
        dem_quad r[4], v[4], a[4], b[4], w[4];

        for (int k = 0; k < 4; k++)
        {
            const struct dem_particle *const i = &record[near[c + k].i], *const j = &record[near[c + k].j & JUST_J];
            const struct dem_particle *const next = &record[soon[k].j & JUST_J];
            const dem_quad wi = DEM_QUAD(i->w), wj = DEM_QUAD(j->w);
            const dem_quad ri = {i->radius, i->radius, i->radius, i->radius}, rj = {j->radius, j->radius, j->radius, j->radius};

            __builtin_prefetch(next->x);
            __builtin_prefetch(next->w);                                                  /* its second line */
            r[k] = DEM_QUAD(i->x) + less*DEM_QUAD(j->x) + DEM_QUAD(shift[near[c + k].j >> DEM_NEAR_SHIFT]);      /* x_i - x_j + shift, R_i + R_j */
            v[k] = DEM_QUAD(i->v) + less*DEM_QUAD(j->v);                                  /* v_i - v_j, 1/m_i + 1/m_j */
            a[k] = ri*wi + rj*wj;
            b[k] = wi + wj;
            g->radius[c + k] = i->radius;
            g->other[c + k] = j->radius;
            if (spin)
            {
                w[k] = wi - wj;
            }
            if (film)
            {
                t->block.viscosity[c + k] = 0.5*(i->viscosity + j->viscosity);
            }
        }
        columns(r, g->rx + c, g->ry + c, g->rz + c, g->radii + c);
        columns(v, g->vx + c, g->vy + c, g->vz + c, g->inverse_mass + c);
        columns(a, g->ax + c, g->ay + c, g->az + c, NULL);
        columns(b, g->bx + c, g->by + c, g->bz + c, NULL);
        if (spin)
        {
            columns(w, t->block.wx + c, t->block.wy + c, t->block.wz + c, NULL);
        }
    }
}

DEM_KERNEL
static void plain(struct dem_tray *restrict t, const struct dem_particle *record, const double (*shift)[4], const struct dem_near *near)
{
    gather(t, record, shift, near, 0, 0);
}

DEM_KERNEL
static void with_spin_and_film(struct dem_tray *restrict t, const struct dem_particle *record, const double (*shift)[4],
                               const struct dem_near *near)
{
    gather(t, record, shift, near, 1, 1);
}

void dem_gather_pairs(struct dem_tray *t, const struct dem_parts *p, unsigned needs, const struct dem_near *near)
{
    (needs & (DEM_NEEDS_SPIN | DEM_NEEDS_VISCOSITY) ? with_spin_and_film : plain)(t, p->particles.record, p->pairs.shift, near);
}
