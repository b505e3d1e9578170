/*
 * sparse_exchange.c -- sends synchronously and receives until all messages have been received
 * everywhere.
 *
 * When all sends of a rank have completed it enters a non-blocking barrier; when the barrier
 * completes, no message is outstanding. Received messages are sorted by rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/sparse_exchange.h"
#include "core/memory.h"
#include "core/sort.h"
#include "ranks/mpi_error.h"
#include <limits.h>
#include <string.h>

enum
{
    TAG = 70                      /* 70 and 71 alternate: messages of a rank that is one exchange
                                     ahead must not be received yet */
};

void dem_messages_free(struct dem_messages *m)
{
    dem_memory_free(m->rank);
    dem_memory_free(m->start);
    dem_memory_free(m->data);
    memset(m, 0, sizeof *m);
}

void dem_messages_clear(struct dem_messages *m)
{
    m->ranks = 0;
    if (m->start)
    {
        m->start[0] = 0;
    }
}

int dem_messages_begin(struct dem_messages *m, int rank)
{
    DEM_TRY(DEM_GROW(m->rank, m->rank_capacity, m->ranks + 1));
    DEM_TRY(DEM_GROW(m->start, m->start_capacity, m->ranks + 2));
    m->rank[m->ranks] = rank;
    m->start[m->ranks + 1] = m->start[m->ranks];
    m->ranks++;
    return DEM_OK;
}

int dem_messages_extend(struct dem_messages *m, size_t count, double **data)
{
    const size_t from = m->start[m->ranks];

    DEM_TRY(DEM_GROW(m->data, m->data_capacity, from + count + 1));
    m->start[m->ranks] = from + count;
    *data = m->data + from;
    return DEM_OK;
}

static int check_lengths(const struct dem_messages *out)
{
    for (int k = 0; k < out->ranks; k++)
    {
        const size_t count = out->start[k + 1] - out->start[k];

        DEM_REQUIRE(count <= INT_MAX, DEM_ERROR_MPI,
                    "a message of %zu numbers is too long for MPI; use more ranks", count);
    }
    return DEM_OK;
}

static int send_all(MPI_Comm comm, const struct dem_messages *out, int tag, MPI_Request *request)
{
    for (int k = 0; k < out->ranks; k++)
    {
        const size_t count = out->start[k + 1] - out->start[k];

        DEM_TRY_MPI(MPI_Issend(out->data + out->start[k], (int)count, MPI_DOUBLE, out->rank[k], tag,
                               comm, &request[k]));
    }
    return DEM_OK;
}

/* Receive a message and drop it, so that the send completes; the memory of those received so far is freed for it. */
static int drop_one(MPI_Comm comm, struct dem_messages *in, int source, int count, int tag)
{
    double *data = NULL;

    dem_memory_free(in->data);
    in->data = NULL;
    in->data_capacity = 0;
    DEM_TRY(DEM_NEW(data, count + 1));
    const int status =
        DEM_MPI_STATUS(MPI_Recv(data, count, MPI_DOUBLE, source, tag, comm, MPI_STATUS_IGNORE));

    dem_memory_free(data);
    return status;
}

/* Receive one message if there is one. `failed`: there was no memory for one, so all are dropped from then on. */
static int receive_one(MPI_Comm comm, struct dem_messages *in, int tag, int *failed)
{
    MPI_Status status;
    int there, count;
    double *data;

    DEM_TRY_MPI(MPI_Iprobe(MPI_ANY_SOURCE, tag, comm, &there, &status));
    if (!there)
    {
        return DEM_OK;
    }
    DEM_TRY_MPI(MPI_Get_count(&status, MPI_DOUBLE, &count));
    *failed = *failed ? *failed : dem_messages_begin(in, status.MPI_SOURCE);
    *failed = *failed ? *failed : dem_messages_extend(in, (size_t)count, &data);
    return *failed ? drop_one(comm, in, status.MPI_SOURCE, count, tag)
                   : DEM_MPI_STATUS(MPI_Recv(data, count, MPI_DOUBLE, status.MPI_SOURCE, tag, comm,
                                             MPI_STATUS_IGNORE));
}

