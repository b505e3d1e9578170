/*
 * survey.c -- one walk over particles and lists.
 *
 * Sums are exact, so that a plan reads the same on any number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/survey.h"
#include "step/measure.h"
#include <math.h>
#include <string.h>

enum
{
    SUMS = 6                                              /* of one material */
};

static void count_particles(const struct dem_parts *p, int material, struct dem_stock *s)
{
    struct dem_sum sum[SUMS];
    double value[SUMS], ends[2] = {INFINITY, 0.0};
    int64_t count[2] = {0, 0};

    for (int k = 0; k < SUMS; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const r = &p->particles.record[i];
        const double d = 2.0*r->radius, volume = dem_particle_volume(r), moves = r->flags & DEM_PARTICLE_FROZEN ? 0.0 : 1.0;
        const double term[SUMS] = {d, d*d, volume, r->mass, moves*volume, moves*r->mass};

        if (r->material != material)
        {
            continue;
        }
        for (int k = 0; k < SUMS; k++)
        {
            dem_sum_add(&sum[k], term[k]);
        }
        count[0]++;
        count[1] += moves == 0.0;
        ends[0] = fmin(ends[0], d);
        ends[1] = fmin(ends[1], -d);
    }
    dem_measure_sums(p, sum, SUMS, value);
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_INT64_T, MPI_SUM, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, ends, 2, MPI_DOUBLE, MPI_MIN, p->pieces.comm);
    }
    *s = (struct dem_stock){.n = count[0], .frozen = count[1], .least = ends[0], .most = -ends[1], .diameters = value[0],
                            .squares = value[1], .volume = value[2], .mass = value[3], .moving_volume = value[4],
                            .moving_mass = value[5]};
}

static void add_up(struct dem_stock *all, const struct dem_stock *s)
{
    all->n += s->n;
    all->frozen += s->frozen;
    all->least = fmin(all->least, s->least);
    all->most = fmax(all->most, s->most);
    all->diameters += s->diameters;
    all->squares += s->squares;
    all->volume += s->volume;
    all->mass += s->mass;
    all->moving_volume += s->moving_volume;
    all->moving_mass += s->moving_mass;
}

static void mean_fluid(const struct dem_parts *p, struct dem_survey *s)
{
    const double *const rho = dem_column(&p->particles, DEM_COLUMN_FLUID_DENSITY);
    const double *const mu = dem_column(&p->particles, DEM_COLUMN_FLUID_VISCOSITY);
    struct dem_sum sum[2];
    double value[2];

    dem_sum_clear(&sum[0]);
    dem_sum_clear(&sum[1]);
    for (size_t i = 0; rho && i < p->particles.n; i++)
    {
        dem_sum_add(&sum[0], rho[i]);
        dem_sum_add(&sum[1], mu[i]);
    }
    dem_measure_sums(p, sum, 2, value);
    s->fluid_density = s->all.n > 0 ? value[0]/(double)s->all.n : 0.0;
    s->fluid_viscosity = s->all.n > 0 ? value[1]/(double)s->all.n : 0.0;
}

static double held(const struct dem_parts *p)
{
    return (double)(dem_particles_bytes(&p->particles) + dem_contacts_bytes(&p->contacts) + dem_pairs_bytes(&p->pairs)
                    + p->touches.room*sizeof *p->touches.touch + p->walls.triangle_room*sizeof *p->walls.triangle);
}

void dem_survey_take(const struct dem_parts *p, struct dem_survey *s)
{
    double bytes[2] = {held(p), held(p)};
    int64_t lists[2] = {(int64_t)p->contacts.pairs, 0};

    memset(s, 0, sizeof *s);
    s->all.least = INFINITY;
    for (int m = 0; m < p->recipe.materials; m++)
    {
        count_particles(p, m, &s->material[m]);
        add_up(&s->all, &s->material[m]);
    }
    mean_fluid(p, s);
    for (int c = 0; c < p->contacts.classes && p->contacts.rows > 0; c++)
    {
        lists[1] += p->contacts.segment[c].count;
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, lists, 2, MPI_INT64_T, MPI_SUM, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, &bytes[0], 1, MPI_DOUBLE, MPI_SUM, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, &bytes[1], 1, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
    }
    s->pairs = lists[0];
    s->rows = lists[1];
    s->bytes = bytes[0];
    s->most_bytes = bytes[1];
}
