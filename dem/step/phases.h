/*
 * phases.h -- where the time of a run goes: one reading of the clock ends a phase and begins the next.
 *
 * A reading takes 30 ns, a step has ten. So that the clock costs less than 0.1 % of steps that take 0.06 us a particle, each step is
 * looked at when a rank has 5000 particles or more, every second one when it has half of that, and so on. Time that was not
 * looked at is shared out among the phases of every step as those that were; renewed lists and copies of the state are rare and
 * always looked at. So all phases together are the time that passed. Nothing in the run depends on any of this.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_PHASES_H
#define DEM_STEP_PHASES_H

#include <stddef.h>
#include <stdint.h>

enum dem_phase
{
    DEM_PHASE_DRIFT,                                      /* positions, walls */
    DEM_PHASE_AGREE,                                      /* all ranks know the largest speed: waits for the last one */
    DEM_PHASE_REFRESH,                                    /* copies of neighbours' particles */
    DEM_PHASE_PRUNE,                                      /* near rows from outer lists */
    DEM_PHASE_CONTACTS,
    DEM_PHASE_SUMS,
    DEM_PHASE_BODIES,                                     /* forces that are no contacts, kicks */
    DEM_PHASE_EVERY_STEP,                                 /* those above: of each step, maybe not looked at in each */

    DEM_PHASE_RENEW = DEM_PHASE_EVERY_STEP,               /* owners, order, copies, outer lists */
    DEM_PHASE_AVERAGES,
    DEM_PHASE_KEEP,                                       /* copies of the state */
    DEM_PHASE_OUTSIDE,                                    /* between two advances: output, a fluid */
    DEM_PHASES
};

struct dem_phases
{
    double spent[DEM_PHASES], unseen;                     /* s; unseen: of phases of every step */
    double last;                                          /* s: the last reading */
    double processor;                                     /* s: at the beginning */
    int looks;                                            /* 1: in this step */
    int64_t every, steps;                                 /* one step in so many is looked at; steps since the beginning */
    int64_t particle_steps, row_steps;                    /* owned particles and swept rows, summed over steps */
    int64_t agreements;                                   /* all-reduces of a step */
    int64_t rebuilds, prunes;                             /* made before the beginning */
};

/* Begin now, with everything zero but what was made before. */
void dem_phases_begin(struct dem_phases *, int64_t rebuilds, int64_t prunes);

/* An advance begins and ends. */
void dem_phases_enter(struct dem_phases *, size_t particles);
void dem_phases_leave(struct dem_phases *);

/* A step begins; what comes after it is in the phase that ends next. */
void dem_phases_step(struct dem_phases *);

/* A phase of every step ends here. */
void dem_phases_end(struct dem_phases *, enum dem_phase);

/* A rare phase begins after `before`, which ended just now, and ends. */
void dem_phases_rare(struct dem_phases *, enum dem_phase before);
void dem_phases_rare_end(struct dem_phases *, enum dem_phase);

/* Seconds in each phase, what was not looked at shared out. */
void dem_phases_shares(const struct dem_phases *, double spent[DEM_PHASES]);

const char *dem_phase_name(enum dem_phase);

#endif
