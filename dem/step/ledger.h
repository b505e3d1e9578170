/*
 * ledger.h -- where the energy of the particles comes from and where it goes.
 *
 *   total = kinetic + gravity + elastic + lost + broken - work of walls - work of other body forces + carried out - carried in
 *
 * stays what it was, but for the error of the integrator: that is the residual. Each term is told by its own formula, none
 * is what is left of the others.
 *
 *   drift   positions move with the velocity of half a step ago, so forces of before and after the drift work half each.
 *           Rows book elastic energy as a function of where they are, and heat for the drift: by struct dem_effect's
 *           `energy`, or, of an effect without it, the work of its force (told as measured).
 *   gravity m g times what particles have moved by: wrapping at periodic faces is no fall.
 *   walls   force on the particle times the velocity of the wall's surface, half of it with the forces before the drift.
 *   kick    body forces but gravity: force times the mean of the velocities before and after, which is exact; of drag,
 *           impulse times u is work of the fluid, impulse times (u - v) is lost.
 *
 * All sums are exact (base/sum), each row is counted by the owner of its lower particle: the same digits on any number of
 * ranks. It begins in dem_ready and again at every restart. A run without it has no column, no sum and no copy.
 *
 * Order of error: second in the step for what is elastic, yields, slips or breaks; first with dashpots, rolling resistance and jumps of a
 * force. Springs of ended contacts and of broken bonds held what they did a step ago, and got what the drift gave with that force alone.
 * Not here: the energy that contacts of a particle hold which leaves the domain; what the force on a moving wall did in the
 * first half step after a restart (no snapshot knows which wall had it).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_LEDGER_H
#define DEM_STEP_LEDGER_H

#include "base/sum.h"
#include "dem.h"
#include "state/particles.h"
#include "state/recipe.h"

struct dem_parts;
struct dem_tray;

enum dem_ledger_sum                                       /* of each effect, */
{
    DEM_LEDGER_STORED,                                    /* J  in the last sweep that told */
    DEM_LEDGER_LOST,                                      /* J  since the start */
    DEM_LEDGER_WORK,                                      /* J  on particles, since the start: body effects */
    DEM_LEDGER_EACH,
    DEM_LEDGER_FALL = DEM_LEDGER_EACH*DEM_CHAIN,          /* and of all: J  work of gravity */
    DEM_LEDGER_BROKEN,                                    /* J  lost by bonds that broke */
    DEM_LEDGER_WALLS,                                     /* J  work of walls on particles */
    DEM_LEDGER_LEFT,                                      /* J  carried out by particles that left */
    DEM_LEDGER_CAME,                                      /* J  carried in by particles that came */
    DEM_LEDGER_SUMS
};

enum
{
    DEM_LEDGER_ITEMS = 9 + DEM_LEDGER_EACH*DEM_CHAIN
};

struct dem_ledger_scratch                                 /* of the block at hand */
{
    const struct dem_effect *effect[DEM_CHAIN];           /* in the order of their sums */
    struct dem_energy tray;
    struct dem_block was;                                 /* as of a step ago, for the normal law */
    double rate[DEM_BLOCK];                               /* m/s  how fast the distance has grown */
    double *before[DEM_MEMORY_COLUMNS];
    _Alignas(64) double column[DEM_MEMORY_COLUMNS][DEM_BLOCK];
    struct                                                /* results and books of the tray before the effect acted */
    {
        double fn[DEM_BLOCK], fx[DEM_BLOCK], fy[DEM_BLOCK], fz[DEM_BLOCK], mx[DEM_BLOCK], my[DEM_BLOCK], mz[DEM_BLOCK];
        double stored[DEM_BLOCK], lost[DEM_BLOCK], broke[DEM_BLOCK];
    } then;
    double force[3][DEM_BLOCK];                           /* N    on bodies before the effect acted */
    double own[DEM_CHAIN][3][DEM_BLOCK];                  /* N    of each body effect */
};

struct dem_ledger
{
    int open;                                             /* 1: this run keeps it */
    int begun;                                            /* 1: what is lost counts; 0 in the sweep that it begins with */
    int tells;                                            /* 1: the next sweep sums elastic energies */
    double since, start;                                  /* s, J: when it began, the total then */
    double gravity[3];                                    /* m/s2 */
    struct dem_sum *sum;                                  /* DEM_LEDGER_SUMS */
    struct dem_ledger_scratch *scratch;
    int items;
    struct dem_energy_item item[DEM_LEDGER_ITEMS];        /* as told last */
};

/* Before the first sweep; the recipe is frozen. */
int dem_ledger_open(struct dem_ledger *, const struct dem_recipe *);
void dem_ledger_free(struct dem_ledger *);

/* Collective. After a sweep that told: the total of now is the one to keep. */
void dem_ledger_begin(struct dem_parts *);

/* Collective. All terms of now, at the end of a window, as `items` in `item`. */
void dem_ledger_tell(struct dem_parts *);

/* ---- rows: a block of the sweep ------------------------------------------------------------------------------ */

struct dem_ledger_rows                                    /* one effect at work on a block */
{
    const struct dem_chain *chain;
    const struct dem_link *link;
    double **memory;                                      /* its remembered columns at the block's rows */
    uint32_t row;                                         /* the first, */
    int rows;                                             /* without padding */
};

void dem_ledger_sweep(struct dem_ledger *);                                             /* before the first block */
void dem_ledger_block(struct dem_parts *, const struct dem_tray *, const struct dem_ledger_rows *);     /* before the first effect; of no link */
void dem_ledger_before(struct dem_parts *, const struct dem_tray *, const struct dem_ledger_rows *);
void dem_ledger_after(struct dem_parts *, const struct dem_tray *, const struct dem_ledger_rows *);

/* ---- work ---------------------------------------------------------------------------------------------------- */

/* After the drift and the walls' motion, before lists change; and after the sweep at its end. */
void dem_ledger_drift(struct dem_parts *, double dt);
void dem_ledger_swept(struct dem_parts *, double dt);

/* A particle is about to be taken out, its velocity behind its position by `late` [s]; or comes in with the velocity of now. */
void dem_ledger_leaves(struct dem_parts *, const struct dem_particle *, double late);
void dem_ledger_comes(struct dem_parts *, const struct dem_particle *);

struct dem_ledger_kick                                    /* a block of bodies, kicked */
{
    const struct dem_chain *bodies;
    const struct dem_body_block *block;                   /* velocities after */
    const double *j[3];                                   /* N s  of drag */
    const double *turn[3];                                /* N m s  of rotational drag; the block then has the spins after */
    size_t first;
    int rows;
    double h, window;                                     /* s */
};

void dem_ledger_body_before(struct dem_ledger *, const struct dem_body_block *);
void dem_ledger_body_after(struct dem_ledger *, const struct dem_body_block *, int link);
void dem_ledger_kicked(struct dem_ledger *, const struct dem_particles *, const struct dem_ledger_kick *);

/* ---- inside ---------------------------------------------------------------------------------------------------- */

/* Where the sums of an effect begin. */
struct dem_sum *dem_ledger_of(const struct dem_ledger *, const struct dem_effect *);

/* Nothing to add is most of the time. */
static inline void dem_ledger_add(struct dem_sum *s, double value)
{
    if (value != 0.0)
    {
        dem_sum_add(s, value);
    }
}

#endif
