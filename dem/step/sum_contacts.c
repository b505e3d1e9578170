/*
 * sum_contacts.c -- who sums which row, in the order of partner ids, is laid out by state/contacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sum_contacts.h"
#include <string.h>

static void sum_moments(const struct dem_contacts *c, uint32_t first, uint32_t end, double t[3])
{
    for (uint32_t e = first; e < end; e++)
    {
        const double side = c->near_entry[e] & 1 ? -1.0 : 1.0;
        const double *const m = c->moment + 3*(c->near_entry[e] >> 1);

        t[0] += side*m[0];
        t[1] += side*m[1];
        t[2] += side*m[2];
    }
}

void dem_sum_contacts(struct dem_particles *p, const struct dem_contacts *c)
{
    double *const force = dem_column(p, DEM_COLUMN_FORCE), *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    const uint32_t *const entry = c->near_entry;

    for (size_t i = 0; i < p->n; i++)
    {
        const double radius = p->record[i].radius;
        const uint32_t first = c->near_start[i], end = c->near_start[i + 1];
        double fx = 0.0, fy = 0.0, fz = 0.0, t[3] = {0.0, 0.0, 0.0};

        for (uint32_t e = first; e < end; e++)
        {
            const struct dem_push *const push = &c->push[entry[e] >> 1];
            const double side = 1.0 - 2.0*(double)(entry[e] & 1), arm = push->arm - radius;

            fx += side*push->f[0];
            fy += side*push->f[1];
            fz += side*push->f[2];
            t[0] += arm*push->t[0];
            t[1] += arm*push->t[1];
            t[2] += arm*push->t[2];
        }
        if (c->moment)
        {
            sum_moments(c, first, end, t);
        }
        force[3*i] = fx;
        force[3*i + 1] = fy;
        force[3*i + 2] = fz;
        memcpy(torque + 3*i, t, sizeof t);
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
