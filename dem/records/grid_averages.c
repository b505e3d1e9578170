/*
 * grid_averages.c -- what is averaged on grids: volume, mass, momentum, kinetic flux m v v and
 * virial of the particles, and their scalars; means with intervals.
 *
 * records/grid_sums.h has the sums. When the files are written, the quantities of grid_averages.h
 * follow from the means. Each scalar has sums of its own, so that the others are the same in a
 * scene without it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/grid_averages.h"
#include "records/totals.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "particles/clump.h"
#include "records/virial.h"
#include "particles/scalars.h"
#include "ranks/dem_state.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    VOLUME,
    MASS,
    MOMENTUM,
    FLUX = MOMENTUM + 3,      /* m v v: xx yy zz xy yz zx */
    VIRIAL = FLUX + 6,
    COLUMNS = VIRIAL + 6,

    WEIGHT = 0,               /* of a scalar */
    WEIGHTED,
    SCALAR_COLUMNS,

    KINDS = 5,                /* columns of one unit have one scale */
    FIELDS = 5,
    RESULTS = 12,
    NAME = 64
};

static const int kind_of[COLUMNS] = {0, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4};

static const char *const kind_name[KINDS] = {"volume", "mass", "momentum", "m v v",
                                             "virial of its contacts"};
static const char *const kind_unit[KINDS] = {"m3", "kg", "kg m/s", "J", "J"};

static const int scalar_kind_of[SCALAR_COLUMNS] = {0, 1};
static const char *const scalar_kind_name[SCALAR_COLUMNS] = {"a weight of its particle scalars of",
                                                             "a particle scalar times its weight of"};
static const char *const scalar_kind_unit[SCALAR_COLUMNS] = {"(SI)", "(SI)"};

static const double max_samples = 0x1p53;    /* integers that are exact in a double */

/* Times that differ by less than this fraction of an interval are equal: they are rounded sums of
   time steps. */
static const double same_time = 1e-6;

/* ---- set-up ---------------------------------------------------------------------------------- */

/* Number of the first sample after a time: the same with a restart as without. */
static int64_t number_after(const struct dem_averages_entry *p, double time)
{
    return (int64_t)fmin(floor((time - p->start)/p->interval + same_time), max_samples) + 1;
}

static int init_grid(struct dem_grid_average *g, const struct dem_interaction_table *r, double time,
                     int collects)
{
    g->next = time > g->entry.start ? number_after(&g->entry, time) : 0;
    DEM_TRY(dem_grid_sums_init(&g->sums, &g->entry, COLUMNS, collects));
    for (int k = 0; k < r->scalars; k++)
    {
        if (r->scalar[k]->flags & DEM_SCALAR_WRITTEN)
        {
            struct dem_scalar_average *const s = &g->scalar[g->scalars++];

            s->index = k;
            s->name = r->scalar[k]->name;
            DEM_TRY(dem_grid_sums_init(&s->sums, &g->entry, SCALAR_COLUMNS, collects));
        }
    }
    return DEM_OK;
}

int dem_grid_averages_init(struct dem_grid_averages *a, const struct dem_averages_entry *entry,
                           int n, const struct dem_interaction_table *r, double time, int collects)
{
    DEM_TRY(DEM_NEW(a->grid, (size_t)n + 1));
    a->grids = n;
    for (int k = 0; k < n; k++)
    {
        a->grid[k].entry = entry[k];
        DEM_TRY(init_grid(&a->grid[k], r, time, collects));
    }
    return DEM_OK;
}

void dem_grid_averages_free(struct dem_grid_averages *a)
{
    for (int k = 0; k < a->grids; k++)
    {
        dem_grid_sums_free(&a->grid[k].sums);
        for (int s = 0; s < a->grid[k].scalars; s++)
        {
            dem_grid_sums_free(&a->grid[k].scalar[s].sums);
        }
        dem_memory_free(a->grid[k].virial);
    }
    dem_memory_free(a->grid);
    *a = (struct dem_grid_averages){.grids = 0};
}

/* ---- one sample ------------------------------------------------------------------------------ */

