/*
 * averages.c -- particles into cells as whole numbers, samples into blocks, blocks into tables.
 *
 * Sums over particles must not depend on who adds first, so numbers become integers in units that all ranks know: the largest contribution of one
 * particle anywhere, over 2^b, with b as many bits as leave room for all particles in one cell. A million particles leave 42 bits, 2e-13 of the
 * largest. A cell wider than a periodic box sees a particle up to three times along that axis: two bits more. So no sum overflows, whatever the
 * particles do; what is not finite, or beyond what products of means can hold, ends the run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/averages.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include "step/parts.h"
#include "step/virial.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    VOLUME,
    MASS,
    MOMENTUM,
    FLUX = MOMENTUM + 3,                                      /* m v v: xx yy zz xy yz zx */
    VIRIAL = FLUX + 6,
    COLUMNS = VIRIAL + 6,

    KINDS = 5,                                                /* columns of one unit share a scale */
    RESULTS = 12,

    MOST_BITS = 61                                            /* of a sum, besides its sign */
};

static const int kind_of[COLUMNS] = {0, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4};

static const char *const kind_name[KINDS] = {"volume", "mass", "momentum", "m v v", "virial of its contacts"};
static const char *const kind_unit[KINDS] = {"m3", "kg", "kg m/s", "J", "J"};

static const double most_part = 1e60;                         /* of one particle, SI: squares of sums of squares of so many stay finite */
static const double most_number = 0x1p53;                     /* of a sample: whole numbers that a double tells apart */

/* Times that differ by less than this share of an interval are the same: they are sums of steps, and round. */
static const double same_time = 1e-6;

/* ---- making -------------------------------------------------------------------------------------------------- */

static size_t cells_of(const struct dem_average *g)
{
    return (size_t)g->plan.cells[0]*(size_t)g->plan.cells[1]*(size_t)g->plan.cells[2];
}

/* Number of the first sample after a time: the same after a restart as without. */
static int64_t number_after(const struct dem_average_plan *p, double time)
{
    return (int64_t)fmin(floor((time - p->start)/p->interval + same_time), most_number) + 1;
}

int dem_averages_init(struct dem_averages *a, const struct dem_average_plan *plan, int n, double time, int collects)
{
    DEM_TRY(DEM_NEW(a->grid, (size_t)n + 1));
    a->grids = n;
    for (int k = 0; k < n; k++)
    {
        struct dem_average *const g = &a->grid[k];

        g->plan = plan[k];
        g->next = time > g->plan.start ? number_after(&g->plan, time) : 0;
        DEM_TRY(DEM_NEW(g->sum, COLUMNS*cells_of(g)));
        DEM_TRY(DEM_NEW(g->sample, COLUMNS*cells_of(g)));
        DEM_TRY(dem_blocks_init(&g->blocks, collects ? COLUMNS*cells_of(g) : 0));
    }
    return DEM_OK;
}

void dem_averages_free(struct dem_averages *a)
{
    for (int k = 0; k < a->grids; k++)
    {
        dem_memory_free(a->grid[k].sum);
        dem_memory_free(a->grid[k].sample);
        dem_memory_free(a->grid[k].virial);
        dem_blocks_free(&a->grid[k].blocks);
    }
    dem_memory_free(a->grid);
    *a = (struct dem_averages){.grids = 0};
}

/* ---- shares -------------------------------------------------------------------------------------------------- */

struct slab                                                   /* the cells along one axis that a sphere is in */
{
    int first, count;
    double lower, width;                                      /* m: edge of the grid, of a cell */
    double x, radius;
};

static struct slab slab_of(const struct dem_average_plan *p, int axis, double x, double radius)
{
    const double width = (p->max[axis] - p->min[axis])/(double)p->cells[axis];
    const double from = floor((x - radius - p->min[axis])/width), to = floor((x + radius - p->min[axis])/width);
    const int first = from < 0.0 ? 0 : from > p->cells[axis] ? p->cells[axis] : (int)from;
    const int last = to < 0.0 ? -1 : to >= p->cells[axis] ? p->cells[axis] - 1 : (int)to;

    return (struct slab){.first = first, .count = last - first + 1, .lower = p->min[axis], .width = width, .x = x, .radius = radius};
}

/* Share of the sphere's volume below a plane. */
static double below(const struct slab *s, double plane)
{
    const double h = fmax(-1.0, fmin(1.0, (plane - s->x)/s->radius));

    return 0.25*(2.0 + 3.0*h - h*h*h);
}

static double share(const struct slab *s, int cell)
{
    return below(s, s->lower + (double)(cell + 1)*s->width) - below(s, s->lower + (double)cell*s->width);
}

