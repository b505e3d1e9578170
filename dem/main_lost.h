/*
 * main_lost.h -- what `dem run` tells of particles that left the domain or passed through a wall: a line, and lost.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_LOST_H
#define DEM_MAIN_LOST_H

#include "dem.h"
#include "main.h"
#include "main_output.h"

struct dem_lost_log
{
    const struct dem_output *output;
    char path[640];                                       /* of lost.csv; it is made with the first loss */
    int64_t removed;                                      /* by this run */
};

/* Rows of an earlier run in the same folder that are later than the start of this one [s] go. */
int dem_lost_begin(struct dem_lost_log *, const struct dem_program *, const struct dem_output *, const struct dem *, double start);

/* Collective. Print and write who was lost since the last call. */
int dem_lost_tell(struct dem_lost_log *, const struct dem_program *, struct dem *);

#endif
