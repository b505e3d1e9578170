/*
 * pieces.h -- which rank owns which part of space: recursive coordinate bisection into equal weights.
 *
 * The group of ranks [lo, hi) is split at mid = (lo + hi)/2 by a plane; the plane is kept at index mid, so the whole
 * tree is two arrays that every rank holds. Pieces reach to infinity at the outside. Who owns what never changes a
 * result, only its cost. Method: Berger and Bokhari, IEEE Trans. Comput. C-36 (1987) 570.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_PIECES_H
#define DEM_SPACE_PIECES_H

#include "state/particles.h"
#include <mpi.h>

struct dem_pieces
{
    MPI_Comm comm;                                        /* MPI_COMM_NULL when alone */
    int rank, ranks;
    int *axis;                                            /* of the plane at index mid, 1 <= mid < ranks */
    double *at;                                           /* m */
};

int dem_pieces_init(struct dem_pieces *, MPI_Comm comm, int rank, int ranks);
void dem_pieces_free(struct dem_pieces *);

/* Collective. Cut anew so that every rank gets its share, to a hundredth, of the weights of the owned particles; NULL: one each. */
int dem_pieces_balance(struct dem_pieces *, const struct dem_particles *, const uint32_t *weight);

/* The same for any n places [m] in hand here, one every `stride` doubles. */
int dem_pieces_cut(struct dem_pieces *, size_t n, const double *x, size_t stride);

/* The rank that owns a position. */
int dem_pieces_owner(const struct dem_pieces *, const double x[3]);

/* The box of a rank, infinite at the outside. */
void dem_pieces_box(const struct dem_pieces *, int rank, double min[3], double max[3]);

#endif
