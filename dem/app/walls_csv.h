/*
 * walls_csv.h -- forces on walls in `dem run`: walls.csv, a row for each wall at each time.
 *
 * A row holds the time, the wall, and force and torque (about the origin): means since the last
 * row, which are impulse over time, and present values. After a restart the first mean begins at
 * the restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_WALLS_CSV_H
#define DEM_APP_WALLS_CSV_H

#include "dem.h"
#include "app/main.h"
#include "app/output_files.h"

struct dem_wall_log
{
    const struct dem_output *output;
    char path[640];
    double interval, since;  /* s  between rows, 0: none; time of the last rows */
};

/* Collective. Remove the rows of an earlier run in the same folder that are later than the start
   of this one [s]. */
int dem_wall_log_begin(struct dem_wall_log *, const struct dem_program *, const struct dem_output *,
                       struct dem *);

/* Collective. Write rows if they are due. */
int dem_wall_log_append(struct dem_wall_log *, const struct dem_program *, struct dem *,
                        double now);

#endif
