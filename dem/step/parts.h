/*
 * parts.h -- all stores of one rank in one hand. Only the step pipeline and the door hold it; a function below takes the
 * stores it works on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_PARTS_H
#define DEM_STEP_PARTS_H

#include "space/domain.h"
#include "space/halo.h"
#include "space/pairs.h"
#include "space/pieces.h"
#include "state/contacts.h"
#include "state/particles.h"
#include "state/recipe.h"
#include "state/walls.h"
#include "step/averages.h"
#include "step/balance.h"
#include "step/durations.h"
#include "step/kept.h"
#include "step/ledger.h"
#include "step/bonds.h"
#include "step/flows.h"
#include "step/losses.h"
#include "step/phases.h"
#include "step/wall_books.h"
#include "step/wall_touch.h"
#include <signal.h>

struct dem_watch                                          /* what the sweep saw; reset by who asks */
{
    double overlap;                                       /* 1  largest, of the smaller partner's diameter */
    double most;                                          /* 1  the same, of all times that somebody has asked */
    double limit;                                         /* 1  more than this ends the run */
    double most_speed;                                    /* m/s  a faster particle ends the run; 0: none does */
    int64_t i, j;                                         /* culprits; j is -1 - region at a wall */
    double x[3];                                          /* m  where */
};

struct dem_parts
{
    struct dem_domain domain;
    struct dem_recipe recipe;
    struct dem_particles particles;
    struct dem_contacts contacts;
    struct dem_walls walls;
    struct dem_wall_touches touches;
    struct dem_pairs pairs;
    struct dem_pieces pieces;
    struct dem_halo halo;
    struct dem_watch watch;
    struct dem_averages averages;
    struct dem_losses losses;
    struct dem_flows flows;
    struct dem_bonds bonds;
    struct dem_kept kept;
    struct dem_wall_books books;
    struct dem_ledger ledger;
    struct dem_phases phases;
    struct dem_durations durations;
    struct dem_balance balance;
    int stale;                                            /* 1: rebuild in the next step whatever has moved; 2: there are no
                                                             lists of these particles yet */
    int64_t steps, rebuilds, prunes;
    int64_t before, ahead;                                /* steps made before this window, and steps in it */
    double time, dt, window;                              /* s; of the positions; last step; length of the last window */
    double opened;                                        /* s; start of the last window */
    int drifted;                                          /* 1: the last step has made the next one's drift, too: nobody looked */
    double fastest;                                       /* m/s in it */
    int open;                                             /* 1: it stopped in the middle, velocities half a step ahead */
    const volatile sig_atomic_t *asked;                   /* not 0: stop after this step; NULL: nobody asks */
    int stopped;                                          /* what asked had then, the largest of all ranks */
    double longest_step;                                  /* s; that any window takes */
};

#endif
