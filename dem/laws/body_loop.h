/*
 * body_loop.h -- template: the loop of a body, fluid or heat law over a batch of particles. Include
 * it once for each loop:
 *
 *   #define LAW dem_ergun
 *   #define SETS DEM_SETS_DRAG
 *   #include "laws/body_loop.h"
 *
 * defines apply_to_bodies(settings, batch) from dem_ergun_row(settings, row). SETS: the columns that
 * the row function sets. By choice:
 *
 *   LOOP     the name of the loop; default: apply_to_bodies
 *   ROW      the row function; default: <LAW>_row
 *   SCALARS  the number of particle scalars; default: none
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/batch_row.h"

#ifndef LOOP
#define LOOP apply_to_bodies
#endif
#ifndef ROW
#define ROW DEM_JOIN(LAW, _row)
#endif
#ifndef SCALARS
#define SCALARS 0
#endif

DEM_KERNEL
static void LOOP(const void *of, struct dem_body_batch *restrict b)
{
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_body_row r = dem_body_row_load(b, SCALARS, SETS, c);

        ROW(of, &r);
        dem_body_row_store(&r, SETS, b, c);
    }
}

#undef LAW
#undef SETS
#undef LOOP
#undef ROW
#undef SCALARS
