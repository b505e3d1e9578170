/*
 * energy_csv.h -- the energy balance in `dem run`: energy.csv, a row at each time, and the largest
 * residual at the end.
 *
 * A row holds the time, the time at which the balance began (0, or the restart's), and its
 * terms [J], which docs/energy-balance.md describes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_tables.h"
#include "app/main.h"
#include "app/output_files.h"

struct dem_energy_extreme            /* of the mechanical balance or the balance of heat */
{
    double residual, when, largest;  /* J, s, J  largest residual of all rows, its time; largest term */
};

struct dem_energy_log
{
    const struct dem_output *output;
    struct dem_table table;
    double interval;                 /* s  0: no rows */
    struct dem_energy_extreme mechanical, heat;
    double stored_heat;              /* J  largest heat above 0 K */
    double before, then;             /* J, s  mechanical residual and time of the last row */
};

/* Collective. Remove the rows of an earlier run in the same folder that are later than the start
   of this one [s]. */
int dem_energy_log_begin(struct dem_energy_log *, const struct dem_program *,
                         const struct dem_output *, const struct dem *);

/* Collective. Write a row if one is due. DEM_ERROR_NUMBER when the mechanical residual has grown since
   the last row by more than time/maxCreated, a fraction of the largest mechanical term. */
int dem_energy_log_append(struct dem_energy_log *, const struct dem_program *, struct dem *,
                          double now);

/* Print the largest residuals on the first rank. */
void dem_energy_log_print(const struct dem_energy_log *, const struct dem_program *);
