/*
 * sums.cl -- exact sums on the device: the digits of core/sum.h, added as integers, so the order of the
 * additions has no effect.
 *
 * Neighboring work items add to different copies of a sum, which the host adds up: one copy would make
 * them wait for each other. A number is a place in sums: digit k of copy c of sum s is at
 * (s DEM_DEVICE_SUM + k) copies + c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#include "core/sum_digits.h"

/* what a kernel adds to */
struct dem_exact_sums
{
    constant struct dem_device_batch *batch;
    global struct dem_device_report *report;
    global long *sums;    /* NULL: another rank adds */
    uint step;
};

/* Add a value. One that is not finite is an event, for the host to repeat the step. */
static void dem_exact_add(const struct dem_exact_sums *to, uint sum, double value)
{
    const uint copies = to->batch->copies, copy = (uint)get_local_id(0) & (copies - 1);
    struct dem_sum_digits d;

    if (value == 0.0 || !to->sums)
    {
        return;
    }
    if (!dem_sum_digits_of(value, &d))
    {
        dem_report_event(to->report, DEM_DEVICE_NOT_FINITE, to->step);
        return;
    }
    for (int m = 0; m < 3; m++)
    {
        if (d.digit[m])
        {
            const size_t digit = (size_t)sum*DEM_DEVICE_SUM + (size_t)(d.first + m);

            atom_add((volatile global long *)to->sums + digit*copies + copy, d.digit[m]);
        }
    }
}
