/*
 * fused.c -- find the fused kernel for an effect list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused.h"
#include <stddef.h>

const struct dem_effect dem_none = {.size = 0};

const struct dem_fused_kernel *const dem_fused_kernels[] = {dem_fused_hertz, dem_fused_hooke,
                                                            dem_fused_adhesive, NULL};

/* Number of effects that the kernel takes, 0 if the list does not begin with its laws. The adhesive
   force of an effect that it does not have would come too late for its friction. */
static int taken_by(const struct dem_fused_kernel *kernel, const struct dem_effect *const *effects,
                    int count)
{
    int taken = 0;

    for (int k = 0; k < DEM_FUSED_LAWS; k++)
    {
        if (kernel->law[k] == &dem_none)
        {
            continue;
        }
        if (taken == count || effects[taken] != kernel->law[k])
        {
            return 0;
        }
        taken++;
    }
    for (int k = taken; k < count; k++)
    {
        taken = effects[k]->set_adhesion ? 0 : taken;
    }
    return taken;
}

const struct dem_fused_kernel *dem_fused_find(const struct dem_effect *const *effects, int count,
                                              int *taken)
{
    const struct dem_fused_kernel *best = NULL;

    *taken = 0;
    for (const struct dem_fused_kernel *const *table = dem_fused_kernels; *table; table++)
    {
        for (const struct dem_fused_kernel *kernel = *table; kernel->apply; kernel++)
        {
            const int takes = taken_by(kernel, effects, count);

            best = takes > *taken ? kernel : best;
            *taken = takes > *taken ? takes : *taken;
        }
    }
    return best;
}
