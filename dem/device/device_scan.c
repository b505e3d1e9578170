/*
 * device_scan.c -- zeros, and exclusive sums of many numbers, on the device (scan.cl).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "device/device_internal.h"

enum
{
    SCAN_BLOCK = 16*DEM_DEVICE_GROUP    /* SCAN_ITEMS of scan.cl times the items of a group */
};

int dem_device_clear(struct dem_device *d, struct dem_opencl_memory *m, size_t n)
{
    struct dem_opencl_kernel *const k = d->of_lists[DEM_SCAN_CLEAR];

    DEM_TRY(dem_opencl_reserve(d->cl, m, (n + 1)*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 0, (uint32_t)(n + 1)));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 1, m));
    return dem_opencl_launch(d->cl, k, n + 1);
}

/* Exclusive sums of n numbers in place; their sum after the last. */
int dem_device_scan(struct dem_device *d, struct dem_opencl_memory *m, size_t n)
{
    const size_t blocks = (n + SCAN_BLOCK - 1)/SCAN_BLOCK;
    struct dem_opencl_kernel *const *const k = d->of_lists;

    DEM_TRY(dem_opencl_reserve(d->cl, &d->sums, (blocks + 1)*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_give_number(d->cl, k[DEM_SCAN_BLOCKS], 0, (uint32_t)n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_SCAN_BLOCKS], 1, m, &d->sums));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_SCAN_BLOCKS], blocks*DEM_DEVICE_GROUP));
    DEM_TRY(dem_opencl_give_number(d->cl, k[DEM_SCAN_SUMS], 0, (uint32_t)blocks));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_SCAN_SUMS], 1, &d->sums));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_SCAN_SUMS], DEM_DEVICE_GROUP));
    DEM_TRY(dem_opencl_give_number(d->cl, k[DEM_SCAN_FINISH], 0, (uint32_t)n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_SCAN_FINISH], 1, m, &d->sums));
    return dem_opencl_launch(d->cl, k[DEM_SCAN_FINISH], blocks*DEM_DEVICE_GROUP);
}
