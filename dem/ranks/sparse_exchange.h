/*
 * sparse_exchange.h -- sparse exchange: messages to a few ranks without knowing which ranks send to
 * this one.
 *
 * Each rank sends its messages and receives those addressed to it; the cost depends on the number
 * of messages, not of ranks. Used by migration and by the construction of ghosts.
 *
 * Method: Hoefler, Siebert, Lumsdaine, "Scalable communication protocols for dynamic sparse data
 * exchange", PPoPP 2010 (synchronous sends and a non-blocking barrier).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <mpi.h>
#include <stddef.h>
#include <stdint.h>

struct dem_traffic                                        /* sent so far by this rank */
{
    int64_t messages, bytes;
};

struct dem_messages    /* messages of doubles, one per rank */
{
    int ranks;                    /* number of messages */
    int *rank;                    /* rank of each, ascending in what was received */
    size_t *start;                /* messages + 1 offsets into data */
    double *data;
    size_t rank_capacity, start_capacity, data_capacity;
    int rounds;                   /* exchanges so far, the same on all ranks */
    struct dem_traffic sent;      /* total of this rank; counted in the receiving struct */
};

void dem_messages_free(struct dem_messages *);
void dem_messages_clear(struct dem_messages *);

/* Begin a message to a rank; extend the last message by `count` doubles, to be written at
   `where`. */
int dem_messages_begin(struct dem_messages *, int rank);
int dem_messages_extend(struct dem_messages *, size_t count, double **where);

/* Collective: send all messages of `out`, receive into `in`. All ranks must use the same sequence
   of `in`. `status`: a rank that has failed before takes part without messages. When a rank has
   failed, before or in the exchange, all return an error. */
int dem_messages_exchange(MPI_Comm, int status, const struct dem_messages *out,
                          struct dem_messages *in);
