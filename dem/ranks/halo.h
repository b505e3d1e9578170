/*
 * halo.h -- migration of particles to the ranks that own them, and ghosts: copies of particles of
 * other ranks.
 *
 * Particles migrate with their columns and their contact history. Ghosts keep the true coordinates
 * of their originals, and have the columns that contacts read (particles/particles.h). They are
 * built at each rebuild of the neighbor lists and refreshed (send, receive) in each step. With one
 * rank these functions do nothing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "ranks/sparse_exchange.h"
#include "ranks/decomposition.h"
#include "contacts/contacts.h"

enum
{
    DEM_HALO_WIDTH = 9                  /* doubles sent per ghost in each step: position,
                                           velocity, spin; then the columns ghost_step */
};

enum dem_halo_set                                       /* sets of ghosts */
{
    DEM_HALO_ALL,
    DEM_HALO_NEEDED,                    /* in a step: ghosts with contact rows */
    DEM_HALO_SETS
};

/* what is sent to, or received from, each rank */
struct dem_halo_route
{
    size_t *start;                /* ranks + 1 offsets into index */
    uint32_t *index;              /* owned particle, or ghost */
    size_t start_capacity, capacity;
};

struct dem_halo
{
    struct dem_decomposition *decomposition;
    double reach;                         /* m  past touching, of the present ghosts */
    double clump_reach;                   /* m  how far owned spheres of clumps may lie outside the
                                             subdomain (particles/clump.h) */
    struct dem_messages out, in;
    int neighbors, *neighbor;             /* neighbor ranks, ascending */
    int send_ranks, receive_ranks;        /* number of ranks to send to, to receive from */
    int *send_rank, *receive_rank;        /* these ranks */
    struct dem_halo_route send[DEM_HALO_SETS], receive[DEM_HALO_SETS];
    uint8_t *needed_here, *needed_there;  /* 1: this ghost is needed here; this particle
                                             is needed on the rank it is sent to */
    double *send_buffer, *receive_buffer;
    MPI_Request *request;
    int open_requests;                    /* number of open requests */
    enum dem_halo_set sent;               /* set that is being sent, or was sent last */
    struct dem_traffic refresh_traffic;   /* refreshes only; other messages count in `in` */
    size_t neighbor_capacity, send_rank_capacity, receive_rank_capacity, needed_here_capacity;
    size_t needed_there_capacity, send_capacity, receive_capacity, request_capacity;
};

/* Doubles of the largest refresh of a ghost, in a step or at the beginning of a window. */
static inline size_t dem_halo_width(const struct dem_particles *p)
{
    const size_t step = DEM_HALO_WIDTH + (size_t)p->ghost_step.n,
                 window = 1 + (size_t)p->ghost_window.n;

    return step > window ? step : window;
}

void dem_halo_init(struct dem_halo *, struct dem_decomposition *);
void dem_halo_free(struct dem_halo *);

/* The box [m] of a rank: outer limits are infinite, or the faces of the domain along periodic
   axes. */
void dem_halo_box(const struct dem_halo *, const struct dem_domain *, int rank, double box[2][3]);

/* Find the neighbor ranks, in ascending order: those whose boxes, or periodic images of them, come
   within `reach` [m] of the box of this rank along every axis. */
int dem_halo_find_neighbors(struct dem_halo *, const struct dem_domain *, double reach);

/* Collective. Send every particle to the rank that owns its position, with the saved history of its
   contacts. Removes all ghosts. `status`, here and in the next function: of this rank; one that has
   failed takes part, and all ranks return an error. A rank without memory for what it receives
   fails alone: agree on the result, or pass it on as the status of the next collective call. */
int dem_halo_migrate(struct dem_halo *, int status, struct dem_particles *, struct dem_contacts *);

/* Collective. Build the ghosts: copies of all particles that may come within `reach` [m] past
   touching of particles of other ranks. */
int dem_halo_build(struct dem_halo *, int status, struct dem_particles *, const struct dem_domain *,
                   double max_radius, double reach);

/* After dem_halo_build: the memory of the next function. */
int dem_halo_reserve_needed(struct dem_halo *, const struct dem_particles *);

/* Collective, after a prune: select the ghosts that are needed in each step: those with contact rows, or
   those that are marked in needed_here. Neither allocates. An error of MPI is recorded (collect.h) and
   returned by the next agreement. */
void dem_halo_select_needed(struct dem_halo *, const struct dem_particles *,
                            const struct dem_contacts *);
void dem_halo_select_marked(struct dem_halo *);

/* Begin to send positions, velocities, spins and the columns ghost_step for the ghosts on other
   ranks; does not allocate. One of the two functions below must complete it before any other call of
   this file. An error of MPI is recorded (collect.h) and returned by the next agreement. */
void dem_halo_send(struct dem_halo *, const struct dem_particles *, enum dem_halo_set);

/* The same for numbers that are in send_buffer already, `width` of each particle; those received are in
   receive_buffer after dem_halo_wait. */
void dem_halo_post(struct dem_halo *, enum dem_halo_set, int width);

/* Wait for the data; copy them to the ghosts (receive) or discard them (wait). */
void dem_halo_receive(struct dem_halo *, struct dem_particles *);
void dem_halo_wait(struct dem_halo *);

/* Collective. Send the inverse inertial mass (with added mass) and the columns ghost_window to the
   ghosts. */
int dem_halo_refresh_window(struct dem_halo *, struct dem_particles *);
