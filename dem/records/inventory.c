/*
 * inventory.c -- count particles and lists in one pass.
 *
 * Sums are exact, so that a plan is the same on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/inventory.h"
#include "records/totals.h"
#include "laws/fluid/viscosity.h"
#include "particles/scalars.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

enum
{
    SUMS = 6                                              /* of one material */
};

static void count_particles(const struct dem_state *state, int material,
                            struct dem_material_inventory *s)
{
    struct dem_sum sum[SUMS] = {0};
    double value[SUMS], range[2] = {INFINITY, 0.0};
    int64_t count[2] = {0, 0};

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        const double d = 2.0*r->radius, volume = dem_totals_volume(state, r),
                     moving = r->flags & DEM_PARTICLE_FROZEN ? 0.0 : 1.0;
        const double term[SUMS] = {d, d*d, volume, r->mass, moving*volume, moving*r->mass};

        if (r->material != material)
        {
            continue;
        }
        for (int k = 0; k < SUMS; k++)
        {
            dem_sum_add(&sum[k], term[k]);
        }
        count[0]++;
        count[1] += moving == 0.0;
        range[0] = fmin(range[0], d);
        range[1] = fmin(range[1], -d);
    }
    dem_totals_reduce_sums(state, sum, SUMS, value);
    dem_collect_sum_int64(&state->decomposition, count, 2);
    dem_collect_min_double(&state->decomposition, range, 2);
    *s = (struct dem_material_inventory){.n = count[0],
                                         .frozen = count[1],
                                         .min_diameter = range[0],
                                         .max_diameter = -range[1],
                                         .diameters = value[0],
                                         .squares = value[1],
                                         .volume = value[2],
                                         .mass = value[3],
                                         .moving_volume = value[4],
                                         .moving_mass = value[5],
                                         .grains = (double)count[0],
                                         .grain_squares = value[1]};
}

/* sum of l^3, and of l^3 (D/l)^2 */
static void count_grains(const struct dem_state *state, int material, struct dem_material_inventory *s)
{
    const double *const ratio =
        dem_scalar_values(&state->particles, state->interaction_table.parcels.scalar);
    struct dem_sum sum[2] = {0};
    double value[2];

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        const double l = ratio[i], D = 2.0*r->radius;

        if (r->material == material)
        {
            dem_sum_add(&sum[0], l*l*l);
            dem_sum_add(&sum[1], l*D*D);
        }
    }
    dem_totals_reduce_sums(state, sum, 2, value);
    s->grains = value[0];
    s->grain_squares = value[1];
}

static void add_up(struct dem_material_inventory *all, const struct dem_material_inventory *s)
{
    all->n += s->n;
    all->frozen += s->frozen;
    all->min_diameter = fmin(all->min_diameter, s->min_diameter);
    all->max_diameter = fmax(all->max_diameter, s->max_diameter);
    all->diameters += s->diameters;
    all->squares += s->squares;
    all->volume += s->volume;
    all->mass += s->mass;
    all->moving_volume += s->moving_volume;
    all->moving_mass += s->moving_mass;
    all->grains += s->grains;
    all->grain_squares += s->grain_squares;
}

static void mean_fluid(const struct dem_state *state, struct dem_inventory *s)
{
    const double *const rho = dem_column(&state->particles, DEM_COLUMN_FLUID_DENSITY);
    const double *const mu = dem_scalar_values_of(
        &state->particles, &state->interaction_table, dem_fluid_viscosity.name);
    struct dem_sum sum[2] = {0};
    double value[2];

    for (size_t i = 0; rho && mu && i < state->particles.n; i++)
    {
        dem_sum_add(&sum[0], rho[i]);
        dem_sum_add(&sum[1], mu[i]);
    }
    dem_totals_reduce_sums(state, sum, 2, value);
    s->fluid_density = s->all.n > 0 ? value[0]/(double)s->all.n : 0.0;
    s->fluid_viscosity = s->all.n > 0 ? value[1]/(double)s->all.n : 0.0;
}

static double bytes_held(const struct dem_state *state)
{
    return (double)(dem_particles_bytes(&state->particles) + dem_contacts_bytes(&state->contacts) +
                    dem_pairs_bytes(&state->pairs) + state->touches.capacity*sizeof *state->touches.touch +
                    dem_wall_store_bytes(&state->wall_store, &state->walls));
}

void dem_inventory_take(const struct dem_state *state, struct dem_inventory *s)
{
    double bytes[2] = {bytes_held(state), bytes_held(state)};
    int64_t lists[2] = {(int64_t)state->contacts.pairs.n, 0};

    memset(s, 0, sizeof *s);
    s->all.min_diameter = INFINITY;
    for (int m = 0; m < state->interaction_table.materials; m++)
    {
        count_particles(state, m, &s->material[m]);
        if (state->interaction_table.parcels.used)
        {
            count_grains(state, m, &s->material[m]);
        }
        add_up(&s->all, &s->material[m]);
    }
    mean_fluid(state, s);
    for (int c = 0; c < state->contacts.rows.classes && state->contacts.rows.n > 0; c++)
    {
        lists[1] += state->contacts.rows.segment[c].count;
    }
    dem_collect_sum_int64(&state->decomposition, lists, 2);
    dem_collect_sum_double(&state->decomposition, &bytes[0], 1);
    dem_collect_max_double(&state->decomposition, &bytes[1], 1);
    s->pairs = lists[0];
    s->rows = lists[1];
    s->bytes = bytes[0];
    s->max_bytes = bytes[1];
}