/* ---- one sample ---------------------------------------------------------------------------------------------- */

static void contribution(const struct dem_particle *q, const double *virial, double out[COLUMNS])
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

/* Who has what can't be summed: this rank's first, in words. */
static int refuse_part(const struct dem_average *g, const struct dem_parts *p)
{
    double out[COLUMNS];

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        contribution(q, g->virial + 6*i, out);
        for (int c = 0; c < COLUMNS; c++)
        {
            DEM_REQUIRE(isless(fabs(out[c]), most_part), DEM_ERROR_NUMBER, "averages/%s: particle %lld at (%g %g %g) m with (%g %g %g) m/s has %s %g %s "
                        "in step %lld, the limit is %g; look at the forces on it, or use a smaller time/step", g->plan.name, (long long)q->id, q->x[0],
                        q->x[1], q->x[2], q->v[0], q->v[1], q->v[2], kind_name[kind_of[c]], out[c], kind_unit[kind_of[c]], (long long)p->steps, most_part);
        }
    }
    return DEM_OK;
}

/* Bits that images of one particle in one cell take. */
static int bits_of_images(const struct dem_average_plan *a, const struct dem_domain *d)
{
    int bits = 0;

    for (int k = 0; k < 3; k++)
    {
        bits += d->periodic[k] && (a->max[k] - a->min[k])/(double)a->cells[k] > d->length[k]*(1.0 + 1e-9) ? 2 : 0;
    }
    return bits;
}

/* Bits to shift each kind of number by. The largest are maxima and the count a whole number: all ranks agree. 0: one is too large. */
static int scales(const struct dem_average *g, const struct dem_parts *p, int scale[KINDS])
{
    double most[KINDS] = {0.0}, out[COLUMNS];
    int64_t count = (int64_t)p->particles.n;
    int bits = 0, good = 1;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        contribution(&p->particles.record[i], g->virial + 6*i, out);
        for (int c = 0; c < COLUMNS; c++)
        {
            most[kind_of[c]] = islessequal(fabs(out[c]), most[kind_of[c]]) ? most[kind_of[c]] : isnan(out[c]) ? INFINITY : fabs(out[c]);
        }
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, most, KINDS, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT64_T, MPI_SUM, p->pieces.comm);
    }
    while (count >> bits)
    {
        bits++;
    }
    for (int k = 0; k < KINDS; k++)
    {
        int exponent;

        good = good && most[k] < most_part;
        frexp(good ? most[k] : 0.0, &exponent);
        scale[k] = MOST_BITS - bits - bits_of_images(&g->plan, &p->domain) - exponent;
    }
    return good;
}

/* The cells of one sphere at one place. */
static void deposit(struct dem_average *g, const double x[3], double radius, const double value[COLUMNS])
{
    struct slab s[3];

    for (int k = 0; k < 3; k++)
    {
        s[k] = slab_of(&g->plan, k, x[k], radius);
    }
    for (int z = s[2].first; z < s[2].first + s[2].count; z++)
    {
        const double sz = share(&s[2], z);

        for (int y = s[1].first; y < s[1].first + s[1].count; y++)
        {
            const double sy = sz*share(&s[1], y);

            for (int h = s[0].first; h < s[0].first + s[0].count; h++)
            {
                const double part = sy*share(&s[0], h);
                int64_t *const sum = g->sum + COLUMNS*((size_t)h + (size_t)g->plan.cells[0]*((size_t)y
                                                       + (size_t)g->plan.cells[1]*(size_t)z));

                for (int c = 0; c < COLUMNS; c++)
                {
                    sum[c] += llrint(part*value[c]);
                }
            }
        }
    }
}

/* Every particle where it is, and at its images: parts of it may look in over a periodic face. */
static void deposit_all(struct dem_average *g, const struct dem_parts *p, const int scale[KINDS])
{
    const int *const periodic = p->domain.periodic;
    double out[COLUMNS];

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        contribution(q, g->virial + 6*i, out);
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
                    const double x[3] = {q->x[0] + a*p->domain.length[0], q->x[1] + b*p->domain.length[1],
                                         q->x[2] + c*p->domain.length[2]};

                    deposit(g, x, q->radius, out);
                }
            }
        }
    }
}

