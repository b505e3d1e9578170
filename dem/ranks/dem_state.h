/*
 * dem_state.h -- the state of a simulation on one rank: particles, walls, laws, lists, records.
 *
 * The time step and the public calls pass the whole state; functions of lower folders take only the
 * parts that they need.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/error.h"
#include "particles/applied_forces.h"
#include "particles/cell.h"
#include "particles/clump.h"
#include "particles/domain.h"
#include "ranks/halo.h"
#include "ranks/wall_store.h"
#include "contacts/pairs.h"
#include "ranks/decomposition.h"
#include "contacts/contacts.h"
#include "particles/particles.h"
#include "laws/interaction_table.h"
#include "walls/walls.h"
#include "ranks/load_balance.h"
#include "ranks/backup.h"
#include "walls/wall_touch.h"
#include <signal.h>

/* what the run must not exceed, and the largest overlap so far; a query resets overlap */
struct dem_limits
{
    /* 1    largest overlap relative to the smaller diameter: since the last query; before it */
    double overlap, earlier_overlap;
    /* 1    a larger overlap ends the run */
    double overlap_limit;
    /* m/s  a higher speed ends the run; 0: no limit */
    double speed_limit;
    /* ids of the contact with the largest overlap; j is -1 - facet at a wall */
    int64_t i, j;
    /* m    its position */
    double x[3];
    /* 1: no normal law acts in it */
    int lawless;
};

enum
{
    /* after so many steps the ranks agree in any case */
    DEM_UNAGREED_STEPS = 16
};

/* steps since the ranks agreed last, of this rank */
struct dem_unagreed
{
    int n;
    /* m  largest displacement in each */
    double moved[DEM_UNAGREED_STEPS];
    /* m  bound of their sum on all ranks, from time/maxSpeed; infinite without it */
    double bound;
    /* of the first error, and its text */
    int status;
    char text[DEM_ERROR_TEXT_SIZE];
};

/* the drift of the next step, made within the last one where nothing needed the state between */
struct dem_next_drift
{
    int done;
    /* 1: its work is in the energy balance and in the wall statistics */
    int counted;
    /* m/s  largest speed in it */
    double max_speed;
};

/* the program's function that follows an advance; dem_set_progress */
struct dem_progress
{
    /* NULL: none */
    void (*report)(void *self, double time, int64_t steps);
    void *self;
    /* s of the clock: between calls; of the last call */
    double seconds, last;
};

/* are the neighbor lists up to date? */
enum dem_neighbors_state
{
    DEM_NEIGHBORS_VALID,
    /* to be rebuilt in the next step */
    DEM_NEIGHBORS_REBUILD,
    /* there are no lists and no contact rows, for example after a load or an edit */
    DEM_NEIGHBORS_NONE
};

struct dem_state
{
    struct dem_domain domain;
    /* how it deforms */
    struct dem_cell cell;
    struct dem_interaction_table interaction_table;
    struct dem_particles particles;
    struct dem_contacts contacts;
    struct dem_walls walls;
    struct dem_wall_store wall_store;
    struct dem_wall_touches touches;
    struct dem_pairs pairs;
    struct dem_decomposition decomposition;
    struct dem_halo halo;
    struct dem_limits limits;
    /* of the scene, on chosen particles */
    struct dem_applied_forces applied_forces;
    /* rigid bodies of several spheres */
    struct dem_clumps clumps;
    struct dem_backup backup;
    struct dem_load_balance load_balance;

    /* Stores of upper layers, which the step fills for reports; owned by struct
       dem_attached_stores. Headers: sources/flows.h, others records/<name>.h */
    struct dem_grid_averages *averages;
    struct dem_flows *flows;
    struct dem_lost_particles *lost_particles;
    struct dem_bonds *bonds;
    struct dem_wall_statistics *wall_statistics;
    struct dem_energy_balance *energy_balance;
    struct dem_timers *timers;

    /* makes steps in place of the CPU (device/device_steps.h); NULL: none */
    struct dem_device *device;

    /* s  time of the positions; the last time step; limit of the time step of any window */
    double time, dt, max_dt;
    int64_t steps, rebuilds, prunes;
    struct dem_window window;
    struct dem_next_drift next_drift;
    enum dem_neighbors_state lists_state;
    /* 1: they and the contact rows are the device's; the host has none, though its lists count as valid
       (device/device_window.c) */
    int contacts_on_device;

    /* all-reduces of dem_agree */
    int64_t agreements;
    struct dem_unagreed unagreed;
    /* not 0: stop after this step; NULL: no such request */
    const volatile sig_atomic_t *stop_request;
    /* called during an advance */
    struct dem_progress progress;
};

/* Rebuild the neighbor lists in the next step. */
static inline void dem_request_rebuild(struct dem_state *state)
{
    if (state->lists_state == DEM_NEIGHBORS_VALID)
    {
        state->lists_state = DEM_NEIGHBORS_REBUILD;
    }
}
