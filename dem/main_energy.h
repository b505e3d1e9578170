/*
 * main_energy.h -- what `dem run` tells of energy: energy.csv, a row at each time, and the largest residual at the end.
 *
 * A row holds the time, the time since which the ledger is kept (0, or that of the restart), and its terms [J]: README.md,
 * section 4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_ENERGY_H
#define DEM_MAIN_ENERGY_H

#include "dem.h"
#include "main.h"
#include "main_output.h"

struct dem_energy_log
{
    const struct dem_output *output;
    char path[640];
    double interval;                                      /* s; 0: nothing is told */
    double residual, when, largest;                       /* J, s, J: the largest residual of all rows, largest of all terms */
    double before, then;                                  /* J, s: the residual of the last row */
};

/* Collective. Rows of an earlier run in the same folder that are later than the start of this one [s] go. */
int dem_energy_log_begin(struct dem_energy_log *, const struct dem_program *, const struct dem_output *, const struct dem *, double start);

/* Collective. Write a row if one is due. DEM_ERROR_NUMBER where since the last one more energy has come from nowhere than time/maxCreated,
   a share of the largest term. */
int dem_energy_log_tell(struct dem_energy_log *, const struct dem_program *, struct dem *, double now);

/* The last word. */
void dem_energy_log_end(const struct dem_energy_log *, const struct dem_program *);

#endif
