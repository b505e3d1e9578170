/*
 * grid_averages.c -- deposit particles on grids, sum samples in blocks and compute means with intervals.
 *
 * 1. Each particle's volume, mass, momentum, kinetic flux m v v and virial are distributed over the
 *    cells that it overlaps.
 * 2. The contributions are converted to integers, so that the sum over particles and ranks does not
 *    depend on the order.
 * 3. Each sample is added to the block sums (core/block_means.h) on the first rank.
 * 4. When the files are written, the quantities of grid_averages.h follow from the means.
 *
 * Unit of the integers: the largest contribution of one particle anywhere over 2^b. b leaves enough
 * bits for all particles in one cell; with a million particles b = 42, which is 2e-13 of the
 * largest. A cell wider than a periodic box contains a particle up to three times along that axis,
 * which takes two bits more. So no sum can overflow. A contribution that is not finite, or too
 * large for products of means, ends the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/grid_averages.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "parallel/collect.h"
#include "simulation/dem_state.h"
#include "diagnostics/virial.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    VOLUME,
    MASS,
    MOMENTUM,
    FLUX = MOMENTUM + 3,      /* m v v: xx yy zz xy yz zx */
    VIRIAL = FLUX + 6,
    COLUMNS = VIRIAL + 6,

    KINDS = 5,                /* columns of one unit have one scale */
    RESULTS = 12,

    MAX_BITS = 61             /* of a sum, without its sign */
};

static const int kind_of[COLUMNS] = {0, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4};

static const char *const kind_name[KINDS] = {"volume", "mass", "momentum", "m v v",
                                             "virial of its contacts"};
static const char *const kind_unit[KINDS] = {"m3", "kg", "kg m/s", "J", "J"};

/* Limit of a contribution of one particle, SI units: squares of sums of squares stay finite. */
static const double max_contribution = 1e60;

static const double max_samples = 0x1p53;    /* integers that are exact in a double */

/* Times that differ by less than this fraction of an interval are equal: they are rounded sums of
   time steps. */
static const double same_time = 1e-6;

/* ---- set-up ---------------------------------------------------------------------------------- */

static size_t cells_of(const struct dem_grid_average *g)
{
    return (size_t)g->entry.cells[0]*(size_t)g->entry.cells[1]*(size_t)g->entry.cells[2];
}

/* Number of the first sample after a time: the same with a restart as without. */
static int64_t number_after(const struct dem_averages_entry *p, double time)
{
    return (int64_t)fmin(floor((time - p->start)/p->interval + same_time), max_samples) + 1;
}

int dem_grid_averages_init(struct dem_grid_averages *a, const struct dem_averages_entry *entry,
                           int n, double time, int collects)
{
    DEM_TRY(DEM_NEW(a->grid, (size_t)n + 1));
    a->grids = n;
    for (int k = 0; k < n; k++)
    {
        struct dem_grid_average *const g = &a->grid[k];

        g->entry = entry[k];
        g->next = time > g->entry.start ? number_after(&g->entry, time) : 0;
        DEM_TRY(DEM_NEW(g->sum, COLUMNS*cells_of(g)));
        DEM_TRY(DEM_NEW(g->sample, COLUMNS*cells_of(g)));
        DEM_TRY(dem_block_means_init(&g->blocks, collects ? COLUMNS*cells_of(g) : 0));
    }
    return DEM_OK;
}

void dem_grid_averages_free(struct dem_grid_averages *a)
{
    for (int k = 0; k < a->grids; k++)
    {
        dem_memory_free(a->grid[k].sum);
        dem_memory_free(a->grid[k].sample);
        dem_memory_free(a->grid[k].virial);
        dem_block_means_free(&a->grid[k].blocks);
    }
    dem_memory_free(a->grid);
    *a = (struct dem_grid_averages){.grids = 0};
}

/* ---- overlap of a sphere and cells ----------------------------------------------------------- */

struct slab                 /* the cells along one axis that a sphere overlaps */
{
    int first, count;
    double lower, width;    /* m: lower edge of the grid, width of a cell */
    double x, radius;
};

static struct slab slab_of(const struct dem_averages_entry *p, int axis, double x, double radius)
{
    const double width = (p->max[axis] - p->min[axis])/(double)p->cells[axis];
    const double from = floor((x - radius - p->min[axis])/width),
                 to = floor((x + radius - p->min[axis])/width);
    const int first = from < 0.0 ? 0 : from > p->cells[axis] ? p->cells[axis] : (int)from;
    const int last = to < 0.0 ? -1 : to >= p->cells[axis] ? p->cells[axis] - 1 : (int)to;

    return (struct slab){.first = first,
                         .count = last - first + 1,
                         .lower = p->min[axis],
                         .width = width,
                         .x = x,
                         .radius = radius};
}

