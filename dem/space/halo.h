/*
 * halo.h -- particles on the move between ranks: migration to their owners, and copies for the neighbours.
 *
 * A particle takes its columns and its contact memory along. Copies keep their true coordinates. Send and receive each step,
 * renew after a rebuild. When alone (one rank) all of these do nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_HALO_H
#define DEM_SPACE_HALO_H

#include "space/domain.h"
#include "space/mail.h"
#include "space/pieces.h"
#include "state/contacts.h"

struct dem_halo
{
    struct dem_pieces *pieces;
    struct dem_mail out, in;
    int peers, *peer;                                     /* ranks whose pieces are near, ascending */
    int sends, receives;                                  /* peers of the refresh */
    int *send_peer, *receive_peer;
    size_t *send_start, *receive_start;                   /* particles, offsets */
    uint32_t *send_index;
    double *send_buffer, *receive_buffer;
    MPI_Request *request;
    int open;                                             /* of them */
    struct dem_traffic refreshed;                         /* letters are counted in `in` */
    size_t peer_room, send_peer_room, receive_peer_room, send_start_room, receive_start_room, send_index_room, send_room, receive_room,
        request_room;
};

void dem_halo_init(struct dem_halo *, struct dem_pieces *);
void dem_halo_free(struct dem_halo *);

/* Collective. Hand every particle to the owner of its place, with the carried rows of its contacts. */
int dem_halo_migrate(struct dem_halo *, struct dem_particles *, struct dem_contacts *);

/* Collective. Copies of all particles within `reach` [m] past touching of what other ranks own. */
int dem_halo_renew(struct dem_halo *, struct dem_particles *, const struct dem_domain *, double most_radius, double reach);

/* Positions, velocities and spins for the copies of others are on their way; never allocates. What is sent must have arrived, by one
   of the two below, before any other call here. */
void dem_halo_send(struct dem_halo *, const struct dem_particles *);

/* The copies here get what was sent for them; or it is waited for, and dropped. */
void dem_halo_receive(struct dem_halo *, struct dem_particles *);
void dem_halo_wait(struct dem_halo *);

/* Collective. The fluid's viscosity at the copies. */
int dem_halo_refresh_viscosity(struct dem_halo *, struct dem_particles *);

#endif
