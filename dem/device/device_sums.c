/*
 * device_sums.c -- exact sums of the steps of the device (sums.cl), added to the host's: loads on walls
 * and their work (write/walls, records/wall_statistics.h), the energy balance (write/energy).
 *
 * Limit: the device does not carry within a batch, so a copy of a digit holds 2^31 terms: 2^23 terms a step in
 * batches of DEM_DEVICE_BATCH steps. This is not checked.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "records/energy_balance.h"
#include "records/wall_statistics.h"
#include <string.h>

_Static_assert((int)DEM_DEVICE_SUM >= (int)DEM_SUM_LIMBS && DEM_BINNED_SUMS + 1 == DEM_DEVICE_WALL_SUMS &&
                   (int)DEM_DEVICE_LAWS == (int)DEM_EFFECT_LIST_LIMIT, "as sums.cl and loads.cl add them");

enum
{
    MOST_NUMBERS = 1 << 20    /* of all copies of the sums; with more, sums have fewer copies */
};

static int has_loads(const struct dem_state *state)
{
    return state->wall_statistics->sum != NULL;
}

static size_t count_sums(const struct dem_state *state)
{
    return !has_loads(state) && !state->energy_balance->open
               ? 0
               : DEM_DEVICE_WALL_SUMS*(size_t)state->walls.walls +
                     (state->energy_balance->open ? DEM_ENERGY_BALANCE_SUMS : 0);
}

static uint32_t count_copies(size_t sums)
{
    uint32_t copies = DEM_DEVICE_COPIES;

    while (copies > 1 && sums*DEM_DEVICE_SUM*copies > MOST_NUMBERS)
    {
        copies /= 2;
    }
    return copies;
}

int dem_device_has_wall_work(const struct dem_state *state)
{
    return count_sums(state) > 0 && !state->walls.all_flat_static;
}

int dem_device_begin_sums(struct dem_device *d, const struct dem_state *state,
                          struct dem_device_batch *batch)
{
    const size_t sums = count_sums(state);

    batch->copies = count_copies(sums);
    batch->loads = has_loads(state);
    batch->work = dem_device_has_wall_work(state);
    /* zeros, in words of 32 bits */
    return sums > 0 ? dem_device_clear(d, &d->exact, 2*sums*DEM_DEVICE_SUM*batch->copies) : DEM_OK;
}

int dem_device_give_loads(struct dem_device *d)
{
    const struct dem_device_rows *const list = &d->list[d->at];

    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_loads, 0, &d->batch, &d->report));
    return DEM_OPENCL_GIVE(d->cl, d->of_loads, 3, &d->record, &list->partners, &d->facets, &d->frames,
                           &list->start, &list->entry, &list->touch, &d->force, &d->moment,
                           &d->contacts, &d->exact, &d->axes, &d->drives);
}

int dem_device_launch_loads(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_device_rows *const list = &d->list[d->at];

    if ((!has_loads(state) && !dem_device_has_wall_work(state)) || list->rows == list->walls)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_give_number(d->cl, d->of_loads, 2, s));
    return dem_opencl_launch(d->cl, d->of_loads, state->particles.n);
}

/* Where a sum of the device belongs. */
static struct dem_sum *place_of(struct dem_state *state, struct dem_binned_sum *loads, size_t sum)
{
    const size_t wall = sum/DEM_DEVICE_WALL_SUMS, k = sum%DEM_DEVICE_WALL_SUMS,
                 walls = (size_t)state->walls.walls;

    if (wall >= walls)
    {
        return &state->energy_balance->sum[sum - DEM_DEVICE_WALL_SUMS*walls];
    }
    return !has_loads(state)     ? NULL
           : k < DEM_BINNED_SUMS ? &loads[wall].sum[k]
                                 : &state->wall_statistics->work[wall];
}

static void add_copies(struct dem_sum *to, const int64_t *digits, size_t copies)
{
    dem_sum_normalise(to);
    for (size_t k = 0; k < DEM_SUM_LIMBS*copies; k++)
    {
        to->part[k/copies] += digits[k];
    }
    dem_sum_normalise(to);
}

int dem_device_add_sums(struct dem_device *d, struct dem_state *state, struct dem_binned_sum *loads)
{
    const size_t sums = count_sums(state), copies = count_copies(sums), of_sum = DEM_DEVICE_SUM*copies;
    int64_t *all;

    if (sums == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(all, sums*of_sum));
    const int status = dem_opencl_read(d->cl, &d->exact, 0, sums*of_sum*sizeof *all, all);

    for (size_t k = 0; !status && k < sums; k++)
    {
        if (place_of(state, loads, k))
        {
            add_copies(place_of(state, loads, k), all + k*of_sum, copies);
        }
    }
    dem_memory_free(all);
    return status;
}
