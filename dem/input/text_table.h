/*
 * text_table.h -- read a table of numbers from a text file.
 *
 *     id, x, y, z, diameter
 *     0, 1.5e-3, 2e-3, 1e-3, 1e-3
 *
 * The first row names the columns, in any order. Columns are separated by a comma, a semicolon or
 * blanks; empty rows and rows that begin with # are skipped. A unit may follow a name, as in x[m];
 * it is not read: units are SI.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stdint.h>

enum
{
    DEM_TEXT_TABLE_COLUMNS = 64
};

struct dem_text_table
{
    /* given: the file; the names that columns may have */
    const char *file, *name[DEM_TEXT_TABLE_COLUMNS];
    int names;
    int whole;    /* the name whose numbers are 64-bit integers; 0: none, as for the first name */
    /* given: called after the row of names, and with each row of numbers, one for each name, 0 where
       the table has no such column */
    int (*check)(const struct dem_text_table *);
    int (*take)(struct dem_text_table *, const double *number);
    void *data;    /* theirs */

    /* found: the number of a row in the column of integers; the line; the name of each column; 1 for
       names that have a column */
    int64_t integer;
    int line, columns, what[DEM_TEXT_TABLE_COLUMNS], present[DEM_TEXT_TABLE_COLUMNS];
};

/* Read the whole file. An unknown name or one that comes twice, and a row that does not have a finite
   number for each column, are errors that name file and line. */
int dem_text_table_read(struct dem_text_table *);
