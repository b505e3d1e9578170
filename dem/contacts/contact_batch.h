/*
 * contact_batch.h -- a contact batch: up to 64 contact rows as columns, and the gathered data of
 * their partners.
 *
 * A candidate contact is a pair within the inner skin; it has one contact row, that is one history
 * and one contact force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CONTACTS_CONTACT_BATCH_H
#define DEM_CONTACTS_CONTACT_BATCH_H

#include "laws/batch.h"

struct dem_contact_scalars;

enum
{
    DEM_LANES = 8  /* the number of rows is padded to a multiple of this */
};

struct dem_gathered
{
    /* m    from j (or the nearest point of the wall) to i */
    _Alignas(64) double rx[DEM_BATCH_ROWS], ry[DEM_BATCH_ROWS], rz[DEM_BATCH_ROWS];
    /* m/s  v_i - v_j */
    _Alignas(64) double vx[DEM_BATCH_ROWS], vy[DEM_BATCH_ROWS], vz[DEM_BATCH_ROWS];
    /* m/s  R_i w_i + R_j w_j */
    _Alignas(64) double ax[DEM_BATCH_ROWS], ay[DEM_BATCH_ROWS], az[DEM_BATCH_ROWS];
    /* 1/s  w_i + w_j; 2 w_i at a wall */
    _Alignas(64) double bx[DEM_BATCH_ROWS], by[DEM_BATCH_ROWS], bz[DEM_BATCH_ROWS];
    _Alignas(64) double radii[DEM_BATCH_ROWS];         /* m    R_i + R_j */
    _Alignas(64) double inverse_mass[DEM_BATCH_ROWS];  /* 1/kg summed */
    _Alignas(64) double radius[DEM_BATCH_ROWS], other[DEM_BATCH_ROWS];  /* m    R_i, R_j */
};

/* the columns that effects work on, and what they are computed from */
struct dem_contact_workspace
{
    struct dem_contact_batch batch;
    struct dem_gathered gathered;
    struct dem_contact_scalars *scalars;    /* step/contact_scalars.h, of the batch; NULL: none */
};

#endif
