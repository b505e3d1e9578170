/*
 * contact_forces.h -- what the effects leave at each contact row: forces, moments, energies, rates of
 * particle scalars.
 *
 * Forces and moments are records in slots. In a small scene the slot of a row is its number. In a
 * large one rows of pairs pass through the first slots, a ring buffer that stays in the
 * second-level cache: a particle is summed shortly after its last row has been computed, and then
 * the slot is used again. Rows that are summed later are deferred: they are copied to slots of
 * their own behind the ring. Rows of walls have slots of their own, too. The ring is the smallest
 * in which at most one row in eight is deferred; a scene that needs a larger one has none.
 *
 * So after a step only rows of walls have their forces. `all_rows` keeps the forces of all rows after
 * an observed step. A step is observed if something reads the state after it: the end of a window, a
 * sample, a backup, the energy balance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "contacts/contact_rows.h"

enum
{
    DEM_FORCE_BUFFER_ROWS = 4096,      /* slots of the smallest ring, 256 kB of forces: two layers
                                          of a bed of 40 by 40 */
    DEM_FORCE_BUFFER_MAX_ROWS = 16384  /* slots of the largest ring */
};

/* contact force of a row; one cache line */
struct dem_contact_force
{
    double f[3], arm;             /* N on i; m: the lever arm of a side is radius - arm */
    double t[3], spare;           /* N: n x F; torque on a side: -(radius - arm) t */
};

/* moment of a row that acts on its sides whatever the lever arms, of rolling or of a bond; half a
   cache line */
struct dem_contact_moment
{
    double m[3], spare;           /* N m on i; the opposite on j */
};

/* energies of a row, see laws/batch.h */
struct dem_contact_energy
{
    double stored, lost;          /* J, J in the last step */
    double bonds, broke;          /* bonds that hold, that broke in the last step */
};

struct dem_contact_forces
{
    /* 1: an effect makes moments; one acts past touching */
    int moments, has_energy;
    /* 1: bonds, averages or the virial read the forces of all rows */
    int all_rows;
    /* slots of the ring, a power of two; 0: none */
    uint32_t ring;
    /* per slot */
    struct dem_contact_force *force;
    /* per slot; NULL without `moments` */
    struct dem_contact_moment *moment;
    /* slots */
    size_t capacity;
    /* slots behind the ring */
    size_t own_slots, slot_row_capacity;
    /* per slot behind the ring: its row; the first has none, the force 0 */
    uint32_t *slot_row;
    /* from this one on they are of deferred rows, ascending; before it of walls */
    size_t first_deferred;
    /* a bit per row: 1 where it is deferred */
    uint64_t *deferred;
    /* per word of deferred: bits before it */
    uint32_t *deferred_before;
    /* words */
    size_t deferred_capacity, before_capacity;
    /* per row; NULL without ring or `all_rows` */
    struct dem_contact_force *row_force;
    struct dem_contact_moment *row_moment;
    size_t row_force_capacity;
    /* per row; NULL without `has_energy` */
    struct dem_contact_energy *energy;
    /* particle scalars whose rates rows have */
    int rates;
    /* 2 per row and scalar: what i and j receive; NULL without `rates` */
    double *rate;
    /* rows of energy and rate */
    size_t row_capacity;
    /* rows with overlap whose i is owned; valid after an observed step */
    int64_t touching;
};

/* Force and moment of any row after an observed step, with `all_rows`. */
static inline const struct dem_contact_force *
dem_contact_forces_of_row(const struct dem_contact_forces *c, uint32_t row)
{
    return (c->ring ? c->row_force : c->force) + row;
}

static inline const struct dem_contact_moment *
dem_contact_moments_of_row(const struct dem_contact_forces *c, uint32_t row)
{
    return (c->ring ? c->row_moment : c->moment) + row;
}

/* The slot of the first row of a batch. */
static inline uint32_t dem_contact_forces_slot(const struct dem_contact_forces *c,
                                               const struct dem_segment *segment, int with_wall,
                                               uint32_t row)
{
    return with_wall || !c->ring ? segment->slot + (row - segment->first) : row & (c->ring - 1);
}

/* The oldest row in the ring when a particle is summed, at the end of the stretch of rows that holds the
   last one it needs; below 0 while the ring has not been filled. */
static inline int64_t dem_contact_forces_oldest(const struct dem_contact_forces *c,
                                                const struct dem_contact_rows *rows,
                                                size_t particle)
{
    return (int64_t)rows->needed[particle/DEM_BATCH_ROWS] + DEM_STRETCH_ROWS - (int64_t)c->ring;
}

/* The row of an entry of a particle; the one past the last where the entry has none. */
static inline uint32_t dem_contact_forces_row(const struct dem_contact_forces *c,
                                              const struct dem_contact_rows *rows, size_t particle,
                                              uint32_t entry)
{
    const uint32_t slot = entry >> DEM_ENTRY_SLOT_SHIFT;
    const uint32_t oldest = (uint32_t)dem_contact_forces_oldest(c, rows, particle);

    return !c->ring         ? slot
           : slot < c->ring ? oldest + ((slot - oldest) & (c->ring - 1))
                            : c->slot_row[slot - c->ring];
}

void dem_contact_forces_free(struct dem_contact_forces *);

/* Bytes held; of the smallest ring; of a row of a pair in a scene without ring, or at most with
   one. */
size_t dem_contact_forces_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_ring_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *, int ring);

/* After rows and adjacency are built: choose whether there is a ring, and assign slots to entries and
   segments, which have the numbers of rows so far. n: owned particles. */
int dem_contact_forces_assign_slots(struct dem_contact_forces *, struct dem_contact_rows *,
                                    size_t n);

/* Energies and rates of `capacity` rows, zero for the first n. */
int dem_contact_forces_resize(struct dem_contact_forces *, size_t n, size_t capacity);
void dem_contact_forces_clear(struct dem_contact_forces *);    /* free these */

/* Forces and moments, to be written by a sweep; entries without a row have zeros. While history
   is saved there are neither rows nor contact forces: this keeps the peak of memory low. */
int dem_contact_forces_allocate(struct dem_contact_forces *, const struct dem_contact_rows *);
void dem_contact_forces_release(struct dem_contact_forces *);