/* Fraction of the sphere's volume below a plane. */
static double below(const struct slab *s, double plane)
{
    const double h = fmax(-1.0, fmin(1.0, (plane - s->x)/s->radius));

    return 0.25*(2.0 + 3.0*h - h*h*h);
}

static double slab_fraction(const struct slab *s, int cell)
{
    return below(s, s->lower + (double)(cell + 1)*s->width) -
           below(s, s->lower + (double)cell*s->width);
}

/* ---- one sample ------------------------------------------------------------------------------ */

static void particle_values(const struct dem_particle *q, const double *virial, double out[COLUMNS])
{
    out[VOLUME] = dem_particle_volume(q);
    out[MASS] = q->mass;
    for (int k = 0; k < 3; k++)
    {
        out[MOMENTUM + k] = q->mass*q->v[k];
        out[FLUX + k] = q->mass*q->v[k]*q->v[k];
        out[FLUX + 3 + k] = q->mass*q->v[k]*q->v[(k + 1)%3];
    }
    memcpy(out + VIRIAL, virial, 6*sizeof *out);
}

/* DEM_ERROR_NUMBER with the first particle of this rank that has a contribution above the limit. */
static int refuse_contribution(const struct dem_grid_average *g, const struct dem_state *p)
{
    double out[COLUMNS];

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        particle_values(q, g->virial + 6*i, out);
        for (int c = 0; c < COLUMNS; c++)
        {
            DEM_REQUIRE(
                isless(fabs(out[c]), max_contribution), DEM_ERROR_NUMBER,
                "averages/%s: particle %lld at (%g %g %g) m with (%g %g %g) m/s has %s %g %s in step %lld, the "
                "limit is %g; look at the forces on it, or use a smaller time/step",
                g->entry.name, (long long)q->id, q->x[0], q->x[1], q->x[2], q->v[0], q->v[1],
                q->v[2], kind_name[kind_of[c]], out[c], kind_unit[kind_of[c]], (long long)p->steps,
                max_contribution);
        }
    }
    return DEM_OK;
}

/* Extra bits for several periodic images of one particle in one cell. */
static int bits_of_images(const struct dem_averages_entry *a, const struct dem_domain *d)
{
    int bits = 0;

    for (int k = 0; k < 3; k++)
    {
        bits += d->periodic[k] &&
                        (a->max[k] - a->min[k])/(double)a->cells[k] > d->length[k]*(1.0 + 1e-9)
                    ? 2
                    : 0;
    }
    return bits;
}

/* Collective. Binary exponent by which each kind of number is scaled. Computed from maxima and
   an integer count, hence equal on all ranks. Returns 0 when a contribution is too large. n: particles of this rank. */
static int scales(const struct dem_grid_average *g, const struct dem_state *p, size_t n,
                  int scale[KINDS])
{
    double largest[KINDS] = {0.0}, out[COLUMNS];
    int64_t count = (int64_t)n;
    int bits = 0, good = 1;

    for (size_t i = 0; i < n; i++)
    {
        particle_values(&p->particles.record[i], g->virial + 6*i, out);
        for (int c = 0; c < COLUMNS; c++)
        {
            double *const max = &largest[kind_of[c]];

            *max = islessequal(fabs(out[c]), *max) ? *max : isnan(out[c]) ? INFINITY : fabs(out[c]);
        }
    }
    dem_collect_max_double(&p->decomposition, largest, KINDS);
    dem_collect_sum_int64(&p->decomposition, &count, 1);
    while (count >> bits)
    {
        bits++;
    }
    for (int k = 0; k < KINDS; k++)
    {
        int exponent;

        good = good && largest[k] < max_contribution;
        frexp(good ? largest[k] : 0.0, &exponent);
        scale[k] = MAX_BITS - bits - bits_of_images(&g->entry, &p->domain) - exponent;
    }
    return good;
}

/* Add the values of one sphere at x to the cells that it overlaps. */
static void deposit(struct dem_grid_average *g, const double x[3], double radius,
                    const double value[COLUMNS])
{
    struct slab s[3];

    for (int k = 0; k < 3; k++)
    {
        s[k] = slab_of(&g->entry, k, x[k], radius);
    }
    for (int z = s[2].first; z < s[2].first + s[2].count; z++)
    {
        const double sz = slab_fraction(&s[2], z);

        for (int y = s[1].first; y < s[1].first + s[1].count; y++)
        {
            const double sy = sz*slab_fraction(&s[1], y);

            for (int h = s[0].first; h < s[0].first + s[0].count; h++)
            {
                const double fraction = sy*slab_fraction(&s[0], h);
                int64_t *const sum =
                    g->sum +
                    COLUMNS*((size_t)h + (size_t)g->entry.cells[0]*
                                               ((size_t)y + (size_t)g->entry.cells[1]*(size_t)z));

                for (int c = 0; c < COLUMNS; c++)
                {
                    sum[c] += llrint(fraction*value[c]);
                }
            }
        }
    }
}

