/*
 * collect.h -- reductions, gathers and agreement over the ranks of a decomposition.
 *
 * All functions are collective, and with one rank they make no MPI call. Those without a status
 * record the first error of MPI in the decomposition and go on, so that the ranks stay in step. The
 * next agreement (dem_agree, dem_collect_agree) turns a recorded error into an error of all ranks;
 * a public call that makes no agreement returns dem_collect_status.
 *
 * The result of a reduction is the same on all ranks. Integers and maxima do not depend on the
 * order of the ranks; sums of doubles do, so only quantities that change no result of the
 * simulation are summed as doubles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/decomposition.h"
#include <stddef.h>
#include <stdint.h>

/* ---- errors ---------------------------------------------------------------------------------- */

/* Not collective. Record the error of an MPI call (its name and return code); MPI_SUCCESS does nothing. */
void dem_collect_record(const struct dem_decomposition *, const char *call, int code);

/* Not collective. The error recorded first, with its message; DEM_OK without one. */
int dem_collect_status(const struct dem_decomposition *);

/* An error of all ranks when one has failed. A rank that has failed itself keeps its status and message. */
int dem_collect_agree(const struct dem_decomposition *, int status);

/* Number of this rank on its machine, from 0. */
int dem_collect_machine_rank(const struct dem_decomposition *);

/* ---- reductions ------------------------------------------------------------------------------ */

/* Each of n values becomes the sum, the maximum or the minimum of all ranks. */
void dem_collect_sum_int64(const struct dem_decomposition *, int64_t *value, size_t n);
void dem_collect_max_int64(const struct dem_decomposition *, int64_t *value, size_t n);
void dem_collect_sum_uint64(const struct dem_decomposition *, uint64_t *value,
                            size_t n);    /* modulo 2^64 */
void dem_collect_max_uint8(const struct dem_decomposition *, uint8_t *value, size_t n);
void dem_collect_sum_double(const struct dem_decomposition *, double *value, size_t n);
void dem_collect_max_double(const struct dem_decomposition *, double *value, size_t n);
void dem_collect_min_double(const struct dem_decomposition *, double *value, size_t n);

/* The same sum, but of the first rank only; the values of the other ranks are unchanged. */
void dem_collect_sum_int64_to_first(const struct dem_decomposition *, int64_t *value, size_t n);

/* `before` becomes the sum of `own` of the lower ranks, 0 on the first rank; n values each. */
void dem_collect_sum_before(const struct dem_decomposition *, const int64_t *own, int64_t *before,
                            size_t n);

/* ---- gather ---------------------------------------------------------------------------------- */

struct dem_collect_items         /* what a rank gives */
{
    const char *name;            /* plural, for the message of too many items */
    const void *item;
    size_t n, size;              /* number of items, bytes of one */
};

/* The items of all ranks on every rank, in the order of ranks. `status`: a rank that has failed before
   takes part, and all ranks return an error. `all`: a new array, which the caller frees with
   dem_memory_free; `total`: number of items. On failure they are NULL and 0. */
int dem_collect_gather(const struct dem_decomposition *, int status,
                       const struct dem_collect_items *, void **all, size_t *total);

/* The same in the order of `compare` (as qsort's), for records that are collected now and then: when there are any, they
   replace the array *all. `total` is 0 on failure. */
int dem_collect_records(const struct dem_decomposition *, const struct dem_collect_items *,
                        int (*compare)(const void *, const void *), void **all, int64_t *total);
