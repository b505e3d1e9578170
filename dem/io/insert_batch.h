/*
 * insert_batch.h -- one group of `insert`, read and checked (insert.c), until its particles are placed (insert_place.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_INSERT_BATCH_H
#define DEM_IO_INSERT_BATCH_H

#include "io/insert.h"
#include "io/vessel.h"

enum dem_batch_type
{
    DEM_BATCH_LATTICE, DEM_BATCH_RANDOM, DEM_BATCH_LIST, DEM_BATCH_TABLE, DEM_BATCH_TYPES
};

struct dem_batch
{
    const struct dem_dict *dict;                          /* lists point into it */
    char where[256];                                      /* starts messages: line and path */
    enum dem_batch_type type;
    int material;
    bool frozen;
    int64_t count, seed;
    double velocity[3], spin[3];                          /* m/s, 1/s */
    double diameter;                                      /* m  of all, unless there are diameters */
    const double *diameters;                              /* m  of each, or null: all ranks know all */
    double *drawn;                                        /* m  the same, where they are the batch's own */
    struct dem_vessel vessel;                             /* of a lattice or at random */
    double pitch, amplitude;                              /* m: between the sites of a lattice, and of the shake */
    int64_t sites[3];
    const double (*positions)[3], (*velocities)[3], (*spins)[3];   /* of a list or table; null: the same for all */
    const int64_t *ids;                                   /* the same; null: the next free ones */
    void *table[5];                                       /* what the above point to, where it is the batch's own */
};

/* Read the rows of a table. */
int dem_batch_read_table(struct dem_batch *);

/* The first id that is free behind this group, when `first` is free before it. */
int64_t dem_batch_next_id(const struct dem_batch *, int64_t first);

/* Centre [m] of the m-th particle of a lattice. */
void dem_batch_site(const struct dem_batch *, int64_t m, double x[3]);

/* Diameter [m] of the m-th. */
static inline double dem_batch_diameter(const struct dem_batch *b, int64_t m)
{
    return b->diameters ? b->diameters[m] : b->diameter;
}

/* Collective. Place this rank's share of one batch behind the particles that are there. */
int dem_batch_place(struct dem_crowd *, const struct dem_batch *, const struct dem_recipe *, const struct dem_pieces *);

#endif
