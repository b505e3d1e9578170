/*
 * measure.c -- exact sums: the order in which ranks and particles come does not matter.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/measure.h"
#include "base/vec.h"
#include "io/fingerprint.h"
#include <math.h>
#include <string.h>

void dem_measure_sums(const struct dem_parts *p, struct dem_sum *sum, int count, double *value)
{
    for (int k = 0; k < count; k++)
    {
        dem_sum_normalise(&sum[k]);
        if (p->pieces.ranks > 1)
        {
            MPI_Allreduce(MPI_IN_PLACE, sum[k].part, DEM_SUM_PARTS, MPI_INT64_T, MPI_SUM, p->pieces.comm);
        }
        value[k] = dem_sum_value(&sum[k]);
    }
}

void dem_measure_most(const struct dem_parts *p, double *value, int count)
{
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, value, count, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
    }
}

enum
{
    SUMS = 8                                              /* of a tally */
};

static double kinetic(const struct dem_particle *r)
{
    const double inertia = 0.4*r->mass*r->radius*r->radius;

    return 0.5*r->mass*dem_vec_dot(r->v, r->v) + 0.5*inertia*dem_vec_dot(r->w, r->w);
}

int64_t dem_measure_moving(const struct dem_parts *p, double energy)
{
    int64_t n = 0;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        n += kinetic(&p->particles.record[i]) > energy;
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_INT64_T, MPI_SUM, p->pieces.comm);
    }
    return n;
}

static void add_particle(struct dem_sum sum[SUMS], const struct dem_particle *r)
{
    dem_sum_add(&sum[0], kinetic(r));
    for (int k = 0; k < 3; k++)
    {
        dem_sum_add(&sum[1 + k], r->mass*r->v[k]);
    }
    dem_sum_add(&sum[4], dem_particle_volume(r));
    dem_sum_add(&sum[5], r->mass);
    dem_sum_add(&sum[6], r->flags & DEM_PARTICLE_FROZEN ? 0.0 : 2.0*r->radius);
    dem_sum_add(&sum[7], r->flags & DEM_PARTICLE_FROZEN ? 0.0 : r->mass);
}

int64_t dem_measure_touching(const struct dem_parts *p)
{
    const struct dem_contacts *const c = &p->contacts;
    int64_t count = 0;

    for (uint32_t r = 0; r < c->rows; r++)
    {
        count += dem_contacts_push(c, r).arm > 0.0 && c->row_pair[r] != DEM_ROW_NONE && c->pair[c->row_pair[r]].i < p->particles.n;
    }
    return count;
}

/* What is stored and holds is counted by the owner of the lower particle; what is lost and broken stands with particles. */
static void tally_books(const struct dem_parts *p, struct dem_tally *t)
{
    const struct dem_contacts *const c = &p->contacts;
    struct dem_sum sum[4];
    double value[4];

    for (int k = 0; k < 4; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] != DEM_ROW_NONE && c->pair[c->row_pair[r]].i < p->particles.n)
        {
            dem_sum_add(&sum[0], c->books[r].stored);
            dem_sum_add(&sum[1], c->books[r].bonds);
        }
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        dem_sum_add(&sum[2], dem_column(&p->particles, DEM_COLUMN_LOST)[i]);
        dem_sum_add(&sum[3], dem_column(&p->particles, DEM_COLUMN_BROKEN)[i]);
    }
    dem_measure_sums(p, sum, 4, value);
    t->stored = value[0];
    t->bonds = (int64_t)value[1];
    t->lost = value[2];
    t->broken = value[3];
}

void dem_measure_tally(struct dem_parts *p, struct dem_tally *t)
{
    struct dem_sum sum[SUMS];
    double value[SUMS], g[3];
    int64_t count[2] = {(int64_t)p->particles.n, dem_measure_touching(p)};

    for (int k = 0; k < SUMS; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        add_particle(sum, &p->particles.record[i]);
    }
    dem_measure_sums(p, sum, SUMS, value);
    dem_recipe_vector(&p->recipe, "gravity", "acceleration", g);
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_INT64_T, MPI_SUM, p->pieces.comm);
        MPI_Allreduce(MPI_IN_PLACE, &p->watch.overlap, 1, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
    }
    *t = (struct dem_tally){.particles = count[0], .steps = p->steps, .contacts = count[1], .rebuilds = p->rebuilds,
                            .prunes = p->prunes, .time = p->time, .kinetic = value[0], .largest_overlap = p->watch.overlap,
                            .momentum = {value[1], value[2], value[3]}, .volume = value[4], .mass = value[5],
                            .fall = count[0] > 0 ? dem_vec_norm(g)*value[7]*value[6]/(double)count[0] : 0.0};
    for (int k = 0; k < p->flows.n; k++)
    {
        *(p->flows.flow[k].kind != DEM_FLOW_OUTLET ? &t->inserted : &t->removed) += p->flows.flow[k].count;
    }
    p->watch.most = fmax(p->watch.most, p->watch.overlap);
    p->watch.overlap = 0.0;
    if (p->contacts.booked)
    {
        tally_books(p, t);
    }
}

