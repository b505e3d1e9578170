/*
 * main_output.h -- what `dem run` leaves on disk: VTK files and snapshots, and the last good state of a run that failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_OUTPUT_H
#define DEM_MAIN_OUTPUT_H

#include "dem.h"
#include "io/dictionary.h"
#include "main.h"
#include <stdbool.h>

struct dem_output
{
    char folder[512];
    bool vtk;
    double walls, energy;                                 /* s between rows of forces on walls, of energy; 0: none */
    double most_created;                                  /* 1  energy from nowhere between two rows, of the largest term; 0: any */
    int snapshots;                                        /* 0 no, 1 last, 2 all */
    int64_t keep;                                         /* of all only the last so many; 0: all */
    bool orientation;                                     /* of each particle, in pictures and snapshots */
    bool profile;                                         /* where the time went is told at the end */
    bool last_good;                                       /* copies are kept in memory, and written when the run fails */
};

/* `write` may be NULL. The folder's default is the scene's name without its ending. */
int dem_output_read(struct dem_output *, const struct dem_dict *write, const char *scene);

/* Collective. Can the folder be written, or made? Nothing is made. */
int dem_output_check(const struct dem_output *, const struct dem_program *);

/* Make the folder, if it is not there. */
int dem_output_folder(const struct dem_output *);

/* Collective. Pictures and means of an output; then its snapshot, and the oldest one goes if so many are not to be kept. */
int dem_output_write(const struct dem_output *, const struct dem_program *, struct dem *, int64_t number, double time);
int dem_output_save(const struct dem_output *, const struct dem_program *, struct dem *, int64_t number);
void dem_output_snapshot_name(const struct dem_output *, int64_t number, char *path, size_t size);

/* Collective. The state as it is, after dem_restore, as lastGood.dem and, where pictures are written, lastGood.vtp. */
int dem_output_last_good(const struct dem_output *, const struct dem_program *, struct dem *);

#endif
