/*
 * mail.h -- letters to a few ranks without knowing who writes to whom: the sparse exchange behind migration and halos.
 *
 * Each rank posts its letters and reads those addressed to it; the cost depends on the number of letters, not of ranks.
 * Method: Hoefler, Siebert, Lumsdaine, "Scalable communication protocols for dynamic sparse data exchange", PPoPP 2010
 * (synchronous sends and a non-blocking barrier).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_MAIL_H
#define DEM_SPACE_MAIL_H

#include <mpi.h>
#include <stddef.h>
#include <stdint.h>

struct dem_traffic                                        /* sent so far by this rank */
{
    int64_t messages, bytes;
};

struct dem_mail                                           /* letters of doubles, one a peer */
{
    int peers;
    int *peer;                                            /* ranks, ascending in a received bag */
    size_t *start;                                        /* peers + 1 offsets into data */
    double *data;
    size_t peer_room, start_room, data_room;
    int rounds;                                           /* exchanges so far; counts on every rank alike */
    struct dem_traffic sent;                              /* in a received bag: what was sent for it */
};

void dem_mail_free(struct dem_mail *);
void dem_mail_clear(struct dem_mail *);

/* Start the next letter; then write into its room of `count` doubles. */
int dem_mail_letter(struct dem_mail *, int peer);
int dem_mail_room(struct dem_mail *, size_t count, double **where);   /* lengthens the last letter */

/* Collective, always with the same `in` on all ranks. */
int dem_mail_exchange(MPI_Comm, const struct dem_mail *out, struct dem_mail *in);

#endif
