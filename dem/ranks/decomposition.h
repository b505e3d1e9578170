/*
 * decomposition.h -- domain decomposition: recursive coordinate bisection into subdomains of equal
 * weight.
 *
 * The group of ranks [lo, hi) is split at mid = (lo + hi)/2 by a plane. The plane is stored at
 * index mid, so the tree is two arrays, which every rank holds. The outer subdomains extend to
 * infinity. The decomposition affects the cost of a run only, not its results.
 *
 * Method: Berger and Bokhari, IEEE Trans. Comput. C-36 (1987) 570.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"
#include <mpi.h>
#include <stdint.h>

struct dem_mpi_error              /* the first error of an MPI call that could not be returned, see collect.h */
{
    int status;
    char text[512];
};

struct dem_decomposition
{
    MPI_Comm comm;                /* MPI_COMM_NULL in a serial run */
    int rank, ranks;
    int *axis;                    /* normal of the plane at index mid, 1 <= mid < ranks */
    double *at;                   /* m: position of the plane */
    struct dem_mpi_error *error;
    int64_t *count;               /* scratch of a gather: items of each rank */
    int *number;                  /* the same, and then the index of the first item of each */
};

int dem_decomposition_init(struct dem_decomposition *, MPI_Comm comm, int rank, int ranks);
void dem_decomposition_free(struct dem_decomposition *);

/* Collective. New decomposition: each rank gets an equal fraction of the weights of the owned
   particles to within a hundredth; weight NULL: 1 each. */
int dem_decomposition_balance(struct dem_decomposition *, const struct dem_particles *,
                              const uint32_t *weight);

/* Collective. The same for n positions x [m] of this rank, `stride` doubles apart, with weight
   1. */
int dem_decomposition_divide(struct dem_decomposition *, size_t n, const double *x, size_t stride);

/* The rank that owns a position. */
int dem_decomposition_owner(const struct dem_decomposition *, const double x[3]);

/* The box [m] of a rank; outer limits are infinite. */
void dem_decomposition_box(const struct dem_decomposition *, int rank, double min[3],
                           double max[3]);
