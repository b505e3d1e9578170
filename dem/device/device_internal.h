/*
 * device_internal.h -- what is on the device: for the files device_*.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "device/device_steps.h"
#include "device/opencl_device.h"
#include "device/shared.h"
#include "laws/interaction_table.h"

enum
{
    DEM_DEVICE_CLASSES = DEM_PARTNERS*DEM_MATERIALS*DEM_MATERIALS
};

/* contact rows, with what goes from one step and one list to the next */
struct dem_device_rows
{
    struct dem_opencl_memory partners, start, entry, touch, history;
    struct dem_opencl_memory near;      /* of wall rows (facets.cl) */
    uint32_t rows, walls;               /* walls: the first row of a wall */
    uint32_t first[DEM_DEVICE_CLASSES + 1];    /* row of each class; the last: rows */
    uint32_t count[DEM_DEVICE_CLASSES];        /* of its rows, without those that fill up batches of the host */
};

enum dem_device_list_kernel
{
    DEM_LISTS_IMAGES, DEM_LISTS_CELLS, DEM_LISTS_ORDER, DEM_LISTS_COUNT, DEM_LISTS_FIND,
    DEM_LISTS_ROWS, DEM_LISTS_ENTRIES, DEM_LISTS_HISTORY, DEM_LISTS_DISPLACEMENT, DEM_LISTS_REFER,
    DEM_SCAN_CLEAR, DEM_SCAN_BLOCKS, DEM_SCAN_SUMS, DEM_SCAN_FINISH, DEM_LISTS_TOTALS, DEM_LISTS_NEEDED,
    DEM_LISTS_KERNELS
};

struct dem_device_progress    /* of the steps of an advance, or of several whose contacts stay here */
{
    double moved;           /* m  displacement since the lists were made, at most */
    double skin;            /* m  of the device's lists; 0: they are the host's */
    double rest;            /* m  displacement up to which they are valid, with the walls where they were */
    double before;          /* m  displacements from the host's last rebuild to the present lists */
    double walls_before;    /* m  the same of walls */
    int64_t checked;        /*    the last step with a check of particles that enter or leave, of those made */
};

struct dem_device
{
    struct dem_opencl *cl;
    char name[400];
    int classes;
    struct dem_opencl_kernel *of_rows[DEM_DEVICE_CLASSES], *bodies, *clear;
    struct dem_opencl_kernel *of_lists[DEM_LISTS_KERNELS];
    struct dem_opencl_kernel *of_facets, *of_triangles, *of_near;    /* NULL: not needed */
    struct dem_opencl_kernel *of_loads, *pack_ghosts, *unpack_ghosts;

    /* constants, a batch of steps and its report */
    struct dem_opencl_memory axes, shift, facets, frames, drives, pair_class, wall_class;
    struct dem_opencl_memory triangles, grid_first, grid, images;
    struct dem_opencl_memory batch, report;
    /* of several ranks: particles that are sent, ghosts that are received, their numbers; ghosts in rows */
    struct dem_opencl_memory ghosts_out, ghosts_in, ghosts, needed;
    enum dem_halo_set ghost_set;        /* that is on the device */
    /* of particles, and a copy from before the batch */
    struct dem_opencl_memory record, lost, columns, before_record, before_lost, before_columns;
    /* of rows: the present lists and those before; results of a step; a copy */
    struct dem_device_rows list[2];
    int at;
    struct dem_opencl_memory force, moment, energy, contacts, exact, conditions, rates, applied, ids,
        before_touch, before_history, contact_sums;
    struct    /* contacts at the last backup; list.rows is 0 where the host had them */
    {
        struct dem_device_rows list;
        struct dem_particle *ghost;
        size_t ghosts, capacity;
        struct dem_facet *facet;        /* of the rows of walls */
        size_t facets;
        int64_t selections;             /* of triangles, when they were copied */
    } backup;
    /* of lists that are made */
    struct dem_opencl_memory lists, reference, cell, place, first, order, row_first, sums, partner,
        image, totals, largest, candidate_start, candidates, former_place;

    int renumbered;                     /* 1: particles have other places since the present lists: former_place */
    int own;                            /* 1: the present lists are made here, not on the host */
    int keeps;                          /* 1: contacts may stay here between windows */
    struct dem_device_progress progress;
    int64_t host_lists;                 /* rebuilds and prunes of the host's lists that are here */
    int64_t selections;                 /* of the triangles that this rank holds and are here */
    int64_t host_until;                 /* up to this step the host makes the steps */
    int64_t wait;                       /* steps added there after the next event: each event that
                                           follows another one doubles them */
    double last_speed;                  /* m/s  largest of the last drift */
    double min_skin, max_skin;          /* m */
    struct dem_device_counts counts;
    struct dem_device_report seen;
    struct dem_device_frame *frame;     /* of the steps of a batch */
    size_t frames_capacity;
    double *speed;
    uint32_t *word;                     /* scratch */
    size_t speeds, words;
};

/* device_renewal.c, collective. New lists for the next step: always (changed: particles have entered or left), or
   if more than half of the displacement is used up. *end: 1 when the host has to make this step. */
int dem_device_new_lists(struct dem_device *, struct dem_state *, const struct dem_device_steps *,
                         struct dem_device_progress *, int changed, int *end);
int dem_device_renew_lists(struct dem_device *, struct dem_state *, const struct dem_device_steps *,
                           struct dem_device_progress *, int *end);

/* device_open.c: skin [m] of the next lists, for particles of up to this speed [m/s]. */
double dem_device_skin(const struct dem_device *, double speed, double dt);

/* device_state.c: the host's lists and state to the device; the state back, with rows of the host's
   lists, or as saved history. */
