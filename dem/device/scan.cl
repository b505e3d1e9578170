/*
 * scan.cl -- exclusive sums of many numbers, in three kernels: sums of blocks; of the blocks' sums;
 * within blocks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define SCAN_ITEMS 16    /* numbers of a work item; a block is a group of them */

kernel void scan_clear(uint n, global uint *number)
{
    if (get_global_id(0) < n)
    {
        number[get_global_id(0)] = 0;
    }
}

kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void scan_blocks(uint n, global const uint *restrict number, global uint *restrict sums)
{
    local uint part[DEM_DEVICE_GROUP];
    const uint l = get_local_id(0), from = (uint)get_global_id(0)*SCAN_ITEMS;
    uint sum = 0;

    for (uint k = from; k < min(from + SCAN_ITEMS, n); k++)
    {
        sum += number[k];
    }
    part[l] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l == 0)
    {
        for (uint k = 1; k < DEM_DEVICE_GROUP; k++)
        {
            sum += part[k];
        }
        sums[get_group_id(0)] = sum;
    }
}

/* By one group: each item a run of blocks. */
kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void scan_sums(uint blocks, global uint *sums)
{
    local uint part[DEM_DEVICE_GROUP];
    const uint l = get_local_id(0), each = (blocks + DEM_DEVICE_GROUP - 1)/DEM_DEVICE_GROUP,
               from = l*each, end = min(from + each, blocks);
    uint sum = 0, before = 0;

    for (uint k = from; k < end; k++)
    {
        sum += sums[k];
    }
    part[l] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint k = 0; k < l; k++)
    {
        before += part[k];
    }
    for (uint k = from; k < end; k++)
    {
        const uint own = sums[k];

        sums[k] = before;
        before += own;
    }
}

/* number[n]: the sum of all. */
kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void scan_finish(uint n, global uint *restrict number, global const uint *restrict sums)
{
    local uint part[DEM_DEVICE_GROUP];
    const uint l = get_local_id(0), from = (uint)get_global_id(0)*SCAN_ITEMS;
    uint sum = 0, before = sums[get_group_id(0)];

    for (uint k = from; k < min(from + SCAN_ITEMS, n); k++)
    {
        sum += number[k];
    }
    part[l] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint k = 0; k < l; k++)
    {
        before += part[k];
    }
    for (uint k = from; k < min(from + SCAN_ITEMS, n); k++)
    {
        const uint own = number[k];

        number[k] = before;
        before += own;
        if (k == n - 1)
        {
            number[n] = before;
        }
    }
}