void dem_measure_wall(const struct dem_parts *p, int wall, double force[3], double torque[3])
{
    struct dem_sum sum[6];
    double value[6];

    for (int k = 0; k < 6; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    dem_wall_books_sum(p, wall, 1.0, sum);
    dem_measure_sums(p, sum, 6, value);
    memcpy(force, value, 3*sizeof *force);
    memcpy(torque, value + 3, 3*sizeof *torque);
}

void dem_measure_impulse(const struct dem_parts *p, int wall, double impulse[3], double twist[3])
{
    struct dem_sum sum[6];
    double value[6];

    memcpy(sum, p->books.sum + 6*wall, sizeof sum);
    dem_measure_sums(p, sum, 6, value);
    memcpy(impulse, value, 3*sizeof *impulse);
    memcpy(twist, value + 3, 3*sizeof *twist);
}

/* ---- fingerprint --------------------------------------------------------------------------------------------- */

uint64_t dem_measure_hash(const struct dem_parts *p)
{
    const struct dem_contacts *const c = &p->contacts;
    double memory[DEM_MEMORY_COLUMNS];
    uint64_t total = 0;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        struct dem_particle home = p->particles.record[i];

        dem_domain_wrap(&p->domain, &home);               /* as a snapshot has it */
        total += dem_fingerprint_particle(&home);
    }
    for (uint32_t r = 0; r < c->rows; r++)
    {
        const int mine = c->row_pair[r] != DEM_ROW_NONE && c->pair[c->row_pair[r]].i < p->particles.n;

        if (mine && dem_contacts_remembers(c, r))
        {
            const struct dem_carried name = dem_contacts_name(c, &p->particles, p->pairs.wall_region, r);

            dem_contacts_recall(c, r, memory);
            total += dem_fingerprint_row(&name, memory, c->memories);
        }
    }
    for (size_t k = 0; k < c->carried; k++)
    {
        total += c->carry[k].counted ? dem_fingerprint_row(&c->carry[k], c->kept + k*(size_t)c->memories, c->memories) : 0;
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_UINT64_T, MPI_SUM, p->pieces.comm);
    }
    return total;
}

double dem_measure_overlap(struct dem_parts *p, int64_t *i, int64_t *j, double x[3])
{
    double worst = 0.0;

    dem_wall_touches_update(&p->touches, &p->pairs.search, &p->walls, &p->particles);
    for (uint32_t r = 0; r < p->contacts.rows; r++)
    {
        const struct dem_pair *const q = p->contacts.row_pair[r] == DEM_ROW_NONE ? NULL : &p->contacts.pair[p->contacts.row_pair[r]];
        const struct dem_particle *const a = q ? &p->particles.record[q->i] : NULL;
        double overlap = 0.0, least = 1.0;

        if (q && q->wall)
        {
            overlap = a->radius - p->touches.touch[q->j].distance;
            least = a->radius;
        }
        else if (q)
        {
            const struct dem_particle *const b = &p->particles.record[q->j];
            const double *const s = p->pairs.shift[q->shift];
            const double d[3] = {a->x[0] - b->x[0] + s[0], a->x[1] - b->x[1] + s[1], a->x[2] - b->x[2] + s[2]};

            overlap = a->radius + b->radius - dem_vec_norm(d);
            least = fmin(a->radius, b->radius);
        }
        if (q && 0.5*overlap/least > worst)
        {
            worst = 0.5*overlap/least;
            *i = a->id;
            *j = q->wall ? -1 - p->pairs.wall_region[q->j] : p->particles.record[q->j].id;
            memcpy(x, a->x, sizeof a->x);
        }
    }
    return worst;
}

double dem_measure_sauter(const struct dem_parts *p)
{
    struct dem_sum sum[2];
    double value[2];

    dem_sum_clear(&sum[0]);
    dem_sum_clear(&sum[1]);
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const double d = 2.0*p->particles.record[i].radius;

        dem_sum_add(&sum[0], d*d*d);
        dem_sum_add(&sum[1], d*d);
    }
    dem_measure_sums(p, sum, 2, value);
    return value[1] > 0.0 ? value[0]/value[1] : 0.0;
}
