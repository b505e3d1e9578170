/*
 * energy_balance.h -- energy balance of the particles: where their energy comes from and where it
 * goes.
 *
 *   total = kinetic + gravity + elastic + lost + broken - work of walls
 *           - work of other body forces + carried out - carried in
 *           - supplied by edits between advances (run/edit.c)
 *           + gain of heat content - what it comes from (energy_work.c)
 *
 * The total is constant up to the error of the integrator; its change is the residual. Each term is
 * computed by a formula of its own; none is the difference of the others.
 *
 *   drift   positions move with the velocity of half a step ago, so the forces before and after the
 *           drift each do half of the work. Rows report elastic energy as a function of their
 *           positions, and heat for the drift: by `energy` of struct dem_effect, or, for an effect
 *           without it, the work of its force (reported as measured).
 *   gravity m g times the displacement of the particles: wrapping at periodic faces does no work.
 *   walls   force on the particle times the velocity of the wall's surface, half of it with the
 *           forces before the drift.
 *           The work on walls that are moved by force stays in the system: these have kinetic energy,
 *           and their given forces and damping do work (walls/wall_body.h).
 *   kick    body forces except gravity: force times the mean of the velocities before and after,
 *           which is exact. For drag, impulse times u is work of the fluid, impulse times (u - v)
 *           is lost.
 *
 * All sums are exact (core/sum.h), and each row is counted by the owner of its lower id: the same
 * digits on any number of ranks. The balance begins in dem_start and again at every restart. A run
 * without it has no column, no sum and no copy for it.
 *
 * Order of the error: second in the time step for what is elastic, yields, slips or breaks; first
 * with dashpots, rolling resistance and discontinuous forces. The springs of ended contacts and of
 * broken bonds are taken to hold the energy of a step ago plus what the drift supplied with that
 * force alone. Not included: the energy in contacts of a particle that leaves the domain; the work
 * of the force on a moving wall in the first half step after a restart (a snapshot does not hold
 * the force of each wall).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/sum.h"
#include "dem_types.h"
#include "particles/particles.h"
#include "laws/interaction_table.h"

struct dem_state;
struct dem_contact_workspace;

enum dem_energy_balance_sum                                       /* of each effect: */
{
    DEM_ENERGY_BALANCE_ELASTIC,  /* J  elastic energy in the last sweep that summed it */
    DEM_ENERGY_BALANCE_LOST,     /* J  heat since the start */
    DEM_ENERGY_BALANCE_WORK,     /* J  on particles, since the start: body effects */
    DEM_ENERGY_BALANCE_SUMS_PER_EFFECT,
    /* of the whole: J  work of gravity */
    DEM_ENERGY_BALANCE_GRAVITY = DEM_ENERGY_BALANCE_SUMS_PER_EFFECT*DEM_EFFECT_LIST_LIMIT,
    DEM_ENERGY_BALANCE_BROKEN,   /* J  lost by bonds that broke */
    DEM_ENERGY_BALANCE_WALLS,    /* J  work of walls on particles */
    DEM_ENERGY_BALANCE_OUT,      /* J  carried out by particles that left */
    DEM_ENERGY_BALANCE_IN,       /* J  carried in by particles that came */
    DEM_ENERGY_BALANCE_APPLIED,  /* J  work of the scene's forces on chosen particles */
    DEM_ENERGY_BALANCE_CELL,     /* J  work of the periodic cell that deforms */
    DEM_ENERGY_BALANCE_DRIVEN,   /* J  work of what moves driven particles */
    DEM_ENERGY_BALANCE_LOADS,    /* J  work of given forces on walls that are moved by force */
    DEM_ENERGY_BALANCE_LOST_WALLS,  /* J  in their damping and at their stops */
    DEM_ENERGY_BALANCE_CONTENT,  /* J  heat content at the start, negative */
    DEM_ENERGY_BALANCE_HEATED,   /* J  dissipated in contacts whose heat partners receive */
    DEM_ENERGY_BALANCE_HEAT_WALLS,   /* J  heat from walls */
    DEM_ENERGY_BALANCE_HEAT_BODIES,  /* J  heat from the fluid and the program */
    DEM_ENERGY_BALANCE_HEAT_OUT, /* J  heat content of particles that left */
    DEM_ENERGY_BALANCE_HEAT_IN,  /* J  of particles that came */
    DEM_ENERGY_BALANCE_SUMS
};

