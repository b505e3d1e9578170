/*
 * wall_books.h -- the impulse that particles have given to each wall: force times kick, step by step, as the particles got it.
 *
 * With the weights of the kicks (half a step at both ends of a window) the impulse on the walls is what the particles have
 * lost by them, to round-off. Only the first half kick after a restart is not in it: the snapshot knows the force on
 * each particle, but not which wall had it. Sums are exact, so ranks and order do not matter.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_WALL_BOOKS_H
#define DEM_STEP_WALL_BOOKS_H

#include "base/sum.h"

struct dem_parts;

struct dem_wall_books
{
    struct dem_sum *sum;                                  /* 6 a wall: N s, N m s about the origin; NULL: nobody asks */
    int walls;
    struct dem_sum *held;                                 /* N, N m: force of the last sweep whose rows are gone; NULL: they are there */
};

/* Begin anew, from nothing. */
int dem_wall_books_open(struct dem_wall_books *, int walls);
void dem_wall_books_free(struct dem_wall_books *);

/* The forces of the last sweep act for `kick` [s]. */
void dem_wall_books_add(struct dem_parts *, double kick);

/* Rows are about to go without a sweep to follow before the next kick: sum what they do. */
int dem_wall_books_hold(struct dem_parts *);

/* The state has gone back to a copy: those rows were others'. */
void dem_wall_books_drop(struct dem_wall_books *);

/* The force of the last sweep on one wall (-1: on all of them, one after the other), times `factor`, added to 6 sums a wall. */
void dem_wall_books_sum(const struct dem_parts *, int wall, double factor, struct dem_sum *);

#endif
