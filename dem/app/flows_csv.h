/*
 * flows_csv.h -- streams and outlets in `dem run`: a line and rows of flows.csv at each output, a
 * line each at the end.
 *
 * A row holds the sums since the start of the first run, which restarts continue, and the mean
 * rates since the last row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_FLOWS_CSV_H
#define DEM_APP_FLOWS_CSV_H

#include "dem.h"
#include "app/main.h"
#include "app/output_files.h"

enum
{
    DEM_FLOW_LOG_MAX = 64  /* limit of streams and outlets; a scene may have fewer */
};

struct dem_flow_log
{
    const struct dem_output *output;
    char path[640];  /* of flows.csv, which is created if there are streams or outlets */
    double since;    /* s  time of the last rows */
    double particles[DEM_FLOW_LOG_MAX], mass[DEM_FLOW_LOG_MAX];  /* 1, kg  of the last rows */
};

/* Collective. Remove the rows of an earlier run in the same folder that are later than the start
   of this one [s]. */
int dem_flow_log_begin(struct dem_flow_log *, const struct dem_program *, const struct dem_output *,
                       struct dem *);

/* Collective. Print a line, and write a row for each stream and outlet. */
int dem_flow_log_append(struct dem_flow_log *, const struct dem_program *, struct dem *,
                        double now);

/* Print a line for each stream and outlet, on the first rank. */
void dem_flow_log_print(const struct dem_program *, struct dem *);

#endif