enum
{
    DEM_ENERGY_BALANCE_ITEMS = 25 + DEM_ENERGY_BALANCE_SUMS_PER_EFFECT*DEM_EFFECT_LIST_LIMIT
};

struct dem_energy_balance_scratch    /* working columns of the current batch */
{
    /* in the order of their sums */
    const struct dem_effect *effect[DEM_EFFECT_LIST_LIMIT];
    struct dem_energy energy;
    /* the batch with the overlap of a step ago, for the normal law */
    struct dem_contact_batch was;
    /* m/s  rate of change of the distance */
    double rate[DEM_BATCH_ROWS];
    double *before[DEM_HISTORY_COLUMNS];
    _Alignas(64) double column[DEM_HISTORY_COLUMNS][DEM_BATCH_ROWS];
    struct                                                   /* forces and energies of the batch
                                                                before the effect acted */
    {
        double fn[DEM_BATCH_ROWS], fx[DEM_BATCH_ROWS], fy[DEM_BATCH_ROWS], fz[DEM_BATCH_ROWS],
            mx[DEM_BATCH_ROWS], my[DEM_BATCH_ROWS], mz[DEM_BATCH_ROWS];
        double stored[DEM_BATCH_ROWS], lost[DEM_BATCH_ROWS], broke[DEM_BATCH_ROWS];
    } then;
    /* N  on particles before the effect acted */
    double force[3][DEM_BATCH_ROWS];
    /* N  of each body effect */
    double own[DEM_EFFECT_LIST_LIMIT][3][DEM_BATCH_ROWS];
};

struct dem_energy_balance
{
    /* 1: this run has an energy balance */
    int open;
    /* 1: there are driven particles */
    int driven;
    /* 1: the run has streams or outlets */
    int flows;
    /* 1: heat is summed; 0 in the sweep that the balance begins with */
    int begun;
    /* 1: the next sweep sums elastic energies */
    int sums_elastic;
    /* s, J: when it began, the total then */
    double since, start;
    /* J: supplied by edits between advances; 1: there were edits */
    double edited;
    int edits;
    /* the particle scalar whose content is energy, or -1 */
    int heat;
    /* m/s2 */
    double gravity[3];
    /* DEM_ENERGY_BALANCE_SUMS */
    struct dem_sum *sum;
    /* J: elastic energy of the contacts with each wall, kept as it was when the wall went; NULL: all
       walls stay */
    struct dem_sum *wall_elastic;
    /* of the last backup: the sums, then wall_elastic; NULL: none */
    struct dem_sum *backup;
    double backup_edited;
    int backup_edits;
    struct dem_energy_balance_scratch *scratch;
    int items;
    /* as reported last */
    struct dem_energy_item item[DEM_ENERGY_BALANCE_ITEMS];
};

/* Before the first sweep, with the final interaction table. */
int dem_energy_balance_open(struct dem_energy_balance *, const struct dem_interaction_table *);
void dem_energy_balance_free(struct dem_energy_balance *);

/* After it, where walls come and go: the springs of contacts with a wall that goes count as lost. */
struct dem_walls;
int dem_energy_balance_watch_walls(struct dem_energy_balance *, const struct dem_walls *);

/* Collective. After a sweep that summed elastic energies: the present total becomes the reference
   of the residual. */
void dem_energy_balance_begin(struct dem_state *);

/* Collective, at the end of a window. Compute all terms, as `items` entries of `item`. */
void dem_energy_balance_report(struct dem_state *);

/* Collective, between two advances: the total, without what edits have supplied. After an edit, and a
   sweep that summed elastic energies: the edit has supplied what the total has grown by since it was
   `before` [J]. No effect without a balance. */
