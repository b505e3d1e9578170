/*
 * contact_loop.h -- template: the loop of a contact law over a batch. Include it once for each
 * loop:
 *
 *   #define LAW dem_hertz
 *   #define SETS DEM_SETS_KN | DEM_SETS_FN
 *   #include "laws/contact_loop.h"
 *
 * defines apply(settings, batch, history) from struct dem_hertz and dem_hertz_row(). SETS: the
 * columns that the row function sets. By choice:
 *
 *   LOOP     the name of the loop; default: apply
 *   ROW      the row function; default: <LAW>_row
 *   COLUMNS  the number of history columns; default: none
 *   SCALARS  the number of particle scalars; default: none
 *   BEFORE   called with settings and batch before the rows; default: nothing
 *   ENERGY   defined: energy(), too, from <LAW>_energy_row() (energy_loop.h)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/batch_row.h"

#ifndef LOOP
#define LOOP apply
#endif
#ifndef ROW
#define ROW DEM_JOIN(LAW, _row)
#endif
#ifndef COLUMNS
#define COLUMNS 0
#endif
#ifndef SCALARS
#define SCALARS 0
#endif

DEM_KERNEL
static void LOOP(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    const struct LAW settings_of_class = *(const struct LAW *)of;    /* a copy stays in registers */
    const double inverse_dt = dem_contact_batch_inverse_dt(b);

    (void)history;
#ifdef BEFORE
    BEFORE(&settings_of_class, b);
#endif
    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        double values[DEM_LAW_HISTORY];

        dem_contact_row_load_scalars(&r, SCALARS, SETS, b, c);
        dem_history_load(history, COLUMNS, c, values);
        ROW(&settings_of_class, &r, values);
        dem_history_store(values, COLUMNS, c, history);
        dem_contact_row_store(&r, SETS, b, c);
    }
}

#ifdef ENERGY
#include "laws/energy_loop.h"
#endif

#undef LAW
#undef SETS
#undef LOOP
#undef ROW
#undef COLUMNS
#undef SCALARS
#undef BEFORE
#undef ENERGY
