/*
 * virial.c -- each particle sums the contribution of its rows in the same fixed order as its force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/virial.h"
#include "core/vec.h"
#include "particles/clump.h"
#include <string.h>

/* Unit vector from the partner or the wall to particle i of the row. */
static void direction(const struct dem_state *state, const struct dem_pair *q, double n[3])
{
    const struct dem_particle *const i = &state->particles.record[q->i];

    if (q->wall)
    {
        memcpy(n, state->touches.touch[q->j].normal, 3*sizeof *n);
        return;
    }
    const struct dem_particle *const j = &state->particles.record[q->j];

    for (int k = 0; k < 3; k++)
    {
        n[k] = i->x[k] - j->x[k] + state->pairs.shift[q->shift][k];
    }
    const double length = dem_vec_norm(n);

    for (int k = 0; k < 3; k++)
    {
        n[k] = length > 0.0 ? n[k]/length : 0.0;
    }
}

/* Add `factor` times the symmetric part of f r^T: xx yy zz xy yz zx. */
static void add_product(double factor, const double f[3], const double r[3], double w[6])
{
    for (int k = 0; k < 3; k++)
    {
        const int next = (k + 1)%3;

        w[k] += factor*f[k]*r[k];
        w[3 + k] += 0.5*factor*(f[k]*r[next] + f[next]*r[k]);
    }
}

/* On i the force f acts at -lever n, on j the force -f at +lever n: both give -lever f n. */
static void add_row(const struct dem_state *state, uint32_t row, double radius, double w[6])
{
    const struct dem_contact_force *const contact =
        dem_contact_forces_of_row(&state->contacts.forces, row);
    const double lever = radius - contact->arm, *const f = contact->f;
    double n[3];

    if (f[0] == 0.0 && f[1] == 0.0 && f[2] == 0.0)
    {
        return;
    }
    direction(state, dem_contacts_pair(&state->contacts, row), n);
    add_product(-lever, f, n, w);
}

/* The force f on a sphere of a clump acts at the sphere's centre, off the centre of the clump. */
static void add_arm(const struct dem_clump *b, const double f[3], double w[6])
{
    double arm[3];

    dem_clump_rotate(b->q, b->offset, arm);
    add_product(1.0, f, arm, w);
}

void dem_virial_sum(const struct dem_state *state, double *virial)
{
    const struct dem_contacts *const c = &state->contacts;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        double *const w = virial + 6*i;

        memset(w, 0, 6*sizeof *w);
        for (uint32_t e = c->rows.start[i]; e < c->rows.start[i + 1]; e++)
        {
            const uint32_t row = dem_contact_forces_row(&c->forces, &c->rows, i, c->rows.entry[e]);

            if (row < c->rows.n)
            {
                add_row(state, row, state->particles.record[i].radius, w);
            }
        }
        const struct dem_clump *const b = dem_clump_of(&state->particles, i);

        if (b)
        {
            add_arm(b, dem_column(&state->particles, DEM_COLUMN_FORCE) + 3*i, w);
        }
    }
}