static int sample(struct dem_average *g, const struct dem_parts *p, int status)
{
    const size_t cells = cells_of(g), numbers = COLUMNS*cells;
    int scale[KINDS];

    DEM_TRY(DEM_GROW(g->virial, g->virial_room, 6*(p->particles.n + 1)));
    dem_virial_sum(p, g->virial);
    if (!scales(g, p, scale))                                 /* on all ranks alike */
    {
        return status ? status : refuse_part(g, p);
    }
    memset(g->sum, 0, numbers*sizeof *g->sum);
    deposit_all(g, p, scale);
    if (p->pieces.ranks > 1)
    {
        MPI_Reduce(p->pieces.rank ? g->sum : MPI_IN_PLACE, g->sum, (int)numbers, MPI_INT64_T, MPI_SUM, 0, p->pieces.comm);
    }
    for (size_t k = 0; k < numbers && p->pieces.rank == 0; k++)
    {
        g->sample[k] = ldexp((double)g->sum[k], -scale[kind_of[k%COLUMNS]]);
    }
    if (p->pieces.rank == 0)
    {
        dem_blocks_add(&g->blocks, g->sample);
    }
    return status;
}

static int is_due(const struct dem_average *g, double time)
{
    const double due = g->plan.start + ((double)g->next - same_time)*g->plan.interval;

    return time >= due && due <= g->plan.end;
}

int dem_averages_due(const struct dem_averages *a, double time)
{
    int due = 0;

    for (int k = 0; k < a->grids; k++)
    {
        due |= is_due(&a->grid[k], time);
    }
    return due;
}

int dem_averages_sample(struct dem_averages *a, const struct dem_parts *p, int status)
{
    for (int k = 0; k < a->grids; k++)
    {
        struct dem_average *const g = &a->grid[k];

        if (is_due(g, p->time))
        {
            status = sample(g, p, status);
            g->next = number_after(&g->plan, p->time);
        }
    }
    return status;
}

/* ---- results ------------------------------------------------------------------------------------------------- */

/* Sums over the cell, not yet by its volume. Order: volume, mass, velocity, temperature, stress. */
static void results(const double *mean, double *out)
{
    const double mass = mean[MASS], *const momentum = mean + MOMENTUM;
    const double by = mass > 0.0 ? 1.0/mass : 0.0;

    out[0] = mean[VOLUME];
    out[1] = mass;
    for (int k = 0; k < 3; k++)
    {
        out[2 + k] = by*momentum[k];
    }
    out[5] = by*(mean[FLUX] + mean[FLUX + 1] + mean[FLUX + 2] - by*dem_vec_dot(momentum, momentum))/3.0;
    for (int k = 0; k < 3; k++)
    {
        out[6 + k] = mean[VIRIAL + k] - mean[FLUX + k] + by*momentum[k]*momentum[k];
        out[9 + k] = mean[VIRIAL + 3 + k] - mean[FLUX + 3 + k] + by*momentum[k]*momentum[(k + 1)%3];
    }
}

static void by_volume(double *out, double volume)
{
    for (int k = 0; k < RESULTS; k++)
    {
        out[k] = k < 2 || k > 5 ? out[k]/volume : out[k];
    }
}

static int save(const struct dem_average *g, const char *folder)
{
    const size_t cells = cells_of(g);
    double volume = 1.0, *value, *ci;

    DEM_TRY(DEM_NEW(value, 2*RESULTS*cells));
    ci = value + RESULTS*cells;
    for (int k = 0; k < 3; k++)
    {
        volume *= (g->plan.max[k] - g->plan.min[k])/(double)g->plan.cells[k];
    }
    for (size_t c = 0; c < cells; c++)
    {
        dem_blocks_derive(&g->blocks, COLUMNS*c, COLUMNS, results, RESULTS, value + RESULTS*c, ci + RESULTS*c);
        by_volume(value + RESULTS*c, volume);
        by_volume(ci + RESULTS*c, volume);
    }
    const struct dem_average_field field[] =
    {
        {"solidFraction", "1", 1, value, ci},
        {"bulkDensity", "kg/m3", 1, value + 1, ci + 1},
        {"velocity", "m/s", 3, value + 2, ci + 2},
        {"temperature", "m2/s2", 1, value + 5, ci + 5},
        {"stress", "Pa", 6, value + 6, ci + 6},
    };
    const int status = dem_averages_write(folder, &g->plan, field, (int)(sizeof field/sizeof *field), RESULTS);

    dem_memory_free(value);
    return status;
}

int dem_averages_save(const struct dem_averages *a, const struct dem_parts *p, const char *folder)
{
    for (int k = 0; k < a->grids && p->pieces.rank == 0; k++)
    {
        if (a->grid[k].blocks.samples > 0)
        {
            DEM_TRY(save(&a->grid[k], folder));
        }
    }
    return DEM_OK;
}
