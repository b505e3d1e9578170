/*
 * row.h -- one row of the contact batch in registers: the columns of batch.h under the same names.
 *
 * A law written for one row is used twice: by its own effect, batch by batch, and by
 * step/fused_kernel.c, where the usual combinations of laws follow each other in one loop. Members
 * that a law does not use cost nothing: the compiler drops the loads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_ROW_H
#define DEM_EFFECTS_ROW_H

#include "effects/batch.h"

struct dem_contact_row
{
    double dt;                                        /* s    */

    /* geometry */
    double nx, ny, nz, hx, hy, hz;                    /* 1    */
    double overlap, touching;                         /* m, 1 */
    double reduced_radius, reduced_mass, min_radius;  /* m, kg, m */
    double vn, sx, sy, sz;                            /* m/s  */
    double normal_spin;                               /* 1/s  */
    double adhesive_force;                            /* N    */

    /* results */
    double kn, kt, eta;                               /* N/m, N/m, kg/s */
    double fn, fx, fy, fz;                            /* N    */
};

static inline __attribute__((always_inline)) struct dem_contact_row dem_contact_row_load(
    const struct dem_contact_batch *b, int c)
{
    return (struct dem_contact_row){.dt = b->dt,
                                    .nx = b->nx[c],
                                    .ny = b->ny[c],
                                    .nz = b->nz[c],
                                    .hx = b->hx[c],
                                    .hy = b->hy[c],
                                    .hz = b->hz[c],
                                    .overlap = b->overlap[c],
                                    .touching = b->touching[c],
                                    .reduced_radius = b->reduced_radius[c],
                                    .reduced_mass = b->reduced_mass[c],
                                    .vn = b->vn[c],
                                    .sx = b->sx[c],
                                    .sy = b->sy[c],
                                    .sz = b->sz[c],
                                    .normal_spin = b->normal_spin[c],
                                    .adhesive_force = b->adhesive_force[c],
                                    .kn = b->kn[c],
                                    .kt = b->kt[c],
                                    .eta = b->eta[c],
                                    .fn = b->fn[c],
                                    .fx = b->fx[c],
                                    .fy = b->fy[c],
                                    .fz = b->fz[c]};
}

#endif
