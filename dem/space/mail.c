/*
 * mail.c -- post with synchronous sends, read until all have been read everywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/mail.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include <limits.h>
#include <string.h>

enum
{
    TAG = 70                                              /* and 71: a rank that is one exchange ahead must not be read now */
};

void dem_mail_free(struct dem_mail *m)
{
    dem_memory_free(m->peer);
    dem_memory_free(m->start);
    dem_memory_free(m->data);
    memset(m, 0, sizeof *m);
}

void dem_mail_clear(struct dem_mail *m)
{
    m->peers = 0;
    if (m->start)
    {
        m->start[0] = 0;
    }
}

int dem_mail_letter(struct dem_mail *m, int peer)
{
    DEM_TRY(DEM_GROW(m->peer, m->peer_room, m->peers + 1));
    DEM_TRY(DEM_GROW(m->start, m->start_room, m->peers + 2));
    m->peer[m->peers] = peer;
    m->start[m->peers + 1] = m->start[m->peers];
    m->peers++;
    return DEM_OK;
}

int dem_mail_room(struct dem_mail *m, size_t count, double **where)
{
    const size_t from = m->start[m->peers];

    DEM_TRY(DEM_GROW(m->data, m->data_room, from + count + 1));
    m->start[m->peers] = from + count;
    *where = m->data + from;
    return DEM_OK;
}

static int post(MPI_Comm comm, const struct dem_mail *out, int tag, MPI_Request *request)
{
    for (int k = 0; k < out->peers; k++)
    {
        const size_t count = out->start[k + 1] - out->start[k];

        DEM_REQUIRE(count <= INT_MAX, DEM_ERROR_MPI, "a message of %zu numbers is too long for MPI; use more ranks", count);
        MPI_Issend(out->data + out->start[k], (int)count, MPI_DOUBLE, out->peer[k], tag, comm, &request[k]);
    }
    return DEM_OK;
}

static int read_one(MPI_Comm comm, struct dem_mail *in, int tag)
{
    MPI_Status status;
    int there, count;
    double *where;

    MPI_Iprobe(MPI_ANY_SOURCE, tag, comm, &there, &status);
    if (!there)
    {
        return DEM_OK;
    }
    MPI_Get_count(&status, MPI_DOUBLE, &count);
    DEM_TRY(dem_mail_letter(in, status.MPI_SOURCE));
    DEM_TRY(dem_mail_room(in, (size_t)count, &where));
    MPI_Recv(where, count, MPI_DOUBLE, status.MPI_SOURCE, tag, comm, MPI_STATUS_IGNORE);
    return DEM_OK;
}

/* Letters arrive in any order; what is built from them must not depend on it. */
static int sort_by_peer(struct dem_mail *in)
{
    struct dem_mail sorted = {.rounds = in->rounds, .sent = in->sent};
    const size_t n = (size_t)in->peers;
    struct dem_sort_pair *letter, *scratch;
    double *where;

    DEM_TRY(DEM_NEW(letter, n + 1));
    DEM_TRY(DEM_NEW(scratch, n + 1));
    for (size_t k = 0; k < n; k++)
    {
        letter[k] = (struct dem_sort_pair){.lo = (uint64_t)in->peer[k], .index = (uint32_t)k};
    }
    dem_sort_pairs(letter, n, scratch);
    for (size_t k = 0; k < n; k++)
    {
        const size_t from = in->start[letter[k].index], count = in->start[letter[k].index + 1] - from;

        DEM_TRY(dem_mail_letter(&sorted, (int)letter[k].lo));
        DEM_TRY(dem_mail_room(&sorted, count, &where));
        memcpy(where, in->data + from, count*sizeof *where);
    }
    dem_memory_free(letter);
    dem_memory_free(scratch);
    dem_mail_free(in);
    *in = sorted;
    return DEM_OK;
}

int dem_mail_exchange(MPI_Comm comm, const struct dem_mail *out, struct dem_mail *in)
{
    MPI_Request *request, barrier = MPI_REQUEST_NULL;
    const int tag = TAG + (in->rounds++ & 1);
    int all_read = 0, waiting = 0, sent = 0, status = DEM_OK;

    DEM_TRY(DEM_NEW(request, out->peers + 1));
    dem_mail_clear(in);
    in->sent.messages += out->peers;
    in->sent.bytes += out->peers > 0 ? (int64_t)(out->start[out->peers]*sizeof *out->data) : 0;
    status = post(comm, out, tag, request);
    while (!all_read && !status)
    {
        status = read_one(comm, in, tag);
        if (waiting)
        {
            MPI_Test(&barrier, &all_read, MPI_STATUS_IGNORE);
        }
        else
        {
            MPI_Testall(out->peers, request, &sent, MPI_STATUSES_IGNORE);
            if (sent)
            {
                MPI_Ibarrier(comm, &barrier);
                waiting = 1;
            }
        }
    }
    dem_memory_free(request);
    return status ? status : sort_by_peer(in);
}
