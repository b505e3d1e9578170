/*
 * snapshot.h -- the whole state in one file: written aside by all ranks, checked and renamed; read on any number of ranks.
 *
 * Layout, all in 8-byte words of the machine's own order (checked): magic, byte order, version, checksums, counts, time,
 * the window at hand, books of streams and outlets, names (materials, columns, memory), then particles (record and columns), then
 * remembered contacts (name and memory), then bytes of the caller's own. Columns and memory are matched by name when loading, materials too; what the file has
 * and the scene lacks is left. No rank ever holds more than its share: blocks are packed, summed and written one after the other.
 *
 * A state in the middle of a window (a run that was told to stop) has velocities half a step ahead of positions; what the
 * window was is in the head.
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

struct dem_snapshot_window                                /* one that is not over */
{
    int64_t ahead, done;                                  /* steps of it, and those made; ahead 0: none is open */
    double opened, dt;                                    /* s: its start, its step */
};

struct dem_span
{
    const void *data;
    size_t size;                                          /* bytes, a multiple of 8 */
};

enum
{
    DEM_SNAPSHOT_LEARNT = 24,                             /* words */
    DEM_SNAPSHOT_FLOWS = 24
};

struct dem_snapshot_flow                                  /* what has come in by a stream or gone out by an outlet: step/flows.h */
{
    char name[48];
    int64_t kind, count;                                  /* 1 a stream of numbers, 3 of kilograms, 2 an outlet */
    double mass, momentum[3], energy;                     /* kg, kg m/s, J */
    double rate, start, end;                              /* of a stream: in force */
    double owed, since, last;                             /* of a stream: particles or kg at `since` [s]; s of the last look */
};

struct dem_snapshot                                       /* what stands beside particles and contacts */
{
    int64_t particles, rows, steps;
    double time;                                          /* s */
    struct dem_snapshot_window window;
    int64_t learnt[DEM_SNAPSHOT_LEARNT];                  /* of how thick lists should be, as it lies in memory: who goes on keeps particles in the same order */
    int64_t flows, next_id;                               /* next_id: free for who comes in next; 0 where nobody does */
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS];
    const struct dem_domain *domain;                      /* for writing: particles are put back into its periodic box */
    const struct dem_span *beside;                        /* the caller's own, for writing: of the first rank */
    int besides;
};

/* Collective. */
int dem_snapshot_write(const char *path, const struct dem_snapshot *, const struct dem_pieces *, const struct dem_recipe *,
                       const struct dem_particles *, const struct dem_contacts *, const int *wall_region);

/* Collective. First the particles (each rank a share of the file), then, once these are with their owners, the rows: again a share
   each, which goes to the owners of the partners. */
int dem_snapshot_read_particles(const char *path, struct dem_snapshot *, const struct dem_pieces *, const struct dem_recipe *,
                                struct dem_particles *);
int dem_snapshot_read_rows(const char *path, const struct dem_pieces *, const struct dem_recipe *, const struct dem_particles *,
                           struct dem_contacts *);

/* The caller's own bytes, for one rank; NULL when there are none. The caller frees them. Not collective. */
int dem_snapshot_read_beside(const char *path, void **bytes, size_t *size);

/* The fingerprint of the state in a file, as dem_hash tells it of a running one. Not collective. */
int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint);

#endif
