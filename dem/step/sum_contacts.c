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

struct places                                             /* where pushes are: at their rows; those that are summed soon perhaps in the ring */
{
    const void *base[2];
    uint32_t mask[2];
};

static struct places places_of(const struct dem_contacts *c, int quiet)
{
    const void *const push = c->single ? (const void *)c->push_single : (const void *)c->push;
    const void *const ring = c->single ? (const void *)c->ring_single : (const void *)c->ring;

    return quiet && ring ? (struct places){{push, ring}, {UINT32_MAX, DEM_RING - 1}} : (struct places){{push, push}, {UINT32_MAX, UINT32_MAX}};
}

__attribute__((always_inline)) static inline void
add(const struct places *at, uint32_t entry, const int single, double radius, dem_quad *f, dem_quad *t)
{
    const uint32_t soon = (entry & DEM_ENTRY_SOON)/DEM_ENTRY_SOON;
    dem_quad row_f, row_t;

    take(at->base[soon], entry >> DEM_ENTRY_ROW & at->mask[soon], single, &row_f, &row_t);
    *f += sides[entry & DEM_ENTRY_SIDE]*row_f;
    *t += (__builtin_shufflevector(row_f, row_f, 3, 3, 3, 3) - radius)*row_t;
}

__attribute__((always_inline)) static inline void
sum(const struct dem_contacts *c, const struct dem_particle *restrict record, const struct dem_sum_part *part, const int single)
{
    const struct places at = places_of(c, part->quiet);
    const uint32_t *restrict const start = c->near_start, *restrict const entry = c->near_entry;
    double *restrict force = part->force, *restrict torque = part->torque;

    for (size_t i = part->first; i < part->end; i++)
    {
        const double radius = record[i].radius;
        dem_quad f = {0.0, 0.0, 0.0, 0.0}, t = {0.0, 0.0, 0.0, 0.0};

        /* by twos: half as many ends of a loop to guess */
        for (size_t k = start[i], end = start[i + 1]; k < end; k += 2)
        {
            add(&at, entry[k], single, radius, &f, &t);
            add(&at, entry[k + 1], single, radius, &f, &t);
        }
        for (size_t k = 0; k < 3; k++)
        {
            *force++ = f[k];
            *torque++ = t[k];
        }
    }
}

DEM_KERNEL
static void sum_pushes(const struct dem_contacts *c, const struct dem_particle *record, const struct dem_sum_part *part)
{
    sum(c, record, part, 0);
}

DEM_KERNEL
static void sum_single_pushes(const struct dem_contacts *c, const struct dem_particle *record, const struct dem_sum_part *part)
{
    sum(c, record, part, 1);
}

static void add_moments(const struct dem_contacts *c, const struct dem_sum_part *part)
{
    for (size_t i = part->first; i < part->end; i++)
    {
        double *const torque = part->torque + 3*(i - part->first);

        for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
        {
            const double side = sides[c->near_entry[e] & DEM_ENTRY_SIDE];
            const double *const m = c->moment + 3*(c->near_entry[e] >> DEM_ENTRY_ROW);

            torque[0] += side*m[0];
            torque[1] += side*m[1];
            torque[2] += side*m[2];
        }
    }
}

void dem_sum_part(const struct dem_particles *p, const struct dem_contacts *c, const struct dem_sum_part *part)
{
    if (part->first == part->end)
    {
        return;
    }
    (c->single ? sum_single_pushes : sum_pushes)(c, p->record, part);
    if (c->moment)
    {
        add_moments(c, part);
    }
}

void dem_sum_contacts(struct dem_particles *p, const struct dem_contacts *c)
{
    dem_sum_part(p, c, &(struct dem_sum_part){.end = p->n, .force = dem_column(p, DEM_COLUMN_FORCE), .torque = dem_column(p, DEM_COLUMN_TORQUE)});
}

/* Half of what a pair books belongs to each partner; a wall keeps no books. */
void dem_sum_books(struct dem_particles *p, const struct dem_contacts *c)
{
    double *const lost = dem_column(p, DEM_COLUMN_LOST), *const broken = dem_column(p, DEM_COLUMN_BROKEN);

    for (size_t i = 0; c->booked && i < p->n; i++)
    {
        for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
        {
            const uint32_t row = c->near_entry[e] >> DEM_ENTRY_ROW;
            const double share = row < c->rows && c->pair[c->row_pair[row]].wall ? 1.0 : 0.5;

            lost[i] += share*c->books[row].lost;
            broken[i] += share*c->books[row].broke;
        }
    }
}
