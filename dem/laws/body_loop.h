/*
 * body_loop.h -- template: the loop of a body, fluid or heat law over a batch of particles:
 *
 *   #define LAW dem_ergun
 *   #define SETS DEM_SETS_DRAG
 *   #include "laws/body_loop.h"
 *
 * defines apply_to_bodies(settings, batch) from dem_ergun_row(settings, row). SETS: the columns that
 * the row function sets. By choice:
 *
 *   SCALARS  the number of particle scalars; default: none
 *   PREPARES the columns that <LAW>_prepare_row() sets, for prepare_bodies(), which is defined first
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/batch_row.h"

#ifdef PREPARES
DEM_KERNEL
static void prepare_bodies(const void *of, struct dem_body_batch *restrict b)
{
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_body_row r = dem_body_row_load(b, 0, PREPARES, c);

        DEM_JOIN(LAW, _prepare_row)(of, &r);
        dem_body_row_store(&r, PREPARES, b, c);
    }
}
#endif

#ifndef SCALARS
#define SCALARS 0
#endif

DEM_KERNEL
static void apply_to_bodies(const void *of, struct dem_body_batch *restrict b)
{
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_body_row r = dem_body_row_load(b, SCALARS, SETS, c);

        DEM_JOIN(LAW, _row)(of, &r);
        dem_body_row_store(&r, SETS, b, c);
    }
}