int dem_device_put(struct dem_device *, const struct dem_state *);
int dem_device_get(struct dem_device *, struct dem_state *);
int dem_device_reserve_rows(struct dem_device *, const struct dem_state *, uint32_t rows);

/* device_state.c: the same where contacts have stayed on the device: particles, and forces of the scene. Rows of the
   host away; the history of rows that do not touch to zero; history of these rows, at these facets, as saved history
   of the host. */
int dem_device_put_window(struct dem_device *, const struct dem_state *);
void dem_device_drop_host_rows(struct dem_contacts *);
int dem_device_clear_apart(struct dem_device *, int columns);
int dem_device_get_saved(struct dem_device *, struct dem_state *, const struct dem_device_rows *,
                         const struct dem_facet *);

/* device_window.c: after the last step of a window, whose contacts stay: particles and sums of their contacts to the
   host. */
int dem_device_get_window(struct dem_device *, struct dem_state *);

/* device_state.c: records and columns of particles, up and down. */
int dem_device_put_particles(struct dem_device *, const struct dem_state *);
int dem_device_get_particles(struct dem_device *, struct dem_state *);

/* device_changes.c: let particles enter and leave before the next step, if that one checks them.
   skin [m]: of the device's lists; 0: the lists are the host's. changes: 1 when some did; new lists
   must follow, images of rows are kept already. end: 1 when the host has to make this step. */
int dem_device_check(struct dem_device *, struct dem_state *, const struct dem_device_steps *,
                     double skin, int *changes, int *end);

/* Smallest radius [m] of the scene. */
double dem_device_smallest_radius(const struct dem_interaction_table *);

/* device_lists.c: constants of lists; new lists from the present positions, with this skin [m]
   (outside: 1 when a particle has left the domain, so that the host has to look); largest
   displacement [m] since the lists were made; the present positions as its reference. */
int dem_device_begin_lists(struct dem_device *, const struct dem_state *);
int dem_device_make_lists(struct dem_device *, const struct dem_state *, double skin,
                          int *outside);
int dem_device_displacement(struct dem_device *, const struct dem_state *, double *moved);
int dem_device_refer(struct dem_device *, const struct dem_state *);

/* device_scan.c: zeros, n and one more; exclusive sums of n numbers in place, their sum after the
   last. */
int dem_device_clear(struct dem_device *, struct dem_opencl_memory *, size_t n);
int dem_device_scan(struct dem_device *, struct dem_opencl_memory *, size_t n);

/* The images of the rows, before particles and walls are wrapped. */
int dem_device_keep_images(struct dem_device *);

/* device_facets.c: facets, and triangles if there are any. Kernels; those that this rank holds, with
   classes of contacts; what the host's lists say of wall rows; the image in the key of a wall row whose
   facet has an image of this code; walls taken whole periods back; candidates, and what wall rows have to
   know, of new lists; the arguments of the kernel of contacts, and its launch in step s. */
int dem_device_begin_facets(struct dem_device *, const struct dem_walls *);
int dem_device_put_facets(struct dem_device *, const struct dem_state *);
int dem_device_put_near(struct dem_device *, const struct dem_state *);
uint32_t dem_device_facet_image(const struct dem_walls *, const struct dem_facet *, uint32_t code,
                                uint32_t particle);
int dem_device_wrap_walls(struct dem_device *, struct dem_state *);
int dem_device_find_candidates(struct dem_device *, const struct dem_state *);
int dem_device_find_near(struct dem_device *, const struct dem_state *);
int dem_device_give_facets(struct dem_device *);
int dem_device_launch_facets(struct dem_device *, const struct dem_state *, uint32_t s);

/* device_walls.c: walls move along with the steps of a batch. next: 1: the frames of the step after the
   batch, too. */
int dem_device_move_walls(struct dem_device *, struct dem_state *, const struct dem_device_steps *,
                          struct dem_device_batch *, uint32_t *n, double skin, int next);
void dem_device_leave_walls(struct dem_state *, const struct dem_device_steps *);

/* device_sums.c: exact sums of a batch of steps, of loads on walls and of the energy balance, if they are
   asked for. Begin with zero; the arguments of the kernel of walls, and its launch in step s; add the sums
   to the host's; `loads` takes the forces on walls. has_wall_work: 1 when the work of walls that move is summed. */
int dem_device_begin_sums(struct dem_device *, const struct dem_state *, struct dem_device_batch *);
int dem_device_give_loads(struct dem_device *);
int dem_device_launch_loads(struct dem_device *, const struct dem_state *, uint32_t s);
int dem_device_add_sums(struct dem_device *, struct dem_state *, struct dem_binned_sum *loads);
int dem_device_has_wall_work(const struct dem_state *);

/* device_ghosts.c, with several ranks. put: which particles are sent and received. send: the
   particles of step s to other ranks; all ranks agree on errors and on the largest speed^2 [m2/s2], infinite
   after an event. receive: the ghosts to the device. Both: of the set that was put last. Collective, for new
   lists: all ghosts are put and refreshed; then those in the new rows are put. */
int dem_device_put_ghosts(struct dem_device *, const struct dem_halo *, enum dem_halo_set);
int dem_device_send_ghosts(struct dem_device *, struct dem_state *, uint32_t s, int status,
                           double *fastest);
int dem_device_receive_ghosts(struct dem_device *, const struct dem_state *);
int dem_device_refresh_ghosts(struct dem_device *, struct dem_state *);
int dem_device_select_ghosts(struct dem_device *, struct dem_state *);

/* All memory in turn, for k from 0; NULL past the last. */
struct dem_opencl_memory *dem_device_memory_of(struct dem_device *, size_t k);
