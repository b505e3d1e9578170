/*
 * dem_state.h -- the state of a simulation on one rank: particles, walls, laws, lists, records.
 *
 * The time step and the public calls pass the whole state; functions of lower folders take only the
 * parts that they need.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RANKS_DEM_STATE_H
#define DEM_RANKS_DEM_STATE_H

#include "core/error.h"
#include "particles/applied_forces.h"
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

struct dem_limits                                          /* limits check; reset by each query */
{
    double overlap;      /* 1  largest, relative to the smaller diameter */
    double max_overlap;  /* 1  the same, maximum of all queries */
    double limit;        /* 1  a larger overlap ends the run */
    double max_speed;    /* m/s  a higher speed ends the run; 0: no limit */
    int64_t i, j;        /* ids of the contact; j is -1 - facet at a wall */
    double x[3];         /* m  its position */
    int lawless;         /* 1: no normal law acts in it */
};

enum
{
    DEM_UNAGREED_STEPS = 16       /* after so many steps the ranks agree in any case */
};

/* steps since the ranks agreed last, of this rank */
struct dem_unagreed
{
    int n;
    double moved[DEM_UNAGREED_STEPS];  /* m: largest displacement in each */
    double bound;                      /* m: bound of their sum on all ranks, from time/maxSpeed;
                                          infinite without it */
    int status;                        /* of the first error, and its text */
    char text[DEM_ERROR_TEXT_SIZE];
};

/* the program's function that follows an advance; dem_set_progress */
struct dem_progress
{
    void (*report)(void *self, double time, int64_t steps);   /* NULL: none */
    void *self;
    double seconds, last;                                     /* s of the clock: between calls, of
                                                                 the last one */
};

struct dem_state
{
    struct dem_domain domain;
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
    struct dem_applied_forces applied_forces;  /* of the scene, on chosen particles */
    struct dem_backup backup;
    struct dem_load_balance load_balance;

    /* Stores of upper layers, which the step fills for reports; owned by struct
       dem_attached_stores. */
    struct dem_grid_averages *averages;           /* records/grid_averages.h */
    struct dem_flows *flows;                      /* sources/flows.h */
    struct dem_lost_particles *lost_particles;    /* records/lost_particles.h */
    struct dem_bonds *bonds;                      /* records/bonds.h */
    struct dem_wall_statistics *wall_statistics;  /* records/wall_statistics.h */
    struct dem_energy_balance *energy_balance;    /* records/energy_balance.h */
    struct dem_timers *timers;                    /* records/timers.h */

    int stale;                                    /* 1: rebuild in the next step; 2: there
                                                     are no lists of these particles yet */
    int64_t steps, rebuilds, prunes;
    int64_t agreements;                           /* all-reduces of dem_agree */
    struct dem_unagreed unagreed;
    int64_t steps_before, steps_ahead;            /* steps before this window,
                                                     steps of this window */
    double time, dt, window;                      /* s; of positions; last step;
                                                     length of last window */
    double window_start;                          /* s; start of the last window */
    int next_drift_done;                          /* 1: the last step included the drift
                                                     of the next one, because the state
                                                     between them was not needed */
    double fastest;                               /* m/s; largest speed in that drift */
    int half_step_ahead;                          /* 1: stopped within a window;
                                                     velocities are half a step ahead */
    const volatile sig_atomic_t *stop_request;    /* not 0: stop after this step;
                                                     NULL: no such request */
    struct dem_progress progress;                 /* called during an advance */
    int stopped;                                  /* value of the request at the
                                                     stop, maximum of ranks */
    double max_dt;                                /* s; limit of the time step of any window */
};

#endif