double dem_energy_balance_total(struct dem_state *);
void dem_energy_balance_edited(struct dem_state *, double before);

/* Copy the sums; put the copy back. Between two calls of swap all is added to the copy instead. */
int dem_energy_balance_backup(struct dem_energy_balance *, int walls);
void dem_energy_balance_restore(struct dem_energy_balance *, int walls);
void dem_energy_balance_swap(struct dem_energy_balance *);

/* ---- contacts: a batch of the sweep ---------------------------------------------------------- */

struct dem_energy_balance_rows    /* one effect applied to a batch */
{
    const struct dem_effect_list *list;
    const struct dem_effect_entry *entry;
    double **memory;  /* its history columns at the rows of the batch */
    uint32_t row;     /* the first; */
    int rows;         /* their number without padding */
};

/* Before the first batch of a sweep; before the first effect of a batch (`link` is not used);
   before and after each effect. */
void dem_energy_balance_begin_sweep(struct dem_state *);
void dem_energy_balance_begin_batch(struct dem_state *, const struct dem_contact_workspace *,
                                    const struct dem_energy_balance_rows *);
void dem_energy_balance_before_effect(struct dem_state *, const struct dem_contact_workspace *,
                                      const struct dem_energy_balance_rows *);
void dem_energy_balance_after_effect(struct dem_state *, const struct dem_contact_workspace *,
                                     const struct dem_energy_balance_rows *);

/* ---- work ------------------------------------------------------------------------------------ */

/* Work over the drift dt [s]: after the drift and the motion of walls, before lists change; and
   after the sweep that follows. */
void dem_energy_balance_after_drift(struct dem_state *, double dt);
void dem_energy_balance_after_sweep(struct dem_state *, double dt);

/* A particle, of the records, is about to be removed, its velocity behind its position by `late` [s];
   or has been inserted, velocity and position synchronous. */
void dem_energy_balance_particle_out(struct dem_state *, const struct dem_particle *, double late);
void dem_energy_balance_particle_in(struct dem_state *, const struct dem_particle *);

/* ---- heat ------------------------------------------------------------------------------------ */

/* The present content becomes the reference, and all other terms begin at 0. */
void dem_energy_balance_begin_heat(struct dem_state *);

/* After a batch (`entry` is not used): rate is what the first partner of each row receives [W]. */
void dem_energy_balance_contact_heat(struct dem_state *, const struct dem_contact_batch *,
                                     const struct dem_energy_balance_rows *, const double *rate);

/* Add the heat content of a particle, times `sign`, exactly. */
void dem_energy_balance_add_content(const struct dem_state *, size_t particle, double sign,
                                    struct dem_sum *);

/* ---- body forces ------------------------------------------------------------------------------ */

struct dem_energy_balance_kick    /* a batch of particles after the kick */
{
    const struct dem_effect_list *effects;
    /* with velocities after the kick */
    const struct dem_body_batch *batch;
    /* N s impulse of drag */
    const double *j[3];
    /* N m s impulse of rotational drag; the batch then holds the spins after */
    const double *spin_impulse[3];
    size_t first;
    int rows;
    /* s */
    double h, window;
};

void dem_energy_balance_before_body_effect(struct dem_energy_balance *,
                                           const struct dem_body_batch *);
void dem_energy_balance_after_body_effect(struct dem_energy_balance *,
                                          const struct dem_body_batch *, int entry);
void dem_energy_balance_after_kick(struct dem_energy_balance *, const struct dem_particles *,
                                   const struct dem_energy_balance_kick *);

/* ---- internal -------------------------------------------------------------------------------- */

/* The first sum of an effect; DEM_ENERGY_BALANCE_SUMS_PER_EFFECT sums follow each other. */
struct dem_sum *dem_energy_balance_sums_of(const struct dem_energy_balance *,
                                           const struct dem_effect *);

/* Adds only values that are not zero: most are. */
static inline void dem_energy_balance_add(struct dem_sum *s, double value)
{
    if (value != 0.0)
    {
        dem_sum_add(s, value);
    }
}