static void particle_values(const struct dem_grid_columns *s, const struct dem_state *state,
                            size_t particle, double *out)
{
    const struct dem_particle *const q = &state->particles.record[particle];
    const struct dem_clump *const b = dem_clump_of(&state->particles, particle);
    const double *const v = b ? b->v : q->v;

    out[VOLUME] = dem_totals_volume(state, q);
    out[MASS] = q->mass;
    for (int k = 0; k < 3; k++)
    {
        out[MOMENTUM + k] = q->mass*v[k];
        out[FLUX + k] = q->mass*v[k]*v[k];
        out[FLUX + 3 + k] = q->mass*v[k]*v[(k + 1)%3];
    }
    memcpy(out + VIRIAL, s->virial + 6*particle, 6*sizeof *out);
}

/* The weight is the capacity, else 1 for an amount, else the mass. */
static void scalar_values(const struct dem_grid_columns *s, const struct dem_state *state,
                          size_t particle, double *out)
{
    const struct dem_interaction_table *const r = &state->interaction_table;
    const struct dem_particle *const q = &state->particles.record[particle];
    const struct dem_scalar *const row = r->scalar[s->scalar];

    out[WEIGHT] = row->capacity
                      ? dem_interaction_table_capacity(r, s->scalar, q->material, q->mass)
                  : row->flags & DEM_SCALAR_AMOUNT ? 1.0
                                                   : q->mass;
    out[WEIGHTED] = out[WEIGHT]*dem_scalar_values(&state->particles, s->scalar)[particle];
}

/* Collective; a rank without memory takes part without particles. */
static int sample(struct dem_grid_average *g, const struct dem_state *state, int status)
{
    const int short_of_memory = DEM_GROW(g->virial, g->virial_capacity, 6*(state->particles.n + 1));
    const size_t n = short_of_memory ? 0 : state->particles.n;

    status = status ? status : short_of_memory;
    if (!short_of_memory)
    {
        dem_virial_sum(state, g->virial);
    }
    const struct dem_grid_columns mechanics = {.columns = COLUMNS,
                                               .kinds = KINDS,
                                               .kind_of = kind_of,
                                               .kind_name = kind_name,
                                               .kind_unit = kind_unit,
                                               .virial = g->virial,
                                               .values = particle_values};

    status = dem_grid_sums_sample(&g->sums, &g->entry, &mechanics, state, n, status);
    for (int k = 0; k < g->scalars; k++)
    {
        const struct dem_grid_columns scalar = {.columns = SCALAR_COLUMNS,
                                                .kinds = SCALAR_COLUMNS,
                                                .kind_of = scalar_kind_of,
                                                .kind_name = scalar_kind_name,
                                                .kind_unit = scalar_kind_unit,
                                                .scalar = g->scalar[k].index,
                                                .values = scalar_values};

        status = dem_grid_sums_sample(&g->scalar[k].sums, &g->entry, &scalar, state, n, status);
    }
    return status;
}

static int is_due(const struct dem_grid_average *g, double time)
{
    const double due = g->entry.start + ((double)g->next - same_time)*g->entry.interval;

    return time >= due && due <= g->entry.end;
}

int dem_grid_averages_due(const struct dem_grid_averages *a, double time)
{
    int due = 0;

    for (int k = 0; k < a->grids; k++)
    {
        due |= is_due(&a->grid[k], time);
    }
    return due;
}

int dem_grid_averages_sample(struct dem_grid_averages *a, const struct dem_state *state, int status)
{
    for (int k = 0; k < a->grids; k++)
    {
        struct dem_grid_average *const g = &a->grid[k];

        if (is_due(g, state->time))
        {
            status = sample(g, state, status);
            g->next = number_after(&g->entry, state->time);
        }
    }
    return status;
}

/* ---- results --------------------------------------------------------------------------------- */

/* From the means over the cell, not yet divided by its volume. Order: volume, mass, velocity,
   temperature, stress. */
