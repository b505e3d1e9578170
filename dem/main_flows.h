/*
 * main_flows.h -- what `dem run` tells of streams and outlets: a line and rows of flows.csv at each output, a line each at the end.
 *
 * A row holds what has passed since the start of the run or of the first one before it, and the mean rates since the row before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_FLOWS_H
#define DEM_MAIN_FLOWS_H

#include "dem.h"
#include "main.h"
#include "main_output.h"

enum
{
    DEM_MAIN_FLOWS = 64                                   /* more than a scene may have */
};

struct dem_flow_log
{
    const struct dem_output *output;
    char path[640];                                       /* of flows.csv; it is made where there are streams or outlets */
    double since;                                         /* s  of the rows before, */
    double particles[DEM_MAIN_FLOWS], mass[DEM_MAIN_FLOWS];    /* what had passed then */
};

/* Collective. Rows of an earlier run in the same folder that are later than the start of this one [s] go. */
int dem_flow_log_begin(struct dem_flow_log *, const struct dem_program *, const struct dem_output *, struct dem *, double start);

/* Collective. A line, and a row each. */
int dem_flow_log_tell(struct dem_flow_log *, const struct dem_program *, struct dem *, double now);

/* The last word. */
void dem_flow_log_end(const struct dem_program *, struct dem *);

#endif
