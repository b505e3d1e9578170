/*
 * parallel_file.h -- a file that all ranks write or read at their own offsets: MPI-IO, or stdio in
 * serial runs.
 *
 * A file being written has the name path.part until it is closed without error; then it is renamed
 * to path. A durable file is flushed to the disk before the rename, and its folder after it. A
 * crash of the program, a kill -9 or a power failure therefore leaves either the previous file or
 * the new one, never part of one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/decomposition.h"
#include <mpi.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* the ranks that write or read a file together */
struct dem_file_ranks
{
    MPI_Comm comm;                /* MPI_COMM_NULL: serial, no call of MPI is made */
    int rank;
    const char *comment;             /* comment in the header of VTK files; NULL: none */
};

/* All ranks of a decomposition. */
static inline struct dem_file_ranks dem_file_ranks_of(const struct dem_decomposition *d)
{
    return (struct dem_file_ranks){.comm = d->ranks > 1 ? d->comm : MPI_COMM_NULL, .rank = d->rank};
}

/* Collective. n summed over the lower ranks and over all. `status`: a rank that has failed before takes part, and all ranks
   return an error. */
int dem_file_ranks_count(const struct dem_file_ranks *, int status, int64_t n, int64_t *before,
                         int64_t *all);

struct dem_parallel_file
{
    struct dem_file_ranks by;
    MPI_File file;
    FILE *serial;                  /* of a serial run */
    int writing, durable, status;  /* status: first error */
    char path[1024];
};

/* Collective. lasting: 1 for a durable file (snapshots), which waits for the disk; 0 for output
   such as VTK. */
int dem_parallel_file_create(struct dem_parallel_file *, const struct dem_file_ranks *,
                             const char *path, int lasting);
int dem_parallel_file_open(struct dem_parallel_file *, const struct dem_file_ranks *,
                           const char *path);
/* an error on all ranks if one had an error */
int dem_parallel_file_close(struct dem_parallel_file *);

/* Collective. Each rank writes its own bytes at its own offset `at` [bytes]; size 0 for none. */
void dem_parallel_file_write_all(struct dem_parallel_file *, size_t at, const void *data,
                                 size_t size);

/* Collective. The maximum of n over the ranks; an error of MPI goes to the status of the file. */
int64_t dem_parallel_file_max(struct dem_parallel_file *, int64_t n);

/* Not collective. `at` and `size` in bytes. After an error, which close returns, calls do
   nothing. */
void dem_parallel_file_write(struct dem_parallel_file *, size_t at, const void *data, size_t size);
void dem_parallel_file_read(struct dem_parallel_file *, size_t at, void *data, size_t size);
/* bytes in the file; 0 when unknown */
size_t dem_parallel_file_size(struct dem_parallel_file *);
