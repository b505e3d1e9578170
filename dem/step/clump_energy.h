/*
 * clump_energy.h -- energy balance: work of a fluid on rigid bodies of several spheres.
 *
 * In a kick over h from v, L to v', L' (particles/clump_flow.h), with the means v_m, w_m of velocity and spin and
 * v_k = v_m + w_m x R r_k, the kinetic energy of a body changes by the sum of these, to round-off:
 *
 *   force f of an effect on sphere k     h f . v_k                                    work of the effect
 *   drag                                 sum J_k . u_k                                work of the fluid
 *     less                               sum J_k . (u_k - v_m) - A . w_m              lost
 *   viscous torque                       S . w_m                                      its work
 *
 *   S   h phi(z_r) sum of t_k (o_k - w)
 *   A   L' - L - S - h (T and the moments of all f): what drag adds to the angular momentum
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/clump_flow.h"
#include "records/energy_balance.h"

/* Before the sweeps: room for n particles. */
int dem_clump_energy_reserve(struct dem_clump_flow *, const struct dem_clumps *, const struct dem_effect_list *effects,
                             size_t n);

/* After the effects of a batch: keep the shares of their forces. */
void dem_clump_energy_take(const struct dem_clump_flow *, const struct dem_energy_balance *,
                           const struct dem_effect_list *effects, size_t first, int rows);

/* Before the kick of all bodies, and after it, over h in a window of this length [s]. */
void dem_clump_energy_before(const struct dem_clumps *, const struct dem_particles *);
void dem_clump_energy_after(struct dem_energy_balance *, const struct dem_effect_list *effects,
                            const struct dem_clumps *, const struct dem_particles *, double h, double window);
