/*
 * snapshot.h -- the whole state in one file: written aside, checked and renamed; read on any number of ranks.
 *
 * Layout, all in 8-byte words of the machine's own order (checked): magic, byte order, version, checksums, counts, time,
 * names (materials, columns, memory), then particles (record and columns), then remembered contacts (name and memory).
 * Columns and memory are matched by name when loading, materials too; what the file has and the scene lacks is left.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SNAPSHOT_H
#define DEM_IO_SNAPSHOT_H

#include "space/domain.h"
#include "space/pieces.h"
#include "state/contacts.h"
#include "state/particles.h"
#include "state/recipe.h"

struct dem_snapshot                                       /* what stands beside particles and contacts */
{
    int64_t particles, rows, steps;
    double time;                                          /* s */
    uint64_t checksum;                                    /* of particles and rows, order-free */
    const struct dem_domain *domain;                      /* for writing: particles are put back into its periodic box */
};

/* Collective. */
int dem_snapshot_write(const char *path, const struct dem_snapshot *, const struct dem_pieces *, const struct dem_recipe *,
                       const struct dem_particles *, const struct dem_contacts *, const int *wall_region);

/* Collective. First the particles (each rank a share of the file), then, once these are with their owners, the rows. */
int dem_snapshot_read_particles(const char *path, struct dem_snapshot *, const struct dem_pieces *, const struct dem_recipe *,
                                struct dem_particles *);
int dem_snapshot_read_rows(const char *path, const struct dem_recipe *, const struct dem_particles *, struct dem_contacts *);

/* The fingerprint of the state in a file, as dem_hash tells it of a running one. Not collective. */
int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint);

#endif
