/*
 * collect.c -- reductions, gathers and agreement over the ranks of a decomposition.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/collect.h"
#include "core/memory.h"
#include "core/sort.h"
#include "ranks/mpi_error.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

enum
{
    CHUNK = 1 << 30               /* values per call: MPI counts them in int */
};

static const char another_rank[] = "another rank failed; see its message";

/* ---- errors ---------------------------------------------------------------------------------- */

void dem_collect_record(const struct dem_decomposition *d, const char *call, int code)
{
    const int status = dem_mpi_status(call, code);

    if (status && !d->error->status)
    {
        d->error->status = status;
        snprintf(d->error->text, sizeof d->error->text, "%s", dem_error_text());
    }
}

int dem_collect_status(const struct dem_decomposition *d)
{
    return d->error && d->error->status ? dem_error(d->error->status, "%s", d->error->text)
                                        : DEM_OK;
}

int dem_collect_agree(const struct dem_decomposition *d, int status)
{
    const int recorded = dem_collect_status(d), own = recorded ? recorded : status;
    int worst = own, agreed = own;

    if (d->ranks > 1)
    {
        const int code = MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, d->comm);

        agreed = own ? own : dem_mpi_status("MPI_Allreduce", code);
    }
    return agreed || !worst ? agreed : dem_error(worst, "%s", another_rank);
}

int dem_collect_machine_rank(const struct dem_decomposition *d)
{
    MPI_Comm machine;
    int rank = 0;

    if (d->ranks > 1)
    {
        const int code = MPI_Comm_split_type(d->comm, MPI_COMM_TYPE_SHARED, d->rank, MPI_INFO_NULL, &machine);

        dem_collect_record(d, "MPI_Comm_split_type", code);
        if (code == MPI_SUCCESS)
        {
            (void)MPI_Comm_rank(machine, &rank);
            (void)MPI_Comm_free(&machine);
        }
    }
    return rank;
}

/* ---- reductions ------------------------------------------------------------------------------ */

static void reduce(const struct dem_decomposition *d, void *value, size_t n, size_t size,
                   MPI_Datatype type, MPI_Op operation)
{
    for (size_t done = 0; d->ranks > 1 && done < n; done += CHUNK)
    {
        const int count = (int)(n - done < CHUNK ? n - done : CHUNK);

        dem_collect_record(d, "MPI_Allreduce",
                           MPI_Allreduce(MPI_IN_PLACE, (char *)value + done*size, count, type,
                                         operation, d->comm));
    }
}

void dem_collect_sum_int64(const struct dem_decomposition *d, int64_t *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_INT64_T, MPI_SUM);
}

void dem_collect_max_int64(const struct dem_decomposition *d, int64_t *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_INT64_T, MPI_MAX);
}

void dem_collect_sum_uint64(const struct dem_decomposition *d, uint64_t *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_UINT64_T, MPI_SUM);
}

void dem_collect_max_uint8(const struct dem_decomposition *d, uint8_t *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_UINT8_T, MPI_MAX);
}

void dem_collect_sum_double(const struct dem_decomposition *d, double *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_DOUBLE, MPI_SUM);
}

void dem_collect_max_double(const struct dem_decomposition *d, double *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_DOUBLE, MPI_MAX);
}

void dem_collect_min_double(const struct dem_decomposition *d, double *value, size_t n)
{
    reduce(d, value, n, sizeof *value, MPI_DOUBLE, MPI_MIN);
}

void dem_collect_sum_int64_to_first(const struct dem_decomposition *d, int64_t *value, size_t n)
{
    for (size_t done = 0; d->ranks > 1 && done < n; done += CHUNK)
    {
        const int count = (int)(n - done < CHUNK ? n - done : CHUNK);

        dem_collect_record(d, "MPI_Reduce",
                           MPI_Reduce(d->rank > 0 ? value + done : MPI_IN_PLACE, value + done,
                                      count, MPI_INT64_T, MPI_SUM, 0, d->comm));
    }
}

