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

enum dem_halo_which                                       /* copies */
{
    DEM_HALO_ALL,
    DEM_HALO_NEAR,                                        /* those that near rows touch: a step needs no others */
    DEM_HALO_ROUTES
};

struct dem_route                                          /* to the peers of the refresh, or from them */
{
    size_t *start;                                        /* peers + 1 offsets into index */
    uint32_t *index;                                      /* owned particle, or copy */
    size_t start_room, room;
};

struct dem_halo
{
    struct dem_pieces *pieces;
    struct dem_mail out, in;
    int peers, *peer;                                     /* ranks whose pieces are near, ascending */
    int sends, receives;                                  /* peers of the refresh */
    int *send_peer, *receive_peer;
    struct dem_route send[DEM_HALO_ROUTES], receive[DEM_HALO_ROUTES];
    uint8_t *wants, *wanted;                              /* 1: near rows touch this copy here; this one of mine there */
    double *send_buffer, *receive_buffer;
    MPI_Request *request;
    int open;                                             /* of them */
    enum dem_halo_which sent;                             /* on the way, or last */
    struct dem_traffic refreshed;                         /* letters are counted in `in` */
    size_t peer_room, send_peer_room, receive_peer_room, wants_room, wanted_room, send_room, receive_room, request_room;
};

void dem_halo_init(struct dem_halo *, struct dem_pieces *);
void dem_halo_free(struct dem_halo *);

/* Collective. Hand every particle to the owner of its place, with the carried rows of its contacts. */
int dem_halo_migrate(struct dem_halo *, struct dem_particles *, struct dem_contacts *);

/* Collective. Copies of all particles within `reach` [m] past touching of what other ranks own. */
int dem_halo_renew(struct dem_halo *, struct dem_particles *, const struct dem_domain *, double most_radius, double reach);

/* Collective, after near rows were pruned: who needs which copies in each step. */
int dem_halo_choose_near(struct dem_halo *, const struct dem_particles *, const struct dem_contacts *);

/* Positions, velocities and spins for the copies of others are on their way; never allocates. What is sent must have arrived, by one
   of the two below, before any other call here. */
void dem_halo_send(struct dem_halo *, const struct dem_particles *, enum dem_halo_which);

/* The copies here get what was sent for them; or it is waited for, and dropped. */
void dem_halo_receive(struct dem_halo *, struct dem_particles *);
void dem_halo_wait(struct dem_halo *);

/* Collective. The fluid's viscosity at the copies, and their inertial mass, which it adds to. */
int dem_halo_refresh_fluid(struct dem_halo *, struct dem_particles *);

#endif
