/*
 * csv_table.c -- write the rows of all ranks into one CSV file.
 *
 * 1. Each rank prints its rows once to count their bytes; the sum over lower ranks is its offset.
 * 2. It prints them again into blocks, which all ranks write together.
 *
 * Nothing is gathered, and no rank holds more than a block of text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/csv_table.h"

#include "core/memory.h"
#include <string.h>

enum
{
    BLOCK = 1 << 22    /* bytes printed before they are written */
};

static size_t print_row(dem_csv_row *row, const void *source, int64_t i, char *out)
{
    const int length = row(source, i, out, DEM_CSV_MAX_ROW);
    const size_t kept = length < DEM_CSV_MAX_ROW ? (size_t)length : DEM_CSV_MAX_ROW - 1;

    out[kept] = '\n';
    return kept + 1;
}

static void write_rows(struct dem_parallel_file *f, size_t at, char *block, int64_t n, size_t bytes,
                       dem_csv_row *row, const void *source)
{
    const int64_t rounds =
        dem_parallel_file_max(f, (int64_t)(bytes/(BLOCK - DEM_CSV_MAX_ROW) + 1));
    int64_t i = 0;

    /* a block is left with less than a row free, so this rank needs no more rounds than counted */
    for (int64_t k = 0; k < rounds; k++)
    {
        size_t used = 0;

        while (i < n && used <= BLOCK - DEM_CSV_MAX_ROW)
        {
            used += print_row(row, source, i++, block + used);
        }
        dem_parallel_file_write_all(f, at, block, used);
        at += used;
    }
}

int dem_csv_table_write(const struct dem_file_ranks *by, const char *path, const char *columns,
                        int64_t n, dem_csv_row *row, const void *source)
{
    const struct dem_file_ranks alone = {.comm = MPI_COMM_NULL};
    const size_t head = strlen(columns) + 1;
    struct dem_parallel_file f;
    char *block = NULL, line[DEM_CSV_MAX_ROW];
    int64_t bytes = 0, before, all;

    by = by ? by : &alone;
    int status = DEM_NEW(block, BLOCK);

    for (int64_t i = 0; i < n && !status; i++)
    {
        bytes += (int64_t)print_row(row, source, i, line);
    }
    status = dem_file_ranks_count(by, status, bytes, &before, &all);
    status = status ? status : dem_parallel_file_create(&f, by, path, 0);
    if (!status)
    {
        if (by->rank == 0)
        {
            dem_parallel_file_write(&f, 0, columns, head - 1);
            dem_parallel_file_write(&f, head - 1, "\n", 1);
        }
        write_rows(&f, head + (size_t)before, block, n, (size_t)bytes, row, source);
        status = dem_parallel_file_close(&f);
    }
    dem_memory_free(block);
    return status;
}
