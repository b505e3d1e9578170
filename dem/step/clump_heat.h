/*
 * clump_heat.h -- temperature of rigid bodies of several spheres: one a body, held by all its spheres.
 *
 *   M c dT/dt = sum q_k + sum (S_k - B_k T)          over the spheres, integrated as laws/scalar.h does
 *
 *   q_k        heat rate of the contacts of sphere k and of the program                         [W]
 *   B_k, S_k   coefficient of heat transfer and B_k times the fluid's temperature at sphere k, by the law for
 *              the volume-equivalent sphere, times w_k A/(pi d^2)                               [W/K], [W]
 *   w_k        share of sphere k (particles/clump_shape.h)                                      [1]
 *   A, d       surface of the union; diameter of the volume-equivalent sphere                   [m2], [m]
 *
 * So h = Nu k_f/d acts on the whole surface. Sphere k passes on to the fluid what its B_k gave.
 * The spheres are summed in the order of their ids, so the result does not depend on the ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/clump_flow.h"
#include "step/body_scalars.h"

struct dem_clump_heat_row    /* of a sphere in this step */
{
    double rate, coefficient, to_target;    /* W, W/K, W */
};

struct dem_clump_heat
{
    int scalar;                             /* the one with DEM_SCALAR_HEAT */
    struct dem_clump_heat_row *row;         /* of each particle, valid for bodies in a step */
    size_t capacity;
};

/* Before the effects, in a step with h > 0: set the rates of bodies aside; after them: add the shares of
   what they gave. */
void dem_clump_heat_begin(const struct dem_clump_heat *, struct dem_body_scalars *, const struct dem_particles *,
                          size_t first, int rows);
void dem_clump_heat_take(const struct dem_clump_heat *, const struct dem_clump_flow *,
                         const struct dem_body_scalars *, const struct dem_particles *, size_t first, int rows);

/* After the sweep over all particles: integrate over the step. Returns the number of temperatures that are
   out of their range. */
int dem_clump_heat_integrate(const struct dem_clumps *, const struct dem_scalar_step *, struct dem_particles *);

/* At the end of a window, with heat: give each sphere a decay factor of which dem_scalars_end_window makes its
   share of the body's response. */
void dem_clump_heat_end_window(const struct dem_clumps *, const struct dem_interaction_table *,
                               struct dem_particles *);
