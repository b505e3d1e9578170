/*
 * tray.h -- one block of near rows on its way through the sweep: what was gathered of the partners, and the tray of the effects.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_TRAY_H
#define DEM_STEP_TRAY_H

#include "step/parts.h"

enum
{
    DEM_LANES = 8                                         /* rows are padded to this many */
};

struct dem_gathered                                       /* what the geometry of a block is computed from */
{
    _Alignas(64) double rx[DEM_BLOCK], ry[DEM_BLOCK], rz[DEM_BLOCK];          /* m    from j (or the wall's point) to i */
    _Alignas(64) double vx[DEM_BLOCK], vy[DEM_BLOCK], vz[DEM_BLOCK];          /* m/s  v_i - v_j */
    _Alignas(64) double ax[DEM_BLOCK], ay[DEM_BLOCK], az[DEM_BLOCK];          /* m/s  R_i w_i + R_j w_j */
    _Alignas(64) double bx[DEM_BLOCK], by[DEM_BLOCK], bz[DEM_BLOCK];          /* 1/s  share (w_i + w_j) */
    _Alignas(64) double radii[DEM_BLOCK];                                     /* m    R_i + R_j */
    _Alignas(64) double inverse_mass[DEM_BLOCK];                              /* 1/kg summed */
    _Alignas(64) double product[DEM_BLOCK];                                   /* m2   R_i R_j */
};

struct dem_tray
{
    struct dem_block block;
    struct dem_gathered g;
};

/* Fill the tray with the geometry and the relative motion of `rows` rows of one class, from `row` on, and clear its results. Lanes
   past the last row repeat it. */
void dem_tray_fill(struct dem_tray *, const struct dem_parts *, const struct dem_chain *, uint32_t row, int rows);

/* Only gather, of rows of pairs, for who goes on alone: `g`, `n` and `least_radius` are filled. */
void dem_tray_gather(struct dem_tray *, const struct dem_parts *, const struct dem_chain *, uint32_t row, int rows);

#endif
