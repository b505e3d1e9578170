/*
 * totals.c -- exact sums over particles and contact rows, independent of the order of ranks and
 * particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/totals.h"
#include "core/binned_sum.h"
#include "core/vec.h"
#include "records/fingerprint.h"
#include "particles/scalars.h"
#include "records/wall_statistics.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

void dem_totals_reduce_sums(const struct dem_state *state, struct dem_sum *sum, int count,
                            double *value)
{
    for (int k = 0; k < count; k++)
    {
        dem_sum_normalise(&sum[k]);
    }
    dem_collect_sum_int64(&state->decomposition, sum[0].part, (size_t)count*DEM_SUM_PARTS);
    for (int k = 0; k < count; k++)
    {
        value[k] = dem_sum_value(&sum[k]);
    }
}

void dem_totals_reduce_max(const struct dem_state *state, double *value, int count)
{
    dem_collect_max_double(&state->decomposition, value, (size_t)count);
}

enum
{
    SUMS = 8,                                             /* of a tally */
    MAX_ROW = 1 << 20
};

double dem_totals_scalar(const struct dem_state *state, int k)
{
    const double *const value = dem_scalar_values(&state->particles, k);
    struct dem_sum sum = {0};
    double total;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];

        dem_sum_add(&sum, value[i]*dem_interaction_table_capacity(&state->interaction_table, k,
                                                                  r->material, r->mass));
    }
    dem_totals_reduce_sums(state, &sum, 1, &total);
    return total;
}

double dem_totals_max_speed(const struct dem_state *state)
{
    double squared = 0.0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const double *const v = state->particles.record[i].v;

        squared = fmax(squared, dem_vec_dot(v, v));
    }
    dem_totals_reduce_max(state, &squared, 1);
    return sqrt(squared);
}

int64_t dem_totals_moving(const struct dem_state *state, double energy)
{
    int64_t n = 0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        struct dem_particle_share s;

        dem_particle_share(&state->particles, i, &s);
        n += s.kinetic[0] + (state->particles.record[i].body ? s.kinetic[1] : 0.0) > energy;
    }
    dem_collect_sum_int64(&state->decomposition, &n, 1);
    return n;
}

double dem_totals_volume(const struct dem_state *state, const struct dem_particle *r)
{
    return r->body ? r->mass/state->interaction_table.material[r->material].density
                   : dem_particle_volume(r);
}

/* Particles in a row with the same volume, mass, moving diameter and moving mass: most, in a bed of
   equal spheres. They are added at once. */
struct row
{
    double value[4];
    int64_t n;
};

static void add_row(struct dem_sum sum[4], struct row *row)
{
    for (int k = 0; k < 4; k++)
    {
        dem_sum_add_times(&sum[k], row->value[k], row->n);
    }
    row->n = 0;
}

static void add_particle(struct dem_binned_sum *motion, struct dem_sum sum[4], struct row *row,
                         const struct dem_state *state, size_t i)
{
    const struct dem_particle *const r = &state->particles.record[i];
    const int frozen = r->flags & DEM_PARTICLE_FROZEN;
    struct dem_particle_share s;

    dem_particle_share(&state->particles, i, &s);
    const double term[DEM_BINNED_SUMS] = {s.kinetic[0] + s.kinetic[1], s.momentum[0], s.momentum[1],
                                          s.momentum[2]};

    dem_binned_sum_add(motion, term);

    const double value[4] = {dem_totals_volume(state, r), s.mass, frozen ? 0.0 : 2.0*r->radius,
                             frozen ? 0.0 : r->mass};

    if (memcmp(row->value, value, sizeof value) != 0 || row->n == MAX_ROW)
    {
        add_row(sum, row);
        memcpy(row->value, value, sizeof value);
    }
    row->n++;
}

int64_t dem_totals_touching(const struct dem_state *state)
{
    return state->contacts.forces.touching;
}