/* Every particle at its position and at its periodic images, which may overlap the grid too. */
static void deposit_all(struct dem_grid_average *g, const struct dem_state *p, size_t n,
                        const int scale[KINDS])
{
    const int *const periodic = p->domain.periodic;
    double out[COLUMNS];

    for (size_t i = 0; i < n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        particle_values(q, g->virial + 6*i, out);
        for (int c = 0; c < COLUMNS; c++)
        {
            out[c] = ldexp(out[c], scale[kind_of[c]]);
        }
        for (int a = -periodic[0]; a <= periodic[0]; a++)
        {
            for (int b = -periodic[1]; b <= periodic[1]; b++)
            {
                for (int c = -periodic[2]; c <= periodic[2]; c++)
                {
                    const double x[3] = {q->x[0] + a*p->domain.length[0],
                                         q->x[1] + b*p->domain.length[1],
                                         q->x[2] + c*p->domain.length[2]};

                    deposit(g, x, q->radius, out);
                }
            }
        }
    }
}

/* Collective; a rank without memory takes part without particles. */
static int sample(struct dem_grid_average *g, const struct dem_state *p, int status)
{
    const size_t cells = cells_of(g), numbers = COLUMNS*cells;
    const int short_of_memory = DEM_GROW(g->virial, g->virial_capacity, 6*(p->particles.n + 1));
    const size_t n = short_of_memory ? 0 : p->particles.n;
    int scale[KINDS];

    status = status ? status : short_of_memory;
    if (!short_of_memory)
    {
        dem_virial_sum(p, g->virial);
    }
    if (!scales(g, p, n, scale))                              /* the same on all ranks */
    {
        return status ? status : refuse_contribution(g, p);
    }
    memset(g->sum, 0, numbers*sizeof *g->sum);
    deposit_all(g, p, n, scale);
    dem_collect_sum_int64_to_first(&p->decomposition, g->sum, numbers);
    for (size_t k = 0; k < numbers && p->decomposition.rank == 0; k++)
    {
        g->sample[k] = ldexp((double)g->sum[k], -scale[kind_of[k%COLUMNS]]);
    }
    if (p->decomposition.rank == 0)
    {
        dem_block_means_add(&g->blocks, g->sample, 1.0);
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

int dem_grid_averages_sample(struct dem_grid_averages *a, const struct dem_state *p, int status)
{
    for (int k = 0; k < a->grids; k++)
    {
        struct dem_grid_average *const g = &a->grid[k];

        if (is_due(g, p->time))
        {
            status = sample(g, p, status);
            g->next = number_after(&g->entry, p->time);
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

static int save(const struct dem_grid_average *g, const char *folder)
{
    const size_t cells = cells_of(g);
    double volume = 1.0, *value, *ci;

    DEM_TRY(DEM_NEW(value, 2*RESULTS*cells));
    ci = value + RESULTS*cells;
    for (int k = 0; k < 3; k++)
    {
        volume *= (g->entry.max[k] - g->entry.min[k])/(double)g->entry.cells[k];
    }
    for (size_t c = 0; c < cells; c++)
    {
        dem_block_means_derive(&g->blocks, COLUMNS*c, COLUMNS, results, RESULTS,
                               value + RESULTS*c, ci + RESULTS*c);
        divide_by_volume(value + RESULTS*c, volume);
        divide_by_volume(ci + RESULTS*c, volume);
    }
    const struct dem_averages_quantity field[] =
    {
        {"solidFraction", "1", 1, value, ci},
        {"bulkDensity", "kg/m3", 1, value + 1, ci + 1},
        {"velocity", "m/s", 3, value + 2, ci + 2},
        {"temperature", "m2/s2", 1, value + 5, ci + 5},
        {"stress", "Pa", 6, value + 6, ci + 6},
    };
    const int status = dem_averages_io_write(folder, &g->entry, field,
                                             (int)(sizeof field/sizeof *field), RESULTS);

    dem_memory_free(value);
    return status;
}

int dem_grid_averages_write(const struct dem_grid_averages *a, const struct dem_state *p,
                            const char *folder)
{
    for (int k = 0; k < a->grids && p->decomposition.rank == 0; k++)
    {
        if (a->grid[k].blocks.samples > 0)
        {
            DEM_TRY(save(&a->grid[k], folder));
        }
    }
    return DEM_OK;
}
