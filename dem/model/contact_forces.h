/*
 * contact_forces.h -- what the effects leave at each contact row, and the force buffer.
 *
 * Most rows are summed shortly after they are computed. In a step whose contact forces are not read
 * afterwards they pass through a ring buffer of DEM_FORCE_BUFFER_ROWS rows that stays in the
 * second-level cache, instead of through memory. Rows that are summed later (deferred) or that
 * belong to walls are stored at their own index as well. The buffer pays when at most one row in
 * eight is deferred.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MODEL_CONTACT_FORCES_H
#define DEM_MODEL_CONTACT_FORCES_H

#include "model/contact_rows.h"

enum
{
    DEM_FORCE_BUFFER_ROWS = 4096  /* contact forces in the force buffer, 256 kB: two layers of a bed
                                     of 40 by 40 */
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
    struct dem_contact_force *force;              /* per row */
    size_t capacity;
    struct dem_contact_moment *moment;            /* per row; NULL without `moments` */
    struct dem_contact_energy *energy;            /* per row; NULL without `has_energy` */
    int rates;                                    /* particle scalars whose rates rows have */
    double *rate;                                 /* 2 per row and scalar: what i and j receive;
                                                     NULL without `rates` */
    size_t moment_capacity;                       /* rows of these three */
    struct dem_contact_force *buffer;             /* DEM_FORCE_BUFFER_ROWS rows where it pays, else
                                                     NULL */
    struct dem_contact_moment *moment_buffer;     /* as many, with `moments` */
    size_t deferred, deferred_capacity;
    uint32_t *deferred_row;                       /* rows that are summed after the buffer has been
                                                     overwritten; ascending; no walls */
};

/* 1 when steps whose contact forces are not read afterwards use the force buffer. */
static inline int dem_contact_forces_use_buffer(const struct dem_contact_forces *c)
{
    return c->buffer != NULL;
}

/* Contact force of a row. After a step through the force buffer only rows of walls are valid. */
static inline struct dem_contact_force dem_contact_forces_at(const struct dem_contact_forces *c,
                                                             uint32_t row)
{
    return c->force[row];
}

void dem_contact_forces_free(struct dem_contact_forces *);

/* Bytes held, of the force buffer, of a row. */
size_t dem_contact_forces_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_buffer_bytes(const struct dem_contact_forces *);
size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *);

/* Moments, energies and rates of `capacity` rows, those of the first n zero. */
int dem_contact_forces_resize(struct dem_contact_forces *, size_t n, size_t capacity);
void dem_contact_forces_clear(struct dem_contact_forces *);    /* free these three */

/* Contact forces of all rows, zero until a sweep writes them; that of the row past the last stays
   zero. While history is saved there are neither rows nor contact forces: this keeps the peak of
   memory low. */
int dem_contact_forces_allocate(struct dem_contact_forces *, const struct dem_contact_rows *);
void dem_contact_forces_release(struct dem_contact_forces *);

/* After rows and adjacency are built: mark the entries that are summed from the force buffer, list
   the deferred rows, and allocate the buffer where it pays. n: owned particles. */
int dem_contact_forces_make_buffer(struct dem_contact_forces *, struct dem_contact_rows *,
                                   const struct dem_pair_list *, size_t n);

#endif
