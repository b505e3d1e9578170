/*
 * csv_table.h -- a table of all ranks in one CSV file, for pandas, spreadsheets and ParaView.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/parallel_file.h"
#include <stddef.h>
#include <stdint.h>

/* Prints row i of this rank without the end of the line into out[size], and returns its length as
   snprintf does; it returns the same for the same row each time. */
typedef int dem_csv_row(const void *source, int64_t i, char *out, size_t size);

enum
{
    DEM_CSV_MAX_ROW = 1024    /* bytes of a row with its end */
};

/* Collective; a null first argument means one rank. The line of columns, then the n rows of each
   rank, in the order of ranks. */
int dem_csv_table_write(const struct dem_file_ranks *, const char *path, const char *columns,
                        int64_t n, dem_csv_row *row, const void *source);
