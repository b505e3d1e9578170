/*
 * store.h -- one file that all ranks write or read at places of their own: MPI-IO together, plain files alone.
 *
 * A store being written bears the name path.part until it is closed well; then it takes its own name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_STORE_H
#define DEM_IO_STORE_H

#include <mpi.h>
#include <stddef.h>
#include <stdio.h>

struct dem_store
{
    MPI_Comm comm;                                        /* MPI_COMM_NULL: alone */
    MPI_File file;
    FILE *alone;
    int rank, writing, status;
    char path[1024];
};

/* Collective. */
int dem_store_create(struct dem_store *, MPI_Comm, int rank, const char *path);
int dem_store_open(struct dem_store *, MPI_Comm, int rank, const char *path);
int dem_store_close(struct dem_store *);                  /* fails on all ranks if anything failed on one */

/* Not collective. `at` and `size` in bytes. A failure is remembered, later calls do nothing. */
void dem_store_write(struct dem_store *, size_t at, const void *data, size_t size);
void dem_store_read(struct dem_store *, size_t at, void *data, size_t size);
size_t dem_store_size(struct dem_store *);                /* bytes in the file; 0 when that can't be told */

#endif
