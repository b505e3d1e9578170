/*
 * contact_forces.h -- what the effects leave at each contact row: forces, moments, energies, rates of
 * particle scalars.
 *
 * Forces and moments lie in places. In a small scene the place of a row is its number. In a large one
 * rows of pairs pass through a ring buffer of DEM_FORCE_BUFFER_ROWS places that stays in the
 * second-level cache, instead of through memory: a particle is summed shortly after its last row has
 * been computed. Rows that are summed later (deferred) are copied to a place of their own behind the
 * ring, and so are those of walls. The ring is used where at most one row in eight is deferred.
 *
 * After a step all contact forces are there only where something reads them: see `keep`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MODEL_CONTACT_FORCES_H
#define DEM_MODEL_CONTACT_FORCES_H

#include "effects/batch.h"
#include "model/contact_rows.h"

enum
{
    DEM_FORCE_BUFFER_ROWS = 4096  /* places of the ring, 256 kB: two layers of a bed of 40 by 40 */
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

/* energies of a row, see effects/batch.h */
struct dem_contact_energy
{
    double stored, lost;          /* J, J in the last step */
    double bonds, broke;          /* bonds that hold, that broke in the last step */
};

struct dem_contact_forces
{
    int moments, has_energy;                      /* 1: an effect makes moments; one acts past
                                                     touching */
    int keep;                                     /* 1: after an observed step the forces of all rows
                                                     are read */
    uint32_t ring;                                /* DEM_FORCE_BUFFER_ROWS, or 0: no ring */
    struct dem_contact_force *force;              /* per place */
    struct dem_contact_moment *moment;            /* per place; NULL without `moments` */
    size_t capacity;                              /* places */
    uint32_t *kept_row;                           /* row of each place behind the ring; the first
                                                     has no row, and force 0 */
    size_t kept, kept_capacity;
    size_t first_deferred;                        /* the first of kept_row that is deferred;
                                                     ascending from there on */
    struct dem_contact_force *row_force;          /* per row; NULL without ring or without `keep` */
    struct dem_contact_moment *row_moment;
    size_t row_force_capacity;
    struct dem_contact_energy *energy;            /* per row; NULL without `has_energy` */
    int rates;                                    /* particle scalars whose rates rows have */
    double *rate;                                 /* 2 per row and scalar: what i and j receive;
                                                     NULL without `rates` */
    size_t row_capacity;                          /* rows of these two */
    int64_t touching;                             /* rows with overlap in the last observed step whose
                                                     i is owned */
};

/* Force and moment of any row after an observed step, with `keep`. */
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

/* The place of the first row of a batch. */
static inline uint32_t dem_contact_forces_place(const struct dem_contact_forces *c,
                                                const struct dem_segment *segment, int with_wall,
                                                uint32_t row)
{
    return with_wall || !c->ring ? segment->place + (row - segment->first) : row & (c->ring - 1);
}

/* The row of an entry of a particle; the one past the last where the entry has none. */
static inline uint32_t dem_contact_forces_row(const struct dem_contact_forces *c,
                                              const struct dem_contact_rows *rows, size_t particle,
                                              uint32_t entry)
{
    const uint32_t place = entry >> DEM_ENTRY_PLACE_SHIFT;
    /* the oldest row in the ring when this particle is summed */
    const uint32_t oldest = rows->needed[particle/DEM_BATCH_ROWS] + 2*DEM_BATCH_ROWS - c->ring;

    return !c->ring          ? place
           : place < c->ring ? oldest + ((place - oldest) & (c->ring - 1))
                             : c->kept_row[place - c->ring];
}

void dem_contact_forces_free(struct dem_contact_forces *);

/* Bytes held; of the ring; of a row in a scene without ring, or with one. */
size_t dem_contact_forces_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_ring_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *, int ring);

/* After rows and adjacency are built: choose whether there is a ring, and give rows their places:
   those of entries and segments change. n: owned particles. */
int dem_contact_forces_place_rows(struct dem_contact_forces *, struct dem_contact_rows *,
                                  const struct dem_pair_list *, size_t n);

/* Energies and rates of `capacity` rows, those of the first n zero. */
int dem_contact_forces_resize(struct dem_contact_forces *, size_t n, size_t capacity);
void dem_contact_forces_clear(struct dem_contact_forces *);    /* free these */

/* Forces and moments, zero until a sweep writes them. While history is saved there are neither rows
   nor contact forces: this keeps the peak of memory low. */
int dem_contact_forces_allocate(struct dem_contact_forces *, const struct dem_contact_rows *);

/* From the next observed step on, keep the forces of all rows. */
int dem_contact_forces_keep(struct dem_contact_forces *, const struct dem_contact_rows *);
void dem_contact_forces_release(struct dem_contact_forces *);

#endif
