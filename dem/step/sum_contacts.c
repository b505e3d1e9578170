/*
 * sum_contacts.c -- who sums which row, in the order of partner ids, is laid out by state/contacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sum_contacts.h"
#include "effects/effect.h"
#include "step/quad.h"

/* What a row does to i, and to j. */
static const double sides[2] = {1.0, -1.0};

/* The fourth lanes hold arms and spares, which go nowhere. */
DEM_KERNEL
static void sum_pushes(const struct dem_contacts *c, const struct dem_particle *record, const size_t part[2], double *restrict force,
                       double *restrict torque)
{
    const struct dem_push *const push = c->push;
    const uint32_t *const start = c->near_start, *const entry = c->near_entry;

    for (size_t i = part[0]; i < part[1]; i++)
    {
        const double radius = record[i].radius;
        dem_quad f = {0.0, 0.0, 0.0, 0.0}, t = {0.0, 0.0, 0.0, 0.0};

        for (uint32_t e = start[i], end = start[i + 1]; e < end; e++)
        {
            const struct dem_push *const from = &push[entry[e] >> 1];

            f += sides[entry[e] & 1]*DEM_QUAD(from->f);
            t += (from->arm - radius)*DEM_QUAD(from->t);
        }
        for (size_t k = 0; k < 3; k++)
        {
            force[3*i + k] = f[k];
            torque[3*i + k] = t[k];
        }
    }
}

static void add_moments(const struct dem_contacts *c, const size_t part[2], double *restrict torque)
{
    for (size_t i = part[0]; i < part[1]; i++)
    {
        for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
        {
            const double side = sides[c->near_entry[e] & 1];
            const double *const m = c->moment + 3*(c->near_entry[e] >> 1);

            torque[3*i] += side*m[0];
            torque[3*i + 1] += side*m[1];
            torque[3*i + 2] += side*m[2];
        }
    }
}

void dem_sum_contacts(struct dem_particles *p, const struct dem_contacts *c, size_t first, size_t end)
{
    double *const force = dem_column(p, DEM_COLUMN_FORCE), *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    const size_t part[2] = {first, end};

    if (first == end)
    {
        return;
    }
    sum_pushes(c, p->record, part, force, torque);
    if (c->moment)
    {
        add_moments(c, part, torque);
    }
}

/* Half of what a pair books belongs to each partner; a wall keeps no books. */
void dem_sum_books(struct dem_particles *p, const struct dem_contacts *c)
{
    double *const lost = dem_column(p, DEM_COLUMN_LOST), *const broken = dem_column(p, DEM_COLUMN_BROKEN);

    for (size_t i = 0; c->booked && i < p->n; i++)
    {
        for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
        {
            const uint32_t row = c->near_entry[e] >> 1;
            const double share = c->pair[c->row_pair[row]].wall ? 1.0 : 0.5;

            lost[i] += share*c->books[row].lost;
            broken[i] += share*c->books[row].broke;
        }
    }
}
