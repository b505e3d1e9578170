/*
 * device_loads.c -- loads on walls in the steps of the device (write/walls): exact sums there, added to
 * the host's (records/wall_statistics.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "records/wall_statistics.h"
#include <string.h>

_Static_assert((int)DEM_DEVICE_SUM >= (int)DEM_SUM_LIMBS && DEM_BINNED_SUMS == 6, "as loads.cl adds them");

enum
{
    NUMBERS = DEM_BINNED_SUMS*DEM_DEVICE_SUM    /* of a wall */
};

static size_t bytes_of(const struct dem_state *state)
{
    return (size_t)state->walls.walls*NUMBERS*sizeof(int64_t);
}

int dem_device_begin_loads(struct dem_device *d, const struct dem_state *state)
{
    struct dem_device_rows *const list = &d->list[d->at];
    const size_t bytes = bytes_of(state);
    int64_t *zeros;

    if (!state->wall_statistics->sum || bytes == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(zeros, bytes/sizeof *zeros));
    const int status = dem_opencl_put(d->cl, &d->loads, bytes, zeros);

    dem_memory_free(zeros);
    DEM_TRY(status);
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_loads, 0, &d->batch, &d->report));
    return DEM_OPENCL_GIVE(d->cl, d->of_loads, 3, &d->record, &list->partners, &d->facets, &d->frames,
                           &list->start, &list->entry, &list->touch, &d->force, &d->moment,
                           &d->contacts, &d->loads, &d->axes);
}

int dem_device_launch_loads(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_device_rows *const list = &d->list[d->at];

    if (!state->wall_statistics->sum || list->rows == list->walls)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_give_number(d->cl, d->of_loads, 2, s));
    return dem_opencl_launch(d->cl, d->of_loads, state->particles.n);
}

int dem_device_add_loads(struct dem_device *d, struct dem_state *state)
{
    struct dem_binned_sum *const sum = state->wall_statistics->sum;
    const size_t bytes = bytes_of(state);
    int64_t *loads;

    if (!sum || bytes == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(loads, bytes/sizeof *loads));
    const int status = dem_opencl_read(d->cl, &d->loads, 0, bytes, loads);

    for (size_t k = 0; !status && k < bytes/sizeof *loads; k++)
    {
        const size_t digit = k%DEM_DEVICE_SUM;
        struct dem_sum *const to = &sum[k/NUMBERS].sum[k/DEM_DEVICE_SUM%DEM_BINNED_SUMS];

        to->part[digit < DEM_SUM_LIMBS ? digit : DEM_SUM_ADDED] += loads[k];
        if (digit == DEM_DEVICE_SUM - 1)
        {
            dem_sum_normalise(to);
        }
    }
    dem_memory_free(loads);
    return status;
}
