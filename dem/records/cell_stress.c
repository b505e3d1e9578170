/*
 * cell_stress.c -- sums over the contacts of a periodic cell, each contact once.
 *
 *   stress = -(sum f l + sum m u u)/V         f: force on i, l = x_i - x_j through periodic faces
 *   work   = -sum f.(D l) dt                  of the cell on the particles
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/cell_stress.h"
#include "core/vec.h"
#include "core/binned_sum.h"
#include "ranks/dem_state.h"
#include "records/energy_balance.h"
#include "records/totals.h"
#include <math.h>

/* The force of a row on i and the vector from j; 0: no force, a wall, or a row that another rank counts. */
static int take_row(const struct dem_state *state, uint32_t row, const double **force, double l[3],
                    double *overlap)
{
    const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row);
    const double *const f = dem_contact_forces_of_row(&state->contacts.forces, row)->f;

    if (q->wall || q->i >= state->particles.n || (f[0] == 0.0 && f[1] == 0.0 && f[2] == 0.0))
    {
        return 0;
    }
    const struct dem_particle *const i = &state->particles.record[q->i], *const j = &state->particles.record[q->j];

    for (int k = 0; k < 3; k++)
    {
        l[k] = i->x[k] - j->x[k] + state->pairs.shift[q->shift][k];
    }
    *force = f;
    *overlap = i->radius + j->radius - dem_vec_norm(l);
    return 1;
}

struct sums    /* stress times V; fabric; modulus times V, contacts, mass, solid volume */
{
    struct dem_binned_sum stress, fabric, other;
};

static void add_segment(const struct dem_state *state, const struct dem_segment *segment, struct sums *s)
{
    for (uint32_t r = segment->first; r < segment->first + segment->count; r++)
    {
        const double *f;
        double l[3], overlap;

        if (!take_row(state, r, &f, l, &overlap))
        {
            continue;
        }
        const double square = dem_vec_dot(l, l), length = sqrt(square);
        const double stiffness =
            overlap > 0.0 ? 1.5*fabs(dem_vec_dot(f, l))/(length*overlap) : 0.0;
        const double stress[6] = {-f[0]*l[0], -f[1]*l[1], -f[2]*l[2], -0.5*(f[0]*l[1] + f[1]*l[0]),
                                  -0.5*(f[1]*l[2] + f[2]*l[1]), -0.5*(f[2]*l[0] + f[0]*l[2])};
        const double fabric[6] = {l[0]*l[0]/square, l[1]*l[1]/square, l[2]*l[2]/square,
                                  l[0]*l[1]/square, l[1]*l[2]/square, l[2]*l[0]/square};
        const double other[6] = {stiffness*l[0]*l[0]*fabric[0], stiffness*l[1]*l[1]*fabric[1],
                                 stiffness*l[2]*l[2]*fabric[2], 1.0};

        dem_binned_sum_add(&s->stress, stress);
        dem_binned_sum_add(&s->fabric, fabric);
        dem_binned_sum_add(&s->other, other);
    }
}

/* Between the segments there may be rows of no contact. */
static void add_contacts(const struct dem_state *state, struct sums *s)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;

    for (int k = 0; k < rows->classes && rows->n > 0; k++)
    {
        add_segment(state, &rows->segment[k], s);
    }
}

static void add_particles(const struct dem_state *state, struct sums *s)
{
    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];
        const double m = q->mass, *const u = q->v;
        const double stress[6] = {-m*u[0]*u[0], -m*u[1]*u[1], -m*u[2]*u[2],
                                  -m*u[0]*u[1], -m*u[1]*u[2], -m*u[2]*u[0]};
        const double other[6] = {[4] = m, [5] = 4.18879020478639098*q->radius*q->radius*q->radius};

        dem_binned_sum_add(&s->stress, stress);
        dem_binned_sum_add(&s->other, other);
    }
}

void dem_cell_measure(const struct dem_state *state, struct dem_cell_measured *m)
{
    struct sums s;
    double value[18];

    dem_binned_sum_clear(&s.stress);
    dem_binned_sum_clear(&s.fabric);
    dem_binned_sum_clear(&s.other);
    add_contacts(state, &s);
    add_particles(state, &s);
    dem_binned_sum_flush(&s.stress);
    dem_binned_sum_flush(&s.fabric);
    dem_binned_sum_flush(&s.other);
    dem_totals_reduce_sums(state, s.stress.sum, 6, value);
    dem_totals_reduce_sums(state, s.fabric.sum, 6, value + 6);
    dem_totals_reduce_sums(state, s.other.sum, 6, value + 12);
    *m = (struct dem_cell_measured){.volume = state->domain.length[0]*state->domain.length[1]*state->domain.length[2],
                                    .contacts = value[15],
                                    .mass = value[16],
                                    .solid = value[17]};
    for (int k = 0; k < 6; k++)
    {
        m->stress[k] = value[k]/m->volume;
        m->fabric[k] = value[15] > 0.0 ? value[6 + k]/value[15] : 0.0;
        m->modulus[k%3] = value[12 + k%3]/m->volume;
    }
}

static void add_segment_work(struct dem_state *state, const struct dem_segment *segment, double span)
{
    const double *const rate = state->cell.flow;

    for (uint32_t r = segment->first; r < segment->first + segment->count; r++)
    {
        const double *f;
        double l[3], overlap;

        if (take_row(state, r, &f, l, &overlap))
        {
            dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_CELL],
                                   -span*(rate[0]*f[0]*l[0] + rate[1]*f[1]*l[1] + rate[2]*f[2]*l[2]
                                          + state->cell.shear_flow*f[0]*l[1]));
        }
    }
}

void dem_cell_add_work(struct dem_state *state, double span)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;

    for (int k = 0; state->cell.active && k < rows->classes && rows->n > 0; k++)
    {
        add_segment_work(state, &rows->segment[k], span);
    }
}
