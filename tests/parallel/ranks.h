/*
 * ranks.h -- tests in C on several ranks: a check that fails on any rank is the failure of all.
 *
 *     ranks_begin(&argc, &argv);
 *     try(dem_start(&c, &d));                               an error of the core ends all ranks
 *     check(n == 3, "contacts", n, 3);
 *     return ranks_end();
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem.h"

#include <stdio.h>

static int rank, ranks, failed;

static inline void ranks_begin(int *argc, char ***argv)
{
    MPI_Init(argc, argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
}

static inline int ranks_end(void)
{
    PMPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed;
}

static inline void check(int holds, const char *what, double found, double expected)
{
    if (!holds)
    {
        printf("# rank %d of %d: %s: found %.17g, expected %.17g: %s\n", rank, ranks, what, found,
               expected, dem_error_text());
        failed = 1;
    }
}

static inline void try(int status)
{
    if (status)
    {
        printf("# rank %d: %s\n", rank, dem_error_text());
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
}