/* Elastic energy and intact bonds are counted by the owner of the lower id; energy lost and broken
   bonds are particle columns. */
static void tally_bonds(const struct dem_state *state, struct dem_totals *t)
{
    const struct dem_contacts *const c = &state->contacts;
    struct dem_sum sum[4] = {0};
    double value[4];

    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        if (c->rows.pair[r] != DEM_ROW_NONE && dem_contacts_pair(c, r)->i < state->particles.n)
        {
            dem_sum_add(&sum[0], c->forces.energy[r].stored);
            dem_sum_add(&sum[1], c->forces.energy[r].bonds);
        }
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        dem_sum_add(&sum[2], dem_column(&state->particles, DEM_COLUMN_LOST_ENERGY)[i]);
        dem_sum_add(&sum[3], dem_column(&state->particles, DEM_COLUMN_BROKEN_BONDS)[i]);
    }
    dem_totals_reduce_sums(state, sum, 4, value);
    t->stored = value[0];
    t->bonds = (int64_t)value[1];
    t->lost = value[2];
    t->broken = value[3];
}

void dem_totals_tally(struct dem_state *state, struct dem_totals *t)
{
    struct dem_binned_sum motion;
    struct dem_sum sum[SUMS] = {0};
    struct row row = {.n = 0};
    double value[SUMS], g[3];
    int64_t count[4] = {(int64_t)state->particles.n, dem_totals_touching(state), 0, 0};

    dem_binned_sum_clear(&motion);
    for (size_t i = 0; i < state->particles.n; i++)
    {
        add_particle(&motion, &sum[4], &row, state, i);
        count[2] += state->particles.record[i].body == state->particles.record[i].id + 1;
        count[3] += dem_clump_counts(&state->particles.record[i]);
    }
    add_row(&sum[4], &row);
    dem_binned_sum_flush(&motion);
    memcpy(sum, motion.sum, 4*sizeof *sum);
    dem_totals_reduce_sums(state, sum, SUMS, value);
    dem_interaction_table_gravity(&state->interaction_table, g);
    dem_collect_sum_int64(&state->decomposition, count, 4);
    dem_collect_max_double(&state->decomposition, &state->limits.overlap, 1);
    *t = (struct dem_totals){.particles = count[0],
                             .steps = state->steps,
                             .contacts = count[1],
                             .clumps = count[2],
                             .rebuilds = state->rebuilds,
                             .prunes = state->prunes,
                             .time = state->time,
                             .kinetic = value[0],
                             .largest_overlap = state->limits.overlap,
                             .momentum = {value[1], value[2], value[3]},
                             .volume = value[4],
                             .mass = value[5],
                             .fall_energy = count[0] > 0 ? dem_vec_norm(g)*value[7]*value[6]/
                                                               (double)count[0]
                                                         : 0.0,
                             .weight = dem_vec_norm(g)*value[7],
                             .bodies = count[3]};
    state->limits.earlier_overlap = fmax(state->limits.earlier_overlap, state->limits.overlap);
    state->limits.overlap = 0.0;
    if (state->contacts.forces.has_energy)
    {
        tally_bonds(state, t);
    }
}

double dem_totals_extent(const struct dem_state *state, const double along[3])
{
    const double size = dem_vec_norm(along);
    double limit[2] = {-INFINITY, -INFINITY};    /* the largest, and of the negative */

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        const double at = dem_vec_dot(r->x, along)/size;

        if (!(r->flags & DEM_PARTICLE_FROZEN))
        {
            limit[0] = fmax(limit[0], at);
            limit[1] = fmax(limit[1], -at);
        }
    }
    dem_collect_max_double(&state->decomposition, limit, 2);
    return isfinite(limit[0]) ? limit[0] + limit[1] : 0.0;
}

