/*
 * energy_loop.h -- template: the energy of a contact law over a batch. contact_loop.h includes it; it
 * defines energy(settings, batch, before, history, energy) from struct <LAW> and <LAW>_energy_row()
 * (energy_row.h). COLUMNS: the number of history columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/batch_row.h"
#include "laws/energy_row.h"

DEM_KERNEL
static void energy(const void *of, const struct dem_contact_batch *restrict batch,
                   double *const *before, double *const *history, struct dem_energy *restrict e)
{
    const struct LAW settings_of_class = *(const struct LAW *)of;
    const double inverse_dt = dem_contact_batch_inverse_dt(batch);
    const struct dem_energy *const b = e;

    (void)before, (void)history;
    for (int c = 0; c < batch->n; c++)
    {
        const struct dem_contact_row r = dem_contact_row_load(batch, c, inverse_dt);
        struct dem_energy_row q = {DEM_ENERGY_COLUMNS(DEM_ROW_LOAD)};
        double from[DEM_LAW_HISTORY], to[DEM_LAW_HISTORY];

        dem_history_load(before, COLUMNS, c, from);
        dem_history_load(history, COLUMNS, c, to);
        DEM_JOIN(LAW, _energy_row)(&settings_of_class, &r, from, to, &q);
        e->stored[c] = q.stored;
        e->lost[c] = q.lost;
    }
}