/* `sorted` becomes the messages of `in`, by rank; order and scratch: capacity in->ranks. */
static int copy_sorted(const struct dem_messages *in, struct dem_messages *sorted,
                       struct dem_sort_pair *order, struct dem_sort_pair *scratch)
{
    const size_t n = (size_t)in->ranks;
    double *data;

    for (size_t k = 0; k < n; k++)
    {
        order[k] = (struct dem_sort_pair){.lo = (uint64_t)in->rank[k], .index = (uint32_t)k};
    }
    dem_sort_pairs(order, n, scratch);
    for (size_t k = 0; k < n; k++)
    {
        const size_t from = in->start[order[k].index], count = in->start[order[k].index + 1] - from;

        DEM_TRY(dem_messages_begin(sorted, (int)order[k].lo));
        DEM_TRY(dem_messages_extend(sorted, count, &data));
        memcpy(data, in->data + from, count*sizeof *data);
    }
    return DEM_OK;
}

/* Messages arrive in any order; results must not depend on it. */
static int sort_by_rank(struct dem_messages *in)
{
    struct dem_messages sorted = {.rounds = in->rounds, .sent = in->sent};
    struct dem_sort_pair *order = NULL, *scratch = NULL;
    int status = DEM_NEW(order, in->ranks + 1);

    status = status ? status : DEM_NEW(scratch, in->ranks + 1);
    status = status ? status : copy_sorted(in, &sorted, order, scratch);
    dem_memory_free(order);
    dem_memory_free(scratch);
    if (status)
    {
        dem_messages_free(&sorted);
        return status;
    }
    dem_messages_free(in);
    *in = sorted;
    return DEM_OK;
}

/* Send and receive until no message is outstanding anywhere. Returns an error after which the ranks are out of step; `failed`:
   memory was short. */
static int exchange_all(MPI_Comm comm, const struct dem_messages *out, struct dem_messages *in,
                        int tag, MPI_Request *request, int *failed)
{
    MPI_Request barrier = MPI_REQUEST_NULL;
    int all_received = 0, waiting = 0, sent = out->ranks == 0;

    DEM_TRY(send_all(comm, out, tag, request));
    while (!all_received)
    {
        DEM_TRY(receive_one(comm, in, tag, failed));
        if (waiting)
        {
            DEM_TRY_MPI(MPI_Test(&barrier, &all_received, MPI_STATUS_IGNORE));
            continue;
        }
        if (!sent)
        {
            DEM_TRY_MPI(MPI_Testall(out->ranks, request, &sent, MPI_STATUSES_IGNORE));
        }
        if (sent)
        {
            DEM_TRY_MPI(MPI_Ibarrier(comm, &barrier));
            waiting = 1;
        }
    }
    return DEM_OK;
}

int dem_messages_exchange(MPI_Comm comm, int failed, const struct dem_messages *out,
                          struct dem_messages *in)
{
    static const struct dem_messages none = {.ranks = 0};
    const int tag = TAG + (in->rounds++ & 1);
    MPI_Request *request = NULL;
    int worst;

    failed = failed ? failed : check_lengths(out);
    failed = failed ? failed : DEM_NEW(request, out->ranks + 1);
    out = failed ? &none : out;
    dem_messages_clear(in);
    in->sent.messages += out->ranks;
    in->sent.bytes += out->ranks > 0 ? (int64_t)(out->start[out->ranks]*sizeof *out->data) : 0;
    const int status = exchange_all(comm, out, in, tag, request, &failed);

    dem_memory_free(request);
    DEM_TRY(status);
    failed = failed ? failed : sort_by_rank(in);
    if (failed)
    {
        dem_messages_clear(in);
    }
    worst = failed;
    const int agreed =
        DEM_MPI_STATUS(MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, comm));

    DEM_TRY(failed ? failed : agreed);
    return worst ? dem_error(worst, "another rank failed; see its message") : DEM_OK;
}
