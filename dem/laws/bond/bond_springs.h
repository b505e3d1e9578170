/*
 * bond_springs.h -- springs of a bond, rotated into the new frame and incremented.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/rotate.h"
#include "laws/row.h"

/* history columns of a bond; see `history_names` in bond_linear.c */
enum
{
    /* m  force-free length l; 0: no bond; < 0: broken, see bond_linear.c */
    DEM_BOND_LENGTH,
    /* m  overlap that is subtracted for the contact laws */
    DEM_BOND_WORN,
    DEM_BOND_SHEAR,
    DEM_BOND_TWIST = DEM_BOND_SHEAR + 3,
    DEM_BOND_BEND,
    DEM_BOND_ASKED = DEM_BOND_BEND + 3,    /* 1    1: the scene lists this pair */
    DEM_BOND_HISTORY
};

/* springs of a bond in the new frame, and their velocities */
struct dem_bond_springs
{
    struct dem_history_vector n, slip, turn, u, bend;
    double q, spin, twist, squeezed;
};

/* values: history after the last step */
DEM_MATH struct dem_bond_springs dem_bond_springs(const struct dem_contact_row *r,
                                                  const double *values)
{
    const struct dem_history_vector n = {r->nx, r->ny, r->nz}, h = {r->hx, r->hy, r->hz};
    const struct dem_history_vector s = {r->sx, r->sy, r->sz}, w = {r->wx, r->wy, r->wz};
    const double dt = r->dt, q = 0.25*dt*r->normal_spin, spin = dem_rotate_dot(h, w);
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
        .twist = values[DEM_BOND_TWIST] + dt*spin,
        .u = dem_rotate_history((struct dem_history_vector){values[DEM_BOND_SHEAR],
                                                            values[DEM_BOND_SHEAR + 1],
                                                            values[DEM_BOND_SHEAR + 2]},
                                slid, h, n, q),
        .bend = dem_rotate_history((struct dem_history_vector){values[DEM_BOND_BEND],
                                                               values[DEM_BOND_BEND + 1],
                                                               values[DEM_BOND_BEND + 2]},
                                   bent, h, n, q),
        .squeezed = values[DEM_BOND_LENGTH] - r->distance};
}