void dem_totals_wall_force(const struct dem_state *state, int wall, double force[3], double torque[3])
{
    struct dem_binned_sum sum;
    double value[6];

    dem_binned_sum_clear(&sum);
    if (state->wall_statistics->saved)
    {
        sum = state->wall_statistics->saved[wall];
    }
    else
    {
        dem_wall_statistics_sum_forces(state, wall, 1.0, &sum);
    }
    dem_binned_sum_flush(&sum);
    dem_totals_reduce_sums(state, sum.sum, 6, value);
    memcpy(force, value, 3*sizeof *force);
    memcpy(torque, value + 3, 3*sizeof *torque);
}

void dem_totals_wall_impulse(const struct dem_state *state, int wall, double impulse[3],
                             double twist[3])
{
    struct dem_binned_sum sum = state->wall_statistics->sum[wall];
    double value[6];

    dem_binned_sum_flush(&sum);
    dem_totals_reduce_sums(state, sum.sum, 6, value);
    memcpy(impulse, value, 3*sizeof *impulse);
    memcpy(twist, value + 3, 3*sizeof *twist);
}

double dem_totals_wall_work(const struct dem_state *state, int wall)
{
    struct dem_sum sum = state->wall_statistics->work[wall];
    double value;

    dem_totals_reduce_sums(state, &sum, 1, &value);
    return value;
}

/* ---- fingerprint ----------------------------------------------------------------------------- */

uint64_t dem_totals_fingerprint(const struct dem_state *state)
{
    const struct dem_contacts *const c = &state->contacts;
    double memory[DEM_HISTORY_COLUMNS];
    uint64_t total = 0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        struct dem_particle home = state->particles.record[i];

        dem_domain_wrap(&state->domain, &home);               /* as in a snapshot */
        total += dem_fingerprint_particle(&home);
        for (int k = 0; k < state->interaction_table.listed; k++)
        {
            total += dem_fingerprint_scalar(home.id, state->interaction_table.scalar[k]->name,
                                            dem_scalar_values(&state->particles, k)[i]);
        }
    }
    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        const int owned =
            c->rows.pair[r] != DEM_ROW_NONE && dem_contacts_pair(c, r)->i < state->particles.n;

        if (owned && dem_contact_history_any(&c->history, r))
        {
            const struct dem_contact_key name =
                dem_contacts_key(c, &state->particles, state->pairs.wall_facet, r);

            dem_contact_history_get(&c->history, r, memory);
            total += dem_fingerprint_contact(&name, memory, c->history.columns);
        }
    }
    for (size_t k = 0; k < c->history.saved; k++)
    {
        total += c->history.saved_key[k].counted
                     ? dem_fingerprint_contact(&c->history.saved_key[k],
                                               c->history.saved_value +
                                                   k*(size_t)c->history.columns,
                                               c->history.columns)
                     : 0;
    }
    dem_collect_sum_uint64(&state->decomposition, &total, 1);
    return total;
}

double dem_totals_sauter_diameter(const struct dem_state *state)
{
    struct dem_sum sum[2] = {0};
    double value[2];

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const double d = 2.0*state->particles.record[i].radius;

        dem_sum_add(&sum[0], d*d*d);
        dem_sum_add(&sum[1], d*d);
    }
    dem_totals_reduce_sums(state, sum, 2, value);
    return value[1] > 0.0 ? value[0]/value[1] : 0.0;
}

/* 1 if the flags of a particle on any rank, among those in `mask`, are these. */
static int any_flags(const struct dem_state *state, unsigned mask, unsigned flags)
{
    int64_t count = 0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        count += (state->particles.record[i].flags & mask) == flags;
    }
    dem_collect_sum_int64(&state->decomposition, &count, 1);
    return count > 0;
}

int dem_totals_any_driven(const struct dem_state *state)
{
    return any_flags(state, DEM_PARTICLE_DRIVEN, DEM_PARTICLE_DRIVEN);
}

int dem_totals_any_free(const struct dem_state *state)
{
    return any_flags(state, DEM_PARTICLE_FROZEN, 0);
}