static void results(const double *mean, double *out)
{
    const double mass = mean[MASS], *const momentum = mean + MOMENTUM;
    const double per_mass = mass > 0.0 ? 1.0/mass : 0.0;

    out[0] = mean[VOLUME];
    out[1] = mass;
    for (int k = 0; k < 3; k++)
    {
        out[2 + k] = per_mass*momentum[k];
    }
    out[5] = per_mass*
             (mean[FLUX] + mean[FLUX + 1] + mean[FLUX + 2] -
              per_mass*dem_vec_dot(momentum, momentum))/
             3.0;
    for (int k = 0; k < 3; k++)
    {
        out[6 + k] = mean[VIRIAL + k] - mean[FLUX + k] + per_mass*momentum[k]*momentum[k];
        out[9 + k] = mean[VIRIAL + 3 + k] - mean[FLUX + 3 + k] +
                     per_mass*momentum[k]*momentum[(k + 1)%3];
    }
}

static void divide_by_volume(double *out, double volume)
{
    for (int k = 0; k < RESULTS; k++)
    {
        out[k] = k < 2 || k > 5 ? out[k]/volume : out[k];
    }
}

/* The mean of a scalar. */
static void ratio(const double *mean, double *out)
{
    out[0] = mean[WEIGHT] > 0.0 ? mean[WEIGHTED]/mean[WEIGHT] : 0.0;
}

/* The mean of a scalar has the scalar's name, or particleName if one of `fields` has that name. */
static void name_scalar(const char *scalar, const struct dem_averages_quantity *field, int fields,
                        char name[NAME])
{
    int taken = 0;

    for (int k = 0; k < fields; k++)
    {
        taken = taken || strcmp(field[k].name, scalar) == 0;
    }
    snprintf(name, NAME, taken ? "particle%c%s" : "%c%s",
             taken ? toupper((unsigned char)scalar[0]) : scalar[0], scalar + 1);
}

/* Means of all cells, `stride` numbers a cell: RESULTS, then one for each scalar. */
static void derive(const struct dem_grid_average *g, size_t stride, double *value, double *ci)
{
    double volume = 1.0;

    for (int k = 0; k < 3; k++)
    {
        volume *= (g->entry.max[k] - g->entry.min[k])/(double)g->entry.cells[k];
    }
    for (size_t c = 0; c < dem_averages_cells(&g->entry); c++, value += stride, ci += stride)
    {
        dem_block_means_derive(&g->sums.blocks, COLUMNS*c, COLUMNS, results, RESULTS, value, ci);
        divide_by_volume(value, volume);
        divide_by_volume(ci, volume);
        for (int k = 0; k < g->scalars; k++)
        {
            dem_block_means_derive(&g->scalar[k].sums.blocks, SCALAR_COLUMNS*c, SCALAR_COLUMNS,
                                   ratio, 1, value + RESULTS + k, ci + RESULTS + k);
        }
    }
}

static int save(const struct dem_grid_average *g, const struct dem_interaction_table *r,
                const char *folder)
{
    const size_t stride = RESULTS + (size_t)g->scalars, numbers = stride*dem_averages_cells(&g->entry);
    char name[DEM_SCALARS][NAME];
    double *value, *ci;

    DEM_TRY(DEM_NEW(value, 2*numbers));
    ci = value + numbers;
    derive(g, stride, value, ci);
    struct dem_averages_quantity field[FIELDS + DEM_SCALARS] =
    {
        {"solidFraction", "1", 1, value, ci},
        {"bulkDensity", "kg/m3", 1, value + 1, ci + 1},
        {"velocity", "m/s", 3, value + 2, ci + 2},
        {"temperature", "m2/s2", 1, value + 5, ci + 5},
        {"stress", "Pa", 6, value + 6, ci + 6},
    };
    for (int k = 0; k < g->scalars; k++)
    {
        name_scalar(g->scalar[k].name, field, FIELDS, name[k]);
        field[FIELDS + k] = (struct dem_averages_quantity){
            name[k], r->scalar[g->scalar[k].index]->unit, 1, value + RESULTS + k, ci + RESULTS + k};
    }
    const int status = dem_averages_io_write(folder, &g->entry, field, FIELDS + g->scalars, stride);

    dem_memory_free(value);
    return status;
}

int dem_grid_averages_write(const struct dem_grid_averages *a, const struct dem_state *state,
                            const char *folder)
{
    for (int k = 0; k < a->grids && state->decomposition.rank == 0; k++)
    {
        if (a->grid[k].sums.blocks.samples > 0)
        {
            DEM_TRY(save(&a->grid[k], &state->interaction_table, folder));
        }
    }
    return DEM_OK;
}
