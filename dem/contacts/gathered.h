/*
 * gathered.h -- what the geometry of contact rows is computed from: columns of a batch on a CPU, one
 * row on a device.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#ifdef __OPENCL_C_VERSION__
#define DEM_GATHERED(column) double column[1]
#else
#include "laws/batch.h"
#define DEM_GATHERED(column) _Alignas(64) double column[DEM_BATCH_ROWS]
#endif

struct dem_gathered
{
    /* m    from j (or the nearest point of the wall) to i */
    DEM_GATHERED(rx);
    DEM_GATHERED(ry);
    DEM_GATHERED(rz);
    /* m/s  v_i - v_j */
    DEM_GATHERED(vx);
    DEM_GATHERED(vy);
    DEM_GATHERED(vz);
    /* m/s  R_i w_i + R_j w_j */
    DEM_GATHERED(ax);
    DEM_GATHERED(ay);
    DEM_GATHERED(az);
    /* 1/s  w_i + w_j; 2 w_i at a wall */
    DEM_GATHERED(bx);
    DEM_GATHERED(by);
    DEM_GATHERED(bz);
    DEM_GATHERED(radii);           /* m    R_i + R_j */
    DEM_GATHERED(inverse_mass);    /* 1/kg summed */
    DEM_GATHERED(radius);          /* m    R_i, R_j */
    DEM_GATHERED(other);
};
