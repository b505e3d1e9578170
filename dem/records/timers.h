/*
 * timers.h -- timers of the phases of a time step: one reading of the clock ends a phase and begins
 * the next.
 *
 * A reading takes 30 ns, and a step has ten of them. The clock is to cost less than 0.1 % of steps
 * that take 0.06 us a particle. Every step is therefore timed on a rank of 5000 particles or more,
 * every second one at half of that, and so on. The time of the other steps is distributed over the
 * phases of every step in proportion to the timed ones. Rebuilds of lists and backups are rare and
 * always timed. The sum of all phases is thus the time that has passed. Nothing in the run depends
 * on the timers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

enum dem_phase
{
    DEM_PHASE_DRIFT,                         /* positions, walls */
    DEM_PHASE_AGREE,                         /* all-reduce of the largest speed;
                                                includes waiting for the slowest rank */
    DEM_PHASE_REFRESH,                       /* ghost particles */
    DEM_PHASE_PRUNE,                         /* contact rows from the outer list */
    DEM_PHASE_CONTACTS,
    DEM_PHASE_SUMS,
    DEM_PHASE_BODIES,                        /* body and fluid forces, kicks */
    DEM_PHASE_EVERY_STEP,                    /* number of the phases above, which every
                                                step has; timed in some steps only */

    DEM_PHASE_REBUILD = DEM_PHASE_EVERY_STEP,  /* rebuild: migration, order, ghosts, outer list */
    DEM_PHASE_AVERAGES,
    DEM_PHASE_BACKUP,                          /* backups of the state */
    DEM_PHASE_DEVICE,                        /* steps on a device, and copies of the state */
    DEM_PHASE_OUTSIDE,                       /* between two advances: output, the fluid solver */
    DEM_PHASES
};

struct dem_timers
{
    double spent[DEM_PHASES], untimed;   /* s, in each phase; in steps that were not timed */
    double last;                        /* s: last reading of the clock */

    double first_processor;             /* s: processor clock at the beginning */
    int timed;                          /* 1: this step is timed */
    int64_t every;                      /* one step in so many is timed */
    int64_t steps;                      /* since the beginning */
    int64_t particle_steps, row_steps;  /* owned particles and contact rows, summed over steps */
    int64_t agreements;                 /* all-reduces before the beginning */
    int64_t rebuilds, prunes;           /* made before the beginning */
};

/* Start all timers at zero. `rebuilds`, `prunes`, `agreements`: number made so far. */
void dem_timers_begin(struct dem_timers *, int64_t rebuilds, int64_t prunes, int64_t agreements);

/* An advance of `particles` owned particles begins; it ends. */
void dem_timers_begin_advance(struct dem_timers *, size_t particles);
void dem_timers_end_advance(struct dem_timers *);

/* A step begins; its time up to the next end of a phase belongs to that phase. */
void dem_timers_begin_step(struct dem_timers *);

/* End a phase that every step has. */
void dem_timers_end_phase(struct dem_timers *, enum dem_phase);

/* Begin a rare phase, and with it end the phase `before`; end it. */
void dem_timers_begin_rare_phase(struct dem_timers *, enum dem_phase before);
void dem_timers_end_rare_phase(struct dem_timers *, enum dem_phase);

/* Add the time up to now to that outside. */
void dem_timers_end_outside(struct dem_timers *);

/* Seconds in each phase, with the time of steps that were not timed distributed. */
void dem_timers_seconds(const struct dem_timers *, double spent[DEM_PHASES]);

const char *dem_phase_name(enum dem_phase);
