/*
 * csv_rows.h -- CSV tables to which `dem run` appends rows, and which a restarted run continues.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_CSV_ROWS_H
#define DEM_APP_CSV_ROWS_H

#include "dem.h"
#include "app/output_files.h"
#include <stdio.h>

/* Prepare a table that an earlier run may have left: a run that starts at 0 removes it; a
   restarted one removes the rows later than its start [s]. `column`, from 0, holds the time.
   Comments of earlier versions, which name the effects, are moved into effects.csv. */
int dem_csv_begin(const char *path, int column, const struct dem_output *, const struct dem *);

/* Open a table to append rows, on one rank. A new table gets a line with its columns, and the
   effects of the run stand in effects.csv beside it. */
int dem_csv_open(FILE **, const char *path, const struct dem_output *, const struct dem *,
                 const char *columns);
int dem_csv_close(FILE *, const char *path);

/* Rows are written at integer multiples of an interval [s], so that a restarted run writes the
   same; 0: never. dem_csv_next_due: the time of the next row, or `next` if that is earlier.
   dem_csv_is_due: 1 when a row is due now. */
double dem_csv_next_due(double interval, double now, double next);
int dem_csv_is_due(double interval, double now);

#endif
