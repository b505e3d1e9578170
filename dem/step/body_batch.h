/*
 * body_batch.h -- one batch of particles while their velocities and spins are integrated: gather,
 * forces, kick, scatter.
 *
 * Particle records and columns are copied into the columns of a batch of DEM_BATCH_ROWS lanes.
 * Effects and the kick work on these columns, and the results are written back. Lanes past the last
 * particle of the last batch hold numbers of the batch before, or zeros; they are never written
 * back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "particles/particles.h"
#include "step/drift.h"
#include "step/sum_contacts.h"

struct dem_body_workspace    /* a batch of particles and its working columns */
{
    struct dem_body_batch batch;
    /* 1/kg   inverse inertial mass */
    _Alignas(64) double inverse_mass[DEM_BATCH_ROWS];
    /* N s    impulse of drag in this kick */
    _Alignas(64) double drag_impulse_x[DEM_BATCH_ROWS];
    _Alignas(64) double drag_impulse_y[DEM_BATCH_ROWS];
    _Alignas(64) double drag_impulse_z[DEM_BATCH_ROWS];
    /* 1      decay factor exp(-z) of the slip in this kick */
    _Alignas(64) double decay_factor[DEM_BATCH_ROWS];
    /* kg/s   drag coefficient without the slip factor */
    _Alignas(64) double particle_drag[DEM_BATCH_ROWS];
    /* N m s  impulse of rotational drag in this kick */
    _Alignas(64) double spin_impulse[3][DEM_BATCH_ROWS];
    /* sums, and one that struct dem_sum_slice asks for */
    struct dem_contact_sum contacts[DEM_BATCH_ROWS + 1];
};

/* Particles in the batch that begins at `first`. */
static inline int dem_body_batch_rows(const struct dem_particles *particles, size_t first)
{
    return particles->n - first < DEM_BATCH_ROWS ? (int)(particles->n - first) : DEM_BATCH_ROWS;
}

/* Load the contact forces of the particles [first, first + rows) from their columns. They are loaded
   or summed (sum_contacts.h) before the other functions are called. */
void dem_body_batch_load_forces(struct dem_body_workspace *, const struct dem_particles *,
                                size_t first, int rows);

/* Gather the particles [first, first + rows) with their contact forces, and their spins and forms if
   `needs` (enum dem_needs) has them. Drag and other results are cleared. */
void dem_body_batch_gather(struct dem_body_workspace *, const struct dem_particles *, size_t first,
                           int rows, unsigned needs);

/* Gather the fluid quantities at the particles. The impulse carried over from the last exchange is
   added to the force at the rate `over_window` [1/s], the inverse of the coupling window. */
void dem_body_batch_gather_fluid(struct dem_body_workspace *, const struct dem_particles *,
                                 size_t first, int rows, double over_window);

/* Store what the drag law has computed from the fluid alone (voidage factors), for the steps of
   this coupling window. */
void dem_body_batch_store_voidage_factors(const struct dem_body_workspace *, struct dem_particles *,
                                          size_t first, int rows);

/* Divide drag and lift by the void fraction, so that they are the total force of a steady,
   uniform flow, the force of its pressure gradient included. */
void dem_body_batch_divide_by_void_fraction(struct dem_body_workspace *);

/* Multiply drag by the factor in the column own_wake. */
void dem_body_batch_scale_drag(struct dem_body_workspace *, const struct dem_particles *,
                               size_t first, int rows);

/* Apply the slip factor: the reaction of an incompressible fluid to the motion of the particles
   since the start of the window (step/body_window.c). */
void dem_body_batch_apply_slip_factor(struct dem_body_workspace *, const struct dem_particles *,
                                      size_t first, int rows);

/* In a backward kick, h < 0 [s], leave out drag that would enlarge the slip, or the spin, by more
   than a factor of e = 2.718. To be called after the slip factor. */
void dem_body_batch_limit_backward_drag(struct dem_body_workspace *, const struct dem_particles *,
                                        size_t first, int rows, double h);

/* Store the added mass that the effects of inertia have computed for this window, and add it to the
   inertial mass of the particles that are free to move. */
void dem_body_batch_store_added_mass(const struct dem_body_workspace *, struct dem_particles *,
                                     size_t first, int rows);

/* Before the kick: add the forces whose reaction acts on the fluid to the other forces. After the
   kick, while the records still hold the old velocities: add the impulse of these forces and of the
   added mass to what is passed to the fluid. */
void dem_body_batch_add_reacting_forces(struct dem_body_workspace *);
void dem_body_batch_sum_reactions(const struct dem_body_workspace *, struct dem_particles *,
                                  size_t first, int rows, double h);

/* Kick the spins by contact torques and rotational drag over h [s]. They are written back by the
   second function, after the velocities, because dem_body_batch_scatter applies the contact torques
   alone. */
void dem_body_batch_kick_spins(struct dem_body_workspace *, const struct dem_particles *,
                               size_t first, int rows, double h);
void dem_body_batch_scatter_spins(const struct dem_body_workspace *, struct dem_particles *,
                                  size_t first, int rows);

/* Write the new velocities back, and kick the spins by the contact torques over h [s]. */
void dem_body_batch_scatter(const struct dem_body_workspace *, struct dem_particles *, size_t first,
                            int rows, double h);

/* The same, and drift over h at once, as dem_drift_particles does. */
void dem_body_batch_scatter_and_drift(const struct dem_body_workspace *, struct dem_particles *,
                                      size_t first, int rows, double h, const double round[4],
                                      struct dem_drift_speeds *);

/* Add the drag impulse of the kick h [s], its decay factor and coefficient times h to the columns
   that are passed to the fluid. */
void dem_body_batch_sum_drag(const struct dem_body_workspace *, struct dem_particles *,
                             size_t first, int rows, double h);
