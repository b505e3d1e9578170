/*
 * sum_contacts.c -- sum contact forces over the rows of each particle, in the order of partner ids
 * that model/contacts.h lays out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sum_contacts.h"
#include "effects/effect.h"
#include "step/vec4.h"
#include <string.h>

/* Sign of a row's force on i, and on j. */
static const double sides[2] = {1.0, -1.0};

struct storage    /* where contact forces are: [0] deferred rows, [1] buffered rows */
{
    const struct dem_contact_force *base[2];  /* records of the rows, or the ring buffer */
    const struct dem_contact_moment *moment[2];    /* likewise, if there are moments */
    uint32_t mask[2];                         /* of the row number */
};

static struct storage storage_of(const struct dem_contacts *c, int unobserved)
{
    const struct dem_contact_forces *const f = &c->forces;

    return unobserved && f->buffer
               ? (struct storage){{f->force, f->buffer},
                                  {f->moment, f->moment_buffer},
                                  {UINT32_MAX, DEM_FORCE_BUFFER_ROWS - 1}}
               : (struct storage){{f->force, f->force},
                                  {f->moment, f->moment},
                                  {UINT32_MAX, UINT32_MAX}};
}

__attribute__((always_inline)) static inline void
add(const struct storage *at, uint32_t entry, double radius, dem_vec4 *f, dem_vec4 *t)
{
    const uint32_t buffered = (entry & DEM_ENTRY_BUFFERED)/DEM_ENTRY_BUFFERED;
    const struct dem_contact_force *const from =
        at->base[buffered] + (entry >> DEM_ENTRY_ROW_SHIFT & at->mask[buffered]);
    const dem_vec4 row_f = DEM_VEC4(from->f), row_t = DEM_VEC4(from->t);

    *f += sides[entry & DEM_ENTRY_SIDE]*row_f;
    *t += (__builtin_shufflevector(row_f, row_f, 3, 3, 3, 3) - radius)*row_t;
}

__attribute__((always_inline)) static inline void
add_moment(const struct storage *at, uint32_t entry, dem_vec4 *t)
{
    const uint32_t buffered = (entry & DEM_ENTRY_BUFFERED)/DEM_ENTRY_BUFFERED;
    const struct dem_contact_moment *const from =
        at->moment[buffered] + (entry >> DEM_ENTRY_ROW_SHIFT & at->mask[buffered]);

    *t += sides[entry & DEM_ENTRY_SIDE]*DEM_VEC4(from->m);
}

/* `moments`: 1 when rows have moments; a compile-time constant at every call. Those of a particle
   are added after its forces. */
__attribute__((always_inline)) static inline void
sum(const struct dem_contacts *c, const struct dem_particle *restrict record,
    const struct dem_sum_slice *part, const int moments)
{
    const struct storage at = storage_of(c, part->unobserved);
    const uint32_t *restrict const start = c->rows.start, *restrict const entry = c->rows.entry;

    for (size_t i = part->first; i < part->end; i++)
    {
        const double radius = record[i].radius;
        const dem_vec4 none = {0.0, 0.0, 0.0, 0.0};
        dem_vec4 f = none, t = none;

        /* two at a time, to halve the number of mispredicted loop ends; lists have an even
           length */
        for (size_t k = start[i], end = start[i + 1]; k < end; k += 2)
        {
            add(&at, entry[k], radius, &f, &t);
            add(&at, entry[k + 1], radius, &f, &t);
        }
        for (size_t k = start[i], end = start[i + 1]; moments && k < end; k += 2)
        {
            add_moment(&at, entry[k], &t);
            add_moment(&at, entry[k + 1], &t);
        }
        DEM_VEC4_AT(part->force[i - part->first]) = f;
        DEM_VEC4_AT(part->torque[i - part->first]) = __builtin_shufflevector(t, none, 0, 1, 2, 7);
    }
}

DEM_KERNEL
static void sum_forces(const struct dem_contacts *c, const struct dem_particle *restrict record,
                       const struct dem_sum_slice *part)
{
    sum(c, record, part, 0);
}

DEM_KERNEL
static void sum_forces_and_moments(const struct dem_contacts *c,
                                   const struct dem_particle *restrict record,
                                   const struct dem_sum_slice *part)
{
    sum(c, record, part, 1);
}

void dem_sum_slice(const struct dem_particles *p, const struct dem_contacts *c,
                   const struct dem_sum_slice *part)
{
    if (part->first < part->end)
    {
        (c->forces.moment ? sum_forces_and_moments : sum_forces)(c, p->record, part);
    }
}

/* Rows of four numbers into a column of three. */
static void store_column(double (*from)[4], size_t n, double *column)
{
    for (size_t k = 0; k < n; k++)
    {
        memcpy(column + 3*k, from[k], 3*sizeof *column);
    }
}

void dem_sum_store(struct dem_particles *p, const struct dem_sum_slice *part)
{
    const size_t n = part->end - part->first;

    store_column(part->force, n, dem_column(p, DEM_COLUMN_FORCE) + 3*part->first);
    store_column(part->torque, n, dem_column(p, DEM_COLUMN_TORQUE) + 3*part->first);
}

void dem_sum_contacts(struct dem_particles *p, const struct dem_contacts *c)
{
    _Alignas(64) double force[DEM_BATCH_ROWS][4], torque[DEM_BATCH_ROWS][4];
    struct dem_sum_slice part = {.force = force, .torque = torque};

    for (; part.first < p->n; part.first = part.end)
    {
        part.end = part.first + DEM_BATCH_ROWS < p->n ? part.first + DEM_BATCH_ROWS : p->n;
        dem_sum_slice(p, c, &part);
        dem_sum_store(p, &part);
    }
}

/* Each partner of a pair gets half of its energies; at a wall the particle gets all. */
void dem_sum_bond_energies(struct dem_particles *p, const struct dem_contacts *c)
{
    double *const lost = dem_column(p, DEM_COLUMN_LOST_ENERGY),
                  *const broken = dem_column(p, DEM_COLUMN_BROKEN_BONDS);

    for (size_t i = 0; c->forces.has_energy && i < p->n; i++)
    {
        for (uint32_t e = c->rows.start[i]; e < c->rows.start[i + 1]; e++)
        {
            const uint32_t row = c->rows.entry[e] >> DEM_ENTRY_ROW_SHIFT;
            const double fraction = row < c->rows.n && dem_contacts_pair(c, row)->wall ? 1.0 : 0.5;

            lost[i] += fraction*c->forces.energy[row].lost;
            broken[i] += fraction*c->forces.energy[row].broke;
        }
    }
}
