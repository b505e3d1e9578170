/*
 * bond_springs.h -- the springs of slip and turns of a bond, brought into today's frame and loaded.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_BOND_SPRINGS_H
#define DEM_EFFECTS_BOND_SPRINGS_H

#include "effects/block.h"
#include "effects/carry.h"

enum                                                      /* places in what a bond remembers */
{
    LENGTH,                                               /* m    l of a bond that holds; 0: none; below 0: it broke, see bond_linear.c */
    WORN,                                                 /* m    overlap that the laws of contact must not see */
    SHEAR,
    TWIST = SHEAR + 3,
    BEND,
    ASKED = BEND + 3                                      /* 1    1: the scene lists the pair */
};

struct dem_bond_springs                                   /* a bond's springs in today's frame, and how fast they were loaded */
{
    struct dem_carried n, slip, turn, u, bend;
    dem_real q, spin, twist, squeezed;
};

/* `r`: what the bond of row c remembered a step ago */
DEM_MATH struct dem_bond_springs dem_bond_springs(const struct dem_block *b, dem_real *const *r, int c)
{
    const struct dem_carried n = {b->nx[c], b->ny[c], b->nz[c]}, h = {b->hx[c], b->hy[c], b->hz[c]};
    const struct dem_carried s = {b->sx[c], b->sy[c], b->sz[c]}, w = {b->wx[c], b->wy[c], b->wz[c]};
    const struct dem_carried slip = dem_carry_tilted(s, h, n), turn = dem_carry_tilted(dem_carry_plus(w, -dem_carry_inner(h, w), h), h, n);
    const dem_real dt = b->dt, q = 0.25*dt*b->swing[c], spin = dem_carry_inner(h, w);
    const struct dem_carried slid = {dt*slip.x, dt*slip.y, dt*slip.z}, bent = {dt*turn.x, dt*turn.y, dt*turn.z};

    return (struct dem_bond_springs){.n = n, .slip = slip, .turn = turn, .q = q, .spin = spin, .twist = r[TWIST][c] + dt*spin,
                                     .u = dem_carry_on((struct dem_carried){r[SHEAR][c], r[SHEAR + 1][c], r[SHEAR + 2][c]}, slid, h, n, q),
                                     .bend = dem_carry_on((struct dem_carried){r[BEND][c], r[BEND + 1][c], r[BEND + 2][c]}, bent, h, n, q),
                                     .squeezed = r[LENGTH][c] - b->distance[c]};
}

#endif
