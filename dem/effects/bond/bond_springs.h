/*
 * bond_springs.h -- springs of a bond, rotated into the new frame and incremented.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_BOND_SPRINGS_H
#define DEM_EFFECTS_BOND_SPRINGS_H

#include "effects/batch.h"
#include "effects/rotate.h"

/* history columns of a bond; see `history_names` in bond_linear.c */
enum
{
    /* m  force-free length l; 0: no bond; < 0: broken, see bond_linear.c */
    LENGTH,
    /* m  overlap that is subtracted for the contact laws */
    WORN,
    SHEAR,
    TWIST = SHEAR + 3,
    BEND,
    ASKED = BEND + 3                                      /* 1    1: the scene lists this pair */
};

/* springs of a bond in the new frame, and their velocities */
struct dem_bond_springs
{
    struct dem_history_vector n, slip, turn, u, bend;
    double q, spin, twist, squeezed;
};

/* r: history columns after the last step; row c */
DEM_MATH struct dem_bond_springs dem_bond_springs(const struct dem_contact_batch *b,
                                                  double *const *r, int c)
{
    const struct dem_history_vector n = {b->nx[c], b->ny[c], b->nz[c]},
                                    h = {b->hx[c], b->hy[c], b->hz[c]};
    const struct dem_history_vector s = {b->sx[c], b->sy[c], b->sz[c]},
                                    w = {b->wx[c], b->wy[c], b->wz[c]};
    const double dt = b->dt, q = 0.25*dt*b->normal_spin[c], spin = dem_rotate_dot(h, w);
    const struct dem_history_vector slip = dem_rotate_to_plane(s, h, n);
    const struct dem_history_vector turn =
        dem_rotate_to_plane(dem_rotate_add(w, -spin, h), h, n);
    const struct dem_history_vector slid = {dt*slip.x, dt*slip.y, dt*slip.z},
                                    bent = {dt*turn.x, dt*turn.y, dt*turn.z};

    return (struct dem_bond_springs){
        .n = n,
        .slip = slip,
        .turn = turn,
        .q = q,
        .spin = spin,
        .twist = r[TWIST][c] + dt*spin,
        .u = dem_rotate_history((struct dem_history_vector){r[SHEAR][c], r[SHEAR + 1][c],
                                                            r[SHEAR + 2][c]},
                                slid, h, n, q),
        .bend = dem_rotate_history((struct dem_history_vector){r[BEND][c], r[BEND + 1][c],
                                                               r[BEND + 2][c]},
                                   bent, h, n, q),
        .squeezed = r[LENGTH][c] - b->distance[c]};
}

#endif
