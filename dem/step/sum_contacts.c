/*
 * sum_contacts.c -- sum contact forces over the rows of each particle, in the order of partner ids
 * that contacts/contact_rows.h lays out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sum_contacts.h"
#include "laws/effect.h"
#include "core/vec4.h"
#include <string.h>

typedef int64_t mask8 __attribute__((vector_size(64), aligned(16)));
typedef int64_t mask4 __attribute__((vector_size(32), aligned(16), may_alias));

/* Sign of a row's force on i, and on j. */
static const double sides[2] = {1.0, -1.0};

_Static_assert(DEM_ENTRIES_AT_ONCE == 2, "the loops below take two entries at a time");
_Static_assert(sizeof(struct dem_contact_force) == 8 << DEM_ENTRY_SLOT_SHIFT &&
                   sizeof(struct dem_contact_moment) == 4 << DEM_ENTRY_SLOT_SHIFT,
               "records of a slot follow from an entry without a shift");

/* The record of an entry's slot: `bytes` are the bytes of a record over 2^DEM_ENTRY_SLOT_SHIFT. */
__attribute__((always_inline)) static inline const void *record_of(const void *records,
                                                                   uint32_t entry, size_t bytes)
{
    return (const char *)records + bytes*(entry & ~((1u << DEM_ENTRY_SLOT_SHIFT) - 1));
}

/* Adds {f, arm, t, spare} of a row, times its sign and times the lever arm. */
__attribute__((always_inline)) static inline void
add(const struct dem_contact_forces *at, uint32_t entry, double radius, dem_vec8 *sum)
{
    const dem_vec8 row = DEM_VEC8(record_of(at->force, entry, 8));
    const double side = sides[entry & DEM_ENTRY_SIDE];
    const dem_vec8 sign = {side, side, side, side, side, side, side, side};
    const dem_vec8 lever = __builtin_shufflevector(row, row, 3, 3, 3, 3, 3, 3, 3, 3) - radius;

    *sum += __builtin_shufflevector(sign, lever, 0, 1, 2, 3, 12, 13, 14, 15)*row;
}

/* The sums of the slice, without a branch that depends on the number of rows of a particle: the sum
   so far is stored after every DEM_ENTRIES_AT_ONCE, and cleared after the last of them. */
__attribute__((always_inline)) static inline void
sum(const struct dem_contacts *c, const struct dem_particle *restrict record,
    const struct dem_sum_slice *part)
{
    const struct dem_contact_forces at = c->forces;
    const uint32_t *const entry = c->rows.entry, *const end = entry + c->rows.start[part->end];
    struct dem_contact_sum *restrict to = part->sum;
    dem_vec8 total = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

    record += part->first;
    for (const uint32_t *e = entry + c->rows.start[part->first]; e < end; e += DEM_ENTRIES_AT_ONCE)
    {
        const int64_t last = e[1]/DEM_ENTRY_LAST & 1, keep = last - 1;

        add(&at, e[0], record->radius, &total);
        add(&at, e[1], record->radius, &total);
        DEM_VEC8_AT(to->force) = total;
        total = (dem_vec8)((mask8)total & (mask8){keep, keep, keep, keep, keep, keep, keep, keep});
        to += last;
        record += last;
    }
}

/* Moments of the rows, added to the torques of the slice, likewise: after the last row of a particle
   goes on the torque of the next one. */
__attribute__((always_inline)) static inline void
add_moments(const struct dem_contacts *c, const struct dem_sum_slice *part)
{
    const struct dem_contact_moment *const moment = c->forces.moment;
    const uint32_t *const entry = c->rows.entry, *const end = entry + c->rows.start[part->end];
    struct dem_contact_sum *to = part->sum;
    dem_vec4 total = DEM_VEC4(to->torque);

    for (const uint32_t *e = entry + c->rows.start[part->first]; e < end; e += DEM_ENTRIES_AT_ONCE)
    {
        const int64_t last = e[1]/DEM_ENTRY_LAST & 1, keep = last - 1;
        const mask4 same = {keep, keep, keep, keep};

        total += sides[e[0] & DEM_ENTRY_SIDE]*DEM_VEC4(record_of(moment, e[0], 4));
        total += sides[e[1] & DEM_ENTRY_SIDE]*DEM_VEC4(record_of(moment, e[1], 4));
        DEM_VEC4_AT(to->torque) = total;
        total = (dem_vec4)(((mask4)total & same) | (*(const mask4 *)to[1].torque & ~same));
        to += last;
    }
}

DEM_KERNEL
static void sum_forces(const struct dem_contacts *c, const struct dem_particle *restrict record,
                       const struct dem_sum_slice *part)
{
    sum(c, record, part);
}

DEM_KERNEL
static void sum_forces_and_moments(const struct dem_contacts *c,
                                   const struct dem_particle *restrict record,
                                   const struct dem_sum_slice *part)
{
    sum(c, record, part);
    add_moments(c, part);
}

void dem_sum_slice(const struct dem_particles *particles, const struct dem_contacts *c,
                   const struct dem_sum_slice *part)
{
    if (part->first < part->end)
    {
        (c->forces.moment ? sum_forces_and_moments : sum_forces)(c, particles->record, part);
    }
}

void dem_sum_store(struct dem_particles *particles, const struct dem_sum_slice *part)
{
    double *const force = dem_column(particles, DEM_COLUMN_FORCE) + 3*part->first,
                  *const torque = dem_column(particles, DEM_COLUMN_TORQUE) + 3*part->first;

    for (size_t k = 0; k < part->end - part->first; k++)
    {
        memcpy(force + 3*k, part->sum[k].force, 3*sizeof *force);
        memcpy(torque + 3*k, part->sum[k].torque, 3*sizeof *torque);
    }
}

/* Each partner of a pair gets half of its energies; at a wall the particle gets all. */
void dem_sum_bond_energies(struct dem_particles *particles, const struct dem_contacts *c)
{
    double *const lost = dem_column(particles, DEM_COLUMN_LOST_ENERGY),
                  *const broken = dem_column(particles, DEM_COLUMN_BROKEN_BONDS);

    for (size_t i = 0; c->forces.has_energy && i < particles->n; i++)
    {
        for (uint32_t e = c->rows.start[i]; e < c->rows.start[i + 1]; e++)
        {
            const uint32_t row = dem_contact_forces_row(&c->forces, &c->rows, i, c->rows.entry[e]);
            const double fraction = row < c->rows.n && dem_contacts_pair(c, row)->wall ? 1.0 : 0.5;

            lost[i] += fraction*c->forces.energy[row].lost;
            broken[i] += fraction*c->forces.energy[row].broke;
        }
    }
}
