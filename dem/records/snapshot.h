/*
 * snapshot.h -- checkpoint of the whole state in one file, written by all ranks and read on any
 * number of ranks.
 *
 * The file is written under a temporary name, synchronised and renamed. Layout, in 8-byte words of
 * the machine's byte order (checked when reading):
 *
 *   1. header: magic, byte order, version, checksums, counts, time, the open window, flow records
 *      of inlet streams and outlets, names (materials, columns, history)
 *   2. particles: record and columns
 *   3. contacts with history: ids and history
 *   4. data of the caller: averages, then the scene (snapshot_scene.h)
 *
 * Columns, history and materials are matched by name when loading; data of the file that the scene
 * does not use are ignored. No rank holds more than its slice of the file: blocks are packed,
 * summed and written one after the other.
 *
 * A state inside a window (of a run that was asked to stop) has velocities half a step ahead of
 * positions; the header describes that window.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "ranks/decomposition.h"
#include "contacts/contacts.h"
#include "particles/particles.h"
#include "laws/interaction_table.h"

struct dem_snapshot_window    /* a window that is not complete */
{
    int64_t ahead, done;      /* its steps, and those done; ahead 0: no window is open */
    double opened, dt;        /* s: its start time, its time step */
};

struct dem_span                                           /* a part of the caller's data */
{
    const void *data;
    size_t size;                                          /* bytes, a multiple of 8 */
};

enum
{
    DEM_SNAPSHOT_SKIN_TUNING = 24,                             /* words */
    DEM_SNAPSHOT_FLOWS = 24
};

/* Totals of the particles inserted by a stream or removed by an outlet, see sources/flows.h.
   Stored raw. */
struct dem_snapshot_flow
{
    char name[48];
    /* kind: 1 stream by number, 3 stream by mass, 2 outlet */
    int64_t kind, count;
    /* kg, kg m/s, J */
    double mass, momentum[3], energy;
    /* of a stream: present settings */
    double rate, start, end;
    /* of a stream: particles or kg due at time `since` [s]; time of the last insertion check [s] */
    double owed, since, last;
};

struct dem_snapshot                         /* the state besides particles and contacts */
{
    int64_t particles, rows, steps;
    /* s */
    double time;
    struct dem_snapshot_window window;
    /* state of the skin tuning, raw: a restart keeps the particles in the same order */
    int64_t skin_tuning[DEM_SNAPSHOT_SKIN_TUNING];
    /* next_id: of the next inserted particle; 0: no streams */
    int64_t flows, next_id;
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS];
    /* when read: bit k: the file has scalar k of the interaction table */
    uint32_t scalars;
    /* when writing: particles are wrapped into its periodic box */
    const struct dem_domain *domain;
    /* when writing: the caller's data, of the first rank */
    const struct dem_span *caller_data;
    int caller_data_count;
};

/* Collective. Write the state; a file of that name from before is replaced only when all is
   written. wall_region: the region of each wall, see dem_contacts_key. */
int dem_snapshot_write(const char *path, const struct dem_snapshot *,
                       const struct dem_decomposition *, const struct dem_interaction_table *,
                       const struct dem_particles *, const struct dem_contacts *,
                       const struct dem_facet_key *wall_facet);

/* Collective. Read first the particles (each rank a slice of the file), then, when these have
   migrated to their owners, the contacts: again a slice each, which is sent to the owners of
   both partners. DEM_ERROR_FILE when the file is damaged, DEM_ERROR_INPUT when it does not fit
   the scene. */
int dem_snapshot_read_particles(const char *path, struct dem_snapshot *,
                                const struct dem_decomposition *,
                                const struct dem_interaction_table *, struct dem_particles *);
struct dem_snapshot_facets        /* walls that keep their facets; changed 0: numbers as in the file */
{
    int changed, walls;
    struct dem_facet_range        /* first in the file, how many, first of this run */
    {
        int64_t was, facets, now;
    } *wall;                      /* contacts with a facet of no wall here are dropped */
};

int dem_snapshot_read_contacts(const char *path, const struct dem_decomposition *,
                               const struct dem_interaction_table *, const struct dem_particles *,
                               const struct dem_snapshot_facets *, struct dem_contacts *);

/* The caller's data without the scene; NULL when there are none, or on failure. Free *bytes with dem_memory_free. Not
   collective. */
int dem_snapshot_read_caller_data(const char *path, void **bytes, size_t *size);

/* The fingerprint of the state in a file, the same as dem_hash gives for a running simulation. Not
   collective. */
int dem_snapshot_fingerprint(const char *path, uint64_t *fingerprint);
