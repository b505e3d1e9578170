/*
 * bed_packing.c -- find the slab of a bed between 10 and 90 % of its volume, and what it holds.
 *
 * F(z) is summed over all particles for each step of a bisection, 20 times: to 1e-6 of the height.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/bed_packing.h"
#include "records/totals.h"
#include "ranks/collect.h"
#include <math.h>

static const double lower_part = 0.1, upper_part = 0.9;

static double height(const struct dem_particle *r, const double up[3])
{
    return r->x[0]*up[0] + r->x[1]*up[1] + r->x[2]*up[2];
}

/* m3: volume of particles below a height; of those that move, or of all. */
static double volume_below(const struct dem_state *state, const double up[3], double z, int all)
{
    double volume = 0.0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        const double s = fmin(1.0, (z - height(r, up))/r->radius);

        if (s > -1.0 && (all || !(r->flags & DEM_PARTICLE_FROZEN)))
        {
            volume += 0.25*(2.0 + 3.0*s - s*s*s)*dem_totals_volume(state, r);
        }
    }
    dem_collect_sum_double(&state->decomposition, &volume, 1);
    return volume;
}

static double height_of(const struct dem_state *state, const double up[3], const double range[2],
                        double volume)
{
    double low = range[0], high = range[1];

    for (int k = 0; k < 20; k++)
    {
        const double z = 0.5*(low + high);
        const int below = volume_below(state, up, z, 0) < volume;

        low = below ? z : low;
        high = below ? high : z;
    }
    return 0.5*(low + high);
}

int dem_bed_packing_measure(const struct dem_state *state, struct dem_bed_packing *b)
{
    double g[3], range[2] = {INFINITY, INFINITY};

    dem_interaction_table_gravity(&state->interaction_table, g);
    const double size = sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);

    if (size == 0.0)
    {
        return 0;
    }
    for (int k = 0; k < 3; k++)
    {
        b->up[k] = g[k] == 0.0 ? 0.0 : -g[k]/size;
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];

        if (!(r->flags & DEM_PARTICLE_FROZEN))
        {
            range[0] = fmin(range[0], height(r, b->up) - r->radius);
            range[1] = fmin(range[1], -height(r, b->up) - r->radius);
        }
    }
    dem_collect_min_double(&state->decomposition, range, 2);
    if (!isfinite(range[0]))
    {
        return 0;
    }
    range[1] = -range[1];
    const double moving = volume_below(state, b->up, range[1], 0);

    b->low = height_of(state, b->up, range, lower_part*moving);
    b->high = height_of(state, b->up, range, upper_part*moving);
    b->solid = volume_below(state, b->up, b->high, 1) - volume_below(state, b->up, b->low, 1);
    return 1;
}

double dem_bed_packing_void_fraction(const struct dem_bed_packing *b, double area)
{
    return 1.0 - b->solid/(area*(b->high - b->low));
}
