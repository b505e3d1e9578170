/*
 * store.h -- one file that all ranks write or read at places of their own: MPI-IO together, stdio alone.
 *
 * A store being written bears the name path.part until it is closed well; then it takes its own name. One that is to last is
 * on the disk before that, and its name in the folder after it: a crash of the program, a kill -9 or a loss of power leaves the
 * file of before or the new one, never a half.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_STORE_H
#define DEM_IO_STORE_H

#include <mpi.h>
#include <stddef.h>
#include <stdio.h>

struct dem_writers                                        /* who has a file in hand together */
{
    MPI_Comm comm;                                        /* MPI_COMM_NULL: alone, and no call of MPI is made */
    int rank;
    const char *says;                                     /* a comment in the head of a picture; NULL: none */
};

struct dem_store
{
    struct dem_writers by;
    MPI_File file;
    FILE *alone;
    int writing, lasting, status;
    char path[1024];
};

/* Collective. `lasting`: 1 for what a run must be able to go on from, which waits for the disk; 0 for pictures. */
int dem_store_create(struct dem_store *, const struct dem_writers *, const char *path, int lasting);
int dem_store_open(struct dem_store *, const struct dem_writers *, const char *path);
int dem_store_close(struct dem_store *);                  /* fails on all ranks if anything failed on one */

/* Collective. Each rank its own bytes at its own place; size 0 for none. */
void dem_store_write_together(struct dem_store *, size_t at, const void *data, size_t size);

/* Not collective. `at` and `size` in bytes. A failure is remembered, later calls do nothing. */
void dem_store_write(struct dem_store *, size_t at, const void *data, size_t size);
void dem_store_read(struct dem_store *, size_t at, void *data, size_t size);
size_t dem_store_size(struct dem_store *);                /* bytes in the file; 0 when that can't be told */

#endif
