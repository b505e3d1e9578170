/*
 * clump_applied.h -- forces of the scene and of the program on rigid bodies of several spheres.
 *
 * A force of the scene acts once on a body, at its centre; a force of the program on a sphere, at the sphere's centre.
 * Both join the forces of the contacts. In a kick over h their work is
 *
 *   h (F . (v + v')/2 + T . (w + w')/2),   w = R I^-1 R^T L
 *
 *   F, T   their sum, and moment about the centre of the body [N], [N m]
 *   v, w   velocity and angular velocity of the body before the kick, v' and w' after it [m/s], [1/s]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/applied_forces.h"
#include "particles/clump.h"
#include "records/energy_balance.h"

/* Before the kick: add the forces at this time [s] to the contact forces. */
void dem_clump_applied_add(struct dem_clumps *, const struct dem_particles *, const struct dem_applied_forces *,
                           const struct dem_domain *, double time);

/* After the kick over h [s]: their work. */
void dem_clump_applied_work(const struct dem_clumps *, const struct dem_particles *, struct dem_energy_balance *,
                            double h);
