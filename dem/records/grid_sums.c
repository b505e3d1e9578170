/*
 * grid_sums.c -- distribute numbers of particles over the cells of a grid, and sum them without an
 * order.
 *
 * 1. Each particle's numbers are distributed over the cells that it overlaps.
 * 2. The contributions are converted to integers, so that the sum over particles and ranks does not
 *    depend on the order.
 * 3. Each sample is added to the block sums (core/block_means.h) on the first rank.
 *
 * Unit of the integers: the largest contribution of one particle anywhere over 2^b. b leaves enough
 * bits for all particles in one cell; with a million particles b = 42, which is 2e-13 of the
 * largest. A cell wider than a periodic box contains a particle up to three times along that axis,
 * which takes two bits more. So no sum can overflow. A contribution that is not finite, or too
 * large for products of means, ends the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/grid_sums.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <string.h>

enum
{
    MAX_BITS = 61             /* of a sum, without its sign */
};

/* Limit of a contribution of one particle, SI units: squares of sums of squares stay finite. */
static const double max_contribution = 1e60;

/* ---- set-up ---------------------------------------------------------------------------------- */

size_t dem_averages_cells(const struct dem_averages_entry *p)
{
    return (size_t)p->cells[0]*(size_t)p->cells[1]*(size_t)p->cells[2];
}

int dem_grid_sums_init(struct dem_grid_sums *g, const struct dem_averages_entry *p, int columns,
                       int collects)
{
    const size_t numbers = (size_t)columns*dem_averages_cells(p);

    g->columns = columns;
    DEM_TRY(DEM_NEW(g->sum, numbers));
    DEM_TRY(DEM_NEW(g->sample, numbers));
    return dem_block_means_init(&g->blocks, collects ? numbers : 0);
}

void dem_grid_sums_free(struct dem_grid_sums *g)
{
    dem_memory_free(g->sum);
    dem_memory_free(g->sample);
    dem_block_means_free(&g->blocks);
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

/* DEM_ERROR_NUMBER with the first particle of this rank that has a contribution above the limit. */
static int refuse_contribution(const struct dem_averages_entry *a, const struct dem_grid_columns *s,
                               const struct dem_state *state)
{
    double out[DEM_GRID_COLUMNS];

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];

        s->values(s, state, i, out);
        for (int c = 0; c < s->columns; c++)
        {
            DEM_REQUIRE(
                isless(fabs(out[c]), max_contribution), DEM_ERROR_NUMBER,
                "averages/%s: particle %lld at (%g %g %g) m with (%g %g %g) m/s has %s %g %s in step %lld, the "
                "limit is %g; look at the forces on it, or use a smaller time/step",
                a->name, (long long)q->id, q->x[0], q->x[1], q->x[2], q->v[0], q->v[1],
                q->v[2], s->kind_name[s->kind_of[c]], out[c], s->kind_unit[s->kind_of[c]],
                (long long)state->steps, max_contribution);
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
static int scales(const struct dem_averages_entry *a, const struct dem_grid_columns *s,
                  const struct dem_state *state, size_t n, int scale[DEM_GRID_KINDS])
{
    double largest[DEM_GRID_KINDS] = {0.0}, out[DEM_GRID_COLUMNS];
    int64_t count = (int64_t)n;
    int bits = 0, good = 1;

    for (size_t i = 0; i < n; i++)
    {
        s->values(s, state, i, out);
        for (int c = 0; c < s->columns; c++)
        {
            double *const max = &largest[s->kind_of[c]];

            *max = islessequal(fabs(out[c]), *max) ? *max : isnan(out[c]) ? INFINITY : fabs(out[c]);
        }
    }
    dem_collect_max_double(&state->decomposition, largest, (size_t)s->kinds);
    dem_collect_sum_int64(&state->decomposition, &count, 1);
    while (count >> bits)
    {
        bits++;
    }
    for (int k = 0; k < s->kinds; k++)
    {
        int exponent;

        good = good && largest[k] < max_contribution;
        frexp(good ? largest[k] : 0.0, &exponent);
        scale[k] = MAX_BITS - bits - bits_of_images(a, &state->domain) - exponent;
    }
    return good;
}

/* Add the values of one sphere at x to the cells that it overlaps. */
static void deposit(struct dem_grid_sums *g, const struct dem_averages_entry *a, const double x[3],
                    double radius, const double *value)
{
    const size_t columns = (size_t)g->columns;
    struct slab s[3];

    for (int k = 0; k < 3; k++)
    {
        s[k] = slab_of(a, k, x[k], radius);
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
                    g->sum + columns*((size_t)h + (size_t)a->cells[0]*
                                                      ((size_t)y + (size_t)a->cells[1]*(size_t)z));

                for (size_t c = 0; c < columns; c++)
                {
                    sum[c] += llrint(fraction*value[c]);
                }
            }
        }
    }
}

/* Every particle at its position and at its periodic images, which may overlap the grid too. */
static void deposit_all(struct dem_grid_sums *g, const struct dem_averages_entry *entry,
                        const struct dem_grid_columns *s, const struct dem_state *state, size_t n,
                        const int scale[DEM_GRID_KINDS])
{
    const int *const periodic = state->domain.periodic;
    double out[DEM_GRID_COLUMNS];

    for (size_t i = 0; i < n; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];

        s->values(s, state, i, out);
        for (int c = 0; c < s->columns; c++)
        {
            out[c] = ldexp(out[c], scale[s->kind_of[c]]);
        }
        for (int a = -periodic[0]; a <= periodic[0]; a++)
        {
            for (int b = -periodic[1]; b <= periodic[1]; b++)
            {
                for (int c = -periodic[2]; c <= periodic[2]; c++)
                {
                    const double x[3] = {q->x[0] + a*state->domain.length[0],
                                         q->x[1] + b*state->domain.length[1],
                                         q->x[2] + c*state->domain.length[2]};

                    deposit(g, entry, x, q->radius, out);
                }
            }
        }
    }
}

int dem_grid_sums_sample(struct dem_grid_sums *g, const struct dem_averages_entry *entry,
                         const struct dem_grid_columns *s, const struct dem_state *state, size_t n,
                         int status)
{
    const size_t numbers = (size_t)g->columns*dem_averages_cells(entry);
    int scale[DEM_GRID_KINDS];

    if (!scales(entry, s, state, n, scale))                              /* the same on all ranks */
    {
        return status ? status : refuse_contribution(entry, s, state);
    }
    memset(g->sum, 0, numbers*sizeof *g->sum);
    deposit_all(g, entry, s, state, n, scale);
    dem_collect_sum_int64_to_first(&state->decomposition, g->sum, numbers);
    for (size_t k = 0; k < numbers && state->decomposition.rank == 0; k++)
    {
        g->sample[k] = ldexp((double)g->sum[k], -scale[s->kind_of[k%(size_t)g->columns]]);
    }
    if (state->decomposition.rank == 0)
    {
        dem_block_means_add(&g->blocks, g->sample, 1.0);
    }
    return status;
}
