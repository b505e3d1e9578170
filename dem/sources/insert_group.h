/*
 * insert_group.h -- one group of `insert`: the settings that insert.c reads and checks and
 * insert_place.c places.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "sources/insert.h"
#include "sources/insert_clump.h"
#include "sources/insertion_limits.h"
#include "sources/insertion_shape.h"
#include "particles/scalar_entry.h"

enum dem_insert_type
{
    DEM_INSERT_LATTICE, DEM_INSERT_RANDOM, DEM_INSERT_LIST, DEM_INSERT_TABLE, DEM_INSERT_TYPES
};

struct dem_insert_group
{
    const struct dem_dict *dict;       /* lists point into it */
    char where[256];                   /* starts messages: line and path */
    enum dem_insert_type type;
    int material;
    bool frozen, driven;
    struct dem_clump_source clump;     /* with a shape: rigid bodies, inserted like spheres of the
                                          diameter that holds them */
    int64_t count, seed;
    double velocity[3], spin[3];       /* m/s, 1/s */
    double ratio;                      /* 1  of its parcels, unless there is a list; 1: none */
    double diameter;                   /* m  of all particles, unless there are diameters */
    const double *diameters;           /* m  of each, on all ranks; NULL: one for all */
    double *drawn;                     /* m  the array behind diameters, where they are computed;
                                          owned */
    struct dem_insertion_shape shape;  /* of a lattice or a random group */
    double pitch, amplitude;           /* m  between lattice sites; range of the jitter */
    int64_t sites[3];                  /* of the lattice along x, y, z */
    bool fill;                         /* 1: a lattice without count */
    struct dem_insertion_limits *limits;  /* of a lattice or a random group, or NULL; owned */
    int64_t *site;                     /* a lattice with limits: the sites of this rank's run that
                                          are taken, once these are known; owned */
    int64_t site_first, site_count;    /* number of the first one in the group, and of them */
    /* m, m/s, 1/s  of a list or table; NULL: one for all */
    const double (*positions)[3], (*velocities)[3], (*spins)[3];
    const int64_t *ids;                /* of a list or table; NULL: the next free ones */
    struct dem_scalar_entry scalar[DEM_SCALARS];    /* of all particles, unless there is a list: */
    const double *scalars[DEM_SCALARS];   /* of each of a list or table; NULL: none */
    void *table[5 + DEM_SCALARS];                    /* the arrays behind the pointers above, where the group owns
                                          them */
};

/* Read the settings of this type. */
int dem_insert_group_read_type(struct dem_insert_group *, const struct dem_interaction_table *,
                               const struct dem_insertion *, const struct dem_walls *,
                               const char *type);

/* Read the rows of a table. Arrays belong to the group, also after a failure. */
int dem_insert_group_read_table(struct dem_insert_group *, const struct dem_interaction_table *);

/* The first free id after this group, when `first` is the first free one before it. */
int64_t dem_insert_group_next_id(const struct dem_insert_group *, int64_t first);

/* Centre [m] of the m-th particle of a lattice. */
void dem_insert_group_site(const struct dem_insert_group *, int64_t m, double x[3]);

/* Diameter [m] of the m-th particle. */
static inline double dem_insert_group_diameter(const struct dem_insert_group *b, int64_t m)
{
    return b->diameters ? b->diameters[m] : b->diameter;
}

/* Collective. Place this rank's part of a group and append it to the particles. */
int dem_insert_group_place(struct dem_initial_particles *, const struct dem_insert_group *,
                           const struct dem_interaction_table *, const struct dem_domain *,
                           const struct dem_decomposition *);
