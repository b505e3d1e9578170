/*
 * time_table.h -- quantities over time from the rows of a text file, and between its rows.
 *
 *     time, x, y, z, angle
 *     0, 0, 0, 0, 0
 *     0.1, 0, 0, -2e-3, 0
 *
 * The first row names the columns, in any order; `time` [s] is one of them and rises. A column that
 * the file does not have is 0. The form of the file: input/text_table.h. Before the first row and
 * after the last, quantities have the values of that row.
 *
 *   linear   straight lines from row to row
 *   smooth   cubics with slopes that are continuous at the rows, and no extremum between two rows:
 *
 *              s_i = (sign d_- + sign d_+) min(|d_-|, |d_+|, |p|/2),
 *              p   = (d_- h_+ + d_+ h_-)/(h_- + h_+)
 *
 *            d, h: slope and length of the intervals before and after row i. Source: Steffen,
 *            Astron. Astrophys. 239 (1990) 443. The error is O(h^4) where the data are monotone, else
 *            O(h^2).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_TIME_TABLE_COLUMNS = 4
};

struct dem_time_table
{
    size_t rows, capacity;
    int smooth;
    struct dem_time_row
    {
        /* s */
        double time;
        /* unit, unit/s: at the row, in the order of the names */
        double value[DEM_TIME_TABLE_COLUMNS], slope[DEM_TIME_TABLE_COLUMNS];
    } *row;
};

/* Read a file; `name`: the n columns besides time that it may have, one of them at least. Free the
   table with dem_time_table_free. */
int dem_time_table_read(struct dem_time_table **, const char *file, const char *const *name, int n,
                        int smooth);
void dem_time_table_free(struct dem_time_table *);    /* NULL is allowed */

/* The quantities at a time [s]: DEM_TIME_TABLE_COLUMNS numbers, 0 for missing columns. */
void dem_time_table_at(const struct dem_time_table *, double time, double *value);

/* The largest rate of change of each quantity [unit/s]; the shortest time between rows [s]. */
void dem_time_table_rates(const struct dem_time_table *, double *rate);
double dem_time_table_shortest(const struct dem_time_table *);

/* Differs between tables with different rows or interpolation. */
uint64_t dem_time_table_hash(const struct dem_time_table *);