void dem_collect_sum_before(const struct dem_decomposition *d, const int64_t *own, int64_t *before,
                            size_t n)
{
    if (d->ranks > 1)
    {
        dem_collect_record(d, "MPI_Exscan",
                           MPI_Exscan(own, before, (int)n, MPI_INT64_T, MPI_SUM, d->comm));
    }
    if (d->rank == 0)
    {
        memset(before, 0, n*sizeof *before);              /* MPI_Exscan leaves them undefined */
    }
}

/* ---- gather ---------------------------------------------------------------------------------- */

/* The number of items of each rank; a rank that has failed gives the negative of its status. */
static int gather_counts(const struct dem_decomposition *d, int status,
                         const struct dem_collect_items *from, size_t *total)
{
    const int64_t own = status ? -status : (int64_t)from->n;
    int64_t sum = 0, failed = 0;
    const int gathered =
        DEM_MPI_STATUS(MPI_Allgather(&own, 1, MPI_INT64_T, d->count, 1, MPI_INT64_T, d->comm));

    if (status)
    {
        return status;
    }
    DEM_TRY(gathered);
    for (int k = 0; k < d->ranks; k++)
    {
        failed = d->count[k] < 0 && failed == 0 ? -d->count[k] : failed;
        sum += d->count[k] > 0 ? d->count[k] : 0;
    }
    DEM_REQUIRE(failed == 0, (int)failed, "%s", another_rank);
    DEM_REQUIRE(sum <= INT_MAX && from->size <= INT_MAX, DEM_ERROR_MPI,
                "%lld %s on all ranks; the limit is %d", (long long)sum, from->name, INT_MAX);
    *total = (size_t)sum;
    return DEM_OK;
}

static int gather_items(const struct dem_decomposition *d, const struct dem_collect_items *from,
                        void *all)
{
    int *const number = d->number, *const start = d->number + d->ranks;
    MPI_Datatype item = MPI_DATATYPE_NULL;

    for (int k = 0, at = 0; k < d->ranks; k++)
    {
        start[k] = at;
        number[k] = (int)d->count[k];
        at += number[k];
    }
    int status = DEM_MPI_STATUS(MPI_Type_contiguous((int)from->size, MPI_BYTE, &item));

    status = status ? status : DEM_MPI_STATUS(MPI_Type_commit(&item));
    status = status ? status
                    : DEM_MPI_STATUS(MPI_Allgatherv(from->item, (int)from->n, item, all, number,
                                                    start, item, d->comm));
    if (item != MPI_DATATYPE_NULL)
    {
        (void)MPI_Type_free(&item);
    }
    return status;
}

int dem_collect_gather(const struct dem_decomposition *d, int status,
                       const struct dem_collect_items *from, void **all, size_t *total)
{
    void *items = NULL;
    size_t n = from->n;

    *all = NULL;
    *total = 0;
    DEM_TRY(d->ranks > 1 ? gather_counts(d, status, from, &n) : status);
    status = n > 0 ? dem_memory_new(&items, n, from->size) : DEM_OK;
    if (n > 0 && d->ranks > 1)
    {
        status = dem_collect_agree(d, status);
        status = status ? status : gather_items(d, from, items);
    }
    else if (n > 0 && !status)
    {
        memcpy(items, from->item, n*from->size);
    }
    if (status)
    {
        dem_memory_free(items);
        return status;
    }
    *all = items;
    *total = n;
    return DEM_OK;
}

int dem_collect_records(const struct dem_decomposition *d, const struct dem_collect_items *own,
                        int (*compare)(const void *, const void *), void **all, int64_t *total)
{
    size_t n;
    void *records;

    *total = 0;
    DEM_TRY(dem_collect_gather(d, DEM_OK, own, &records, &n));
    if (n > 0)
    {
        dem_memory_free(*all);
        *all = records;
        dem_sort_by(records, n, own->size, compare);
    }
    *total = (int64_t)n;
    return DEM_OK;
}
