/*
 * main_walls.h -- what `dem run` tells of the forces on walls: walls.csv, a row for each wall at each time.
 *
 * A row holds the time, the wall, force and torque (about the origin of coordinates) as means since the row before, that
 * is impulse over time, and as they are at that time. After a restart the first mean begins at the restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_WALLS_H
#define DEM_MAIN_WALLS_H

#include "dem.h"
#include "main.h"
#include "main_output.h"

struct dem_wall_log
{
    const struct dem_output *output;
    char path[640];
    double interval, since;                               /* s; 0: nothing is told; time of the last rows */
};

/* Collective. Rows of an earlier run in the same folder that are later than the start of this one [s] go. */
int dem_wall_log_begin(struct dem_wall_log *, const struct dem_program *, const struct dem_output *, struct dem *, double start);

/* Collective. Write rows if they are due. */
int dem_wall_log_tell(struct dem_wall_log *, const struct dem_program *, struct dem *, double now);

#endif
