/*
 * body_tray.h -- one block of particles on its way through the sweep of bodies: in from records and columns, out again.
 *
 * A tray keeps its lanes from block to block: those past the last row of the last block hold numbers of the block before, or
 * zeros, and go nowhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_BODY_TRAY_H
#define DEM_STEP_BODY_TRAY_H

#include "effects/block.h"
#include "state/particles.h"

struct dem_body_tray
{
    struct dem_body_block block;
    _Alignas(64) double over_m[DEM_BLOCK];                /* 1/kg  inverse inertial mass */
    _Alignas(64) double jx[DEM_BLOCK], jy[DEM_BLOCK], jz[DEM_BLOCK];          /* N s   drag impulse of this kick */
    _Alignas(64) double kept[DEM_BLOCK];                  /* 1     exp(-z) */
    _Alignas(64) double drag[DEM_BLOCK];                  /* kg/s  b without counterflow */
    _Alignas(64) double turn[3][DEM_BLOCK];               /* N m s impulse of rotational drag in this kick */
    double *force, *torque;                               /* N, N m: of contacts, 3 a row; the particles' columns, or */
    double own[2][3*DEM_BLOCK];                           /* the tray's own, where nobody wants to see them later */
};

/* Where contact forces of the rows from `first` on are, or go: in the particles' columns, or with `own` in the tray. First of all. */
void dem_body_tray_forces(struct dem_body_tray *, const struct dem_particles *, size_t first, int own);

/* The rows [first, first + rows) of the particles with their contact forces; the columns of drag are cleared. With `spin` the spins. */
void dem_body_tray_gather(struct dem_body_tray *, const struct dem_particles *, size_t first, int rows, int spin);

/* What they see of the fluid; the pending impulse joins the force at so much of it per second. */
void dem_body_tray_fluid(struct dem_body_tray *, const struct dem_particles *, size_t first, int rows, double over_window);

/* What the law of drag has made of the fluid alone, for the steps of this window. */
void dem_body_tray_keep_swarm(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows);

/* Drag becomes the whole force of a steady, uniform flow, that of its pressure gradient included: b/e; and so does lift. */
void dem_body_tray_whole_drag(struct dem_body_tray *);

/* The fluid makes room for what particles have moved since the window's start: see sweep_bodies.c. */
void dem_body_tray_counterflow(struct dem_body_tray *, const struct dem_particles *, size_t first, int rows);

/* A kick backwards, h < 0 [s], is spared drag that would make more than e times of the slip, or of the spin. After counterflow. */
void dem_body_tray_spare(struct dem_body_tray *, const struct dem_particles *, size_t first, int rows, double h);

/* What effects of inertia have told becomes the added mass of this window, and part of the inertial mass of who is free to move. */
void dem_body_tray_inertia(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows);

/* Forces that react join the others, before the kick; after it, with velocities still to go home, what the fluid gets of them and of
   the added mass is booked. */
void dem_body_tray_join(struct dem_body_tray *);
void dem_body_tray_react(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows, double h);

/* Spins under contact torques and rotational drag over the kick h [s], to be taken home after the velocities, which turn them without. */
void dem_body_tray_turn(struct dem_body_tray *, const struct dem_particles *, size_t first, int rows, double h);
void dem_body_tray_turned(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows);

/* The new velocities go home; contact torques turn the spins over the kick h [s]. */
void dem_body_tray_scatter(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows, double h);

/* What drag did in the kick h [s] joins the columns that the fluid is told. */
void dem_body_tray_book(const struct dem_body_tray *, struct dem_particles *, size_t first, int rows, double h);

#endif
