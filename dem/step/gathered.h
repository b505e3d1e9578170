/*
 * gathered.h -- what the geometry of a block is computed from: the partners of its rows, in columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_GATHERED_H
#define DEM_STEP_GATHERED_H

#include "effects/block.h"

enum
{
    DEM_LANES = 8                                         /* rows are padded to this many */
};

struct dem_gathered                                       /* what the geometry of a block is computed from */
{
    _Alignas(64) double rx[DEM_BLOCK], ry[DEM_BLOCK], rz[DEM_BLOCK];          /* m    from j (or the wall's point) to i */
    _Alignas(64) double vx[DEM_BLOCK], vy[DEM_BLOCK], vz[DEM_BLOCK];          /* m/s  v_i - v_j */
    _Alignas(64) double ax[DEM_BLOCK], ay[DEM_BLOCK], az[DEM_BLOCK];          /* m/s  R_i w_i + R_j w_j */
    _Alignas(64) double bx[DEM_BLOCK], by[DEM_BLOCK], bz[DEM_BLOCK];          /* 1/s  w_i + w_j; 2 w_i at a wall */
    _Alignas(64) double radii[DEM_BLOCK];                                     /* m    R_i + R_j */
    _Alignas(64) double inverse_mass[DEM_BLOCK];                              /* 1/kg summed */
    _Alignas(64) double radius[DEM_BLOCK], other[DEM_BLOCK];                  /* m    R_i, R_j */
};

#endif
