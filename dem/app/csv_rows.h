/*
 * csv_rows.h -- CSV tables to which `dem run` appends rows, and which a restarted run continues.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_CSV_ROWS_H
#define DEM_APP_CSV_ROWS_H

#include "dem.h"
#include <stdio.h>

/* Prepare a table that an earlier run may have left: a run that starts at 0 removes it; a
   restarted one removes the rows later than its start [s] and, where its effects differ, appends
   a comment with them. `column`, from 0, holds the time. */
int dem_csv_begin(const char *path, int column, double start, const struct dem *);

/* Open a table to append rows, on one rank. A new table gets a comment, `# ` and dem_heading,
   and a line with its columns. */
int dem_csv_open(FILE **, const char *path, const struct dem *, const char *columns);
int dem_csv_close(FILE *, const char *path);

/* Rows are written at integer multiples of an interval [s], so that a restarted run writes the
   same; 0: never. dem_csv_next_due: the time of the next row, or `next` if that is earlier.
   dem_csv_is_due: 1 when a row is due now. */
double dem_csv_next_due(double interval, double now, double next);
int dem_csv_is_due(double interval, double now);

#endif
