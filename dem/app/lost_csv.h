/*
 * lost_csv.h -- lost particles in `dem run`, which left the domain or passed through a wall: a line
 * in the log, and lost.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_LOST_CSV_H
#define DEM_APP_LOST_CSV_H

#include "dem.h"
#include "app/main.h"
#include "app/output_files.h"

struct dem_lost_log
{
    const struct dem_output *output;
    char path[640];   /* of lost.csv, which is created with the first loss */
    int64_t removed;  /* in this run */
};

/* Collective. Remove the rows of an earlier run in the same folder that are later than the start
   of this one [s]. */
int dem_lost_log_begin(struct dem_lost_log *, const struct dem_program *, const struct dem_output *,
                       const struct dem *);

/* Collective. Print and write the particles lost since the last call. */
int dem_lost_log_append(struct dem_lost_log *, const struct dem_program *, struct dem *);

#endif
