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

typedef float eight __attribute__((vector_size(32), aligned(32), may_alias));

/* Force and torque of a push: the fourth lanes hold arms and spares, which go nowhere. Eight at once, which gcc widens twice as fast as
   two times four. `single`: a constant for the compiler. */
__attribute__((always_inline)) static inline void
take(const void *restrict push, size_t row, const int single, dem_quad *f, dem_quad *t)
{
    if (single)
    {
        typedef double wide __attribute__((vector_size(64)));

        const wide both = __builtin_convertvector(*(const eight *)(const void *)((const struct dem_push_single *)push + row), wide);

        *f = __builtin_shufflevector(both, both, 0, 1, 2, 3);
        *t = __builtin_shufflevector(both, both, 4, 5, 6, 7);
    }
    else
    {
        *f = DEM_QUAD(((const struct dem_push *)push)[row].f);
        *t = DEM_QUAD(((const struct dem_push *)push)[row].t);
    }
}

__attribute__((always_inline)) static inline void
add(const void *restrict push, uint32_t entry, const int single, double radius, dem_quad *f, dem_quad *t)
{
    dem_quad row_f, row_t;

    take(push, entry >> 1, single, &row_f, &row_t);
    *f += sides[entry & 1]*row_f;
    *t += (__builtin_shufflevector(row_f, row_f, 3, 3, 3, 3) - radius)*row_t;
}

__attribute__((always_inline)) static inline void
sum(const struct dem_contacts *c, const struct dem_particle *restrict record, const size_t part[2], double *const column[2], const int single)
{
    const void *restrict const push = single ? (const void *)c->push_single : (const void *)c->push;
    const uint32_t *restrict const start = c->near_start, *restrict const entry = c->near_entry;
    double *restrict const force = column[0], *restrict const torque = column[1];
    const size_t past = part[1];

    for (size_t i = part[0]; i < past; i++)
    {
        const double radius = record[i].radius;
        dem_quad f = {0.0, 0.0, 0.0, 0.0}, t = {0.0, 0.0, 0.0, 0.0};

        /* by twos: half as many ends of a loop to guess */
        for (size_t k = start[i], end = start[i + 1]; k < end; k += 2)
        {
            add(push, entry[k], single, radius, &f, &t);
            add(push, entry[k + 1], single, radius, &f, &t);
        }
        for (size_t k = 0; k < 3; k++)
        {
            force[3*i + k] = f[k];
            torque[3*i + k] = t[k];
        }
    }
}

DEM_KERNEL
static void sum_pushes(const struct dem_contacts *c, const struct dem_particle *record, const size_t part[2], double *column[2])
{
    sum(c, record, part, column, 0);
}

DEM_KERNEL
static void sum_single_pushes(const struct dem_contacts *c, const struct dem_particle *record, const size_t part[2], double *column[2])
{
    sum(c, record, part, column, 1);
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
    double *column[2] = {dem_column(p, DEM_COLUMN_FORCE), dem_column(p, DEM_COLUMN_TORQUE)};
    const size_t part[2] = {first, end};

    if (first == end)
    {
        return;
    }
    (c->single ? sum_single_pushes : sum_pushes)(c, p->record, part, column);
    if (c->moment)
    {
        add_moments(c, part, column[1]);
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
            const double share = row < c->rows && c->pair[c->row_pair[row]].wall ? 1.0 : 0.5;

            lost[i] += share*c->books[row].lost;
            broken[i] += share*c->books[row].broke;
        }
    }
}
