/*
 * energy.h -- a scene with the energy balance enabled, and its terms by name.
 *
 *   struct dem *d = energy_world(scene, n, seeds);   as world(), with dem_case_enable_energy
 *   energy_term(d, "residual")                       J
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "physics/world.h"
#include <math.h>

static inline struct dem *energy_world(const char *scene, int64_t n,
                                       const struct dem_new_particle *seed)
{
    struct dem_case *const c = world_begin(scene);

    if (n > 0)
    {
        WORLD_TRY(dem_case_add_particles(c, n, seed));
    }
    WORLD_TRY(dem_case_enable_energy(c));
    return world_start(c);
}

/* NAN: the balance has no such term */
static inline double energy_value(struct dem *d, const char *name)
{
    const struct dem_energy_item *item;
    double since;
    int n;

    WORLD_TRY(dem_energy(d, &since, &n, &item));
    for (int k = 0; k < n; k++)
    {
        if (strcmp(item[k].name, name) == 0)
        {
            return item[k].value;
        }
    }
    return NAN;
}

static inline double energy_term(struct dem *d, const char *name)
{
    const double value = energy_value(d, name);

    if (isnan(value))
    {
        printf("Bail out! the energy balance has no term %s\n", name);
        exit(1);
    }
    return value;
}
