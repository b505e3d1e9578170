/*
 * halo_refresh.h -- what travels of a copy in each step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_HALO_REFRESH_H
#define DEM_SPACE_HALO_REFRESH_H

enum
{
    DEM_HALO_WIDTH = 9                                    /* numbers: position, velocity, spin */
};

#endif
