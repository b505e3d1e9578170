/*
 * wall_statistics.h -- the impulse that particles have given to each wall: force times kick, step
 * by step, as the particles got it.
 *
 * With the weights of the kicks (half a step at both ends of a window) the impulse on the walls
 * equals what the particles have lost by them, to round-off. Only the first half kick after a
 * restart is missing: a snapshot holds the force on each particle, but not which wall exerted it.
 * The work on the particles is the mean of the forces before and after a drift times the drift.
 * Sums are exact, so they do not depend on ranks and order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/binned_sum.h"

struct dem_state;
struct dem_wear_sum;

struct dem_wall_statistics
{
    struct dem_binned_sum *sum;    /* per wall: N s, N m s about the origin; NULL: not asked for */
    int walls;
    struct dem_sum *work;          /* per wall: J on particles */
    struct dem_wear_sum *wear;     /* per triangle of all walls and ranks (wall_wear.h); NULL: none */
    struct dem_binned_sum *saved;  /* N, N m: saved force of the last sweep,
                                     its rows are gone; NULL: rows exist */
    struct dem_binned_sum *backup; /* sums and forces of the last backup; NULL: none */
    struct dem_sum *backup_work;
};

/* Start the sums at zero. */
int dem_wall_statistics_begin(struct dem_wall_statistics *, int walls);
void dem_wall_statistics_free(struct dem_wall_statistics *);

/* The forces of the last sweep act for `kick` [s]. */
void dem_wall_statistics_add_kick(struct dem_state *, double kick);

/* Contact rows are about to be deleted, and no sweep follows before the next kick: save their
   forces. */
int dem_wall_statistics_save_forces(struct dem_state *);
void dem_wall_statistics_drop_forces(struct dem_wall_statistics *);

/* Copy the sums, without an impulse of the present forces over `kick` [s], and these forces; put the
   copy back. Sums that began after the copy then begin again. */
int dem_wall_statistics_backup(struct dem_state *, double kick);
int dem_wall_statistics_restore(struct dem_wall_statistics *);

/* Add the work of walls on particles, for each wall and for the energy balance, with the forces of the last
   sweep over the time `span` [s] of the drift behind it, or with ahead = 1 of the drift after it, in which
   the walls have already moved. */
void dem_wall_statistics_add_work(struct dem_state *, double span, int ahead);

/* Add the force and torque of the last sweep on one wall (-1: on each of all walls), times
   `factor`, to the sums of the wall; flush them before they are read. */
void dem_wall_statistics_sum_forces(const struct dem_state *, int wall, double factor,
                                    struct dem_binned_sum *);
