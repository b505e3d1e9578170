/*
 * row.h -- one row of the tray of contacts, in registers: what block.h has in columns, by the same names.
 *
 * A law that is written for a row serves two masters: its own effect, block by block, and step/hot_chain.c, where the laws of
 * the commonest chain follow each other in one loop. What a law does not use of a row costs nothing: it is never loaded.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_ROW_H
#define DEM_EFFECTS_ROW_H

#include "effects/block.h"

struct dem_row
{
    dem_real dt;                                          /* s    */

    /* geometry */
    dem_real nx, ny, nz, hx, hy, hz;                      /* 1    */
    dem_real overlap, touching;                           /* m, 1 */
    dem_real reduced_radius, reduced_mass, least_radius;  /* m, kg, m */
    dem_real vn, sx, sy, sz;                              /* m/s  */
    dem_real swing;                                       /* 1/s  */
    dem_real grip;                                        /* N    */

    /* results */
    dem_real kn, kt, eta;                                 /* N/m, N/m, kg/s */
    dem_real fn, fx, fy, fz;                              /* N    */
};

static inline __attribute__((always_inline)) struct dem_row dem_row_at(const struct dem_block *b, int c)
{
    return (struct dem_row){.dt = b->dt, .nx = b->nx[c], .ny = b->ny[c], .nz = b->nz[c], .hx = b->hx[c], .hy = b->hy[c],
                            .hz = b->hz[c], .overlap = b->overlap[c], .touching = b->touching[c],
                            .reduced_radius = b->reduced_radius[c], .reduced_mass = b->reduced_mass[c], .vn = b->vn[c],
                            .sx = b->sx[c], .sy = b->sy[c], .sz = b->sz[c], .swing = b->swing[c], .grip = b->grip[c],
                            .kn = b->kn[c], .kt = b->kt[c], .eta = b->eta[c], .fn = b->fn[c], .fx = b->fx[c],
                            .fy = b->fy[c], .fz = b->fz[c]};
}

#endif
