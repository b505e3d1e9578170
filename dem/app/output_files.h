/*
 * output_files.h -- files of `dem run`: VTK files, snapshots, and the last backup of a run that
 * failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_query.h"
#include "input/dictionary.h"
#include "app/main.h"
#include <stdbool.h>

struct dem_output
{
    char folder[512];
    bool vtk, csv;         /* files of particles */
    bool wide;             /* VTK files with 64 bits for all numbers, not for positions only */
    double walls, energy, cell;  /* s  between rows of walls.csv, energy.csv, cell.csv; 0: none */
    double max_created;    /* 1  limit of energy created between two rows, of the largest term; 0:
                              none */
    int snapshots;         /* 0 no, 1 last, 2 all */
    int64_t keep;          /* of all snapshots only the last so many; 0: all */
    bool orientation;      /* of each particle, in VTK files and snapshots */
    bool profile;          /* print the profile at the end */
    double start;          /* s  of this run: 0, or the time of its snapshot */
    bool last_good;        /* keep backups in memory, and write the last one when the run fails */
};

/* Read the entry `write` of a scene, which may be NULL. The folder's default is the scene's name
   without its extension. */
int dem_output_read(struct dem_output *, const struct dem_dict *write, const char *scene);

/* Collective. An error when the folder can neither be written nor created, or when a snapshot would
   overwrite the scene. Creates nothing. */
int dem_output_check(const struct dem_output *, const struct dem_program *, const char *scene);

/* 1 when the run writes files into the folder, whatever happens in it. */
int dem_output_writes(const struct dem_output *, const struct dem *);

/* Collective. dem_output_write: VTK files and averages of an output. dem_output_save: its
   snapshot; of more than `keep` the oldest is removed. */
int dem_output_write(const struct dem_output *, const struct dem_program *, struct dem *,
                     int64_t number, double time);
int dem_output_save(const struct dem_output *, const struct dem_program *, struct dem *,
                    int64_t number);
void dem_output_snapshot_name(const struct dem_output *, int64_t number, char *path, size_t size);

/* Collective. Write the state after dem_restore as lastGood.dem and, with vtk, lastGood.vtp. */
int dem_output_last_good(const struct dem_output *, const struct dem_program *, struct dem *);
