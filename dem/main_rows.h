/*
 * main_rows.h -- tables of numbers with commas that grow while `dem run` goes on, and go on after a restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_ROWS_H
#define DEM_MAIN_ROWS_H

#include "dem.h"
#include <stdio.h>

/* What an earlier run left under this path: a run that starts at 0 removes it, a later one removes the rows that are later
   than its start [s], and tells its effects from there on where they are others. Time stands in that column, 0 for the first. */
int dem_rows_begin(const char *path, int column, double start, const struct dem *);

/* A table for its next rows, by one rank. Before the first it gets a comment, `# ` and dem_heading, and a line with its columns. */
int dem_rows_open(FILE **, const char *path, const struct dem *, const char *columns);
int dem_rows_close(FILE *, const char *path);

/* Rows lie at whole multiples of an interval [s], so that a run that goes on has the same; 0: never. The time of the next
   row, or `next` if that is earlier; and whether one is due now. */
double dem_rows_due(double interval, double now, double next);
int dem_rows_are_due(double interval, double now);

#endif
